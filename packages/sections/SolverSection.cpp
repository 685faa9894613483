// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/SolverSection.hpp"

#include <cmath>

#include "stroma/base/Log.hpp"
#include "stroma/sections/Ascending.hpp"
#include "stroma/sections/ValidLists.hpp"

namespace stroma::sections {

using namespace solver;

deck::Section<SolverParameters> solver_section() {
  deck::Section<SolverParameters> section("Solver", "Newton's method and its linear systems.");
  section.optional(
      "Newton Tolerance", &SolverParameters::newton_tolerance, deck::strictly_between(0.0, 1.0),
      "A step has converged when ||residual|| <= this * the largest ||reaction|| so far.");
  section.optional(
      "Newton Iterations", &SolverParameters::newton_iterations, deck::at_least(1),
      "Newton iterations after which a step is given up and tried again with half the load.");
  section.optional("Linear Tolerance", &SolverParameters::linear_tolerance,
                   deck::strictly_between(0.0, 1.0),
                   "Conjugate gradients stop at ||residual|| <= this * ||right-hand side||.");
  section.choice("Forcing", &SolverParameters::forcing,
                 {{"Adaptive", Forcing::adaptive}, {"Constant", Forcing::constant}},
                 "Adaptive: a Newton step is solved no better than its nonlinear error and the "
                 "Newton Tolerance are worth, at best to the Linear Tolerance; Constant: always to "
                 "the Linear Tolerance.");
  section.optional("Linear Iterations", &SolverParameters::linear_iterations, deck::at_least(1),
                   "Conjugate gradient iterations after which a linear solve is given up.");
  section.choice(
      "Preconditioner", &SolverParameters::preconditioner,
      {{"Geometric Multigrid", PreconditionerKind::geometric_multigrid},
       {"Multigrid", PreconditionerKind::multigrid},
       {"Jacobi", PreconditionerKind::jacobi},
       {"Chebyshev", PreconditionerKind::chebyshev},
       {"Direct", PreconditionerKind::direct}},
      "Geometric Multigrid: coarser grids of the grid itself, the least memory and time; "
      "Multigrid: MueLu's smoothed aggregation with rigid body modes, in double precision, for "
      "inclusions more than a million times stiffer than the gel; Jacobi and Chebyshev: Ifpack2; "
      "Direct: a factorisation "
      "(Amesos2, KLU2), for small problems.");
  section.free_list("NOX", &SolverParameters::nox,
                    "Settings for NOX, laid over Stroma's own (line search based Newton).",
                    check_nox);
  section.free_list("Belos", &SolverParameters::belos,
                    "Settings for Belos' conjugate gradients (pseudo block CG).", check_belos);
  section.free_list("Ifpack2", &SolverParameters::ifpack2,
                    "Settings for Ifpack2, with Preconditioner = Jacobi or Chebyshev.",
                    check_ifpack2);
  section.free_list("MueLu", &SolverParameters::muelu,
                    "Settings for MueLu, with Preconditioner = Multigrid.", check_muelu);
  section.check([](const SolverParameters& p, deck::Findings& findings) {
    const bool jacobi = p.preconditioner == PreconditionerKind::jacobi;
    const bool chebyshev = p.preconditioner == PreconditionerKind::chebyshev;
    if (p.ifpack2 != Teuchos::null && !jacobi && !chebyshev)
      findings.add("Ifpack2", "is used with Preconditioner = Jacobi or Chebyshev only");
    if (p.ifpack2 != Teuchos::null && (jacobi || chebyshev)) {
      const std::string used = jacobi ? "relaxation: " : "chebyshev: ";
      for (const auto& entry : *p.ifpack2)
        if (entry.first.compare(0, used.size(), used) != 0)
          findings.add("Ifpack2|" + entry.first, "is not used with Preconditioner = " +
                                                     std::string(jacobi ? "Jacobi" : "Chebyshev"));
    }
    if (p.muelu != Teuchos::null && p.preconditioner != PreconditionerKind::multigrid)
      findings.add("MueLu", "is used with Preconditioner = Multigrid only");
  });
  return section;
}

deck::Section<LoadingParameters> loading_section() {
  deck::Section<LoadingParameters> section("Loading", "How the load grows from nothing to full.");
  section.optional("Duration [s]", &LoadingParameters::duration, deck::positive(),
                   "Time at full load. Without it, and without Times [s], time is the load factor: "
                   "1 at full load.");
  section.optional(
      "Steps", &LoadingParameters::steps, deck::at_least(1),
      "Equal load steps; without it 10, or Times [s]. A step that fails is halved and grows back "
      "afterwards; multiples of 1 / Steps are always met.");
  section.optional("Times [s]", &LoadingParameters::times, deck::positive(),
                   "Ends of the steps, ascending, in the place of Steps; the last is the Duration "
                   "[s]. All are met, whatever steps are halved.");
  section.optional(
      "Smallest Step", &LoadingParameters::smallest_step, deck::strictly_between(0.0, 1.0),
      "Fraction of the full load below which steps are not halved; the run ends there.");
  section.check([](const LoadingParameters& p, deck::Findings& findings) {
    if (p.times && p.steps)
      findings.add("Times [s]", "given beside \"Steps\"; give one of the two");
    if (p.times && p.times->empty())
      findings.add("Times [s]", "an empty list; admissible: at least one time");
    if (!p.times && p.smallest_step > 1.0 / p.equal_steps())
      findings.add("Smallest Step", "is larger than a step, 1 / Steps");
    if (!p.times || p.times->empty()) return;
    const std::vector<double>& times = *p.times;
    refuse_descending("Times [s]", times, findings);
    if (p.duration && std::abs(*p.duration - times.back()) > 1e-9 * times.back())
      findings.add("Times [s]", base::format("end at %g s; admissible: at Duration [s], %g s",
                                             times.back(), *p.duration));
    double before = 0.0;
    for (const double time : times) {
      if (time > before && (time - before) / p.seconds() < p.smallest_step)
        findings.add("Smallest Step",
                     base::format("is larger than the step from %g to %g s", before, time));
      before = time;
    }
  });
  return section;
}

}  // namespace stroma::sections
