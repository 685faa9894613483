// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/LoadStep.hpp"

#include "stroma/base/Error.hpp"
#include "stroma/base/ForeignError.hpp"

namespace stroma::solver {

void begin_step(mechanics::MovingBody& body, NewtonSolver& newton) {
  base::run_foreign(body.balance().halo().communicator(), [&] {
    if (body.begin_step()) newton.attach(body.balance());
  });
}

namespace {

/// A step of a body with inertia: solved where the scheme has the balance, and brought to its end.
NewtonResult solve_time_step(mechanics::MovingBody& body, NewtonSolver& newton, double load,
                             grid::Vector& trial) {
  mechanics::MomentumBalance& balance = body.balance();
  const mechanics::Inertia& inertia = *balance.inertia();
  const double at = inertia.balance_load(load);
  balance.set_load(at);
  if (const auto predicted = body.predicted(at)) {
    trial.assign(*predicted);
  } else {
    trial.assign(body.displacement());
    newton.predict(trial, balance.supports().change(at, trial));
  }
  balance.supports().impose(at, trial);
  NewtonResult result = newton.solve(trial);
  if (at != load) {
    inertia.go_to_end(trial);
    balance.set_load(load);
    balance.supports().impose(load, trial);
    if (balance.forces(trial).inverted > 0)
      throw base::StepRejected("particles are turned inside out at the end of the step");
  }
  result.time_error = inertia.step_error(load, trial);
  return result;
}

}  // namespace

NewtonResult solve_step(mechanics::MovingBody& body, NewtonSolver& newton, double load,
                        grid::Vector& trial) {
  mechanics::MomentumBalance& balance = body.balance();
  NewtonResult result;
  base::run_foreign(balance.halo().communicator(), [&] {
    if (balance.inertia() != nullptr) {
      result = solve_time_step(body, newton, load, trial);
      return;
    }
    balance.set_load(load);
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
