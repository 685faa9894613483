// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/DeadForces.hpp"

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

DeadForces::DeadForces(const Body& body)
    : at_full_load_(Teuchos::rcp(new grid::Vector(body.halo().owned_map()))) {
  const Problem& problem = body.problem();
  const grid::Vector at_rest(body.halo().owned_map());
  const auto forces = grid::to_device(
      "forces", volume_forces(problem.forces, problem.body, problem.outer_thickness));
  body.kernels().external_force(body.points(at_rest), forces, body.density(),
                                body_force_at(problem.body_force, body.particles()),
                                body.halo().contributions());
  body.halo().sum_to_owner(*at_full_load_);
  size_at_full_load_ = at_full_load_->norm2();
}

TermForce DeadForces::force(const TrialState&, grid::Vector& force) const {
  force.update(-load_, *at_full_load_, 0.0);
  return {0, std::abs(load_) * size_at_full_load_};
}

}  // namespace stroma::mechanics
