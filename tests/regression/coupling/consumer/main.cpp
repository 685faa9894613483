// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A Trilinos application of its own that couples to Stroma: it makes a body from labels that it
/// holds itself, hands the balance of momentum to its own solver as a Thyra model, and reads the
/// reactions.

#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>

#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/particles/Seeding.hpp"
#include "stroma/solver/NewtonSolver.hpp"

int main(int argc, char** argv) {
  using namespace stroma;
  Tpetra::ScopeGuard mpi_and_kokkos(&argc, &argv);
  const auto world = base::Communicator::world();

  // The body: 4 x 4 x 4 elements of collagen, two voxels an element and direction.
  grid::Grid grid;
  grid.elements = {4, 4, 4};
  grid.spacing = {2.1, 2.1, 2.0};
  const image::LabelVolume labels(world, {8, 8, 8}, {1.05, 1.05, 1.0});
  const auto partition =
      grid::Partition::balanced(grid, world.size(), particles::layer_weights(world, grid, labels));
  particles::ParticleParameters layout;
  layout.layout = particles::Layout::gauss;
  const auto particles = particles::seed(world, layout, partition, labels, {{0, 0}});

  // Its supports: clamped below, pulled by 10 % above.
  mechanics::BoundaryCondition bottom, top;
  bottom.face = mechanics::Face::y_lower;
  bottom.components = "xyz";
  top.face = mechanics::Face::y_upper;
  top.components = "xyz";
  top.strain = 0.1;
  mechanics::MomentumBalance balance(world, partition, particles, {{520.8, 2430.4}},
                                     {{"bottom", bottom}, {"top", top}});

  solver::SolverParameters parameters;
  parameters.newton_tolerance = 1e-11;
  solver::NewtonSolver newton(parameters, balance);
  grid::Vector u(balance.owned_map()), change(balance.owned_map());
  balance.supports().impose(1.0, change);
  newton.predict(u, change);
  newton.solve(u);

  const double pull = balance.reactions(u)[1][1];
  // The same block solved by two unrelated finite element codes.
  const double expected = 10559.99691;
  if (world.is_root()) std::printf("reaction %.10g pN\n", pull);
  return std::abs(pull - expected) < 1e-8 * expected ? 0 : 1;
}
