// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/ValidLists.hpp"

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_StandardParameterEntryValidators.hpp>

#include "stroma/base/Log.hpp"
#include "stroma/deck/FreeList.hpp"
#include "stroma/grid/Types.hpp"

namespace stroma::sections {
namespace {

Teuchos::ParameterList valid_nox() {
  Teuchos::ParameterList valid;
  valid.set("Nonlinear Solver", "Line Search Based", "", one_of({"Line Search Based"}));

  auto& direction = valid.sublist("Direction");
  direction.set("Method", "Newton", "", one_of({"Newton"}));
  auto& newton = direction.sublist("Newton");
  newton.set("Forcing Term Method", "Constant", "", one_of({"Constant", "Type 1", "Type 2"}));
  for (const char* name :
       {"Forcing Term Initial Tolerance", "Forcing Term Minimum Tolerance",
        "Forcing Term Maximum Tolerance", "Forcing Term Alpha", "Forcing Term Gamma"})
    newton.set(name, 0.1);
  newton.set("Rescue Bad Newton Solve", true);
  newton.sublist("Linear Solver").set("Tolerance", 1e-6);

  auto& search = valid.sublist("Line Search");
  search.set("Method", "Backtrack", "", one_of({"Backtrack", "Full Step", "Polynomial"}));
  search.sublist("Full Step").set("Full Step", 1.0);
  auto& backtrack = search.sublist("Backtrack");
  auto& polynomial = search.sublist("Polynomial");
  for (auto* list : {&backtrack, &polynomial}) {
    for (const char* name : {"Default Step", "Minimum Step", "Recovery Step"}) list->set(name, 1.0);
    list->set("Max Iters", 100);
  }
  backtrack.set("Reduction Factor", 0.5);
  polynomial.set("Interpolation Type", "Cubic", "", one_of({"Cubic", "Quadratic", "Quadratic3"}));
  polynomial.set("Sufficient Decrease Condition", "Armijo-Goldstein", "",
                 one_of({"Armijo-Goldstein", "Ared/Pred", "None"}));
  polynomial.set("Recovery Step Type", "Constant", "", one_of({"Constant", "Last Computed Step"}));
  for (const char* name : {"Min Bounds Factor", "Max Bounds Factor", "Alpha Factor"})
    polynomial.set(name, 1.0);
  for (const char* name : {"Force Interpolation", "Use Counters"}) polynomial.set(name, false);
  polynomial.set("Maximum Iteration for Increase", 0);
  polynomial.set("Allowed Relative Increase", 100.0);

  valid.sublist("Solver Options").set("Status Test Check Type", "Minimal");
  auto& printing = valid.sublist("Printing");
  printing.set("Output Information", 0);
  printing.set("Output Precision", 3);
  return valid;
}

Teuchos::ParameterList valid_ifpack2() {
  Teuchos::ParameterList valid;
  valid.set("relaxation: type", "Jacobi", "", one_of({"Jacobi", "Symmetric Gauss-Seidel"}));
  valid.set("relaxation: sweeps", 1);
  valid.set("relaxation: damping factor", 1.0);
  valid.set("relaxation: min diagonal value", 0.0);
  valid.set("relaxation: use l1", false);
  valid.set("chebyshev: degree", 1);
  for (const char* name :
       {"chebyshev: max eigenvalue", "chebyshev: min eigenvalue", "chebyshev: ratio eigenvalue",
        "chebyshev: boost factor", "chebyshev: min diagonal value"})
    valid.set(name, 1.0);
  valid.set("chebyshev: eigenvalue max iterations", 10);
  valid.set("chebyshev: zero starting solution", true);
  return valid;
}

/// A number may not be negative where the package's own default is not: the packages take negative
/// counts, steps and tolerances, and then do not end, or crash.
void refuse_negative(const Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
                     deck::Findings& findings) {
  const auto number = [](const Teuchos::ParameterEntry& entry) {
    if (entry.isType<int>()) return static_cast<double>(Teuchos::getValue<int>(entry));
    return entry.isType<double>() ? Teuchos::getValue<double>(entry) : 0.0;
  };
  for (auto entry = list.begin(); entry != list.end(); ++entry) {
    const std::string& name = list.name(entry);
    const Teuchos::ParameterEntry* allowed = valid.getEntryPtr(name);
    if (allowed == nullptr) continue;
    if (list.entry(entry).isList() && allowed->isList()) {
      deck::Findings inside = findings.below(name);
      refuse_negative(list.sublist(name), valid.sublist(name), inside);
    } else if (number(list.entry(entry)) < 0.0 && number(*allowed) >= 0.0) {
      findings.add(name,
                   base::format("found %g; admissible: at least 0", number(list.entry(entry))));
    }
  }
}

}  // namespace

Teuchos::RCP<const Teuchos::ParameterEntryValidator> one_of(
    std::initializer_list<const char*> choices) {
  Teuchos::Array<std::string> strings(choices.begin(), choices.end());
  return Teuchos::rcp(new Teuchos::StringValidator(strings));
}

void check(const Teuchos::ParameterList& list, const Teuchos::ParameterList& valid,
           deck::Findings& findings) {
  deck::refuse_unknown(list, valid, findings);
  refuse_negative(list, valid, findings);
}

void check_nox(const Teuchos::ParameterList& list, deck::Findings& findings) {
  check(list, valid_nox(), findings);
}

void check_belos(const Teuchos::ParameterList& list, deck::Findings& findings) {
  using Operator = Tpetra::Operator<double>;
  const Belos::PseudoBlockCGSolMgr<double, grid::MultiVector, Operator> manager;
  check(list, *manager.getValidParameters(), findings);
}

void check_ifpack2(const Teuchos::ParameterList& list, deck::Findings& findings) {
  check(list, valid_ifpack2(), findings);
}

}  // namespace stroma::sections
