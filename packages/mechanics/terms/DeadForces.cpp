// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/DeadForces.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/grid/ToDevice.hpp"
#include "stroma/particles/UndeformedPositions.hpp"

namespace stroma::mechanics {
namespace {

/// A force per reference volume at each particle [pN/um^3]; empty without one.
transfer::ForceAtParticles<grid::Device> body_force_at(
    const decltype(Problem::body_force)& body_force,
    const particles::Particles<grid::Device>& particles) {
  if (!body_force) return {};
  const auto X = particles::undeformed_positions(particles);
  const Kokkos::View<double* [3], Kokkos::LayoutRight, grid::Device> force("body force", X.size());
  const auto on_host = Kokkos::create_mirror_view(force);
  for (int p = 0; p < particles.count(); ++p) {
    const auto b = body_force(X[static_cast<std::size_t>(p)]);
    for (int c = 0; c < 3; ++c) on_host(p, c) = b[static_cast<std::size_t>(c)];
  }
  Kokkos::deep_copy(force, on_host);
  return force;
}

}  // namespace

bool has_dead_forces(const Problem& problem) {
  return !problem.forces.empty() || problem.body_force;
}

DeadForces::DeadForces(const Body& body) {
  const Problem& problem = body.problem();
  std::vector<LoadCurve> curves;
  if (problem.body_force) curves.emplace_back();
  for (const auto& named : problem.forces)
    if (std::find(curves.begin(), curves.end(), named.second.curve) == curves.end())
      curves.push_back(named.second.curve);
  const grid::Vector at_rest(body.halo().owned_map());
  for (const LoadCurve& curve : curves) {
    NamedForces together;
    for (const auto& named : problem.forces)
      if (named.second.curve == curve) together.push_back(named);
    const auto forces =
        grid::to_device("forces", volume_forces(together, problem.body, problem.outer_thickness));
    const auto of_points = curve.is_load() ? body_force_at(problem.body_force, body.particles())
                                           : transfer::ForceAtParticles<grid::Device>{};
    const auto full = Teuchos::rcp(new grid::Vector(body.halo().owned_map()));
    body.kernels().external_force(body.points(at_rest), forces, body.density(), of_points,
                                  body.halo().contributions());
    body.halo().sum_to_owner(*full);
    groups_.push_back({curve, full, full->norm2()});
  }
}

TermForce DeadForces::force(const TrialState&, grid::Vector& force) const {
  TermForce all;
  force.putScalar(0.0);
  for (const Group& group : groups_) {
    const double factor = group.curve.at(load_);
    force.update(-factor, *group.full, 1.0);
    all.size += std::abs(factor) * group.size;
  }
  return all;
}

namespace {

/// Load factors at which curves tell each other apart: their points, the middles between these, and
/// some more for curves that repeat.
std::vector<double> telling_loads(const std::vector<double>& of_points) {
  std::vector<double> loads{1.0};
  constexpr int even = 64;
  for (int n = 1; n < even; ++n) loads.push_back(static_cast<double>(n) / even);
  for (const double load : of_points)
    if (load > 0.0 && load < 1.0) loads.push_back(load);
  std::sort(loads.begin(), loads.end());
  const std::size_t points = loads.size();
  for (std::size_t n = 0; n + 1 < points; ++n) loads.push_back(0.5 * (loads[n] + loads[n + 1]));
  return loads;
}

}  // namespace

/// Forces of one curve are told at their full size. Of several, a sum over load factors with weights
/// that nothing else has: it is balanced if, but for an accident, those of each load factor are.
std::vector<grid::RCP<const grid::Vector>> DeadForces::dead_loads() const {
  std::vector<grid::RCP<const grid::Vector>> all;
  if (groups_.size() == 1) return {groups_.front().full};
  std::vector<double> points;
  for (const Group& group : groups_)
    points.insert(points.end(), group.curve.loads.begin(), group.curve.loads.end());
  const std::vector<double> loads = telling_loads(points);
  for (const Group& group : groups_) {
    double factor = 0.0;
    for (std::size_t n = 0; n < loads.size(); ++n) {
      const double golden = 0.6180339887498949 * static_cast<double>(n + 1);
      const double weight = 0.5 + (golden - std::floor(golden));
      factor += weight * group.curve.at(loads[n]) / static_cast<double>(loads.size());
    }
    const auto weighted = Teuchos::rcp(new grid::Vector(group.full->getMap()));
    weighted->update(factor, *group.full, 0.0);
    all.push_back(weighted);
  }
  return all;
}

}  // namespace stroma::mechanics
