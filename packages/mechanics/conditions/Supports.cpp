// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/Supports.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::mechanics {
namespace {

/// The planes of the body's faces at a load factor.
class FacePlanes {
 public:
  FacePlanes(const Problem& problem, double load) : body_(problem.body) {
    for (int d = 0; d < 3; ++d)
      for (const bool upper : {false, true})
        place_[static_cast<std::size_t>(face_of(d, upper))] =
            problem.place_of_plane(face_of(d, upper), load);
  }

  /// Whether a node lies on one of the faces of a condition. In plane strain the one layer of nodes
  /// lies on both faces of z.
  bool hold(const BoundaryCondition& condition, const std::array<double, 3>& x) const {
    for (std::size_t face = 0; face < place_.size(); ++face) {
      if (!condition.applies_to(static_cast<Face>(face))) continue;
      const std::size_t d = face / 2;
      if (std::abs(x[d] - place_[face]) < 1e-6 * body_.spacing[d] || (body_.flat && d == 2))
        return true;
    }
    return false;
  }

 private:
  const grid::Grid& body_;
  std::array<double, 6> place_;
};

/// Refuses what the grid cannot do.
void check_condition(const Problem& problem, const std::string& name,
                     const BoundaryCondition& condition) {
  const std::string where = "Boundary Conditions|" + name;
  const auto& G = condition.displacement_gradient;
  if (problem.body.flat && G && ((*G)[2] != 0.0 || (*G)[5] != 0.0 || (*G)[8] != 0.0))
    throw base::InputError(where +
                           "|Displacement Gradient: displacements that vary along z are not plane "
                           "strain; admissible: zeros in the third column");
  if (!problem.method.reset || problem.imposed_by(condition) == ImposedBy::penalty) return;
  if (!condition.is_self_contained())
    throw base::InputError(
        where + (condition.rotation ? "|Rotation [deg]" : "|Displacement Gradient") +
        ": with Grid|Reset, the displacement must not depend on a direction that the condition "
        "leaves free; admissible: " +
        (condition.rotation ? "components that are free along the axis only"
                            : "zeros in the columns of components that are not prescribed"));
  for (int face = 0; face < 6; ++face)
    if (problem.imposed_by(condition) == ImposedBy::nodes &&
        condition.applies_to(static_cast<Face>(face)) && !(problem.body.flat && face / 2 == 2) &&
        !problem.is_kept_plane(static_cast<Face>(face)))
      throw base::InputError(
          where +
          "|Imposed By: with Grid|Reset, Nodes can hold only a face that stays a plane across its "
          "axis (its normal displacement prescribed, the same everywhere on it); admissible: Grip, "
          "Penalty");
}

}  // namespace

Supports::Supports(const grid::Halo& halo, const Problem& problem, double base_load,
                   const SupportedBody& body, BodyStatics& statics)
    : halo_(&halo),
      problem_(&problem),
      conditions_(static_cast<int>(problem.conditions.size())),
      base_load_(base_load) {
  const auto& communicator = halo.communicator();
  const grid::Box owned = halo.partition().owned_nodes(communicator.rank());
  held_owned_.assign(static_cast<std::size_t>(owned.count()), 0);
  prescribe_faces(problem, body);

  for (const Prescribed& p : prescribed_) {
    const int piece = piece_of(body.pieces, p.unknown);
    if (piece != Pieces::none)
      statics.add_held(
          {piece, component(p.unknown), p.condition, p.rate,
           p.condition >= 0 &&
               !problem.conditions[static_cast<std::size_t>(p.condition)].second.is_linear()});
  }
  body.held_otherwise([&](const HeldComponent& held) { statics.add_held(held); });
  statics.complete();
  pieces_ = statics.summary();
  if (problem.dynamics)  // inertia holds what nothing else does
    pieces_.carried = pieces_.carried_elements = pieces_.carried_particles = 0;
  else
    hold_what_is_loose(body, statics);
  mark_held();
  held_owned_ = {};
}

void Supports::hold_what_is_loose(const SupportedBody& body, const BodyStatics& statics) {
  if (body.is_refused_if_loose) {
    std::vector<std::string> names;
    for (const auto& named : problem_->conditions) names.push_back(named.first);
    statics.refuse_what_moves(names, base_load_ == 0.0);
  }
  carry_idle_pieces(body, statics);
  hold_free_motions(body, statics.free_pieces(), problem_->method.reset);
}

NodeComponent Supports::component(int unknown) const {
  const grid::Partition& partition = halo_->partition();
  const grid::Index3 node = partition.owned_nodes(halo_->communicator().rank()).index(unknown / 3);
  return {partition.node_number(node), partition.grid().node_position(node), unknown % 3};
}

int Supports::piece_of(const Pieces& pieces, int unknown) const {
  const grid::Partition& partition = halo_->partition();
  const int rank = halo_->communicator().rank();
  return pieces.of_node(
      partition.touched_nodes(rank).local(partition.owned_nodes(rank).index(unknown / 3)));
}

void Supports::prescribe_faces(const Problem& problem, const SupportedBody& supported) {
  const auto& communicator = halo_->communicator();
  const grid::Partition& partition = halo_->partition();
  const grid::Grid& grid = partition.grid();
  const grid::Grid& body = problem.body;
  const NamedConditions& conditions = problem.conditions;
  const grid::Box owned = partition.owned_nodes(communicator.rank());
  const grid::Box touched = partition.touched_nodes(communicator.rank());
  const auto host = [](const NodeCounts& counts) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), counts);
  };
  const auto filled = host(supported.filled_around);
  std::vector<NodeCounts::HostMirror> in_grip;
  for (const NodeCounts& grip : supported.gripped) in_grip.push_back(host(grip));
  const std::array<double, 3> length = body.lengths();
  const FacePlanes faces(problem, base_load_);

  std::vector<std::int64_t> nodes_of_condition(conditions.size(), 0);
  const auto name_of = [&](int m) { return conditions[static_cast<std::size_t>(m)].first; };
  const auto condition_of = [&](int m) -> const BoundaryCondition& {
    return conditions[static_cast<std::size_t>(m)].second;
  };
  base::collectively(communicator, [&] {
    for (const auto& [name, condition] : conditions) check_condition(problem, name, condition);
    grid::for_each_index(owned, [&](const grid::Index3& node) {
      const auto n = static_cast<std::size_t>(owned.local(node));
      const auto x = grid.node_position(node);
      const std::int64_t t = touched.local(node);
      const bool node_is_active = filled(t) != 0;
      active_nodes_ += node_is_active ? 1 : 0;
      for (int c = 0; c < 3; ++c) {
        int by = node_is_active ? conditions_ : static_cast<int>(untouched);
        std::array<double, 3> X_by{};
        for (int m = 0; m < conditions_ && node_is_active; ++m) {
          const BoundaryCondition& condition = conditions[static_cast<std::size_t>(m)].second;
          const ImposedBy by_what = problem.imposed_by(condition);
          if (!condition.prescribes(c) || by_what == ImposedBy::penalty) continue;
          const bool applies = by_what == ImposedBy::grip
                                   ? in_grip[static_cast<std::size_t>(m)](t) != 0
                                   : faces.hold(condition, x);
          if (!applies) continue;
          ++nodes_of_condition[static_cast<std::size_t>(m)];
          const auto X = condition.carried_from(x, base_load_, body.origin, length);
          if (grid.flat && c == 2)
            if (const auto moved = disagreement({condition, X}, {{}, X}, c, body.origin, length))
              throw base::InputError(moved_across_plane_strain(name_of(m), *moved));
          if (by == conditions_) {
            by = m;
            X_by = X;
          } else if (const auto found = disagreement({condition_of(by), X_by}, {condition, X}, c,
                                                     body.origin, length)) {
            throw base::InputError(conflict(name_of(by), name_of(m), c, x, *found));
          }
        }
        const bool is_moved = by >= 0 && by < conditions_;
        if (grid.flat && c == 2 && node_is_active && !is_moved) by = plane_strain;
        if (by == conditions_) continue;
        held_owned_[n] = static_cast<std::uint8_t>(held_owned_[n] | 1u << c);
        const int unknown = static_cast<int>(3 * n) + c;
        const bool turns = is_moved && !condition_of(by).is_linear();
        prescribed_.push_back(
            {unknown, by, is_moved ? condition_of(by).direction(c, X_by, body.origin, length) : 0.0,
             turns});
        if (turns) turned_.push_back({unknown, &condition_of(by), X_by});
      }
    });
  });
  for (std::size_t m = 0; m < conditions.size(); ++m)
    if (problem.imposed_by(conditions[m].second) != ImposedBy::penalty &&
        communicator.sum(nodes_of_condition[m]) == 0)
      throw base::InputError(no_particle_at("Boundary Conditions|" + conditions[m].first));
}

void Supports::carry_idle_pieces(const SupportedBody& body, const BodyStatics& statics) {
  if (pieces_.carried == 0) return;
  for (std::size_t n = 0; n < held_owned_.size(); ++n) {
    const int piece = piece_of(body.pieces, static_cast<int>(3 * n));
    if (piece == Pieces::none || !statics.is_carried(piece)) continue;
    for (int c = 0; c < 3; ++c)
      if (!(held_owned_[n] >> c & 1))
        prescribed_.push_back({static_cast<int>(3 * n) + c, carried,
                               statics.translation(piece)[static_cast<std::size_t>(c)], false});
    held_owned_[n] = 7;
  }
}

void Supports::hold_free_motions(const SupportedBody& body,
                                 const std::vector<std::int64_t>& free_pieces,
                                 bool only_deep_nodes) {
  if (free_pieces.empty()) return;
  const auto& communicator = halo_->communicator();
  const grid::Partition& partition = halo_->partition();
  const grid::Box owned = partition.owned_nodes(communicator.rank());
  const grid::Box touched = partition.touched_nodes(communicator.rank());
  const auto filled = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.filled_around);

  std::vector<std::vector<int>> nodes(static_cast<std::size_t>(body.pieces.count()));  // of pieces
  for (std::size_t n = 0; n < held_owned_.size(); ++n) {
    const int piece = piece_of(body.pieces, static_cast<int>(3 * n));
    if (piece != Pieces::none)
      nodes[static_cast<std::size_t>(piece)].push_back(static_cast<int>(n));
  }
  const std::vector<int> no_nodes;
  for (const std::int64_t label : free_pieces) {
    const int piece = body.pieces.find(label);
    const std::vector<int>& own =
        piece == Pieces::none ? no_nodes : nodes[static_cast<std::size_t>(piece)];
    const auto filled_around = [&](int n) { return filled(touched.local(owned.index(n))); };
    // Nodes deep in the body can hold a rigid motion; one that the body barely touches cannot.
    std::uint8_t least = 1;
    if (only_deep_nodes) {
      for (const int n : own) least = std::max(least, filled_around(n));
      least = communicator.max(least);
    }
    const auto visit_if = [&](bool is_held, std::uint8_t filled_at_least, const auto& visit) {
      for (const int n : own)
        for (int c = 0; c < 3; ++c)
          if ((held_owned_[static_cast<std::size_t>(n)] >> c & 1) == (is_held ? 1 : 0) &&
              filled_around(n) >= filled_at_least)
            visit(component(3 * n + c));
    };
    const std::vector<NodeComponent> holds = free_rigid_motions(
        communicator,
        [&](const auto& visit) {
          visit_if(true, 1, visit);
          body.held_otherwise([&](const HeldComponent& held) {
            if (held.piece == piece) visit(held.at);
          });
        },
        [&](const auto& visit) { visit_if(false, least, visit); });
    for (const NodeComponent& hold : holds) {
      rigid_holds_.push_back(hold);
      const std::int64_t n = hold.node - partition.first_node(communicator.rank());
      if (n < 0 || n >= owned.count()) continue;
      prescribed_.push_back({static_cast<int>(3 * n) + hold.component, rigid_motion, 0.0, false});
    }
  }
}

/// Lets ranks know what is held at the nodes that they touch, and counts what is not.
void Supports::mark_held() {
  std::int64_t held_of_active = 0;
  grid::Vector bits(halo_->owned_map());
  {
    const auto bit = Kokkos::create_mirror_view(grid::node_view(bits));
    Kokkos::deep_copy(bit, 0.0);
    for (const Prescribed& p : prescribed_) {
      bit(p.unknown / 3, p.unknown % 3) = 1.0;
      held_of_active += p.condition != untouched ? 1 : 0;
    }
    Kokkos::deep_copy(grid::node_view(bits), bit);
  }
  unknowns_ = halo_->communicator().sum(3 * active_nodes_ - held_of_active);

  const auto touched_bits =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), halo_->gather(bits));
  held_ = Kokkos::View<std::uint8_t*, Device>("held", touched_bits.extent(0));
  const auto held = Kokkos::create_mirror_view(held_);
  for (std::size_t n = 0; n < touched_bits.extent(0); ++n)
    for (int c = 0; c < 3; ++c)
      if (touched_bits(n, c) != 0.0) held(n) = static_cast<std::uint8_t>(held(n) | 1u << c);
  Kokkos::deep_copy(held_, held);
}

std::vector<std::string> Supports::notes() const {
  constexpr std::size_t most_listed = 6;
  std::vector<std::string> notes;
  for (std::size_t n = 0; n < std::min(rigid_holds_.size(), most_listed); ++n) {
    const NodeComponent& hold = rigid_holds_[n];
    notes.push_back(
        base::format("the boundary conditions leave a rigid motion free; u_%c is held at the node "
                     "at (%g, %g, %g) um, which has no effect on the stress",
                     "xyz"[hold.component], hold.position[0], hold.position[1], hold.position[2]));
  }
  if (rigid_holds_.size() > most_listed)
    notes.push_back(base::format("and so are %zu more components of other pieces of the body",
                                 rigid_holds_.size() - most_listed));
  if (pieces_.carried > 0)
    notes.push_back(base::format(
        "%lld of the body's %lld pieces (which share no node of the grid) carry no load: %.3g %% "
        "of its particles, in %lld elements. They stay where they are, or move with the condition "
        "that holds them, without stress, and leave the system; the rest does not feel it. The "
        "largest: %s",
        static_cast<long long>(pieces_.carried), static_cast<long long>(pieces_.count),
        100.0 * static_cast<double>(pieces_.carried_particles) /
            static_cast<double>(pieces_.particles),
        static_cast<long long>(pieces_.carried_elements), pieces_.largest_carried.c_str()));
  return notes;
}

template <class Use>
void Supports::for_each_value(double load, const Use& use) const {
  for (const Prescribed& p : prescribed_)
    if (!p.turns) use(p.unknown, (load - base_load_) * p.rate);
  const grid::Grid& body = problem_->body;
  const std::array<double, 3> length = body.lengths();
  for (const Turned& t : turned_) {
    const auto at = [&](double s) {
      return t.condition->value(t.unknown % 3, t.X, body.origin, length, s);
    };
    use(t.unknown, step_.on_the_line(load, at) - at(base_load_));
  }
}

void Supports::impose(double load, grid::Vector& u) const {
  const auto values = u.getLocalViewHost(Tpetra::Access::ReadWrite);
  for_each_value(load, [&](int unknown, double value) { values(unknown, 0) = value; });
}

bool Supports::are_imposed(double load, const grid::Vector& u, double share) const {
  const auto values = u.getLocalViewHost(Tpetra::Access::ReadOnly);
  double largest = 0.0, difference = 0.0;
  for_each_value(load, [&](int unknown, double value) {
    largest = std::max(largest, std::abs(value));
    difference = std::max(difference, std::abs(values(unknown, 0) - value));
  });
  largest = halo_->communicator().max(largest);
  return halo_->communicator().max(difference) <= share * largest;
}

void Supports::excess(double load, const grid::Vector& u, double stiffness,
                      grid::Vector& excess) const {
  const auto values = u.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto excesses = excess.getLocalViewHost(Tpetra::Access::ReadWrite);
  for_each_value(load, [&](int unknown, double value) {
    excesses(unknown, 0) = stiffness * (values(unknown, 0) - value);
  });
}

void Supports::rate(double load, grid::Vector& rate) const {
  rate.putScalar(0.0);
  const auto values = rate.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Prescribed& p : prescribed_) values(p.unknown, 0) = p.rate;
  const grid::Grid& body = problem_->body;
  const std::array<double, 3> length = body.lengths();
  for (const Turned& t : turned_)
    values(t.unknown, 0) = t.condition->rate(t.unknown % 3, t.X, body.origin, length, load);
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

grid::Vector Supports::prescribed_part(const grid::Vector& v) const {
  grid::Vector part(v.getMap());
  const auto from = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto to = part.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Prescribed& p : prescribed_) to(p.unknown, 0) = from(p.unknown, 0);
  return part;
}

template <class Condition>
double Supports::norm_where(const grid::Vector& unbalanced_force, const Condition& is_one) const {
  const auto force = unbalanced_force.getLocalViewHost(Tpetra::Access::ReadOnly);
  double sum = 0.0;
  for (const Prescribed& p : prescribed_)
    if (is_one(p.condition)) sum += force(p.unknown, 0) * force(p.unknown, 0);
  return std::sqrt(halo_->communicator().sum(sum));
}

double Supports::reaction_norm(const grid::Vector& unbalanced_force) const {
  return norm_where(unbalanced_force, [](int condition) { return condition >= 0; });
}

double Supports::hold_norm(const grid::Vector& unbalanced_force) const {
  if (rigid_holds_.empty()) return 0.0;
  return norm_where(unbalanced_force, [](int condition) { return condition == rigid_motion; });
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

std::vector<double> Supports::torques(const grid::Vector& u,
                                      const grid::Vector& unbalanced_force) const {
  std::vector<double> sums(static_cast<std::size_t>(conditions_));
  const auto force = unbalanced_force.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto moved = u.getLocalViewHost(Tpetra::Access::ReadOnly);
  const grid::Grid& body = problem_->body;
  for (const Prescribed& p : prescribed_) {
    if (p.condition < 0) continue;
    const auto m = static_cast<std::size_t>(p.condition);
    const BoundaryCondition& condition = problem_->conditions[m].second;
    if (!condition.rotation) continue;
    const NodeComponent at = component(p.unknown);
    std::array<double, 3> x = at.position;
    for (std::size_t d = 0; d < 3; ++d)
      x[d] += moved(p.unknown - at.component + static_cast<int>(d), 0);
    sums[m] +=
        force(p.unknown, 0) *
        condition.lever(x, body.origin, body.lengths())[static_cast<std::size_t>(at.component)];
  }
  if (!sums.empty()) halo_->communicator().sum_all(sums.data(), sums.size());
  return sums;
}

void Supports::mark_reaction(std::size_t condition, int component, grid::Vector& v) const {
  v.putScalar(0.0);
  const auto mark = v.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (const Prescribed& p : prescribed_)
    if (p.condition == static_cast<int>(condition) && p.unknown % 3 == component)
      mark(p.unknown, 0) = 1.0;
}

}  // namespace stroma::mechanics
