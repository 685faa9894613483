// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/BoundaryPoints.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/grid/ToDevice.hpp"
#include "stroma/particles/UndeformedPositions.hpp"

namespace stroma::mechanics {
namespace {

using transfer::BoundaryPoint;
using Vector = std::array<double, 3>;

template <class View>
auto on_host(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

/// What makes the boundary points of one particle.
class BoundaryPointMaker {
 public:
  explicit BoundaryPointMaker(const Problem& problem)
      : problem_(problem), body_(problem.body), length_(problem.body.lengths()) {}

  /// Appends the points of a particle that lay at X in the undeformed body.
  void add(int particle, const Vector& X, double volume, std::vector<BoundaryPoint>& points,
           std::vector<Vector>& at) const {
    const std::size_t first = points.size();
    for (std::size_t m = 0; m < problem_.conditions.size(); ++m) {
      const BoundaryCondition& condition = problem_.conditions[m].second;
      if (problem_.imposed_by(condition) != ImposedBy::penalty) continue;
      for (int face = 0; face < 6; ++face)
        if (condition.applies_to(static_cast<Face>(face)))
          add(particle, X, volume, static_cast<int>(m), static_cast<Face>(face), points, at);
    }
    for (std::size_t a = first; a < points.size(); ++a)
      for (std::size_t b = a + 1; b < points.size(); ++b) check_edge(X, points[a], points[b]);
  }

 private:
  void add(int particle, const Vector& X, double volume, int m, Face face,
           std::vector<BoundaryPoint>& points, std::vector<Vector>& at) const {
    const BoundaryCondition& condition = problem_.conditions[static_cast<std::size_t>(m)].second;
    const int axis = axis_of(face);
    const auto d = static_cast<std::size_t>(axis);
    const double thickness = problem_.outer_thickness[d];
    const double outwards = body_.origin[d] + (is_upper(face) ? body_.length(axis) : 0.0) - X[d];
    if (!(std::abs(outwards) <= thickness)) return;
    BoundaryPoint point{};
    point.particle = particle;
    point.condition = m;
    point.spring = problem_.spring_stiffness(condition, axis) * volume / thickness;
    point.offset[axis] = outwards;
    for (int c = 0; c < 3; ++c)
      // In plane strain Supports holds z, at every node of the body.
      if (condition.prescribes(c) && !(body_.flat && c == 2)) point.components |= 1 << c;
    if (point.components == 0) return;
    points.push_back(point);
    at.push_back(X);
    at.back()[d] += outwards;
  }

  /// Two conditions whose faces meet at an edge must agree there.
  void check_edge(const Vector& X, const BoundaryPoint& a, const BoundaryPoint& b) const {
    Vector edge = X;
    for (std::size_t d = 0; d < 3; ++d) edge[d] += a.offset[d] + b.offset[d];
    const auto& first = problem_.conditions[static_cast<std::size_t>(a.condition)];
    const auto& second = problem_.conditions[static_cast<std::size_t>(b.condition)];
    for (int c = 0; c < 3; ++c) {
      if (!(a.components & b.components & 1 << c)) continue;
      if (const auto found =
              disagreement({first.second, edge}, {second.second, edge}, c, body_.origin, length_))
        throw base::InputError(conflict(first.first, second.first, c, edge, *found));
    }
  }

  const Problem& problem_;
  const grid::Grid& body_;
  Vector length_;
};

}  // namespace

void BoundaryPoints::set_load(const Problem& problem, double load, const StraightStep& step,
                              const std::vector<Vector>& beyond) {
  const Vector length = problem.body.lengths();
  const auto point = on_host(writable);
  for (std::size_t n = 0; n < X.size(); ++n) {
    const BoundaryCondition& condition =
        problem.conditions[static_cast<std::size_t>(point(n).condition)].second;
    for (int c = 0; c < 3; ++c)
      if (point(n).components >> c & 1)
        point(n).displacement[c] = step.on_the_line(load, [&](double at) {
          return condition.value(c, X[n], problem.body.origin, length, at);
        }) + (beyond.empty() ? 0.0 : beyond[n][static_cast<std::size_t>(c)]);
  }
  Kokkos::deep_copy(writable, point);
}

BoundaryPoints boundary_points(const base::Communicator& communicator, const Problem& problem,
                               const particles::Particles<grid::Device>& particles) {
  const auto is_penalty = [&](const auto& named) {
    return problem.imposed_by(named.second) == ImposedBy::penalty;
  };
  const auto& conditions = problem.conditions;
  const auto X = particles::undeformed_positions(particles);
  const auto volume = on_host(particles.volume);
  const auto of_element = on_host(particles.element_begin);
  std::vector<BoundaryPoint> points;
  BoundaryPoints made;
  std::vector<int> begin{0};
  base::collectively(communicator, [&] {
    const BoundaryPointMaker maker(problem);
    for (std::size_t e = 0; e + 1 < of_element.extent(0); ++e) {
      for (int p = of_element(e); p < of_element(e + 1); ++p)
        maker.add(p, X[static_cast<std::size_t>(p)], volume(p), points, made.X);
      begin.push_back(static_cast<int>(points.size()));
    }
  });
  for (std::size_t m = 0; m < conditions.size(); ++m) {
    const auto found = std::count_if(points.begin(), points.end(), [&](const BoundaryPoint& b) {
      return b.condition == static_cast<int>(m);
    });
    if (is_penalty(conditions[m]) && communicator.sum(static_cast<std::int64_t>(found)) == 0)
      throw base::InputError(no_particle_at("Boundary Conditions|" + conditions[m].first));
  }
  made.writable = decltype(made.writable)("boundary points", points.size());
  const auto host = Kokkos::create_mirror_view(made.writable);
  std::copy(points.begin(), points.end(), host.data());
  Kokkos::deep_copy(made.writable, host);
  made.points.point = made.writable;
  made.points.element_begin = grid::to_device("boundary points of elements", begin);
  made.set_load(problem, 0.0);
  return made;
}

double stiffest_springs(const Problem& problem) {
  double stiffest = 0.0;
  for (const auto& named : problem.conditions)
    for (int face = 0; face < 6; ++face) {
      const int axis = axis_of(static_cast<Face>(face));
      if (problem.imposed_by(named.second) != ImposedBy::penalty ||
          !named.second.applies_to(static_cast<Face>(face)))
        continue;
      const auto& h = problem.body.spacing;
      const double area = h[0] * h[1] * h[2] / h[static_cast<std::size_t>(axis)];
      stiffest = std::max(stiffest, problem.spring_stiffness(named.second, axis) * area);
    }
  return stiffest;
}

void visit_held_components(const BoundaryPoints& boundary, const Problem& problem,
                           const particles::Particles<grid::Device>& particles,
                           const Pieces& pieces, const HeldVisitor& visit) {
  const Vector length = problem.body.lengths();
  const auto point = on_host(boundary.points.point);
  const auto begin = on_host(boundary.points.element_begin);
  const auto x = on_host(particles.position);
  for (std::size_t e = 0; e + 1 < begin.extent(0); ++e)
    for (int n = begin(e); n < begin(e + 1); ++n) {
      const BoundaryPoint& b = point(n);
      const BoundaryCondition& condition =
          problem.conditions[static_cast<std::size_t>(b.condition)].second;
      NodeComponent held{-1, {}, 0};
      for (int d = 0; d < 3; ++d)
        held.position[static_cast<std::size_t>(d)] = x(b.particle, d) + b.offset[d];
      for (held.component = 0; held.component < 3; ++held.component)
        if (b.components >> held.component & 1)
          visit({pieces.of_element(static_cast<std::int64_t>(e)), held, b.condition,
                 condition.direction(held.component, boundary.X[static_cast<std::size_t>(n)],
                                     problem.body.origin, length),
                 !condition.is_linear()});
    }
}

}  // namespace stroma::mechanics
