// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Settings that packages of Trilinos refuse only when they are used: one message with the section,
/// exit status 2 from `check` and `run`, on any number of ranks.

#include <gtest/gtest.h>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

const fs::path cases = clone_folder() / "tests/data/cases/solver_lists";
const std::string muelu = "muelu_levels.yaml --set 'Solver|MueLu|max levels=3'";

void expect_refused(const std::string& deck, const std::string& settings,
                    const std::string& section, const std::vector<int>& ranks) {
  const TemporaryFolder folder;
  fs::copy(cases, folder.path(), fs::copy_options::recursive);
  for (const int n : ranks)
    for (const std::string command : {"check ", "run "}) {
      const Outcome outcome = run_stroma(folder.path(), command + deck + settings, n);
      const std::string what = command + deck + settings + " on " + std::to_string(n);
      EXPECT_EQ(outcome.status, 2) << what << "\n" << outcome.standard_error;
      EXPECT_NE(outcome.standard_error.find(section), std::string::npos) << what << "\n"
                                                                         << outcome.standard_error;
      for (const char* noise : {"MPI_ABORT", "terminate called", "Throw number", "Segmentation"})
        EXPECT_EQ((outcome.standard_error + outcome.standard_output).find(noise), std::string::npos)
            << what << "\n"
            << outcome.standard_error << outcome.standard_output;
    }
}

TEST(SolverLists, WhatPackagesRefuseIsRefusedBeforeTheRun) {
  expect_refused("ifpack2_degree.yaml", "", "Solver|Ifpack2", {1, 2});
  expect_refused("muelu_levels.yaml", "", "Solver|MueLu", {1, 2});
  expect_refused("nox_reduction.yaml", "", "Solver|NOX", {1, 2});
}

TEST(SolverLists, SoAreTheirTwins) {
  const std::string with_ifpack2 = "ifpack2_degree.yaml --set 'Solver|Ifpack2|chebyshev: degree=3'";
  const std::pair<std::string, std::string> settings[] = {
      {with_ifpack2, "Belos|Maximum Iterations=-1"},
      {with_ifpack2, "Belos|Residual Scaling=Nonsense"},
      {with_ifpack2, "Ifpack2|chebyshev: ratio eigenvalue=-1.0"},
      {with_ifpack2, "NOX|Line Search|Backtrack|Max Iters=-1"},
      {with_ifpack2, "NOX|Line Search|Backtrack|Default Step=-1.0"},
      {with_ifpack2, "NOX|Solver Options|Status Test Check Type=Nonsense"},
      {muelu, "MueLu|coarse: max size=-3"},
      {muelu, "MueLu|sa: damping factor=-10.0"},
      {muelu, "MueLu|smoother: type=NONSENSE"},
      {muelu, "MueLu|multigrid algorithm=nonsense"},
      {muelu, "MueLu|aggregation: type=nonsense"}};
  for (const auto& [deck, setting] : settings)
    expect_refused(deck, " --set 'Solver|" + setting + "'",
                   "Solver|" + setting.substr(0, setting.find('|')), {1});
}

/// Sets a parameter of MueLu's list.
std::string set(const std::string& name, const std::string& value) {
  return " --set 'Solver|MueLu|" + name + "=" + value + "'";
}

/// MueLu takes these words for others, or for nothing.
TEST(SolverLists, WhatMueLuOverlooksIsRefusedBeforeTheRun) {
  const std::string name = "Solver|MueLu|coarse: type: found \"Nope\"; known here: \"KLU2\"";
  expect_refused(muelu, set("coarse: type", "Nope"), name, {1, 2});
  expect_refused(muelu, set("coarse: type", "chebyshev"), "did you mean \"CHEBYSHEV\"?", {1});
  for (const char* word :
       {"smoother: type", "smoother: pre or post", "rap: algorithm", "parameterlist: syntax",
        "aggregation: classical scheme", "aggregation: coloring algorithm",
        "aggregation: distance laplacian algo", "emin: pattern", "emin: iterative method",
        "toggle: mode", "linedetection: orientation", "repartition: partitioner"})
    expect_refused(muelu, set(word, "Nope"), std::string("Solver|MueLu|") + word + ": found", {1});
  expect_refused(muelu, set("pcoarsen: element", "Nope"), "pcoarsen: element: no such parameter",
                 {1});
}

/// Parameters that the smoother in force does not read, or not with this value.
TEST(SolverLists, ParametersWithoutEffectOnASmootherAreRefused) {
  const std::string relaxation = set("smoother: type", "RELAXATION");
  const std::string smoother = "smoother: params", coarse = "coarse: params";
  const auto refused = [](const std::string& settings, const std::string& section,
                          const std::string& words) {
    expect_refused(muelu, settings, "Solver|MueLu|" + section + "|" + words, {1});
  };
  const auto type = smoother + "|relaxation: type", typo = smoother + "|relaxation: typo";
  expect_refused(muelu, set(type, "Nope"),
                 "Solver|MueLu|smoother: params|relaxation: type: has no effect on CHEBYSHEV",
                 {1, 2});
  refused(set(typo, "Jacobi"), smoother, "relaxation: typo: has no effect on CHEBYSHEV");
  refused(relaxation + set(type, "Nope"), smoother, "relaxation: type: found \"Nope\"");
  refused(relaxation + set(typo, "Jacobi"), smoother,
          "relaxation: typo: has no effect on RELAXATION; did you mean \"relaxation: type\"?");
  refused(set(smoother + "|chebyshev: degre", "3"), smoother,
          "chebyshev: degre: has no effect on CHEBYSHEV; did you mean \"chebyshev: degree\"?");
  refused(set(smoother + "|chebyshev: degree", "many"), smoother, "chebyshev: degree: CHEBYSHEV");
  refused(set(smoother + "|relaxation: sweeps", "3"), smoother,
          "relaxation: sweeps: has no effect");
  refused(set("smoother: type", "RILUK") + set(smoother + "|fact: ilut level-of-fill", "2.0"),
          smoother, "fact: ilut level-of-fill: has no effect on RILUK");
  refused(set("smoother: pre type", "CHEBYSHEV") + set("smoother: post type", "RELAXATION") +
              set("smoother: post params|chebyshev: degree", "3"),
          "smoother: post params", "chebyshev: degree: has no effect on RELAXATION");
  refused(set("coarse: type", "RELAXATION") + set(coarse + "|relaxation: type", "Nope"), coarse,
          "relaxation: type: found \"Nope\"");
  refused(set("coarse: type", "KLU2") + set(coarse + "|relaxation: type", "Jacobi"), coarse,
          "relaxation: type: has no effect on KLU2");
  expect_refused(muelu, set(coarse + "|chebyshev: degree", "3"),
                 "Solver|MueLu|coarse: params: needs \"coarse: type\"", {1, 2});
}

TEST(SolverLists, WhatSmoothersTakeIsTaken) {
  const std::string relaxation = set("smoother: type", "RELAXATION");
  const std::string settings[] = {
      set("smoother: params|chebyshev: degree", "3"),
      relaxation + set("smoother: params|relaxation: type", "Symmetric Gauss-Seidel") +
          set("smoother: params|relaxation: sweeps", "2"),
      relaxation,
      set("smoother: pre type", "RELAXATION") + set("smoother: post type", "RELAXATION"),
      set("smoother: type", "RILUK") + set("smoother: params|fact: iluk level-of-fill", "0"),
      set("smoother: type", "SCHWARZ") + set("smoother: params|subdomain solver name", "RILUK") +
          set("smoother: params|subdomain solver parameters|fact: iluk level-of-fill", "0"),
      set("coarse: type", "KLU2"),
      set("coarse: type", "RELAXATION") + set("coarse: params|relaxation: sweeps", "20")};
  for (const std::string& with : settings) {  // check solves on one rank, the run on two
    const TemporaryFolder folder;
    fs::copy(cases, folder.path(), fs::copy_options::recursive);
    const Outcome outcome = run_stroma(folder.path(), "run " + muelu + with, 2);
    EXPECT_EQ(outcome.status, 0) << with << "\n" << outcome.standard_error;
  }
}

TEST(SolverLists, WhatPackagesTakeIsTaken) {
  const TemporaryFolder folder;
  fs::copy(cases, folder.path(), fs::copy_options::recursive);
  for (const std::string arguments :
       {"ifpack2_degree.yaml --set 'Solver|Ifpack2|chebyshev: degree=3'",
        "muelu_levels.yaml --set 'Solver|MueLu|max levels=3'",
        "nox_reduction.yaml --set 'Solver|NOX|Line Search|Backtrack|Reduction Factor=0.3'"}) {
    const Outcome outcome = run_stroma(folder.path(), "check " + arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << "\n" << outcome.standard_error;
  }
}

}  // namespace
}  // namespace stroma::test
