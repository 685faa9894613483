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
  const std::string with_muelu = "muelu_levels.yaml --set 'Solver|MueLu|max levels=3'";
  const std::pair<std::string, std::string> settings[] = {
      {with_ifpack2, "Belos|Maximum Iterations=-1"},
      {with_ifpack2, "Belos|Residual Scaling=Nonsense"},
      {with_ifpack2, "Ifpack2|chebyshev: ratio eigenvalue=-1.0"},
      {with_ifpack2, "NOX|Line Search|Backtrack|Max Iters=-1"},
      {with_ifpack2, "NOX|Line Search|Backtrack|Default Step=-1.0"},
      {with_ifpack2, "NOX|Solver Options|Status Test Check Type=Nonsense"},
      {with_muelu, "MueLu|coarse: max size=-3"},
      {with_muelu, "MueLu|sa: damping factor=-10.0"},
      {with_muelu, "MueLu|smoother: type=NONSENSE"},
      {with_muelu, "MueLu|multigrid algorithm=nonsense"},
      {with_muelu, "MueLu|aggregation: type=nonsense"}};
  for (const auto& [deck, setting] : settings)
    expect_refused(deck, " --set 'Solver|" + setting + "'",
                   "Solver|" + setting.substr(0, setting.find('|')), {1});
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
