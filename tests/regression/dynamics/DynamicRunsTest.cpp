// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Runs of bodies with inertia, by the program: on any number of ranks, in parts, and their
/// balance of energy. Claims V-DYN-RUNS, V-DYN-IMAGES, V-DYN-WORK, V-DYN-STEPS and V-DYN-COST,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "regression/restart/LongDeck.hpp"
#include "support/ExodusReader.hpp"
#include "support/SmallDeck.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

/// A gel with a vessel that is jerked by its top, in steps of 10 us.
///
/// \param grid     what the section Grid holds beside the size of elements
/// \param loading  what the section Loading holds beside Inertia and times
/// \param steps    of the eight that the jerk takes
/// \param finer    how many steps each of them is made of
std::string jerked(const std::string& grid, const std::string& loading, int steps, int finer = 1) {
  std::string times;
  for (int t = 1; t <= steps * finer; ++t)
    times += (t == 1 ? "" : ", ") + std::to_string(10.0 * t / finer) + "e-6";
  return "Stroma:\n" + gel_with_a_vessel + R"(  Materials:
    gel: {Label: 0, Model: Neo-Hookean, "Shear Modulus [Pa]": 520.8, Poisson Ratio: 0.4, "Density [kg/m^3]": 1000}
    vessel: {Label: 1, Model: Neo-Hookean, "Shear Modulus [Pa]": 1041.6, Poisson Ratio: 0.4, "Density [kg/m^3]": 1100}
  Grid: {"Element Size [um]": [2, 2, 2])" +
         grid + R"(}
  Load Curves:
    jerk: {"Times [s]": [0, 40.0e-6, 80.0e-6], Values: [0, 1, 0], Interpolation: Smooth}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz, "Displacement [um]": [0, 0, 0]}
    top: {Face: y+, Components: xyz, "Displacement [um]": [1.5, 0.5, 0], Load Curve: jerk}
  Initial Conditions:
    drift: {"Velocity Gradient [1/s]": [0, 0, 0, 0, 0, 0, 0, 3000, 0], "Center [um]": [0, 0, 0]}
  Loading: {Inertia: true, "Times [s]": [)" +
         times + "]" + loading + R"(}
  Solver: {Newton Tolerance: 1.0e-12, Linear Tolerance: 1.0e-8}
  Output: {Pictures: false, Report: false, Checkpoint Every: 1}
)";
}

struct Variant {
  std::string name, grid, loading;
};

class DynamicRuns : public ::testing::TestWithParam<Variant> {};

// The same history on 1 and 2 ranks, and in two parts of which the second has 4.
TEST_P(DynamicRuns, DoNotDependOnRanksOrPauses) {
  const TemporaryFolder folder;
  const auto& [name, grid, loading] = GetParam();
  const History whole = run_deck(folder, "whole", jerked(grid, loading, 8));
  EXPECT_LT(difference(whole, run_deck(folder, "ranks", jerked(grid, loading, 8), 2)), 1e-10);
  run_deck(folder, "part", jerked(grid, loading, 4));
  folder.write("part.yaml", jerked(grid, loading, 8));
  const Outcome outcome = run_stroma(folder.path(), "run part.yaml -o part --quiet --restart", 4);
  ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
  EXPECT_LT(difference(whole, History(folder / "part/history.csv")), 1e-10);
  EXPECT_EQ(run_stroma(folder.path(), "verify part").status, 0);
  const ExodusReader particles(folder / "part/particles.e.4.0");
  EXPECT_GT(particles.steps(), 8);
}

INSTANTIATE_TEST_SUITE_P(
    All, DynamicRuns,
    ::testing::Values(
        Variant{"Newmark", "", ""},
        Variant{"Consistent", "", ", Mass: Consistent, Scheme: Generalised Alpha"},
        Variant{"Damped", "", ", \"Mass Damping [1/s]\": 1000, \"Stiffness Damping [s]\": 1.0e-6"},
        Variant{"Reset", ", Reset: true, Shape Functions: GIMP", ", Scheme: Generalised Alpha"},
        Variant{"ConsistentReset", ", Reset: true, Shape Functions: GIMP", ", Mass: Consistent"},
        Variant{"ResetOfSplines", ", Reset: true, Shape Functions: Quadratic B-Spline", ""}),
    [](const auto& one) { return one.param.name; });

// checkpoint.h5 has what a body in motion needs: one that is killed goes on to the same history.
TEST(DynamicRunsOfABody, GoOnAfterAKill) {
  const TemporaryFolder folder;
  for (const std::string& grid :
       {std::string(), std::string(", Reset: true, Shape Functions: GIMP")}) {
    const History whole = run_deck(folder, "whole", jerked(grid, "", 8, 4));
    const Outcome killed = run_script(
        folder,
        "set -m\nrm -rf part\n\"$stroma\" run whole.yaml --quiet -o part >output 2>errors &\nrun=$!\n"
        "wait_for_steps part/history.csv\nkill -KILL -$run\nwait $run\ntrue\n");
    EXPECT_EQ(killed.status, 0) << killed.standard_error;
    const std::size_t before = History(folder / "part/history.csv").rows();
    EXPECT_LT(before, whole.rows());
    const Outcome outcome = run_stroma(folder.path(), "run whole.yaml -o part --quiet --restart");
    ASSERT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_LT(difference(whole, History(folder / "part/history.csv")), 1e-10);
    std::printf("  killed after %zu of %zu steps\n", before - 1, whole.rows() - 1);
  }
}

/// The same deck with the drift by images: voxels of 3 x 4 x 5 um that begin before the body.
std::string with_images(std::string deck) {
  const std::string gradient =
      "\"Velocity Gradient [1/s]\": [0, 0, 0, 0, 0, 0, 0, 3000, 0], \"Center [um]\": [0, 0, 0]";
  return deck.replace(deck.find(gradient), gradient.size(),
                      "Velocity Images: {Images: [v_x.mhd, v_y.mhd, v_z.mhd], \"Voxel Size [um]\": "
                      "[3, 4, 5], \"Corner [um]\": [-3, -5, -6]}");
}

// A linear field of velocities, by images and by nine numbers, at nodes and at particles, on grids
// that are reset or not; voxels far from the body need no numbers.
TEST(DynamicRunsOfABody, BeginAsImagesSay) {
  const TemporaryFolder folder;
  const std::array<int, 3> size{20, 20, 20};
  for (const char* name : {"v_x", "v_y"})
    write_stack<double>(folder, name, size, [](int, int, int) { return 0.0; });
  write_stack<double>(folder, "v_z", size, [](int i, int j, int) {
    return i == 19 ? std::nan("") : 3000.0 * (4.0 * (j + 0.5) - 5.0);
  });
  const std::string reset = ", Reset: true, Shape Functions: GIMP";
  for (const auto& [grid, loading] :
       {std::pair<std::string, std::string>{"", ""}, {"", ", Mass: Consistent"}, {reset, ""}}) {
    const std::string deck = jerked(grid, loading, 2);
    const History numbers = run_deck(folder, "numbers", deck);
    EXPECT_GT(numbers["kinetic_energy"][0], 0.0);
    for (const int ranks : {1, 2})
      EXPECT_LT(difference(numbers, run_deck(folder, "images", with_images(deck), ranks)), 1e-10)
          << grid << loading << ranks;
  }

  // grid.e shows them; what is prescribed moves as it is told.
  run_deck(folder, "images", with_images(jerked("", "", 2)));
  const ExodusReader grid(folder / "images/grid.e");
  const auto place = grid.coordinates();
  const auto v_z = grid.variable(1, EX_NODAL, "velocity_z", 1, grid.counts.num_nodes);
  for (std::size_t n = 0; n < v_z.size(); ++n) {
    const double y = place[1][n];
    EXPECT_NEAR(v_z[n], y > 0.5 && y < 11.5 ? 3000.0 * y : 0.0, 1e-6) << y;
  }

  // Others than before when a run goes on, and images that do not fit.
  const std::string deck = with_images(jerked("", "", 2));
  const auto refusal = [&](const std::string& arguments) {
    const Outcome outcome = run_stroma(folder.path(), "run images.yaml --quiet " + arguments, 2);
    EXPECT_EQ(outcome.status, 2) << arguments;
    return outcome.standard_error;
  };
  folder.write("images.yaml", deck);
  write_stack<double>(folder, "v_x", size, [](int, int, int) { return 1.0; });
  EXPECT_NE(refusal("-o images --restart").find("checksums differ"), std::string::npos);
  const std::string images = "Initial Conditions|drift|Velocity Images";
  EXPECT_NE(refusal("-o other --set '" + images + "|Corner [um]={1, 0, 0}'").find(images),
            std::string::npos);
  write_stack<double>(folder, "v_y", size, [](int, int, int) { return std::nan(""); });
  EXPECT_NE(refusal("-o other").find(images + ": component y at"), std::string::npos);
}

/// How far strain and kinetic energy, work and loss are from balance, of the largest kinetic energy.
double imbalance(const History& history) {
  double worst = 0.0, size = 0.0;
  for (std::size_t s = 0; s < history.rows(); ++s) {
    const double gained =
        history["strain_energy"][s] + history["kinetic_energy"][s] - history["kinetic_energy"][0];
    const double given = history["external_work"][s] - history["damping_work"][s];
    worst = std::max(worst, std::abs(gained - given));
    size = std::max(size, history["kinetic_energy"][s]);
  }
  return worst / size;
}

/// A block of 64 um^3 and 1000 kg/m^3, all of whose nodes move by 1 um in 10 us and then rest; 20 steps.
std::string moved(const std::string& mass, const std::string& interpolation) {
  return R"(Stroma:
  Image: {Phantom: {Kind: Uniform, Size: [4, 4, 4], "Voxel Size [um]": [1, 1, 1]}}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3, "Density [kg/m^3]": 1000}
  Grid: {"Element Size [um]": [4, 4, 4]}
  Load Curves:
    way: {"Times [s]": [0, 10.0e-6], Values: [0, 1], Interpolation: )" +
         interpolation + R"(}
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz, "Displacement [um]": [0, 1, 0], Load Curve: way}
    top: {Face: y+, Components: xyz, "Displacement [um]": [0, 1, 0], Load Curve: way}
  Loading: {Inertia: true, "Duration [s]": 20.0e-6, Steps: 20, )" +
         mass + R"(}
  Output: {Pictures: false, Report: false}
)";
}

// V-DYN-WORK. A body that is carried: the force is its mass times the acceleration of the curve, none
// while it moves evenly or rests, and the kinetic energy m v^2 / 2 = 320 aJ, whatever the mass is
// made of.
TEST(DynamicRunsOfABody, AreCarriedWithoutSwinging) {
  const TemporaryFolder folder;
  const double mass = 64e-15, way = 1e-6, time = 10e-6;  // kg, m, s
  for (const std::string scheme :
       {"Mass: Lumped", "Mass: Consistent", "Mass: Consistent, Scheme: Generalised Alpha"}) {
    SCOPED_TRACE(scheme);
    const History even = run_deck(folder, "even", moved(scheme, "Linear"));
    const History smooth = run_deck(folder, "smooth", moved(scheme, "Smooth"));
    for (std::size_t s = 1; s <= 20; ++s) {
      const auto force = [&](const History& history) {
        return history["bottom.reaction_y"][s] + history["top.reaction_y"][s];
      };
      EXPECT_NEAR(force(even), 0.0, 1e-6) << "step " << s;
      EXPECT_NEAR(even["kinetic_energy"][s], s < 10 ? 320.0 : 0.0, 1e-9) << "step " << s;
      // 3 t^2 - 2 t^3; at its end the acceleration is that before it.
      const double t = 0.1 * static_cast<double>(s);
      const double asked = s <= 10 ? mass * way / (time * time) * (6.0 - 12.0 * t) * 1e12 : 0.0;
      EXPECT_NEAR(force(smooth), asked, 2e-3 * mass * way / (time * time) * 1e12) << "step " << s;
    }
  }
}

// V-DYN-WORK. A load curve with a corner: the work is that of the reaction up to it.
TEST(DynamicRunsOfABody, WorkUpToTheCornerOfACurve) {
  const TemporaryFolder folder;
  std::string deck = jerked("", "", 8, 2);
  const std::string smooth = "Interpolation: Smooth";
  deck.replace(deck.find(smooth), smooth.size(), "Interpolation: Linear");
  const History history = run_deck(folder, "whole", deck);
  double work = 0.0;
  for (std::size_t s = 1; s <= 16; ++s) {
    const double change = (s <= 8 ? 1.0 : -1.0) / 8.0;  // of the curve
    for (const auto& [column, displacement] :
         {std::pair<const char*, double>{"top.reaction_x", 1.5}, {"top.reaction_y", 0.5}})
      work += 0.5 * (history[column][s - 1] + history[column][s]) * displacement * change;
    EXPECT_NEAR(history["external_work"][s], work, 1e-6 * std::abs(work) + 1e-9) << "step " << s;
  }
}

// What supports do, less what damping takes, is what the body has gained: to the second order of
// the step.
TEST(DynamicRunsOfABody, BalanceTheirEnergy) {
  const TemporaryFolder folder;
  for (const char* loading :
       {"", ", Scheme: Generalised Alpha, Spectral Radius: 1.0",
        ", \"Mass Damping [1/s]\": 2000, \"Stiffness Damping [s]\": 1.0e-6"}) {
    SCOPED_TRACE(loading);
    const double coarse = imbalance(run_deck(folder, "coarse", jerked("", loading, 8, 4))),
                 fine = imbalance(run_deck(folder, "fine", jerked("", loading, 8, 8)));
    EXPECT_LT(fine, 1.5e-2);
    EXPECT_GT(coarse / fine, 3.0);
    std::printf("  energy is in balance within %.2e, with half the step %.2e\n", coarse, fine);
  }
}

// Steps are halved where their error in time asks for it, and grow back: the tip comes as close to
// where short steps bring it as the error says.
TEST(DynamicRunsOfABody, ChooseStepsByTheirErrorInTime) {
  const TemporaryFolder folder;
  const auto force = [&](const std::string& name, const std::string& loading, int finer) {
    return run_deck(folder, name, jerked("", loading, 8, finer));
  };
  const History exact = force("exact", "", 32), coarse = force("coarse", "", 1),
                chosen = force("chosen", ", \"Step Error [um]\": 5.0e-4", 1);
  EXPECT_GT(chosen.rows(), 2 * coarse.rows());
  EXPECT_LT(chosen.rows(), exact.rows());
  const auto departure = [&](const History& history) {
    return std::abs(history["strain_energy"].back() - exact["strain_energy"].back());
  };
  EXPECT_LT(departure(chosen), 0.2 * departure(coarse));
  std::printf("  %zu steps instead of %zu: %.2e instead of %.2e\n", chosen.rows() - 1,
              coarse.rows() - 1, departure(chosen), departure(coarse));
  EXPECT_NE(content_of(folder / "chosen/log.txt").find("its error in time is"), std::string::npos);
}

// V-DYN-COST. Masses and their forces, by the share of their stage in the time of the steps, which other work on
// the machine lengthens alike.
TEST(DynamicRunsOfABody, CostLittleMoreThanThoseAtRest) {
  const TemporaryFolder folder;
  std::string deck = jerked("", "", 2);
  const std::string size = "Size: [12, 12, 12]";
  deck.replace(deck.find(size), size.size(), "Size: [40, 40, 40]");
  const History history = run_deck(folder, "run", deck);
  const std::string log = content_of(folder / "run/log.txt"), word = "  inertia ";
  const std::size_t at = log.rfind(word);
  ASSERT_NE(at, std::string::npos) << log;
  const double inertia = std::stod(log.substr(at + word.size())),
               whole = history["wall_seconds"].back() - history["wall_seconds"].front();
  std::printf("  %.2f s of %.2f s\n", inertia, whole);
  EXPECT_LT(inertia, 0.1 * whole);
}

}  // namespace
}  // namespace stroma::test
