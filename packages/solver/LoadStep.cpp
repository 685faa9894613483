// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/LoadStep.hpp"

#include "stroma/base/ForeignError.hpp"

namespace stroma::solver {

void begin_step(mechanics::MovingBody& body, NewtonSolver& newton) {
  base::run_foreign(body.balance().halo().communicator(), [&] {
    if (body.begin_step()) newton.attach(body.balance());
  });
}

NewtonResult solve_step(mechanics::MovingBody& body, NewtonSolver& newton, double load,
                        grid::Vector& trial) {
  mechanics::MomentumBalance& balance = body.balance();
  balance.set_load(load);
  NewtonResult result;
  base::run_foreign(balance.halo().communicator(), [&] {
    if (const auto extrapolated = body.extrapolated(load)) {
      trial.assign(*extrapolated);
    } else {
      trial.assign(body.displacement());
      newton.predict(trial, balance.supports().change(load, trial));
    }
    balance.supports().impose(load, trial);
    result = newton.solve(trial);
  });
  return result;
}

}  // namespace stroma::solver
