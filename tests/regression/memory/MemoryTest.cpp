// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What a run would take is known, and refused where there is less, before anything is allocated;
/// and it is what runs do take.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "stroma/base/Memory.hpp"
#include "support/Places.hpp"
#include "support/Program.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

const fs::path deck = clone_folder() / "tests" / "data" / "cases" / "memory" / "long.yaml";

/// Bytes of "1.5 GiB" or "300 MiB" behind some words of a text; NaN without them.
double bytes_behind(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  if (at == std::string::npos) return NAN;
  std::istringstream rest(text.substr(at + words.size()));
  double value = NAN;
  std::string unit;
  rest >> value >> unit;
  return value * (unit.rfind("GiB", 0) == 0 ? 1024.0 : 1.0) * 1024.0 * 1024.0;
}

void expect_refused(const Outcome& outcome) {
  EXPECT_EQ(outcome.status, 2) << outcome.standard_output << outcome.standard_error;
  EXPECT_NE(outcome.standard_error.find("needs"), std::string::npos) << outcome.standard_error;
  EXPECT_NE(outcome.standard_error.find("take coarser elements"), std::string::npos)
      << outcome.standard_error;
  EXPECT_EQ(outcome.standard_error.find("Kokkos"), std::string::npos) << outcome.standard_error;
}

const char* const excessive[] = {
    "--set 'Particles|Layout=Per Element' --set 'Particles|Per Element=64'",
    "--set 'Grid|Element Size [um]=[0.00105,0.00105,0.001]'",
    "--set 'Grid|Element Size [um]=[1e-7,1e-7,1e-7]'",
    "--set 'Image|Phantom|Size=[8000,8000,8000]'",
    "--set 'Particles|Per Voxel=16' --set 'Image|Phantom|Size=[512,512,64]'"};

TEST(Memory, TooLargeADeckIsRefusedAtOnce) {
  const TemporaryFolder folder;
  for (const char* overrides : excessive)
    for (const std::string command : {"check", "run"})
      for (const int ranks : {1, 2}) {
        SCOPED_TRACE(command + " " + overrides + ", ranks " + std::to_string(ranks));
        const auto start = std::chrono::steady_clock::now();
        expect_refused(
            run_stroma(folder.path(), command + " " + quoted(deck) + " " + overrides, ranks));
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
      }
  EXPECT_TRUE(fs::is_empty(folder.path())) << "nothing was run";
}

// The address space of a rank: more than the program alone maps, less than this deck needs.
TEST(Memory, ALimitOfTheAddressSpaceCounts) {
  const TemporaryFolder folder;
  const fs::path limited = folder.write(
      "limited.sh", "#!/bin/sh\nulimit -v 3000000\nexec " + quoted(stroma_program()) + " \"$@\"\n");
  fs::permissions(limited, fs::perms::owner_all);
  const auto run = [&](const std::string& size) {
    return run_program(limited, folder.path(),
                       "check " + quoted(deck) +
                           " --set 'Solver|Preconditioner=Multigrid' --set "
                           "'Image|Phantom|Size=" +
                           size + "'",
                       1, threads_of_test());
  };
  EXPECT_EQ(run("[16,16,16]").status, 0);
  const Outcome outcome = run("[192,192,192]");
  expect_refused(outcome);
  EXPECT_NE(outcome.standard_error.find("ulimit -v"), std::string::npos) << outcome.standard_error;
}

struct Kind {
  const char* name;
  const char* overrides;
  int steps = 1;
};

const Kind kinds[] = {
    {"linear, geometric multigrid", "--set 'Image|Phantom|Size=[128,128,48]'"},
    {"many particles", "--set 'Image|Phantom|Size=[32,32,32]' --set 'Particles|Per Voxel=5'"},
    {"GIMP", "--set 'Image|Phantom|Size=[40,40,40]' --set 'Grid|Shape Functions=GIMP'"},
    {"quadratic",
     "--set 'Image|Phantom|Size=[24,24,24]' --set 'Grid|Shape Functions=Quadratic B-Spline'"},
    {"reset, with inertia",
     "--set 'Image|Phantom|Size=[24,24,24]' --set 'Particles|Per Voxel=3' --set 'Grid|Reset=true'"
     " --set 'Loading|Inertia=true' --set 'Loading|Duration [s]=1e-3'"
     " --set 'Materials|collagen|Density [kg/m^3]=1000'"
     " --set 'Materials|vessel|Density [kg/m^3]=1000'",
     3}};

TEST(Memory, TheEstimateIsWhatRunsTake) {
  const TemporaryFolder folder;
  for (const Kind& kind : kinds)
    for (int ranks = 1; ranks <= (&kind == kinds ? 2 : 1); ++ranks) {
      SCOPED_TRACE(std::string(kind.name) + ", ranks " + std::to_string(ranks));
      const std::string arguments =
          quoted(deck) + " --set 'Loading|Steps=" + std::to_string(kind.steps) +
          "' --set 'Boundary Conditions|top|Strain=0.01'"
          " --set 'Solver|Newton Tolerance=1e-3' --set 'Output|Pictures=false' " +
          kind.overrides;
      const Outcome check = run_stroma(folder.path(), "check " + arguments, ranks);
      ASSERT_EQ(check.status, 0) << check.standard_error;
      const Outcome run = run_stroma(folder.path(), "run " + arguments + " -o out", ranks);
      ASSERT_EQ(run.status, 0) << run.standard_error;
      const double estimate = bytes_behind(check.standard_output, "memory      about ");
      const double peak = bytes_behind(run.standard_output, "\nmemory  ");
      std::printf("  %s, %d ranks: estimate %s, peak %s, %+.0f %%\n", kind.name, ranks,
                  base::readable_bytes(estimate).c_str(), base::readable_bytes(peak).c_str(),
                  100.0 * (estimate / peak - 1.0));
      EXPECT_LT(std::abs(estimate / peak - 1.0), 0.25);
    }
}

// 24 bytes a voxel of a body's velocities, and less of the displacements of a face, are counted while
// particles are made and while steps are solved.
TEST(Memory, TheEstimateKnowsMeasuredFields) {
  const TemporaryFolder folder;
  constexpr int n = 128;
  for (const char* component : {"v_x", "v_y", "v_z"})
    write_stack<std::uint8_t>(folder, component, {n, n, n}, [](int, int j, int) { return j; });
  folder.write("body.yaml", R"(Stroma:
  Image:
    Phantom: {Kind: Uniform, Size: [128, 128, 128], "Voxel Size [um]": [1, 1, 1]}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3, "Density [kg/m^3]": 1000}
  Particles: {Layout: Per Element, Per Element: 2}
  Grid: {"Element Size [um]": [8, 8, 8]}
  Boundary Conditions:
    bottom: {Face: y-, Components: xy, Displacement Images: {Images: [v_x.mhd, v_y.mhd, v_z.mhd], "Voxel Size [um]": [1, 1, 1]}}
  Initial Conditions:
    drift: {Velocity Images: {Images: [v_x.mhd, v_y.mhd, v_z.mhd], "Voxel Size [um]": [1, 1, 1]}}
  Loading: {Inertia: true, "Duration [s]": 1.0e-8, Steps: 1}
  Output: {Pictures: false, Report: false, Tables: false}
)");
  for (const int ranks : {1, 2}) {
    const Outcome check = run_stroma(folder.path(), "check body.yaml", ranks);
    ASSERT_EQ(check.status, 0) << check.standard_error;
    const double kept = 8.0 * (3.0 * n + 2.0 * 9.0) * n * n / ranks;
    EXPECT_NEAR(bytes_behind(check.standard_output, "with the specimen's voxels: "), kept,
                0.02 * kept)
        << check.standard_output;
    const Outcome run = run_stroma(folder.path(), "run body.yaml -o out", ranks);
    ASSERT_EQ(run.status, 0) << run.standard_error;
    const double estimate = bytes_behind(check.standard_output, "memory      about ");
    const double peak = bytes_behind(run.standard_output, "\nmemory  ");
    std::printf("  %d ranks: estimate %s, peak %s, %+.0f %%\n", ranks,
                base::readable_bytes(estimate).c_str(), base::readable_bytes(peak).c_str(),
                100.0 * (estimate / peak - 1.0));
    EXPECT_LT(std::abs(estimate / peak - 1.0), 0.25);
  }
}

}  // namespace
}  // namespace stroma::test
