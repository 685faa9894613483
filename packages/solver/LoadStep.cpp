#include "solver/LoadStep.hpp"

namespace stroma::solver {

void begin_step(mechanics::MovingBody& body, NewtonSolver& newton) {
  if (body.begin_step()) newton.attach(body.balance());
}

NewtonResult solve_step(mechanics::MovingBody& body, NewtonSolver& newton, double load,
                        grid::Vector& trial) {
  mechanics::MomentumBalance& balance = body.balance();
  balance.set_load(load);
  if (const auto extrapolated = body.extrapolated(load)) {
    trial.assign(*extrapolated);
  } else {
    trial.assign(body.displacement());
    newton.predict(trial, balance.supports().change(load, trial));
  }
  balance.supports().impose(load, trial);
  return newton.solve(trial);
}

}  // namespace stroma::solver
