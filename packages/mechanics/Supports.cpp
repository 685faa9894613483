#include "mechanics/Supports.hpp"

#include <algorithm>
#include <cmath>

#include "base/Error.hpp"
#include "base/Log.hpp"

namespace stroma::mechanics {
namespace {

bool lies_on(Face face, const grid::Index3& node, const grid::Grid& grid) {
  for (int d = 0; d < 3; ++d) {
    if (face != Face::all && axis_of(face) != d) continue;
    const bool lower = node[d] == 0;
    const bool upper = node[d] == grid.elements[d] || (grid.flat && d == 2);
    if (face == Face::all ? (lower || upper) : (is_upper(face) ? upper : lower)) return true;
  }
  return false;
}

std::string conflict(const NamedConditions& conditions, int first, int second, int component,
                     const std::array<double, 3>& x, double a, double b) {
  return base::format(
      "Boundary Conditions|%s: its %c displacement, %.10g um, and that of %s, %.10g um, differ at "
      "their "
      "common point (%g, %g, %g) um; admissible: equal values, or %c left out of the Components of "
      "one "
      "of them",
      conditions[static_cast<std::size_t>(first)].first.c_str(), "xyz"[component], a,
      second < 0 ? "plane strain"
                 : ("\"" + conditions[static_cast<std::size_t>(second)].first + "\"").c_str(),
      b, x[0], x[1], x[2], "xyz"[component]);
}

}  // namespace

Supports::Supports(const grid::Halo& halo, const NamedConditions& conditions,
                   const Kokkos::View<std::uint8_t*, Device>& active)
    : halo_(&halo), conditions_(static_cast<int>(conditions.size())) {
  const auto& communicator = halo.communicator();
  const grid::Partition& partition = halo.partition();
  const grid::Grid& grid = partition.grid();
  const grid::Box owned = partition.owned_nodes(communicator.rank());
  const grid::Box touched = partition.touched_nodes(communicator.rank());
  const auto is_active = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), active);
  const std::array<double, 3> length{grid.length(0), grid.length(1), grid.length(2)};
  const double negligible = 1e-12 * *std::max_element(length.begin(), length.end());

  std::vector<std::uint8_t> held_owned(static_cast<std::size_t>(owned.count()), 0);
  std::vector<std::int64_t> nodes_of_condition(conditions.size(), 0);
  std::int64_t active_nodes = 0;
  base::collectively(communicator, [&] {
    for (const auto& [name, condition] : conditions) {
      const auto& G = condition.displacement_gradient;
      if (grid.flat && G && ((*G)[2] != 0.0 || (*G)[5] != 0.0 || (*G)[8] != 0.0))
        throw base::InputError(
            "Boundary Conditions|" + name +
            "|Displacement Gradient: displacements that vary along z are not plane "
            "strain; admissible: zeros in the third column");
    }
    grid::for_each_index(owned, [&](const grid::Index3& node) {
      const auto n = static_cast<std::size_t>(owned.local(node));
      const auto x = grid.node_position(node);
      const bool node_is_active = is_active(touched.local(node)) != 0;
      active_nodes += node_is_active ? 1 : 0;
      for (int c = 0; c < 3; ++c) {
        int by = node_is_active ? conditions_ : static_cast<int>(untouched);
        double value = 0.0;
        for (int m = 0; m < conditions_ && node_is_active; ++m) {
          const BoundaryCondition& condition = conditions[static_cast<std::size_t>(m)].second;
          if (!condition.prescribes(c) || !lies_on(*condition.face, node, grid)) continue;
          ++nodes_of_condition[static_cast<std::size_t>(m)];
          const double wanted = condition.value(c, x, grid.origin, length);
          if (by == conditions_) {
            by = m;
            value = wanted;
          } else if (std::abs(wanted - value) > negligible) {
            throw base::InputError(conflict(conditions, by, m, c, x, value, wanted));
          }
        }
        if (grid.flat && c == 2 && node_is_active) {
          if (by == conditions_) by = plane_strain;
          if (std::abs(value) > negligible)
            throw base::InputError(conflict(conditions, by, -1, c, x, value, 0.0));
        }
        if (by == conditions_) continue;
        held_owned[n] = static_cast<std::uint8_t>(held_owned[n] | 1u << c);
        prescribed_.push_back({static_cast<int>(3 * n) + c, by, value});
      }
    });
  });
  for (std::size_t m = 0; m < conditions.size(); ++m)
    if (communicator.sum(nodes_of_condition[m]) == 0)
      throw base::InputError(
          "Boundary Conditions|" + conditions[m].first +
          "|Face: there is no particle in the elements along this face; admissible: a "
          "face at which the image has a label other than -1 (empty)");

  const auto component = [&](std::int64_t n, int c) {
    const grid::Index3 node = owned.index(n);
    return NodeComponent{partition.node_number(node), grid.node_position(node), c};
  };
  rigid_holds_ = free_rigid_motions(
      communicator,
      [&](const auto& visit) {
        for (const Prescribed& p : prescribed_)
          if (p.condition != untouched) visit(component(p.unknown / 3, p.unknown % 3));
      },
      [&](const auto& visit) {
        for (std::int64_t n = 0; n < owned.count(); ++n)
          for (int c = 0; c < 3; ++c)
            if (!(held_owned[static_cast<std::size_t>(n)] >> c & 1)) visit(component(n, c));
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
  for (const Prescribed& p : prescribed_) values(p.unknown, 0) = load * p.value;
}

void Supports::clear(grid::Vector& v) const {
  const auto values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Prescribed& p : prescribed_) values(p.unknown, 0) = 0.0;
}

double Supports::reaction_norm(const grid::Vector& internal_force) const {
  const auto force = internal_force.getLocalViewHost(Tpetra::Access::ReadOnly);
  double sum = 0.0;
  for (const Prescribed& p : prescribed_)
    if (p.condition >= 0) sum += force(p.unknown, 0) * force(p.unknown, 0);
  return std::sqrt(halo_->communicator().sum(sum));
}

std::vector<std::array<double, 3>> Supports::reactions(const grid::Vector& internal_force) const {
  std::vector<std::array<double, 3>> sums(static_cast<std::size_t>(conditions_));
  const auto force = internal_force.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const Prescribed& p : prescribed_)
    if (p.condition >= 0)
      sums[static_cast<std::size_t>(p.condition)][static_cast<std::size_t>(p.unknown % 3)] +=
          force(p.unknown, 0);
  if (!sums.empty()) halo_->communicator().sum_all(sums.front().data(), 3 * sums.size());
  return sums;
}

}  // namespace stroma::mechanics
