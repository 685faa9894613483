#include "mechanics/Supports.hpp"

#include <algorithm>
#include <cmath>

#include "base/Error.hpp"
#include "base/Log.hpp"

namespace stroma::mechanics {
namespace {

/// Whether a node lies on a face of the body's box. In plane strain the one layer of nodes lies on
/// both faces of z.
bool lies_on(Face face, const std::array<double, 3>& x, const grid::Grid& body) {
  for (int d = 0; d < 3; ++d) {
    if (face != Face::all && axis_of(face) != d) continue;
    const auto i = static_cast<std::size_t>(d);
    const double tolerance = 1e-6 * body.spacing[i];
    const bool lower = std::abs(x[i] - body.origin[i]) < tolerance;
    const bool upper =
        std::abs(x[i] - body.origin[i] - body.length(d)) < tolerance || (body.flat && d == 2);
    if (face == Face::all ? (lower || upper) : (is_upper(face) ? upper : lower)) return true;
  }
  return false;
}

/// Refuses what the grid cannot do.
void check_condition(const Problem& problem, const std::string& name,
                     const BoundaryCondition& condition) {
  const std::string where = "Boundary Conditions|" + name;
  const auto& G = condition.displacement_gradient;
  if (problem.body.flat && G && ((*G)[2] != 0.0 || (*G)[5] != 0.0 || (*G)[8] != 0.0))
    throw base::InputError(where +
                           "|Displacement Gradient: displacements that vary along z are not plane "
                           "strain; admissible: zeros in the third column");
  if (!problem.reset || problem.imposed_by(condition) == ImposedBy::penalty) return;
  if (!condition.is_self_contained())
    throw base::InputError(
        where +
        "|Displacement Gradient: with Grid|Reset, the displacement must not "
        "depend on a direction that the condition leaves free; admissible: zeros "
        "in the columns of components that are not prescribed");
  if (problem.imposed_by(condition) == ImposedBy::nodes && !condition.stays_in_plane())
    throw base::InputError(
        where +
        "|Imposed By: with Grid|Reset, Nodes can hold only a face that stays in "
        "its plane (its normal displacement prescribed as zero); admissible: Grip, Penalty");
}

}  // namespace

Supports::Supports(const grid::Halo& halo, const Problem& problem, double base_load,
                   const NodeCounts& filled_around, const std::vector<NodeCounts>& gripped,
                   const NodeComponents& held_otherwise)
    : halo_(&halo),
      conditions_(static_cast<int>(problem.conditions.size())),
      base_load_(base_load) {
  const auto& communicator = halo.communicator();
  const grid::Partition& partition = halo.partition();
  const grid::Grid& grid = partition.grid();
  const grid::Grid& body = problem.body;
  const NamedConditions& conditions = problem.conditions;
  const grid::Box owned = partition.owned_nodes(communicator.rank());
  const grid::Box touched = partition.touched_nodes(communicator.rank());
  const auto host = [](const NodeCounts& counts) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), counts);
  };
  const auto filled = host(filled_around);
  std::vector<NodeCounts::HostMirror> in_grip;
  for (const NodeCounts& grip : gripped) in_grip.push_back(host(grip));
  const std::array<double, 3> length{body.length(0), body.length(1), body.length(2)};
  const double negligible = 1e-12 * *std::max_element(length.begin(), length.end());

  std::vector<std::uint8_t> held_owned(static_cast<std::size_t>(owned.count()), 0);
  std::vector<std::int64_t> nodes_of_condition(conditions.size(), 0);
  std::int64_t active_nodes = 0;
  const auto name_of = [&](int m) { return conditions[static_cast<std::size_t>(m)].first; };
  base::collectively(communicator, [&] {
    for (const auto& [name, condition] : conditions) check_condition(problem, name, condition);
    grid::for_each_index(owned, [&](const grid::Index3& node) {
      const auto n = static_cast<std::size_t>(owned.local(node));
      const auto x = grid.node_position(node);
      const std::int64_t t = touched.local(node);
      const bool node_is_active = filled(t) != 0;
      active_nodes += node_is_active ? 1 : 0;
      for (int c = 0; c < 3; ++c) {
        int by = node_is_active ? conditions_ : static_cast<int>(untouched);
        double value = 0.0;
        for (int m = 0; m < conditions_ && node_is_active; ++m) {
          const BoundaryCondition& condition = conditions[static_cast<std::size_t>(m)].second;
          const ImposedBy by_what = problem.imposed_by(condition);
          if (!condition.prescribes(c) || by_what == ImposedBy::penalty) continue;
          const bool applies = by_what == ImposedBy::grip
                                   ? in_grip[static_cast<std::size_t>(m)](t) != 0
                                   : lies_on(*condition.face, x, body);
          if (!applies) continue;
          ++nodes_of_condition[static_cast<std::size_t>(m)];
          const auto X = condition.carried_from(x, base_load, body.origin, length);
          const double wanted = condition.value(c, X, body.origin, length);
          if (by == conditions_) {
            by = m;
            value = wanted;
          } else if (std::abs(wanted - value) > negligible) {
            throw base::InputError(conflict(name_of(by), name_of(m), c, x, value, wanted));
          }
        }
        if (grid.flat && c == 2 && node_is_active) {
          if (by == conditions_) by = plane_strain;
          if (std::abs(value) > negligible)
            throw base::InputError(conflict(name_of(by), "", c, x, value, 0.0));
        }
        if (by == conditions_) continue;
        held_owned[n] = static_cast<std::uint8_t>(held_owned[n] | 1u << c);
        prescribed_.push_back({static_cast<int>(3 * n) + c, by, value});
      }
    });
  });
  for (std::size_t m = 0; m < conditions.size(); ++m)
    if (problem.imposed_by(conditions[m].second) != ImposedBy::penalty &&
        communicator.sum(nodes_of_condition[m]) == 0)
      throw base::InputError(no_particle_near(conditions[m].first));

  // Nodes deep in the body can hold a rigid motion; one that the body barely touches cannot.
  std::uint8_t most_filled = 0;
  for (std::size_t t = 0; t < filled.extent(0); ++t) most_filled = std::max(most_filled, filled(t));
  most_filled = communicator.max(most_filled);
  const auto can_hold = [&](std::int64_t n) {
    const std::uint8_t around = filled(touched.local(owned.index(n)));
    return problem.reset ? around == most_filled : around > 0;
  };
  const auto component = [&](std::int64_t n, int c) {
    const grid::Index3 node = owned.index(n);
    return NodeComponent{partition.node_number(node), grid.node_position(node), c};
  };
  rigid_holds_ = free_rigid_motions(
      communicator,
      [&](const auto& visit) {
        for (const Prescribed& p : prescribed_)
          if (p.condition != untouched) visit(component(p.unknown / 3, p.unknown % 3));
        if (held_otherwise) held_otherwise(visit);
      },
      [&](const auto& visit) {
        for (std::int64_t n = 0; n < owned.count(); ++n)
          for (int c = 0; c < 3; ++c)
            if (!(held_owned[static_cast<std::size_t>(n)] >> c & 1) && can_hold(n))
              visit(component(n, c));
      });
  for (const NodeComponent& hold : rigid_holds_) {
    const std::int64_t n = hold.node - partition.first_node(communicator.rank());
    if (n < 0 || n >= owned.count()) continue;
    prescribed_.push_back({static_cast<int>(3 * n) + hold.component, rigid_motion, 0.0});
  }

  std::int64_t held_of_active = 0;
  grid::Vector bits(halo.owned_map());
  {
    const auto bit = Kokkos::create_mirror_view(grid::node_view(bits));
    Kokkos::deep_copy(bit, 0.0);
    for (const Prescribed& p : prescribed_) {
      bit(p.unknown / 3, p.unknown % 3) = 1.0;
      held_of_active += p.condition != untouched ? 1 : 0;
    }
    Kokkos::deep_copy(grid::node_view(bits), bit);
  }
  unknowns_ = communicator.sum(3 * active_nodes - held_of_active);

  const auto touched_bits =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), halo.gather(bits));
  held_ = Kokkos::View<std::uint8_t*, Device>("held", touched_bits.extent(0));
  const auto held = Kokkos::create_mirror_view(held_);
  for (std::size_t n = 0; n < touched_bits.extent(0); ++n)
    for (int c = 0; c < 3; ++c)
      if (touched_bits(n, c) != 0.0) held(n) = static_cast<std::uint8_t>(held(n) | 1u << c);
  Kokkos::deep_copy(held_, held);
}

void Supports::impose(double load, grid::Vector& u) const {
  const auto values = u.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Prescribed& p : prescribed_) values(p.unknown, 0) = (load - base_load_) * p.value;
}

grid::Vector Supports::change(double load, const grid::Vector& u) const {
  grid::Vector change(u, Teuchos::Copy);
  impose(load, change);
  change.update(-1.0, u, 1.0);
  return change;
}

void Supports::clear(grid::Vector& v) const {
  const auto values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Prescribed& p : prescribed_) values(p.unknown, 0) = 0.0;
}

double Supports::reaction_norm(const grid::Vector& unbalanced_force) const {
  const auto force = unbalanced_force.getLocalViewHost(Tpetra::Access::ReadOnly);
  double sum = 0.0;
  for (const Prescribed& p : prescribed_)
    if (p.condition >= 0) sum += force(p.unknown, 0) * force(p.unknown, 0);
  return std::sqrt(halo_->communicator().sum(sum));
}

std::vector<std::array<double, 3>> Supports::reactions(const grid::Vector& unbalanced_force) const {
  std::vector<std::array<double, 3>> sums(static_cast<std::size_t>(conditions_));
  const auto force = unbalanced_force.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const Prescribed& p : prescribed_)
    if (p.condition >= 0)
      sums[static_cast<std::size_t>(p.condition)][static_cast<std::size_t>(p.unknown % 3)] +=
          force(p.unknown, 0);
  if (!sums.empty()) halo_->communicator().sum_all(sums.front().data(), 3 * sums.size());
  return sums;
}

}  // namespace stroma::mechanics
