// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/SolverSection.hpp"

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

}  // namespace stroma::sections
