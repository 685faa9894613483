#include "solver/Advice.hpp"

#include <algorithm>

#include "base/Log.hpp"

namespace stroma::solver {

using base::format;

Circumstances circumstances(const SolverParameters& parameters,
                            const mechanics::MomentumBalance& balance) {
  const mechanics::Problem& problem = balance.problem();
  Circumstances known;
  known.preconditioner = parameters.preconditioner;
  double softest = problem.laws.front().shear_modulus, stiffest = softest;
  for (const material::NeoHookean& law : problem.laws) {
    const double K = law.bulk_modulus, mu = law.shear_modulus;
    softest = std::min(softest, mu);
    stiffest = std::max(stiffest, mu);
    known.largest_poisson_ratio =
        std::max(known.largest_poisson_ratio, (3.0 * K - 2.0 * mu) / (6.0 * K + 2.0 * mu));
  }
  known.contrast = stiffest / softest;
  known.has_pointwise_dilatation = problem.dilatation == grid::Dilatation::pointwise;
  known.barely_filled = balance.barely_filled();
  known.stabilization = problem.stabilization;
  const mechanics::Supports& supports = balance.supports();
  known.pieces = supports.pieces().count - supports.pieces().carried;
  known.has_free_motion = !supports.rigid_holds().empty();
  return known;
}

std::vector<std::string> advice(const Circumstances& known) {
  std::vector<std::string> all;
  if (known.barely_filled > 0.0)
    all.push_back(format(
        "%.2g %% of the elements are filled by less than half: %s", 100.0 * known.barely_filled,
        known.stabilization > 0.0 ? "a larger Grid|Stabilization, or smaller elements"
                                  : "Grid|Stabilization = 1e-4"));
  if (known.contrast > high_contrast && known.preconditioner != PreconditionerKind::multigrid &&
      known.preconditioner != PreconditionerKind::direct)
    all.push_back(format(
        "the stiffest material is %.2g times stiffer than the softest: Solver|Preconditioner = "
        "Multigrid, or Direct for a small problem",
        known.contrast));
  if (known.largest_poisson_ratio > 0.45 && known.has_pointwise_dilatation)
    all.push_back(
        format("a Poisson ratio of %.6g with a pointwise dilatation: Grid|Dilatation = "
               "Element Mean",
               known.largest_poisson_ratio));
  if (known.has_free_motion)
    all.push_back("the conditions leave a rigid motion free: a support that holds it");
  if (known.pieces > 1)
    all.push_back(
        format("%lld pieces of the body carry load, each for itself: a support for each, "
               "or a body in one piece",
               static_cast<long long>(known.pieces)));
  all.push_back("a smaller load, a smaller Loading|Smallest Step, or a finer grid there");
  return all;
}

}  // namespace stroma::solver
