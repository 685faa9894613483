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

/// Solves; springs that pull on do so between Newton iterations, until faces are where conditions
/// want them, or as often as makes them as good as stiff ones: what they hardly feel of a face comes
/// slowly.
NewtonResult solve_pulling(mechanics::MomentumBalance& balance, NewtonSolver& newton,
                           grid::Vector& trial) {
  constexpr double enough = 1e-3;  // of the forces: what springs may miss, and residuals on the way
  constexpr int most_pulls = 8;
  if (!balance.has_springs_that_pull_on()) return newton.solve(trial);
  NewtonResult before;
  for (int pulls = 0; pulls == 0 || (pulls <= most_pulls && balance.pull_on(trial, enough));
       ++pulls) {
    const NewtonResult on_the_way = newton.solve(trial, enough);
    before.iterations += on_the_way.iterations;
    before.linear_iterations += on_the_way.linear_iterations;
  }
  NewtonResult result = newton.solve(trial);
  result.iterations += before.iterations;
  result.linear_iterations += before.linear_iterations;
  return result;
}

/// A step of a body with inertia: solved where the scheme has the balance, and brought to its end.
NewtonResult solve_time_step(mechanics::MovingBody& body, NewtonSolver& newton, double load,
                             grid::Vector& trial) {
  mechanics::MomentumBalance& balance = body.balance();
  const mechanics::Inertia& inertia = *balance.inertia();
  const double at = inertia.balance_load(load);
  balance.go_straight({body.motion().load, load});
  balance.set_load(at);
  if (const auto predicted = body.predicted(at)) {
    trial.assign(*predicted);
  } else {
    trial.assign(body.displacement());
    newton.predict(trial, balance.supports().change(at, trial));
  }
  balance.supports().impose(at, trial);
  NewtonResult result = solve_pulling(balance, newton, trial);
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
    balance.begin_pulling(body.displacement());
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
    result = solve_pulling(balance, newton, trial);
  });
  return result;
}

}  // namespace stroma::solver
