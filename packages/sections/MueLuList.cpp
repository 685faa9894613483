// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What the list for MueLu may hold. MueLu knows its own names and types, but takes many a word
/// that it does not know for another, and leaves the parameters of smoothers to Ifpack2, most of
/// whose smoothers ignore what they do not know.

#include <Amesos2_Factory.hpp>
#include <Ifpack2_AdditiveSchwarz.hpp>
#include <Ifpack2_BlockRelaxation.hpp>
#include <Ifpack2_Factory.hpp>
#include <Ifpack2_Relaxation.hpp>
#include <MueLu_Amesos2Smoother.hpp>
#include <MueLu_MasterList.hpp>
#include <algorithm>
#include <functional>
#include <optional>

#include "stroma/base/ForeignError.hpp"
#include "stroma/deck/Nearest.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/sections/ValidLists.hpp"

namespace stroma::sections {
namespace {

using Names = std::vector<std::string>;
using Teuchos::ParameterList;
using Row = Tpetra::RowMatrix<double>;
using Smoother = Ifpack2::Preconditioner<double>;

Names names_of(const ParameterList& list) {
  Names names;
  for (const auto& entry : list) names.push_back(entry.first);
  return names;
}

/// MueLu's own list, and the words that it does not check, or checks only where it uses them. They
/// are what MueLu_ParameterListInterpreter_def.hpp (Trilinos 13.2, 16.1) and the _def.hpp of the
/// factory in the comment compare with.
ParameterList valid_muelu() {
  ParameterList valid(*MueLu::MasterList::List());
  const auto words = [&](const char* name, std::initializer_list<const char*> choices) {
    if (valid.isParameter(name)) valid.getEntry(name).setValidator(one_of(choices));
  };
  words("parameterlist: syntax", {"muelu"});
  words("use external multigrid package", {"none"});
  words("smoother: pre or post", {"pre", "post", "both", "none"});
  words("rap: algorithm", {"galerkin", "shift", "non-galerkin"});
  words("repartition: partitioner", {"zoltan", "zoltan2"});
  words("emin: pattern", {"AkPtent"});
  words("emin: iterative method", {"cg", "gmres", "sd"});  // EminPFactory
  words("aggregation: classical scheme",                   // ClassicalPFactory
        {"direct", "ext+i", "classical modified"});
  words("aggregation: classical algo", {"default", "unscaled cut", "scaled cut"});  // CoalesceDrop
  words("aggregation: distance laplacian algo",
        {"default", "unscaled cut", "scaled cut", "scaled cut symmetric"});
  words("aggregation: coloring algorithm",  // ClassicalMapFactory
        {"serial", "vertex based", "vertex based bit array", "vertex based color set",
         "vertex based deterministic", "vertex based deterministic bit array", "edge based"});
  words("aggregation: output file: agg style",  // AggregationExportFactory
        {"Point Cloud", "Jacks", "Jacks++", "Convex Hulls", "Alpha Hulls"});
  words("aggregate qualities: algorithm", {"forward", "reverse"});  // AggregateQualityEstimate
  words("aggregate qualities: mode", {"eigenvalue", "size", "both"});
  words("toggle: mode", {"semicoarsen"});                                          // ToggleP
  words("linedetection: orientation", {"vertical", "horizontal", "coordinates"});  // LineDetection
  // Without effect where there is no MATLAB, AmgX, structured grid or Maxwell's equations.
  for (const char* name :
       {"aggregation: params", "strength-of-connection: params", "transfer: params",
        "aggregation: mesh layout", "aggregation: output type", "aggregation: coarsening rate",
        "smoother: neighborhood type"})
    valid.remove(name, false);
  for (const std::string& name : names_of(valid))
    for (const std::string of : {"amgx:", "maxwell1: ", "refmaxwell: ", "pcoarsen: "})
      if (name.compare(0, of.size(), of) == 0) valid.remove(name);
  return valid;
}

bool is_smoother(const std::string& type) { return Ifpack2::Factory::isSupported<Row>(type); }

/// The smoothers to tell of; is_smoother knows more spellings.
Names smoothers() {
  Names names = {"CHEBYSHEV", "RELAXATION", "BLOCK_RELAXATION", "ILUT", "RILUK", "SCHWARZ"};
  names.erase(std::remove_if(names.begin(), names.end(), std::not_fn(is_smoother)), names.end());
  return names;
}

/// The smoothers that the coarsest grid may have: MueLu takes other names for those of direct
/// solvers (UpdateFactoryManager_CoarseSolvers).
Names coarse_smoothers() {
  Names names = smoothers();
  for (const char* name : {"BLOCK RELAXATION", "BLOCKRELAXATION", "SPARSE_BLOCK_RELAXATION",
                           "SPARSE BLOCK RELAXATION", "SPARSEBLOCKRELAXATION"})
    if (is_smoother(name)) names.push_back(name);
  return names;
}

/// The direct solvers to tell of: those of Amesos2_Factory.hpp that Trilinos was built with.
Names direct_solvers() {
  Names names;
  for (const char* name : {"KLU2", "Basker", "SuperLU", "SuperLU_DIST", "UMFPACK", "MUMPS",
                           "Cholmod", "PARDISO_MKL", "Tacho", "LAPACK"})
    if (Amesos2::query(name)) names.emplace_back(name);
  return names;
}

/// The parameters of a smoother, if it has a list of them.
std::optional<ParameterList> valid_list(const Smoother& smoother) {
  if (const auto* relaxation = dynamic_cast<const Ifpack2::Relaxation<Row>*>(&smoother))
    return *relaxation->getValidParameters();
  if (const auto* block = dynamic_cast<const Ifpack2::BlockRelaxation<Row>*>(&smoother))
    return *block->getValidParameters();
  if (const auto* schwarz = dynamic_cast<const Ifpack2::AdditiveSchwarz<Row>*>(&smoother))
    return *schwarz->getValidParameters();
  return std::nullopt;
}

std::string unknown(const std::string& word, const Names& known) {
  return "found \"" + word + "\"; " + deck::suggestion(word, known);
}

void find_no_effect(const std::string& name, const std::string& type, const Names& known,
                    deck::Findings& findings) {
  findings.add(name, "has no effect on " + type +
                         (known.empty() ? "" : "; " + deck::suggestion(name, known)));
}

/// Finds what of `params` is not in `valid`, the parameters of the smoother or solver in force, and
/// what these do not admit.
void check_against(const ParameterList& params, const std::string& type, const ParameterList& valid,
                   deck::Findings& findings) {
  ParameterList known;
  for (const std::string& name : names_of(params)) {
    if (valid.getEntryPtr(name) != nullptr)
      known.setEntry(name, params.getEntry(name));
    else
      find_no_effect(name, type, names_of(valid), findings);
  }
  check(known, valid, findings);
}

/// The names of what a smoother sets in a list that lacks it; not all do.
Names defaults_of(Smoother& smoother) {
  ParameterList list;
  try {
    smoother.setParameters(list);
  } catch (...) {  // it needs some
  }
  return names_of(list);
}

/// Names of Ifpack and ML, which CHEBYSHEV reads, and then takes what Stroma's list says under its
/// own names (Ifpack2_Details_Chebyshev_def.hpp).
bool overridden(const std::string& name) {
  for (const char* other : {"relaxation: sweeps", "smoother: sweeps", "smoother: Chebyshev alpha",
                            "eigen-analysis: iterations"})
    if (name == other) return true;
  return false;
}

/// For a smoother without a list of its parameters: each is given to it alone, and the list shows
/// whether it was read.
void refuse_unread(const ParameterList& params, const std::string& type, Smoother& smoother,
                   deck::Findings& findings) {
  const Names defaults = defaults_of(smoother);
  for (const std::string& name : names_of(params)) {
    if (overridden(name)) {
      find_no_effect(name, type, defaults, findings);
      continue;
    }
    Teuchos::ParameterEntry unread;
    unread.setAnyValue(params.getEntry(name).getAny(false));
    ParameterList alone;
    alone.setEntry(name, unread);
    try {
      smoother.setParameters(alone);
      if (!alone.getEntry(name).isUsed()) find_no_effect(name, type, defaults, findings);
    } catch (...) {
      findings.add(name, type + " refuses it: " + base::words_of_current_exception());
    }
  }
}

void check_smoother(const ParameterList& params, const std::string& type, deck::Findings& findings);

/// What works within the overlapping domains of SCHWARZ has one of these names (as
/// Ifpack2_AdditiveSchwarz_def.hpp reads them), and parameters of its own.
void check_inner(const ParameterList& params, ParameterList& valid, deck::Findings& findings) {
  const std::string parts[] = {"inner preconditioner", "subdomain solver",
                               "schwarz: inner preconditioner", "schwarz: subdomain solver"};
  std::string type = "RILUK";
  for (const std::string& part : parts) {
    valid.set(part + " name", type);
    valid.sublist(part + " parameters");
    if (!params.isType<std::string>(part + " name")) continue;
    type = params.get<std::string>(part + " name");
    if (!is_smoother(type)) return findings.add(part + " name", unknown(type, smoothers()));
  }
  for (const std::string& part : parts) {
    if (!params.isSublist(part + " parameters")) continue;
    deck::Findings inside = findings.below(part + " parameters");
    check_smoother(params.sublist(part + " parameters"), type, inside);
  }
}

/// Finds what has no effect on the smoother in force, and what it refuses.
void check_smoother(const ParameterList& params, const std::string& type,
                    deck::Findings& findings) {
  // A smoother needs no matrix to read its parameters.
  const auto smoother = Ifpack2::Factory::create<Row>(type, Teuchos::RCP<const Row>());
  auto valid = valid_list(*smoother);
  if (!valid) return refuse_unread(params, type, *smoother, findings);
  if (valid->isParameter("schwarz: overlap level")) check_inner(params, *valid, findings);
  check_against(params, type, *valid, findings);
}

/// \param stroma  the smoother that Stroma sets
std::string type_of(const ParameterList& list, const char* name, const std::string& stroma) {
  return list.isType<std::string>(name) ? list.get<std::string>(name) : stroma;
}

void check_smoothers(const ParameterList& list, deck::Findings& findings) {
  for (const char* name : {"smoother: type", "smoother: pre type", "smoother: post type"}) {
    const std::string type = type_of(list, name, "CHEBYSHEV");
    if (!is_smoother(type)) findings.add(name, unknown(type, smoothers()));
  }
  const std::string both = type_of(list, "smoother: type", "CHEBYSHEV");
  const std::string before = type_of(list, "smoother: pre type", both);
  const std::string after = type_of(list, "smoother: post type", both);
  const auto check_params = [&](const char* name, const std::string& type) {
    if (!list.isSublist(name) || !is_smoother(type)) return;
    deck::Findings inside = findings.below(name);
    check_smoother(list.sublist(name), type, inside);
  };
  check_params("smoother: params", before);
  if (after != before) check_params("smoother: params", after);
  check_params("smoother: pre params", before);
  check_params("smoother: post params", after);
}

/// MueLu's own list of what it takes beside the name of a direct solver.
ParameterList valid_direct(const std::string& type) {
  using Direct =
      MueLu::Amesos2Smoother<double, grid::LocalOrdinal, grid::GlobalOrdinal, grid::Map::node_type>;
  ParameterList valid(*Direct(type).GetValidParameterList());
  for (const char* factory : {"A", "Nullspace"}) valid.remove(factory, false);  // no settings
  return valid;
}

void check_coarse(const ParameterList& list, deck::Findings& findings) {
  const ParameterList none;
  const bool has_params = list.isSublist("coarse: params");
  const ParameterList& params = has_params ? list.sublist("coarse: params") : none;
  if (!list.isType<std::string>("coarse: type")) {
    if (has_params)
      findings.add("coarse: params",
                   "needs \"coarse: type\": without, the solver is a direct one on one rank and "
                   "CHEBYSHEV on several");
    return;
  }
  const auto type = list.get<std::string>("coarse: type");
  const Names admissible = coarse_smoothers();
  deck::Findings inside = findings.below("coarse: params");
  if (std::find(admissible.begin(), admissible.end(), type) != admissible.end()) {
    check_smoother(params, type, inside);
  } else if (type == "none") {
    check_against(params, type, none, inside);
  } else if (Amesos2::query(type)) {
    check_against(params, type, valid_direct(type), inside);
  } else {
    Names known = direct_solvers();
    for (const std::string& smoother : smoothers()) known.push_back(smoother);
    findings.add("coarse: type", unknown(type, known));
  }
}

}  // namespace

void check_muelu(const ParameterList& list, deck::Findings& findings) {
  check(list, valid_muelu(), findings);
  // MueLu crashes on none.
  if (list.isType<int>("max levels") && list.get<int>("max levels") == 0)
    findings.add("max levels", "found 0; admissible: at least 1");
  check_smoothers(list, findings);
  check_coarse(list, findings);
}

}  // namespace stroma::sections
