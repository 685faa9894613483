// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/Springs.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Stage.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::mechanics {
namespace {

/// The axis of the face on which a point lies: straight out from its particle.
int axis_beside(const transfer::BoundaryPoint& b) {
  for (int axis = 0; axis < 2; ++axis)
    if (b.offset[axis] != 0.0) return axis;
  return 2;
}

}  // namespace

bool has_springs(const Problem& problem) {
  return std::any_of(problem.conditions.begin(), problem.conditions.end(), [&](const auto& named) {
    return problem.imposed_by(named.second) == ImposedBy::penalty;
  });
}

Springs::Springs(const Body& body)
    : body_(body),
      springs_(boundary_points(body.halo().communicator(), body.problem(), body.particles())),
      some_pull_on_(std::any_of(body.problem().conditions.begin(), body.problem().conditions.end(),
                                [&](const auto& named) {
                                  return body.problem().imposed_by(named.second) ==
                                             ImposedBy::penalty &&
                                         body.problem().pulls_on(named.second);
                                })) {}

void Springs::set_load(double load) {
  load_ = load;
  aim();
}

void Springs::aim() { springs_.set_load(body_.problem(), load_, step_, beyond_); }

bool Springs::pulls_on(const transfer::BoundaryPoint& point) const {
  const Problem& problem = body_.problem();
  return problem.pulls_on(problem.conditions[static_cast<std::size_t>(point.condition)].second);
}

void Springs::begin_pulling(const TrialState& state) {
  if (!some_pull_on_) return;
  const auto point =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), springs_.points.point);
  beyond_.assign(point.extent(0), {});
  std::size_t n = 0;
  body_.field_layers(state.u)([&](int first, const FieldLayers::Fields& fields) {
    const auto stress = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fields.stress);
    const auto gradient = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fields.gradient);
    const int end = first + static_cast<int>(stress.extent(0));
    for (; n < point.extent(0) && point(n).particle < end; ++n) {
      if (!pulls_on(point(n))) continue;
      const auto p = static_cast<std::size_t>(point(n).particle - first);
      double s[6];
      for (int c = 0; c < 6; ++c) s[c] = stress(p, c);
      const tensor::Tensor3 sigma = tensor::symmetric(s);
      tensor::Tensor3 F = tensor::identity();
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) F(c, d) += gradient(p, c, d);
      const tensor::Tensor3 back = tensor::inverse(F);
      const double J = tensor::det(F);
      const BoundaryCondition& condition =
          body_.problem().conditions[static_cast<std::size_t>(point(n).condition)].second;
      const int axis = axis_beside(point(n));
      const double outwards = point(n).offset[axis] > 0.0 ? 1.0 : -1.0;
      for (int c = 0; c < 3; ++c) {
        if (!(point(n).components >> c & 1)) continue;
        double traction = 0.0;
        for (int d = 0; d < 3; ++d) traction += J * sigma(c, d) * back(axis, d) * outwards;
        beyond_[n][static_cast<std::size_t>(c)] =
            traction / body_.problem().spring_stiffness(condition, axis);
      }
    }
  });
  aim();
}

double Springs::slack(const TrialState& state) const {
  if (!some_pull_on_) return 0.0;
  BoundaryPoints at_place = springs_;
  at_place.writable = decltype(at_place.writable)("at place", springs_.points.point.extent(0));
  Kokkos::deep_copy(at_place.writable, springs_.writable);
  at_place.set_load(body_.problem(), load_, step_);
  const auto point = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), at_place.writable);
  for (std::size_t n = 0; n < point.extent(0); ++n)
    if (!pulls_on(point(n))) point(n).spring = 0.0;
  Kokkos::deep_copy(at_place.writable, point);
  at_place.points.point = at_place.writable;
  grid::Vector force(body_.halo().owned_map());
  body_.kernels().spring_force(state.points, at_place.points, body_.halo().contributions());
  body_.halo().sum_to_owner(force);
  return force.norm2();
}

double Springs::distance(const TrialState& state) const {
  if (!some_pull_on_) return 0.0;
  double sums[2] = {0.0, 0.0};
  for_each_gap(state, [&](std::size_t n, const transfer::BoundaryPoint& b,
                          const std::array<double, 3>& gap) {
    if (!pulls_on(b)) return;
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(b.components >> c & 1)) continue;
      const double missing = gap[c] + (beyond_.empty() ? 0.0 : beyond_[n][c]);
      sums[0] += missing * missing;
      sums[1] += 1.0;
    }
  });
  body_.halo().communicator().sum_all(sums, 2);
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

void Springs::pull_on(const TrialState& state) {
  beyond_.resize(springs_.X.size());
  for_each_gap(state, [&](std::size_t n, const transfer::BoundaryPoint& b,
                          const std::array<double, 3>& gap) {
    if (!pulls_on(b)) return;
    for (std::size_t c = 0; c < 3; ++c) beyond_[n][c] = -gap[c];  // the gap is u_b - u* - s
  });
  aim();
}

TermForce Springs::force(const TrialState& state, grid::Vector& force) const {
  const base::Stage stage("springs");
  body_.kernels().spring_force(state.points, springs_.points, body_.halo().contributions());
  body_.halo().sum_to_owner(force);
  return {0, force.norm2()};
}

std::int64_t Springs::add_tangent(const TrialState& state,
                                  const transfer::BlockRows<Device>& rows) const {
  body_.kernels().spring_tangent(state.points, springs_.points, rows);
  return 0;
}

std::int64_t Springs::add_tangent(const TrialState& state,
                                  const transfer::StencilRows<Device>& rows) const {
  body_.kernels().spring_tangent(state.points, springs_.points, rows);
  return 0;
}

void Springs::add_tangent_times(const TrialState& state, const ConstNodeView& direction,
                                const NodeView& product) const {
  body_.kernels().spring_tangent_times(state.points, springs_.points, direction, product);
}

double Springs::stiffest_diagonal() const { return stiffest_springs(body_.problem()); }

void Springs::visit_held(const Pieces& pieces, const HeldVisitor& visit) const {
  visit_held_components(springs_, body_.problem(), body_.particles(), pieces, visit);
}

template <class Use>
void Springs::for_each_gap(const TrialState& state, const Use& use) const {
  const auto& points = springs_.points;
  const grid::NodeView gaps("gaps", points.point.extent(0));
  body_.kernels().boundary_gaps(state.points, points, gaps);
  const auto gap = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gaps);
  const auto point = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), points.point);
  for (std::size_t n = 0; n < point.extent(0); ++n)
    use(n, point(n), std::array<double, 3>{gap(n, 0), gap(n, 1), gap(n, 2)});
}

void Springs::add_reactions(const TrialState& state, PerCondition& of_conditions) const {
  PerCondition sums(of_conditions.size());
  for_each_gap(
      state, [&](std::size_t, const transfer::BoundaryPoint& b, const std::array<double, 3>& gap) {
        for (std::size_t c = 0; c < 3; ++c)
          sums[static_cast<std::size_t>(b.condition)][c] -= b.spring * gap[c];
      });
  if (sums.empty()) return;
  body_.halo().communicator().sum_all(sums.front().data(), 3 * sums.size());
  for (std::size_t m = 0; m < sums.size(); ++m)
    for (std::size_t c = 0; c < 3; ++c) of_conditions[m][c] += sums[m][c];
}

void Springs::add_torques(const TrialState& state, std::vector<double>& of_conditions) const {
  const Problem& problem = body_.problem();
  std::vector<double> sums(of_conditions.size());
  for_each_gap(state, [&](std::size_t n, const transfer::BoundaryPoint& b,
                          const std::array<double, 3>& gap) {
    const auto m = static_cast<std::size_t>(b.condition);
    const BoundaryCondition& condition = problem.conditions[m].second;
    if (!condition.rotation) return;
    std::array<double, 3> x = springs_.X[n];
    for (std::size_t c = 0; c < 3; ++c) x[c] += b.displacement[c] + gap[c];
    const auto lever = condition.lever(x, problem.body.origin, problem.body.lengths());
    for (std::size_t c = 0; c < 3; ++c) sums[m] -= b.spring * gap[c] * lever[c];
  });
  if (sums.empty()) return;
  body_.halo().communicator().sum_all(sums.data(), sums.size());
  for (std::size_t m = 0; m < sums.size(); ++m) of_conditions[m] += sums[m];
}

double Springs::support_energy(const TrialState& state) const {
  // Stiffness, then force, per component of each condition.
  std::vector<double> sums(6 * body_.problem().conditions.size());
  for_each_gap(
      state, [&](std::size_t, const transfer::BoundaryPoint& b, const std::array<double, 3>& gap) {
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t at = 6 * static_cast<std::size_t>(b.condition) + c;
          if (!(b.components >> c & 1) || pulls_on(b)) continue;
          sums[at] += b.spring;
          sums[at + 3] += b.spring * gap[c];
        }
      });
  body_.halo().communicator().sum_all(sums.data(), sums.size());
  double energy = 0.0;
  for (std::size_t at = 0; at < sums.size(); at += 6)
    for (std::size_t c = at; c < at + 3; ++c)
      if (sums[c] > 0.0) energy += 0.5 * sums[c + 3] * sums[c + 3] / sums[c];
  return energy;
}

}  // namespace stroma::mechanics
