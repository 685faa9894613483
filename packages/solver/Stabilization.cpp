// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/Stabilization.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/ForeignError.hpp"
#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/solver/NewtonSolver.hpp"

namespace stroma::solver {
namespace {

constexpr double bearable_share = 3e-4;         // of a body's stiffness
constexpr double least = 2e-6, largest = 1e-4;  // stabilization

/// A number of one digit, so that it does not tell how many ranks there were.
double rounded(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  return std::round(value / unit) * unit;
}

}  // namespace

std::optional<BearableStabilization> bearable_stabilization(const SolverParameters& parameters,
                                                            mechanics::MomentumBalance& balance,
                                                            double load) {
  const double now = balance.problem().method.stabilization, load_before = balance.load();
  if (now == 0.0 || mechanics::count_barely_filled(balance) == 0) return std::nullopt;
  std::optional<BearableStabilization> found;
  base::run_foreign(balance.halo().communicator(), [&] {
    balance.set_load(load);
    grid::Vector u(balance.owned_map());
    try {
      NewtonSolver newton(parameters, balance);
      newton.predict(u, balance.supports().change(load, u));
    } catch (const base::StepRejected&) {
      return;
    }
    const double added = mechanics::small_stabilization_share(balance, u);
    const double wanted = added > 0.0 ? now * bearable_share / added : largest;
    found = {added, rounded(std::clamp(wanted, least, largest))};
  });
  balance.set_load(load_before);
  return found;
}

}  // namespace stroma::solver
