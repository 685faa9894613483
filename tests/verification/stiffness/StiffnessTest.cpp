// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The stiffness of specimens against closed forms and bounds. Claims V-STIFF-1, V-STIFF-2,
/// V-STIFF-3, V-STIFF-4, V-STIFF-5, V-STIFF-6 and V-STIFF-7, docs/verification.md.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "stiffness/ElasticTensor.hpp"
#include "support/TableRows.hpp"
#include "support/WriteStack.hpp"

namespace stroma::test {
namespace {

const char* const boundaries[] = {"Uniform Displacement", "Mixed", "Uniform Traction"};

constexpr double soft_bulk = 500.0, soft_shear = 200.0, stiff_bulk = 6000.0, stiff_shear = 3000.0;
const std::string two_materials =
    "    soft: {Label: 0, 'Bulk Modulus [Pa]': 500, 'Shear Modulus [Pa]': 200}\n"
    "    stiff: {Label: 1, 'Bulk Modulus [Pa]': 6000, 'Shear Modulus [Pa]': 3000}\n";

/// Of stack.mhd, whose voxels are not cubes.
std::string deck(const std::string& materials, const std::string& elements,
                 const std::string& segmentation = "Method: Labels",
                 const std::string& rig = "Kind: Stiffness") {
  return "Stroma:\n"
         "  Title: a specimen\n"
         "  Image:\n"
         "    File: stack.mhd\n"
         "    'Voxel Size [um]': [1, 1.25, 0.8]\n"
         "    Segmentation: {" +
         segmentation +
         "}\n"
         "  Materials:\n" +
         materials + "  Grid: {Elements: [" + elements +
         "]}\n"
         "  Rig: {" +
         rig + "}\n";
}

class Stiffness : public ::testing::Test {
 protected:
  template <class Label>
  void write(const std::array<int, 3>& size, const Label& label) {
    write_stack<std::uint8_t>(folder_, "stack", size, label);
  }
  Outcome stroma(const std::string& text, const std::string& arguments, int ranks = 1) {
    std::ofstream(folder_ / "deck.yaml") << text;
    return run_stroma(folder_.path(), arguments, ranks);
  }
  nlohmann::json run(const std::string& text, int ranks = 1) {
    const Outcome outcome = stroma(text, "run deck.yaml --quiet -o out", ranks);
    EXPECT_EQ(outcome.status, 0) << text << outcome.standard_error;
    return nlohmann::json::parse(content_of(folder_ / "out" / "stiffness.json"));
  }
  TemporaryFolder folder_;
};

Matrix6 matrix(const nlohmann::json& rows) {
  Matrix6 m;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      m(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>();
  return m;
}
Matrix6 stiffness(const nlohmann::json& found, const std::string& boundary) {
  return matrix(found["stiffness"][boundary]["stiffness"]);
}

double distance(const Matrix6& a, const Matrix6& b) {
  return (to_kelvin(a) - to_kelvin(b)).norm() / to_kelvin(b).norm();
}

/// The least eigenvalue of a difference, by the size of the second: >= 0 where a is the stiffer one
/// for all strains.
double excess(const Matrix6& a, const Matrix6& b) {
  const Matrix6 d = to_kelvin(a) - to_kelvin(b);
  return Eigen::SelfAdjointEigenSolver<Matrix6>(0.5 * (d + d.transpose())).eigenvalues()(0) /
         to_kelvin(b).norm();
}

/// A fibre family of modulus k along n (not of unit length): k n n n n in any small strain.
Matrix6 fiber_stiffness(double k, const Eigen::Vector3d& n) {
  const Eigen::Vector3d u = n.normalized();
  Eigen::Matrix<double, 6, 1> v;
  v << u(0) * u(0), u(1) * u(1), u(2) * u(2), u(1) * u(2), u(0) * u(2), u(0) * u(1);
  return k * v * v.transpose();
}

/// A family of Holzapfel, Gasser and Ogden along n, of which E = 2 (1 - 3 kappa)(n n - I/3) : e.
Matrix6 dispersed_stiffness(double k1, double kappa, const Eigen::Vector3d& n) {
  const Eigen::Vector3d u = n.normalized();
  Eigen::Matrix<double, 6, 1> v;
  v << u(0) * u(0) - 1.0 / 3.0, u(1) * u(1) - 1.0 / 3.0, u(2) * u(2) - 1.0 / 3.0, u(1) * u(2),
      u(0) * u(2), u(0) * u(1);
  return 4.0 * k1 * (1.0 - 3.0 * kappa) * (1.0 - 3.0 * kappa) * v * v.transpose();
}

std::string fibers(const std::string& name, double k, const std::string& direction) {
  return "        " + name + ": {Law: Buckling-Stiffening, 'K [Pa]': " + std::to_string(k) +
         ", D0: 0.01, Lambda S: 0.1, DS: 0.1, Direction: [" + direction + "]}\n";
}

// V-STIFF-1. A uniform specimen has the stiffness of its material, whatever its surface does.
TEST_F(Stiffness, OfAUniformSpecimenIsTheMaterials) {
  write({6, 6, 6}, [](int, int, int) { return 0; });
  const Matrix6 matrix_alone = isotropic_stiffness(soft_bulk, soft_shear);
  const std::string gel =
      "    gel:\n      Label: 0\n      'Bulk Modulus [Pa]': 500\n      'Shear Modulus [Pa]': 200\n";
  struct Case {
    std::string materials;
    Matrix6 exact;
  };
  const Case cases[] = {
      {gel, matrix_alone},
      {gel + "      Fibers:\n" + fibers("along", 900.0, "1, 0, 0") + fibers("up", 300.0, "0, 0, 1"),
       matrix_alone + fiber_stiffness(900.0, {1, 0, 0}) + fiber_stiffness(300.0, {0, 0, 1})},
      {gel + "      Fibers:\n" + fibers("oblique", 900.0, "1, 2, -0.5"),
       matrix_alone + fiber_stiffness(900.0, {1, 2, -0.5})},
      {"    wall: {Label: 0, Model: Holzapfel-Gasser-Ogden, 'C [Pa]': 200, 'K1 [Pa]': 300, K2: 3, "
       "Kappa: 0.1, 'Bulk Modulus [Pa]': 500, Fibers: {a: {Direction: [1, 2, -0.5]}}}\n",
       matrix_alone + dispersed_stiffness(300.0, 0.1, {1, 2, -0.5})}};
  for (const Case& c : cases) {
    const nlohmann::json found = run(deck(c.materials, "3, 3, 3"));
    for (const char* boundary : boundaries)
      EXPECT_LT(distance(stiffness(found, boundary), c.exact), 1e-10) << boundary << c.materials;
    EXPECT_LT(distance(matrix(found["Voigt"]), c.exact), 1e-12);
  }
}

/// Layers across z of two isotropic materials, in equal parts (Backus 1962). With < > the mean over
/// the thickness, M = lambda + 2 mu and r = lambda / M:
///
///     C_zz = 1 / <1/M>, C_xz = C_zz <r>, C_xx = <M - lambda r> + C_zz <r>^2,
///     C_xy = C_xx - 2 <mu>, G_xz = 1 / <1/mu>, G_xy = <mu>.
Matrix6 layers() {
  const auto mean = [](auto of) {
    const auto at = [&](double K, double mu) { return of(K - 2.0 / 3.0 * mu, mu); };
    return 0.5 * (at(soft_bulk, soft_shear) + at(stiff_bulk, stiff_shear));
  };
  const auto wave = [](double lambda, double mu) { return lambda + 2.0 * mu; };
  const double across = 1.0 / mean([&](double l, double m) { return 1.0 / wave(l, m); });
  const double r = mean([&](double l, double m) { return l / wave(l, m); });
  const double shear = mean([](double, double m) { return m; });
  Matrix6 C = Matrix6::Zero();
  C(2, 2) = across;
  C(0, 2) = C(2, 0) = C(1, 2) = C(2, 1) = across * r;
  C(0, 0) = C(1, 1) =
      mean([&](double l, double m) { return wave(l, m) - l * l / wave(l, m); }) + across * r * r;
  C(0, 1) = C(1, 0) = C(0, 0) - 2.0 * shear;
  C(3, 3) = C(4, 4) = 1.0 / mean([](double, double m) { return 1.0 / m; });
  C(5, 5) = shear;
  return C;
}

// V-STIFF-2. A laminate with mixed conditions along its layers, across each of the axes.
TEST_F(Stiffness, OfALaminateIsExactWithMixedConditions) {
  for (const int axis : {0, 1, 2}) {
    write({8, 8, 8}, [&](int i, int j, int k) {
      return std::array<int, 3>{i, j, k}[static_cast<std::size_t>(axis)] / 2 % 2;
    });
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();  // as the layers' z is the specimen's `axis`
    for (int d = 0; d < 3; ++d) axes((axis + 1 + d) % 3, d) = 1.0;
    for (int ranks = 1; ranks <= (axis == 2 ? 2 : 1); ++ranks) {
      const nlohmann::json found = run(deck(two_materials, "4, 4, 4"), ranks);
      EXPECT_LT(distance(stiffness(found, "Mixed"), in_frame(layers(), axes)), 1e-10) << axis;
      EXPECT_LT(found["stiffness"]["Mixed"]["symmetry error"], 1e-10);
      const auto& closest = found["stiffness"]["Mixed"]["closest"]["transversely isotropic"];
      EXPECT_LT(closest["distance"], 1e-10);
      EXPECT_NEAR(closest["axes"][2][static_cast<std::size_t>(axis)], 1.0, 1e-10);
    }
  }
}

/// Voxels that are stiff at random.
auto random_stack(unsigned seed, double fraction) {
  auto generator = std::make_shared<std::mt19937>(seed);
  return [=](int, int, int) {
    return static_cast<double>((*generator)()) < fraction * 4294967296.0 ? 1 : 0;
  };
}

// V-STIFF-3. For all strains: Reuss <= traction <= mixed <= displacement <= Voigt; the same on 1, 2
// and 4 ranks.
TEST_F(Stiffness, OfARandomStackLiesBetweenItsBounds) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    write({8, 8, 8}, random_stack(seed, 0.2 * seed));
    const std::string text = deck(two_materials, "8, 8, 8");
    const nlohmann::json found = run(text);
    const Matrix6 displacement = stiffness(found, "Uniform Displacement"),
                  mixed = stiffness(found, "Mixed"),
                  traction = stiffness(found, "Uniform Traction"), voigt = matrix(found["Voigt"]);
    const auto& bounds = found["bounds"];
    const auto isotropic = [&](const char* kind) {
      return isotropic_stiffness(bounds[kind]["K"], bounds[kind]["G"]);
    };
    EXPECT_LT(distance(voigt, isotropic("Voigt")), 1e-12);
    EXPECT_LT(distance(matrix(found["Reuss"]), isotropic("Reuss")), 1e-12);
    EXPECT_GT(excess(voigt, displacement), 0.01);
    EXPECT_GT(excess(displacement, mixed), 0.01);
    EXPECT_GT(excess(mixed, traction), 0.01);
    EXPECT_GT(excess(traction, isotropic("Reuss")), 0.01);
    for (const char* boundary : {"Uniform Displacement", "Uniform Traction"})
      EXPECT_LT(found["stiffness"][boundary]["symmetry error"], 1e-10);
  }
}

TEST_F(Stiffness, IsTheSameOnAnyNumberOfRanks) {
  write({8, 8, 8}, random_stack(4, 0.4));
  const std::string text = deck(two_materials, "8, 8, 8");
  const nlohmann::json found = run(text);
  const auto first_axis = [](const nlohmann::json& of) {
    return of["stiffness"]["Mixed"]["closest"]["orthotropic"]["axes"][0][0].get<double>();
  };
  for (const int ranks : {2, 4}) {
    const nlohmann::json again = run(text, ranks);
    for (const char* boundary : boundaries)
      EXPECT_LT(distance(stiffness(again, boundary), stiffness(found, boundary)), 1e-10);
    EXPECT_NEAR(first_axis(again), first_axis(found), 1e-10);
  }
}

// V-STIFF-6. Of one layer of elements, mixed conditions along z are plane strain: mean stresses of the layer
// under unit strains in its plane by a run in plane strain, whose faces do what those conditions say.
TEST_F(Stiffness, OfOneLayerWithMixedConditionsIsThatOfPlaneStrain) {
  write({8, 8, 1}, random_stack(6, 0.4));
  const std::string layer = deck(two_materials, "8, 8, 1");
  const Matrix6 found = matrix(run(layer)["stiffness"]["Mixed"]["mean stress"]);
  constexpr double strain = 1e-7, length[3] = {8.0, 10.0, 0.8};
  const auto stress = [&](const std::string& conditions) {
    std::string text = layer;
    text.replace(text.find("  Rig: {Kind: Stiffness}"), 24,
                 "  Loading: {Steps: 1}\n  Solver: {Newton Tolerance: 1.0e-12, Linear Tolerance: "
                 "1.0e-12}\n  Boundary Conditions:\n" +
                     conditions);
    text.replace(text.find("Grid: {"), 7, "Grid: {Plane Strain: true, ");
    const Outcome outcome = stroma(text, "run deck.yaml --quiet -o flat");
    EXPECT_EQ(outcome.status, 0) << text << outcome.standard_error;
    const History history(folder_ / "flat/history.csv");
    const auto mean = [&](const std::string& face, int component) {
      const int across = face[0] - 'x';
      const double area = length[1 - across] * length[2];
      return history[face + ".reaction_" + std::string(1, "xyz"[component])].back() / area / strain;
    };
    return std::array<double, 3>{mean("x+", 0), mean("y+", 1), mean("x+", 1)};
  };
  const std::string held = "    x-: {Face: x-, Components: x}\n    y-: {Face: y-, Components: y}\n";
  const auto along_x = stress(held +
                              "    x+: {Face: x+, Components: x, Strain: 1.0e-7}\n"
                              "    y+: {Face: y+, Components: y}\n"),
             along_y = stress(held +
                              "    x+: {Face: x+, Components: x}\n"
                              "    y+: {Face: y+, Components: y, Strain: 1.0e-7}\n");
  std::string sheared;
  for (const char* face : {"x-", "x+", "y-", "y+"})
    sheared += "    " + std::string(face) + ": {Face: " + face +
               ", Components: " + (face[0] == 'x' ? "y" : "x") +
               ", Displacement Gradient: [0, 0.5e-7, 0, 0.5e-7, 0, 0, 0, 0, 0]}\n";
  const double shear = stress(sheared)[2];
  const double tolerance = 1e-6 * found(0, 0);  // of a strain that is not quite 0
  EXPECT_NEAR(along_x[0], found(0, 0), tolerance);
  EXPECT_NEAR(along_x[1], found(1, 0), tolerance);
  EXPECT_NEAR(along_y[0], found(0, 1), tolerance);
  EXPECT_NEAR(along_y[1], found(1, 1), tolerance);
  EXPECT_NEAR(shear, found(5, 5), tolerance);
}

// V-STIFF-7. GIMP and CPDI, whose particles' domains lie within elements, are hats at rest; layers
// across elements' faces are exact with them, too.
TEST_F(Stiffness, OfWiderFunctionsIsThatOfHats) {
  const auto with = [](std::string text, const std::string& functions) {
    return text.replace(text.find("Grid: {"), 7, "Grid: {Shape Functions: " + functions + ", ");
  };
  write({8, 8, 8}, [](int, int, int k) { return k / 2 % 2; });
  const std::string text = deck(two_materials, "4, 4, 4");
  EXPECT_LT(distance(stiffness(run(with(text, "GIMP")), "Mixed"), layers()), 1e-10);
  write({8, 8, 8}, random_stack(7, 0.4));
  const nlohmann::json found = run(text);
  for (const char* functions : {"GIMP", "CPDI"}) {
    const nlohmann::json wider = run(with(text, functions), 2);
    for (const char* boundary : boundaries)
      EXPECT_LT(distance(stiffness(wider, boundary), stiffness(found, boundary)), 1e-10)
          << functions << boundary;
    EXPECT_LT(distance(matrix(wider["Voigt"]), matrix(found["Voigt"])), 1e-12);
  }
}

/// A stack that all turns and mirrors of the cube leave as it is.
auto cubic_stack(unsigned seed, double fraction, int n) {
  std::mt19937 generator(seed);
  std::vector<int> stiff(static_cast<std::size_t>(n * n * n));
  for (int& one : stiff) one = static_cast<double>(generator()) < fraction * 4294967296.0 ? 1 : 0;
  return [=](int i, int j, int k) {
    std::array<int, 3> at{std::min(i, n - 1 - i), std::min(j, n - 1 - j), std::min(k, n - 1 - k)};
    std::sort(at.begin(), at.end());
    return stiff[static_cast<std::size_t>(at[0] + n * (at[1] + n * at[2]))];
  };
}

// V-STIFF-4. A stack of cubic symmetry, repeated: mixed conditions are periodic ones, and its bulk
// modulus must lie between Hashin and Shtrikman's bounds.
TEST_F(Stiffness, OfACubicStackLiesBetweenHashinAndShtrikman) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    write({8, 8, 8}, cubic_stack(seed, 0.4, 8));
    std::string text = deck(two_materials, "8, 8, 8");
    text.replace(text.find("[1, 1.25, 0.8]"), 14, "[1, 1, 1]");
    const nlohmann::json found = run(text);
    const auto& mixed = found["stiffness"]["Mixed"];
    EXPECT_LT(mixed["symmetry error"], 1e-10);
    EXPECT_LT(mixed["closest"]["cubic"]["distance along the specimen's axes"], 1e-10);
    const double K = mixed["closest"]["isotropic"]["moduli"]["K"];
    const auto& bounds = found["bounds"];
    std::printf("  K %.2f Pa between %.2f and %.2f Pa\n", K,
                bounds["Hashin-Shtrikman -"]["K"].get<double>(),
                bounds["Hashin-Shtrikman +"]["K"].get<double>());
    EXPECT_GT(K, bounds["Hashin-Shtrikman -"]["K"].get<double>());
    EXPECT_LT(K, bounds["Hashin-Shtrikman +"]["K"].get<double>());
  }
}

// Empty space bears nothing: a specimen with a hole is softer, and one in two halves has no stiffness
// across.
TEST_F(Stiffness, CountsEmptySpace) {
  const std::string solid =
      "    soft: {Label: 0, 'Bulk Modulus [Pa]': 500, 'Shear Modulus [Pa]': 200}\n";
  const std::string empty = "Method: Labels, Empty Labels: [1]";
  write({8, 8, 8}, [](int i, int j, int k) {
    return i >= 2 && i < 6 && j >= 2 && j < 6 && k >= 2 && k < 6 ? 1 : 0;
  });
  const nlohmann::json hole = run(deck(solid, "8, 8, 8", empty));
  EXPECT_NEAR(hole["solid share"], 1.0 - 0.125, 1e-12);
  EXPECT_EQ(hole["stiffness"].size(), 3u);
  EXPECT_LT(distance(matrix(hole["Voigt"]), 0.875 * isotropic_stiffness(soft_bulk, soft_shear)),
            1e-12);
  EXPECT_GT(excess(matrix(hole["Voigt"]), stiffness(hole, "Uniform Displacement")), 1e-3);
  EXPECT_GT(excess(stiffness(hole, "Uniform Displacement"), stiffness(hole, "Mixed")), -1e-9);
  EXPECT_GT(excess(stiffness(hole, "Mixed"), stiffness(hole, "Uniform Traction")), 1e-3);
  EXPECT_EQ(hole["bounds"]["Reuss"]["K"], 0.0);
  EXPECT_TRUE(hole["Reuss"].is_null());
  EXPECT_LT(hole["stiffness"]["Mixed"]["closest"]["isotropic"]["moduli"]["K"],
            hole["bounds"]["Hashin-Shtrikman +"]["K"]);

  // Two slabs with a gap: each is in plane stress, in the mean over the box.
  write({8, 8, 8}, [](int i, int, int) { return i == 3 || i == 4 ? 1 : 0; });
  const nlohmann::json gap = run(deck(solid, "8, 8, 8", empty));
  EXPECT_EQ(gap["stiffness"].size(), 2u);  // no traction
  EXPECT_TRUE(gap["stiffness"]["Mixed"]["compliance"].is_null());
  const Matrix6 found = stiffness(gap, "Mixed");
  const double young = 9.0 * soft_bulk * soft_shear / (3.0 * soft_bulk + soft_shear),
               nu = young / (2.0 * soft_shear) - 1.0, plane = 0.75 * young / (1.0 - nu * nu);
  Matrix6 exact = Matrix6::Zero();
  exact(1, 1) = exact(2, 2) = plane;
  exact(1, 2) = exact(2, 1) = nu * plane;
  exact(3, 3) = 0.75 * soft_shear;
  EXPECT_LT(distance(found, exact), 1e-10);
}

// What a user sees: load cases, table, files of a second run, and refusals.
TEST_F(Stiffness, IsWrittenAndTold) {
  write({8, 8, 8}, random_stack(5, 0.3));
  const std::string text = deck(two_materials, "4, 4, 4");
  const Outcome checked = stroma(text, "check deck.yaml");
  EXPECT_EQ(checked.status, 0) << checked.standard_error;
  for (const char* line : {"Mixed: xx yy zz; as in a uniform strain are x of x-, x of x+",
                           "Mixed: xy; as in a uniform strain are yz of x-", "nothing is held"})
    EXPECT_NE(checked.standard_output.find(line), std::string::npos) << checked.standard_output;

  const nlohmann::json found = run(text);
  std::map<std::string, double> table;
  for (const auto& row : rows_of(folder_ / "out" / "stiffness.csv"))
    table[row.at("boundary") + "|" + row.at("tensor") + "|" + row.at("figure")] =
        std::stod(row.at("value"));
  const auto& mixed = found["stiffness"]["Mixed"];
  EXPECT_EQ(table.at("Mixed|specimen|C_xx_zz"), matrix(mixed["stiffness"])(0, 2));
  EXPECT_EQ(table.at("Mixed|specimen|S_yz_yz"), matrix(mixed["compliance"])(3, 3));
  EXPECT_EQ(table.at("Mixed|specimen|nu_xy"), mixed["moduli"]["nu_xy"].get<double>());
  EXPECT_EQ(table.at("Mixed|orthotropic|G_12"), mixed["closest"]["orthotropic"]["moduli"]["G_12"]);
  EXPECT_EQ(table.at("bounds|Hashin-Shtrikman +|G"), found["bounds"]["Hashin-Shtrikman +"]["G"]);
  EXPECT_EQ(table.at("bounds|Reuss|C_xx_yy"), matrix(found["Reuss"])(0, 1));
  EXPECT_EQ(table.at("Mixed|specimen|iterations_xy"), mixed["load cases"]["xy"]["iterations"]);
  for (const auto& one : mixed["load cases"]) EXPECT_LE(one["residual"], 1e-11);
  EXPECT_EQ(found["share of materials"]["soft"].get<double>() +
                found["share of materials"]["stiff"].get<double>(),
            found["solid share"]);
  EXPECT_LT((matrix(mixed["compliance"]) * matrix(mixed["stiffness"]) - Matrix6::Identity()).norm(),
            1e-12);
  EXPECT_FALSE(fs::exists(folder_ / "out" / "history.csv"));

  // deck.xml is the deck, and a second run replaces the first.
  fs::copy_file(folder_ / "out" / "deck.xml", folder_ / "again.xml");
  Outcome outcome = run_stroma(folder_.path(), "run again.xml -o out --set 'Rig|Boundary={Mixed}'");
  EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
  EXPECT_NE(outcome.standard_output.find("removed     5 files"), std::string::npos)
      << outcome.standard_output;
  const auto second = nlohmann::json::parse(content_of(folder_ / "out" / "stiffness.json"));
  EXPECT_EQ(second["stiffness"].size(), 1u);
  EXPECT_EQ(matrix(second["stiffness"]["Mixed"]["stiffness"]), matrix(mixed["stiffness"]));

  for (const char* command : {"verify out", "run deck.yaml -o out --restart",
                              "run deck.yaml -o out --time-limit 01:00"}) {
    outcome = run_stroma(folder_.path(), command);
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_NE(outcome.standard_error.find("Rig|Kind = Stiffness"), std::string::npos)
        << command << outcome.standard_error;
  }
  folder_.write("study.yaml",
                "Study:\n  Base Deck: deck.yaml\n  Vary:\n"
                "    Materials|soft|Shear Modulus [Pa]: [200, 300]\n");
  outcome = run_stroma(folder_.path(), "study study.yaml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.standard_error.find("Rig|Kind = Stiffness"), std::string::npos)
      << outcome.standard_error;
}

TEST_F(Stiffness, NeedsASolidSurfaceForTractions) {
  write({8, 8, 8}, [](int i, int, int) { return i == 3 || i == 4 ? 1 : 0; });
  const std::string text =
      deck("    soft: {Label: 0, 'Bulk Modulus [Pa]': 500, 'Shear Modulus [Pa]': 200}\n", "8, 8, 8",
           "Method: Labels, Empty Labels: [1]", "Kind: Stiffness, Boundary: [Uniform Traction]");
  for (const char* command : {"check deck.yaml", "run deck.yaml -o out"}) {
    const Outcome outcome = stroma(text, command);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.standard_error.find("Rig|Boundary: empty space cuts the surface"),
              std::string::npos)
        << outcome.standard_error;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

}  // namespace
}  // namespace stroma::test
