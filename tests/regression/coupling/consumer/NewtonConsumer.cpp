// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// An application that lets Stroma's own Newton solve its body.

#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>

#include "Block.hpp"
#include "stroma/solver/NewtonSolver.hpp"

int main(int argc, char** argv) {
  using namespace stroma;
  Tpetra::ScopeGuard mpi_and_kokkos(&argc, &argv);
  const auto balance = consumer::make_block();

  solver::SolverParameters parameters;
  parameters.newton_tolerance = 1e-11;
  solver::NewtonSolver newton(parameters, *balance);
  grid::Vector u(balance->owned_map()), change(balance->owned_map());
  balance->set_load(1.0);
  balance->supports().impose(1.0, change);
  newton.predict(u, change);
  newton.solve(u);

  const double force = balance->reactions(u)[1][1];
  if (base::Communicator::world().is_root()) std::printf("reaction %.10g pN\n", force);
  return std::abs(force - consumer::expected_force) < 1e-8 * consumer::expected_force ? 0 : 1;
}
