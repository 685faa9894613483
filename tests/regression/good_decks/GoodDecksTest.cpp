// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Every deck of input_decks passes `stroma check` and runs, and what it finds obeys laws that hold
/// whatever the specimen looks like. No stored results: the laws are
///
/// - the supports' forces balance at every step;
/// - the work of the moving support is the energy stored (trapezoidal rule, error of order 1/steps^2);
/// - the materials' volumes at load 0 fill the box;
/// - the energy lies between bounds: a homogeneous strain is an admissible field, so the energy is at
///   most its energy (Voigt); the softer material alone, with faces free to slide, stores less.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <regex>

#include "stroma/material/AnyLaw.hpp"
#include "support/ExodusReader.hpp"
#include "support/Places.hpp"
#include "support/TableRows.hpp"
#include "support/VesselBlock.hpp"

namespace stroma::test {
namespace {

const fs::path decks = clone_folder() / "input_decks";
constexpr double strain = 0.1;
constexpr double vessel_ratio = 2.0;  // of both moduli, in all decks with two materials

enum class Grip { clamped, plane_strain_roller };

struct GoodDeck {
  std::string folder, file;
  std::array<double, 3> box;  ///< [um]
  std::string soft, stiff;    ///< names of the materials
  material::NeoHookean soft_law;
  Grip grip;
  int steps;  ///< to run in this test
  int ranks;
};

// The larger decks in fewer steps, for the sake of time.
const GoodDeck stretched[] = {
    {"01_first_stretch",
     "deck.xml",
     {50.4, 50.4, 24.0},
     "collagen",
     "vessel",
     {520.8, 2430.4},
     Grip::clamped,
     5,
     1},
    {"02_microvessel_stack",
     "deck.xml",
     {134.4, 134.4, 32.0},
     "collagen",
     "vessel",
     {520.8, 2430.4},
     Grip::clamped,
     2,
     2},
    {"03_paper_slice_phantom",
     "deck.xml",
     {268.8, 268.8, 1.0},
     "collagen",
     "vessel",
     {520.8, 1041.6},
     Grip::plane_strain_roller,
     10,
     1},
    {"07_paper_study",
     "deck.xml",
     {537.6, 537.6, 1.0},
     "collagen",
     "vessel",
     {520.8, 1041.6},
     Grip::plane_strain_roller,
     2,
     1},
    {"08_smooth_shapes",
     "deck.xml",
     {537.6, 537.6, 1.0},
     "collagen",
     "vessel",
     {520.8, 1041.6},
     Grip::plane_strain_roller,
     2,
     1},
    {"05_capillary_block",
     "deck.xml",
     {93.0, 93.0, 92.07},
     "matrix",
     "capillary",
     {520.8, 2430.4},
     Grip::clamped,
     1,
     2},
};

/// A deck's folder as a user has it: where it needs a prepared image, a copy with that image.
class DeckFolder {
 public:
  explicit DeckFolder(const std::string& name) : path_(decks / name) {
    if (!fs::exists(path_ / "prepare.sh")) return;
    fs::copy(path_, copy_.path());
    path_ = copy_.path();
    EXPECT_TRUE(prepare(path_)) << "prepare.sh failed";
  }
  fs::path operator/(const std::string& file) const { return path_ / file; }

 private:
  TemporaryFolder copy_;
  fs::path path_;
};

/// Energy per volume of a stretch 1 + e along y, with the widths that make it least where they are
/// free.
double energy_of_stretch(const material::NeoHookean& law, double e, bool free_x, bool free_z) {
  double least = INFINITY;
  for (double narrowing = 0.0; narrowing <= e; narrowing += e / 4000) {
    tensor::Tensor3 H;
    H(0, 0) = free_x ? -narrowing : 0.0;
    H(1, 1) = e;
    H(2, 2) = free_z ? -narrowing : 0.0;
    least = std::min(least, material::energy(law, H));
  }
  return least;
}

void expect_balance(const History& history) {
  for (std::size_t s = 0; s < history.rows(); ++s) {
    const double size = std::abs(history["top.reaction_y"][s]);
    for (const char* axis : {"x", "y", "z"}) {
      const std::string reaction = std::string(".reaction_") + axis;
      EXPECT_NEAR(history["top" + reaction][s] + history["bottom" + reaction][s], 0.0, 1e-7 * size)
          << axis << ", step " << s;
    }
  }
}

void expect_work_is_energy(const History& history, double way) {
  double work = 0.0;
  for (std::size_t s = 1; s < history.rows(); ++s) {
    EXPECT_GT(history["top.reaction_y"][s], history["top.reaction_y"][s - 1]);
    work += 0.5 * (history["top.reaction_y"][s] + history["top.reaction_y"][s - 1]) * way *
            (history["load"][s] - history["load"][s - 1]);
  }
  const double steps = static_cast<double>(history.rows() - 1);
  EXPECT_NEAR(history["strain_energy"].back() / work, 1.0, 0.05 / (steps * steps));
}

void expect_energy_within_bounds(const GoodDeck& deck, const History& history) {
  const double soft = history[deck.soft + ".volume"][0], stiff = history[deck.stiff + ".volume"][0];
  const double box = deck.box[0] * deck.box[1] * deck.box[2];
  EXPECT_NEAR(soft + stiff, box, 1e-9 * box);
  EXPECT_GT(stiff, 0.0);
  const double fraction = stiff / (soft + stiff);
  const bool rollers = deck.grip == Grip::plane_strain_roller;
  const double upper = energy_of_stretch(deck.soft_law, strain, rollers, false);
  const double lower = energy_of_stretch(deck.soft_law, strain, true, !rollers);
  const double energy = history["strain_energy"].back() / box;
  EXPECT_GT(energy, lower);
  EXPECT_LT(energy, (1.0 + fraction * (vessel_ratio - 1.0)) * upper);
  if (rollers) {  // the homogeneous state is the collagen's own: Reuss and Voigt proper
    const double reuss = 1.0 / (1.0 - fraction + fraction / vessel_ratio);
    EXPECT_GT(energy, reuss * lower);
  }
  std::printf("  %s: %.2f %% stiff, energy %.4g Pa between %.4g and %.4g\n", deck.folder.c_str(),
              100 * fraction, energy, lower, (1.0 + fraction * (vessel_ratio - 1.0)) * upper);
}

class StretchedDeck : public ::testing::TestWithParam<GoodDeck> {};

// V-DECKS.
TEST_P(StretchedDeck, ObeysTheLawsOfMechanics) {
  const GoodDeck& deck = GetParam();
  const DeckFolder folder(deck.folder);
  const TemporaryFolder results;
  const std::string arguments =
      quoted(folder / deck.file) + " --set 'Loading|Steps=" + std::to_string(deck.steps) + "'";
  const Outcome check = run_stroma(results.path(), "check " + arguments);
  ASSERT_EQ(check.status, 0) << check.standard_error;
  EXPECT_TRUE(check.standard_error.empty()) << check.standard_error;
  const Outcome run =
      run_stroma(results.path(), "run " + arguments + " -o out --quiet", deck.ranks);
  ASSERT_EQ(run.status, 0) << run.standard_error;
  const History history(results.path() / "out" / "history.csv");
  ASSERT_EQ(history.rows(), static_cast<std::size_t>(deck.steps + 1));
  EXPECT_EQ(history["load"].back(), 1.0);
  expect_balance(history);
  expect_work_is_energy(history, strain * deck.box[1]);
  expect_energy_within_bounds(deck, history);
  for (const char* picture : {"vessels.png", "von_mises.png", "force.png"})
    EXPECT_TRUE(fs::exists(results.path() / "out" / picture)) << picture;
}

INSTANTIATE_TEST_SUITE_P(InputDecks, StretchedDeck, ::testing::ValuesIn(stretched),
                         [](const auto& deck) { return "deck_" + deck.param.folder; });

// The homogeneous state of simple shear: tau = mu g, and its normal stress -mu g^2 / 3.
TEST(SimpleShearDeck, HasTheAnswerOnPaper) {
  const TemporaryFolder results;
  const std::string deck = quoted(decks / "04_simple_shear" / "deck.yaml");
  ASSERT_EQ(run_stroma(results.path(), "check " + deck).status, 0);
  const Outcome run = run_stroma(results.path(), "run " + deck + " -o out --quiet");
  ASSERT_EQ(run.status, 0) << run.standard_error;
  const History history(results.path() / "out" / "history.csv");
  const double mu = 520.8, area = 8.4 * 8.0;
  for (std::size_t s = 0; s < history.rows(); ++s) {
    const double g = 0.2 * history["load"][s];
    EXPECT_NEAR(history["top.reaction_x"][s], mu * g * area, 1e-9 * mu * area);
    EXPECT_NEAR(history["top.reaction_y"][s], -mu * g * g / 3.0 * area, 1e-9 * mu * area);
    EXPECT_NEAR(history["strain_energy"][s], 0.5 * mu * g * g * area * 8.4, 1e-9 * mu * area);
  }
}

/// The force that stretches a bar of 4 x 4 x 4 um with free sides: the sideways stretch at which its
/// sides are free of stress, by bisection.
double uniaxial_force(const material::AnyLaw& law, double stretch) {
  const auto state = [&](double sideways) {
    tensor::Tensor3 H;
    H(0, 0) = H(2, 2) = sideways - 1.0;
    H(1, 1) = stretch - 1.0;
    return material::kirchhoff_stress(law, H);
  };
  double thin = 0.7 / std::sqrt(stretch), wide = stretch;  // a law of shape alone swells the bar
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (thin + wide);
    (state(middle)(0, 0) > 0.0 ? wide : thin) = middle;
  }
  return state(thin)(1, 1) / stretch * 16.0;
}

/// Runs an input deck into the folder "out", without pictures.
/// \param settings  of --set
Outcome run_input(const TemporaryFolder& results, const fs::path& deck,
                  const std::vector<std::string>& settings) {
  std::string line =
      "run " + quoted(decks / deck) + " -o out --quiet --set 'Output|Pictures=false'";
  for (const std::string& setting : settings) line += " --set '" + setting + "'";
  return run_stroma(results.path(), line);
}

// 09_tissue_laws: each law's bar, against the law itself.
TEST(TissueLawsDeck, PullsEachBarAsItsLawSays) {
  const double nu = 0.3, K = material::bulk_modulus(500.0, nu);
  const material::ArrudaBoyce chains{{0.0}, 321.8100652, 2.0};
  const material::AnyLaw laws[] = {
      material::NeoHookean{500.0, K},
      material::CoupledNeoHookean{500.0, 750.0},
      material::MooneyRivlin{{K}, 100.0, 150.0},
      material::Ogden{{K}, 1, {1000.0}, {-8.0}},
      material::Yeoh{{K}, 3, {250.0, 100.0, 100.0}},
      material::VerondaWestmann{{K}, 250.0, 2.0},
      material::HolmesMow{500.0, 750.0, 0.8},
      material::ArrudaBoyce{
          {material::bulk_modulus(chains.small_strain().shear, nu)}, 321.8100652, 2.0},
  };
  const TemporaryFolder results;
  ASSERT_EQ(
      run_stroma(results.path(), "check " + quoted(decks / "09_tissue_laws" / "deck.yaml")).status,
      0);
  int label = 0;
  for (const material::AnyLaw& law : laws) {
    SCOPED_TRACE("label " + std::to_string(label));
    const Outcome run =
        run_input(results, "09_tissue_laws/deck.yaml",
                  {"Image|Phantom|Shapes|bar|Label=" + std::to_string(label++), "Loading|Steps=5"});
    ASSERT_EQ(run.status, 0) << run.standard_error;
    const History history(results.path() / "out" / "history.csv");
    for (std::size_t s = 1; s < history.rows(); ++s) {
      const double force = uniaxial_force(law, 1.0 + 0.5 * history["load"][s]);
      EXPECT_NEAR(history["top.reaction_y"][s], force, 1e-8 * force);
    }
  }
}

// Far too large a step for an exponential law: its first iterates bear many times the force of the
// solution. Whatever is accepted is the law's answer.
TEST(TissueLawsDeck, PullsAsTheLawSaysInOneStep) {
  const TemporaryFolder results;
  for (const double c2 : {5.0, 10.0, 20.0}) {
    SCOPED_TRACE("C2 = " + std::to_string(c2));
    const Outcome run =
        run_input(results, "09_tissue_laws/deck.yaml",
                  {"Image|Phantom|Shapes|bar|Label=5", "Boundary Conditions|top|Strain=1",
                   "Loading|Steps=1", "Materials|Veronda-Westmann|C2=" + std::to_string(c2)});
    ASSERT_EQ(run.status, 0) << run.standard_error;
    const History history(results.path() / "out" / "history.csv");
    const material::VerondaWestmann law{{material::bulk_modulus(250.0 * c2, 0.3)}, 250.0, c2};
    for (std::size_t s = 1; s < history.rows(); ++s) {
      const double force = uniaxial_force(law, 1.0 + history["load"][s]);
      EXPECT_NEAR(history["top.reaction_y"][s], force, 1e-6 * force) << history["load"][s];
    }
  }
}

/// What a log says is left after each of its steps is the time so far by the steps to come, however
/// long these are.
void expect_seconds_left_by_steps(const std::string& log, int steps) {
  const std::regex line(R"(\nstep +(\d+) .* ([0-9.]+) s, about (\d+) s left)");
  int found = 0;
  for (std::sregex_iterator at(log.begin(), log.end(), line), end; at != end; ++at, ++found) {
    const double step = std::stod((*at)[1]), seconds = std::stod((*at)[2]);
    const double to_come = (steps - step) / step;
    EXPECT_NEAR(std::stod((*at)[3]), seconds * to_come, 0.51 + 0.06 * to_come) << at->str();
  }
  EXPECT_EQ(found, steps);
}

// 10_ramp_and_hold: the force is largest when the ramp ends, and falls from then on towards that of
// the elastic body, to which its terms add 1.6 times as much at most.
TEST(RampAndHoldDeck, RelaxesTowardsTheElasticForce) {
  const TemporaryFolder results;
  const std::string deck = quoted(decks / "10_ramp_and_hold" / "deck.yaml");
  ASSERT_EQ(run_stroma(results.path(), "check " + deck).status, 0);
  const std::string quiet = " --quiet --set 'Output|Pictures=false'";
  ASSERT_EQ(run_stroma(results.path(), "run " + deck + " -o slow" + quiet, 2).status, 0);
  ASSERT_EQ(run_stroma(results.path(), "run " + deck + " -o elastic" + quiet +
                                           " --set 'Materials|collagen|Viscosity|Moduli={0,0,0}'"
                                           " --set 'Materials|vessel|Viscosity|Moduli={0}'"
                                           " --set 'Loading|Times [s]={1, 600}'")
                .status,
            0);
  const History slow(results.path() / "slow" / "history.csv");
  const double elastic = History(results.path() / "elastic" / "history.csv")["top.reaction_y"][1];
  const auto& time = slow["time"];
  const auto& force = slow["top.reaction_y"];
  expect_balance(slow);
  for (std::size_t s = 1; s < slow.rows(); ++s)
    EXPECT_EQ(force[s] > force[s - 1], time[s] <= 1.0) << time[s];
  EXPECT_LT(*std::max_element(force.begin(), force.end()), 2.6 * elastic);
  EXPECT_GT(force.back(), elastic);
  EXPECT_LT(force.back(), 1.3 * elastic);
  expect_seconds_left_by_steps(content_of(results.path() / "slow" / "log.txt"), 20);
}

// A law whose shear stiffens and then softens: the run ends where it must, and says why and where.
TEST(TissueLawsDeck, TellWhereEllipticityIsLost) {
  const TemporaryFolder results;
  const Outcome run =
      run_input(results, "09_tissue_laws/deck.yaml",
                {"Image|Phantom|Shapes|bar|Label=4", "Materials|Yeoh|C [Pa]={250, -150, 0}",
                 "Boundary Conditions|top|Strain=1.5", "Boundary Conditions|top|Components=xyz",
                 "Loading|Smallest Step=0.01"});
  EXPECT_EQ(run.status, 1);
  for (const char* words :
       {"lost ellipticity: ", "most of all particle id ", "material \"Yeoh\", at (",
        "a plane wave across (", "has a modulus of -"})
    EXPECT_NE(run.standard_error.find(words), std::string::npos) << run.standard_error;
  EXPECT_GT(History(results.path() / "out" / "history.csv").rows(), 1u);
}

// V-ELL-2. The same law in a bar between rollers, which is strained alike everywhere: steps that
// converge with all of it beyond the loss are told of, those before are not.
TEST(TissueLawsDeck, TellOfAcceptedStatesThatLostEllipticity) {
  const TemporaryFolder results;
  for (const auto& [stretch, words] :
       {std::pair<std::string, std::string>{"0.4", ""},
        {"0.5", "at load 0.9 the body has lost ellipticity: 64 particles, most"}}) {
    const Outcome run =
        run_input(results, "09_tissue_laws/deck.yaml",
                  {"Image|Phantom|Shapes|bar|Label=4", "Materials|Yeoh|C [Pa]={250, -150, 0}",
                   "Boundary Conditions|top|Strain=" + stretch, "Loading|Steps=10"});
    EXPECT_EQ(run.status, 0) << run.standard_error;
    const std::string log = content_of(results.path() / "out" / "log.txt");
    EXPECT_EQ(log.find("lost ellipticity") == std::string::npos, words.empty()) << stretch;
    EXPECT_NE(log.find(words), std::string::npos) << log;
  }
}

// 11_fiber_gel: fibres at 30 degrees to x make the gel several times stiffer along x than along y.
TEST(FiberGelDeck, IsStifferAlongItsFibres) {
  const TemporaryFolder results;
  const fs::path deck = fs::path("11_fiber_gel") / "deck.yaml";
  const Outcome check = run_stroma(results.path(), "check " + quoted(decks / deck));
  EXPECT_NE(check.standard_output.find("mean squares along x, y, z 0.7"), std::string::npos)
      << check.standard_output;
  const auto force = [&](const std::string& axis) {
    const Outcome run = run_input(results, deck,
                                  {"Loading|Steps=2", "Grid|Element Size [um]={6, 6, 6}",
                                   "Boundary Conditions|left|Face=" + axis + "-",
                                   "Boundary Conditions|right|Face=" + axis + "+"});
    EXPECT_EQ(run.status, 0) << run.standard_error;
    return History(results.path() / "out" / "history.csv")["right.reaction_" + axis].back();
  };
  EXPECT_GT(force("x"), 4.0 * force("y"));
}

/// Mean displacement towards the origin of the particles at a distance from it [um].
double drawn_in(const fs::path& file, double least, double most) {
  const ExodusReader particles(file.string());
  const auto x = particles.coordinates();
  std::array<std::vector<double>, 3> u;
  for (std::size_t d = 0; d < 3; ++d)
    u[d] = particles.variable(particles.steps(), EX_NODAL, std::string("displacement_") + "xyz"[d],
                              1, particles.counts.num_nodes);
  double sum = 0.0;
  int count = 0;
  for (std::size_t p = 0; p < x[0].size(); ++p) {
    const double r = std::hypot(x[0][p], x[1][p], x[2][p]);
    if (r < least || r > most) continue;
    sum -= (u[0][p] * x[0][p] + u[1][p] * x[1][p] + u[2][p] * x[2][p]) / r;
    ++count;
  }
  return sum / count;
}

// 12_contracting_cell: at four radii the collagen still has a quarter of the displacement at the
// cell, the linear gel less than a tenth.
TEST(ContractingCellDeck, ReachesFurtherInCollagen) {
  const TemporaryFolder results;
  const auto share_left = [&](int label) {
    const Outcome run = run_input(results, "12_contracting_cell/deck.yaml",
                                  {"Materials|collagen|Fibers|fibres|Quadrature=3",
                                   "Image|Phantom|Shapes|gel|Label=" + std::to_string(label)});
    EXPECT_EQ(run.status, 0) << run.standard_error;
    const fs::path file = results.path() / "out" / "particles.e";
    return drawn_in(file, 36.0, 44.0) / drawn_in(file, 10.0, 12.0);
  };
  const double in_collagen = share_left(0), in_linear_gel = share_left(2);
  EXPECT_GT(in_collagen, 0.2);
  EXPECT_LT(in_linear_gel, 0.1);
}

// 13_growing_vessel: up to twice the volume on a grid that is reset; the wall is pressed together by
// some percent of it, no more.
TEST(GrowingVesselDeck, GrowsToTwiceItsVolume) {
  const TemporaryFolder results;
  const Outcome run =
      run_input(results, "13_growing_vessel/deck.yaml",
                {"Materials|vessel|Growth|Ratio=2", "Grid|Element Size [um]={2, 2, 4}"});
  ASSERT_EQ(run.status, 0) << run.standard_error;
  const History history(results.path() / "out" / "history.csv");
  const auto& volume = history["vessel.volume"];
  EXPECT_LT(volume.back(), 2.0 * volume.front());
  EXPECT_GT(volume.back(), 1.85 * volume.front());
  EXPECT_NEAR(history["left.reaction_x"].back(), -history["right.reaction_x"].back(),
              1e-6 * std::abs(history["left.reaction_x"].back()));
}

// V-RIG-4. The force on the moved face stands in the README of the decks.
TEST(RigDecks, BalanceAndHaveTheForcesOfTheirTable) {
  struct RigDeck {
    const char *name, *column;
    double nanonewtons;
  };
  const RigDeck all[] = {{"clamped_extension", "moved.reaction_y", 179.0},
                         {"roller_extension", "moved.reaction_y", 158.7},
                         {"confined_compression", "moved.reaction_y", -431.9},
                         {"unconfined_compression", "moved.reaction_y", -196.7},
                         {"simple_shear", "moved.reaction_x", 44.8},
                         {"biaxial", "moved_y.reaction_y", 239.4},
                         {"torsion", "moved.reaction_z", -3.5}};
  std::ptrdiff_t decks_there = 0;
  for (const auto& entry : fs::directory_iterator(decks / "15_rigs"))
    decks_there += entry.path().extension() == ".yaml" ? 1 : 0;
  EXPECT_EQ(decks_there, std::end(all) - std::begin(all));
  for (const RigDeck& deck : all) {
    SCOPED_TRACE(deck.name);
    const TemporaryFolder results;
    const Outcome run = run_input(results, "15_rigs/" + std::string(deck.name) + ".yaml", {});
    ASSERT_EQ(run.status, 0) << run.standard_error;
    const History history(results.path() / "out" / "history.csv");
    EXPECT_NEAR(1e-3 * history[deck.column].back(), deck.nanonewtons, 0.051);
    if (history.has("moved.torque")) {
      EXPECT_NEAR(1e-3 * history["moved.torque"].back(), 666.3, 0.051);
    }
    for (const char axis : {'x', 'y', 'z'})
      for (std::size_t s = 0; s < history.rows(); ++s) {
        double sum = 0.0;
        for (const std::string& column : history.names())
          if (column.find(std::string("reaction_") + axis) != std::string::npos)
            sum += history[column][s];
        EXPECT_NEAR(sum, 0.0, 1e-6 * std::abs(history[deck.column].back()));
      }
  }
}

/// Displacements of the particles of a run at its end, by the nearest thousandth of a micrometre of
/// where they were.
std::map<std::array<long, 3>, std::array<double, 3>> displacements(const fs::path& run) {
  const ExodusReader particles((run / "particles.e").string());
  const auto X = particles.coordinates();
  std::map<std::array<long, 3>, std::array<double, 3>> found;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto u =
        particles.variable(particles.steps(), EX_NODAL, std::string("displacement_") + "xyz"[c], 1,
                           particles.counts.num_nodes);
    for (std::size_t p = 0; p < u.size(); ++p)
      found[{std::lround(1e3 * X[0][p]), std::lround(1e3 * X[1][p]), std::lround(1e3 * X[2][p])}]
           [c] = u[p];
  }
  return found;
}

// V-DVC-2. The faces of the region move as the whole did there, and so does what is inside.
TEST(MeasuredDisplacementsDeck, RepeatsTheInteriorOfTheWhole) {
  const TemporaryFolder copy;
  fs::copy(decks / "16_measured_displacements", copy.path(), fs::copy_options::recursive);
  for (const char* deck : {"whole", "region"}) {
    const Outcome run = run_stroma(copy.path(), std::string("run ") + deck + ".yaml --quiet");
    ASSERT_EQ(run.status, 0) << run.standard_error;
  }
  const auto whole = displacements(copy / "whole"), region = displacements(copy / "region");
  EXPECT_EQ(region.size(), 4096u);
  double error = 0.0;
  for (const auto& [X, u] : region)
    for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(u[c] - whole.at(X)[c]));
  EXPECT_LT(error, 0.025);
}

// 17_swing: energy goes from motion into strain and back, and none is lost.
TEST(SwingDeck, KeepsItsEnergyOnTheWay) {
  const TemporaryFolder results;
  const Outcome run = run_input(results, "17_swing/deck.yaml", {"Output|Report=false"});
  ASSERT_EQ(run.status, 0) << run.standard_error;
  const History history(results.path() / "out" / "history.csv");
  const auto& kinetic = history["kinetic_energy"];
  const auto& stored = history["strain_energy"];
  ASSERT_EQ(history.rows(), 41U);
  for (std::size_t s = 0; s < history.rows(); ++s)
    EXPECT_NEAR(kinetic[s] + stored[s], kinetic[0], 3e-3 * kinetic[0]) << s;
  EXPECT_LT(kinetic[11], 0.05 * kinetic[0]);
  EXPECT_GT(kinetic[23], 0.9 * kinetic[0]);
}

// 18_pressed_vessel: the pulse doubles the lumen, and leaves nothing behind.
TEST(PressedVesselDeck, WidensAndReturns) {
  const TemporaryFolder results;
  const Outcome run = run_input(results, "18_pressed_vessel/deck.yaml", {"Output|Report=false"});
  ASSERT_EQ(run.status, 0) << run.standard_error;
  const History history(results.path() / "out" / "history.csv");
  const auto& lumen = history["lumen.volume"];
  EXPECT_EQ(lumen.front(), 624.0);
  EXPECT_NEAR(*std::max_element(lumen.begin(), lumen.end()), 1251.7, 1.0);
  EXPECT_NEAR(lumen.back(), 624.0, 1e-6);
  const auto& pressure = history["lumen.pressure"];
  EXPECT_EQ(pressure.front(), 0.0);
  EXPECT_NEAR(pressure[3], 250.0, 1e-10);  // half way up
  EXPECT_NEAR(pressure[6], 500.0, 1e-10);
  for (std::size_t s = 0; s < history.rows(); ++s)
    EXPECT_NEAR(history["left.reaction_x"][s], -history["right.reaction_x"][s], 0.02);
}

// V-STIFF-4. The figures of its README.
TEST(StiffnessDecks, HaveTheModuliOfTheirTables) {
  const TemporaryFolder folder;
  const auto run = [&](const std::string& name) {
    const fs::path deck = decks / "19_scaffold_stiffness" / (name + ".yaml");
    const Outcome outcome =
        run_stroma(folder.path(), "run " + quoted(deck) + " --quiet -o " + name);
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    std::map<std::string, double> table;
    for (const auto& row : rows_of(folder / name / "stiffness.csv"))
      table[row.at("boundary") + "|" + row.at("tensor") + "|" + row.at("figure")] =
          std::stod(row.at("value"));
    return table;
  };
  const auto scaffold = run("scaffold");
  const auto is_near = [](double value, double table) {
    return std::abs(value - table) < 1e-3 * std::abs(table);
  };
  EXPECT_PRED2(is_near, scaffold.at("Uniform Displacement|specimen|E_x"), 31.17e6);
  EXPECT_PRED2(is_near, scaffold.at("Uniform Displacement|specimen|G_xy"), 7.013e6);
  EXPECT_PRED2(is_near, scaffold.at("Mixed|specimen|E_y"), 27.22e6);
  EXPECT_PRED2(is_near, scaffold.at("Mixed|specimen|E_z"), 25.55e6);
  EXPECT_PRED2(is_near, scaffold.at("Mixed|specimen|G_yz"), 3.369e6);
  EXPECT_PRED2(is_near, scaffold.at("Mixed|specimen|G_xy"), 1.357e6);
  EXPECT_LT(scaffold.at("Mixed|specimen|symmetry_error"), 1e-9);

  auto vessels = run("vessels");
  const std::vector<std::string> order{"bounds|Hashin-Shtrikman -", "Uniform Traction|isotropic",
                                       "Mixed|isotropic", "Uniform Displacement|isotropic",
                                       "bounds|Hashin-Shtrikman +"};
  for (const char* modulus : {"|K", "|G"})
    for (std::size_t n = 1; n < order.size(); ++n)
      EXPECT_LT(vessels.at(order[n - 1] + modulus), vessels.at(order[n] + modulus)) << order[n];
  EXPECT_PRED2(is_near, vessels.at("Mixed|isotropic|K"), 3358.0);
  EXPECT_PRED2(is_near, vessels.at("Mixed|isotropic|G"), 877.6);
}

TEST(InputDecks, AllOfThemAreTested) {
  // 06_resolution_study is run by tests/regression/study, that of 07_paper_study in part by
  // tests/verification/paper_study, 14_fit_vessel_modulus by tests/verification/fit.
  std::vector<std::string> tested{"04_simple_shear",
                                  "06_resolution_study",
                                  "09_tissue_laws",
                                  "10_ramp_and_hold",
                                  "11_fiber_gel",
                                  "12_contracting_cell",
                                  "13_growing_vessel",
                                  "14_fit_vessel_modulus",
                                  "15_rigs",
                                  "16_measured_displacements",
                                  "17_swing",
                                  "18_pressed_vessel",
                                  "19_scaffold_stiffness"};
  for (const GoodDeck& deck : stretched) tested.push_back(deck.folder);
  std::vector<std::string> present;
  for (const auto& entry : fs::directory_iterator(decks))
    if (entry.is_directory()) {
      present.push_back(entry.path().filename().string());
      EXPECT_TRUE(fs::exists(entry.path() / "README.md")) << entry.path();
    }
  std::sort(tested.begin(), tested.end());
  std::sort(present.begin(), present.end());
  EXPECT_EQ(present, tested);
}

}  // namespace
}  // namespace stroma::test
