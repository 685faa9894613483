// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The tables of a run's last step, against particles.e, from which they are computed here in other
/// ways. Claims V-TABLE, docs/verification.md.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/files/ParticleReader.hpp"
#include "support/Program.hpp"
#include "support/SmallDeck.hpp"
#include "support/TableRows.hpp"

namespace stroma::test {
namespace {

double number(const std::map<std::string, std::string>& row, const std::string& name) {
  return output::csv_number(row.at(name)).value_or(NAN);
}

/// Three balls of two materials of their own in a block, which is stretched, to the last digits.
std::string block(const std::string& more = "", const std::string& grid = "",
                  const std::string& of_ball = "") {
  return R"(Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [12, 16, 10]
      Voxel Size [um]: [1, 1, 1.5]
      Shapes:
        ball: {Kind: Ball, "Center [um]": [4, 5, 5], "Radius [um]": 3, Label: 1}
        other: {Kind: Ball, "Center [um]": [8, 11, 10], "Radius [um]": 3, Label: 7}
        small: {Kind: Ball, "Center [um]": [2, 13, 4], "Radius [um]": 1.9, Label: 1}
  Materials:
    gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}
    soft ball: {Label: 1, "Shear Modulus [Pa]": 100, Poisson Ratio: 0.4)" +
         of_ball + R"(}
    stiff ball: {Label: 7, "Shear Modulus [Pa]": 5000, Poisson Ratio: 0.2}
  Grid:
    Elements: [6, 8, 5])" +
         grid + R"(
  Boundary Conditions:
    bottom: {Face: y-, Components: xyz}
    top: {Face: y+, Components: xyz, Strain: 0.2}
  Solver: {Newton Tolerance: 1e-12, Preconditioner: Direct}
  Output: {Pictures: false, Report: false)" +
         more + "}\n";
}

void run(const TemporaryFolder& folder, const std::string& deck, const std::string& name,
         int ranks = 1, const std::string& options = "", int status = 0) {
  folder.write(name + ".yaml", deck);
  const Outcome outcome =
      run_stroma(folder.path(), "run " + name + ".yaml -o " + name + " --quiet " + options, ranks);
  EXPECT_EQ(outcome.status, status) << deck << outcome.standard_error;
}

constexpr std::array<std::int64_t, 3> voxels_along{12, 16, 10};
constexpr std::array<double, 3> voxel_size{1.0, 1.0, 1.5};

/// Of the balls, in the order of their first voxels, by z: label, middle and radius [um].
struct Ball {
  std::size_t material;
  std::array<double, 3> middle;
  double radius;
};
const std::array<Ball, 3> balls{{{1, {4, 5, 5}, 3}, {1, {2, 13, 4}, 1.9}, {2, {8, 11, 10}, 3}}};

/// Number of the ball that a voxel lies in, from 1, or 0.
std::size_t ball_at(const std::array<std::int64_t, 3>& voxel) {
  for (std::size_t b = 0; b < balls.size(); ++b) {
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
      square +=
          std::pow((static_cast<double>(voxel[d]) + 0.5) * voxel_size[d] - balls[b].middle[d], 2);
    if (square <= balls[b].radius * balls[b].radius) return b + 1;
  }
  return 0;
}

template <class Use>
void for_each_voxel(const Use& use) {
  for (std::int64_t k = 0; k < voxels_along[2]; ++k)
    for (std::int64_t j = 0; j < voxels_along[1]; ++j)
      for (std::int64_t i = 0; i < voxels_along[0]; ++i) use(std::array<std::int64_t, 3>{i, j, k});
}

/// A particle of the last step of particles.e.
struct Particle {
  std::size_t material;
  double volume;  // deformed
  std::array<std::int64_t, 3> voxel;
  std::map<std::string, double> of;
};

std::vector<Particle> particles_of(const fs::path& folder) {
  const output::ParticleReader reader((folder / "particles.e").string());
  std::vector<std::string> names{"von_mises", "jacobian"};
  for (const char* tensor : {"stress", "strain"})
    for (const char* component : {"xx", "yy", "zz", "xy", "yz", "zx"})
      names.push_back(std::string(tensor) + "_" + component);
  std::vector<Particle> all;
  reader.for_pieces(reader.steps() - 1, names, [&](const output::ParticlePiece& piece) {
    for (std::size_t n = 0; n < piece.count; ++n) {
      Particle one{piece.material, piece.volume[n], {}, {}};
      for (std::size_t d = 0; d < 3; ++d)
        one.voxel[d] = static_cast<std::int64_t>(std::floor(piece.position[d][n] / voxel_size[d]));
      for (std::size_t v = 0; v < names.size(); ++v) one.of[names[v]] = piece.values[v][n];
      one.volume *= one.of["jacobian"];
      for (const std::string& tensor : {std::string("stress"), std::string("strain")}) {
        const auto at = [&](const char* component) { return one.of[tensor + "_" + component]; };
        Eigen::Matrix3d matrix;
        matrix << at("xx"), at("xy"), at("zx"), at("xy"), at("yy"), at("yz"), at("zx"), at("yz"),
            at("zz");
        const Eigen::Vector3d principal =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvalues();  // ascending
        for (int i = 0; i < 3; ++i)
          one.of["principal_" + tensor + "_" + std::to_string(i + 1)] = principal[2 - i];
      }
      all.push_back(one);
    }
  });
  return all;
}

/// Value and volume of a quantity over a material, ascending.
std::vector<std::pair<double, double>> sorted(const std::vector<Particle>& particles,
                                              std::size_t material, const std::string& quantity) {
  std::vector<std::pair<double, double>> values;
  for (const Particle& one : particles)
    if (one.material == material) values.emplace_back(one.of.at(quantity), one.volume);
  std::sort(values.begin(), values.end());
  return values;
}

const std::vector<std::string> materials{"gel", "soft ball", "stiff ball"};

/// materials.csv and histograms.csv of a folder.
void expect_material_tables(const fs::path& folder) {
  const std::vector<Particle> particles = particles_of(folder);
  const auto summary = rows_of(folder / "materials.csv"), bins = rows_of(folder / "histograms.csv");
  const History history(folder / "history.csv");
  ASSERT_EQ(summary.size(), 8 * materials.size());
  ASSERT_EQ(bins.size(), 64 * summary.size());
  for (std::size_t r = 0; r < summary.size(); ++r) {
    const auto& row = summary[r];
    const std::size_t material = r / 8;
    const std::string quantity = row.at("quantity");
    SCOPED_TRACE(materials[material] + ", " + quantity);
    EXPECT_EQ(row.at("material"), materials[material]);
    EXPECT_EQ(number(row, "step"), history["step"].back());
    EXPECT_EQ(number(row, "time"), history["time"].back());
    const bool is_stress = quantity == "von_mises" || quantity.rfind("principal_stress", 0) == 0;
    EXPECT_EQ(row.at("unit"), is_stress ? "Pa" : "1");
    const auto values = sorted(particles, material, quantity);
    double volume = 0.0, sum = 0.0;
    for (const auto& [value, of] : values) {
      volume += of;
      sum += value * of;
    }
    const double size = std::max(std::abs(values.front().first), std::abs(values.back().first));
    EXPECT_NEAR(number(row, "volume"), volume, 1e-12 * volume);
    EXPECT_NEAR(number(row, "mean"), sum / volume, 1e-12 * size);
    EXPECT_NEAR(number(row, "minimum"), values.front().first, 1e-12 * size);
    EXPECT_NEAR(number(row, "maximum"), values.back().first, 1e-12 * size);
    for (const auto& [name, share] :
         {std::pair{"p05", 0.05}, {"p25", 0.25}, {"p50", 0.5}, {"p75", 0.75}, {"p95", 0.95}}) {
      double up_to = 0.0;
      std::size_t n = 0;
      while ((up_to += values[n].second) < share * volume) ++n;
      EXPECT_NEAR(number(row, name), values[n].first, 1e-12 * size) << name;
    }
    double in_bins = 0.0;
    for (std::size_t b = 64 * r; b < 64 * (r + 1); ++b) {
      EXPECT_EQ(bins[b].at("material"), materials[material]);
      EXPECT_EQ(bins[b].at("quantity"), quantity);
      EXPECT_EQ(bins[b].at("unit"), row.at("unit"));
      const double low = number(bins[b], "low"), high = number(bins[b], "high");
      EXPECT_NEAR(high - low, (values.back().first - values.front().first) / 64.0, 1e-12 * size);
      double within = 0.0;
      for (const auto& [value, of] : values)
        if (value >= low - 1e-13 * size && (value < high - 1e-13 * size || b % 64 == 63))
          within += of;
      EXPECT_NEAR(number(bins[b], "volume"), within, 1e-12 * volume);
      in_bins += number(bins[b], "volume");
    }
    EXPECT_NEAR(in_bins, volume, 1e-12 * volume);
  }
}

/// From the middle of a voxel to the nearest box of a voxel on the other side of a material's wall.
double distance_to_wall(const std::array<std::int64_t, 3>& voxel, std::size_t material) {
  const auto is_inside = [&](const std::array<std::int64_t, 3>& at) {
    const std::size_t ball = ball_at(at);
    return ball > 0 && balls[ball - 1].material == material;
  };
  double least = HUGE_VAL;
  for_each_voxel([&](const std::array<std::int64_t, 3>& other) {
    if (is_inside(other) == is_inside(voxel)) return;
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto away = static_cast<double>(std::abs(other[d] - voxel[d]));
      square += away > 0.0 ? std::pow((away - 0.5) * voxel_size[d], 2) : 0.0;
    }
    least = std::min(least, square);
  });
  return std::sqrt(least);
}

/// wall_distance.csv of a folder.
void expect_wall_table(const fs::path& folder) {
  const std::vector<Particle> particles = particles_of(folder);
  const auto rows = rows_of(folder / "wall_distance.csv");
  std::size_t row = 0;
  for (const std::size_t wall : {1, 2}) {  // the one with more voxels first
    std::map<std::pair<std::size_t, std::int64_t>, std::vector<const Particle*>> bins;
    std::map<std::array<std::int64_t, 3>, double> distance;
    for (const Particle& one : particles) {
      if (distance.count(one.voxel) == 0) distance[one.voxel] = distance_to_wall(one.voxel, wall);
      bins[{one.material, static_cast<std::int64_t>(std::floor(distance[one.voxel] + 1e-6))}]
          .push_back(&one);
    }
    for (const auto& [bin, all] : bins) {
      ASSERT_LT(row, rows.size());
      const auto& is = rows[row++];
      EXPECT_EQ(is.at("label_material"), materials[wall]);
      EXPECT_EQ(is.at("material"), materials[bin.first]);
      EXPECT_EQ(number(is, "low"), static_cast<double>(bin.second));
      EXPECT_EQ(number(is, "high"), static_cast<double>(bin.second + 1));
      double volume = 0.0;
      std::map<std::string, double> sum;
      std::vector<std::pair<double, double>> stress;
      for (const Particle* one : all) {
        volume += one->volume;
        for (const char* quantity : {"von_mises", "principal_stress_1", "principal_strain_1"})
          sum[quantity] += one->volume * one->of.at(quantity);
        stress.emplace_back(one->of.at("von_mises"), one->volume);
      }
      EXPECT_NEAR(number(is, "volume"), volume, 1e-12 * volume);
      for (const auto& [quantity, of] : sum)
        EXPECT_NEAR(number(is, quantity + "_mean"), of / volume, 1e-10 * std::abs(of / volume));
      std::sort(stress.begin(), stress.end());
      for (const auto& [name, share] :
           {std::pair{"von_mises_p05", 0.05}, {"von_mises_p50", 0.5}, {"von_mises_p95", 0.95}}) {
        double up_to = 0.0;
        std::size_t n = 0;
        while ((up_to += stress[n].second) < share * volume * (1.0 - 1e-9)) ++n;
        EXPECT_NEAR(number(is, name), stress[n].first, 1e-12 * stress.back().first);
      }
    }
  }
  EXPECT_EQ(row, rows.size());
}

/// objects.csv of a folder.
void expect_object_table(const fs::path& folder) {
  const std::vector<Particle> particles = particles_of(folder);
  const auto rows = rows_of(folder / "objects.csv");
  ASSERT_EQ(rows.size(), balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const auto& row = rows[b];
    SCOPED_TRACE("object " + std::to_string(b + 1));
    EXPECT_EQ(number(row, "object"), static_cast<double>(b + 1));
    EXPECT_EQ(row.at("material"), materials[balls[b].material]);
    double voxels = 0.0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for_each_voxel([&](const std::array<std::int64_t, 3>& voxel) {
      if (ball_at(voxel) != b + 1) return;
      Eigen::Vector3d x;
      for (int d = 0; d < 3; ++d)
        x[d] = (static_cast<double>(voxel[static_cast<std::size_t>(d)]) + 0.5) *
               voxel_size[static_cast<std::size_t>(d)];
      voxels += 1.0;
      middle += x;
      squares += x * x.transpose();
    });
    middle /= voxels;
    squares = squares / voxels - middle * middle.transpose();
    for (int d = 0; d < 3; ++d)
      squares(d, d) += std::pow(voxel_size[static_cast<std::size_t>(d)], 2) / 12.0;
    EXPECT_EQ(number(row, "voxels"), voxels);
    EXPECT_EQ(number(row, "volume"), 1.5 * voxels);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shape(squares);
    double along = 0.0;
    for (int d = 0; d < 3; ++d) {
      const std::string name(1, "xyz"[d]);
      EXPECT_NEAR(number(row, "centroid_" + name), middle[d], 1e-12 * middle[d]);
      EXPECT_NEAR(number(row, "axis_" + std::to_string(d + 1)),
                  2.0 * std::sqrt(5.0 * shape.eigenvalues()[2 - d]), 1e-10);
      along += number(row, "axis_1_" + name) * shape.eigenvectors()(d, 2);
    }
    if (shape.eigenvalues()[2] > 1.0001 * shape.eigenvalues()[1]) {
      EXPECT_NEAR(std::abs(along), 1.0, 1e-10);
    }

    double volume = 0.0;
    std::map<std::string, double> sum;
    for (const Particle& one : particles) {
      if (ball_at(one.voxel) != b + 1) continue;
      volume += one.volume;
      for (const auto& [name, value] : one.of) sum[name] += one.volume * value;
    }
    const double most = std::abs(sum["von_mises"]);
    EXPECT_NEAR(number(row, "deformed_volume"), volume, 1e-12 * volume);
    EXPECT_NEAR(number(row, "von_mises_mean"), most / volume, 1e-11 * most / volume);
    Eigen::Matrix3d stress;
    const std::array<const char*, 6> components{"xx", "yy", "zz", "xy", "yz", "zx"};
    for (int c = 0; c < 6; ++c) {
      const std::string name = components[static_cast<std::size_t>(c)];
      const double force = sum["stress_" + name];
      stress(c % 3, c < 3 ? c : (c + 1) % 3) = stress(c < 3 ? c : (c + 1) % 3, c % 3) =
          force / volume;
      EXPECT_NEAR(number(row, "dipole_" + name), force, 1e-11 * most) << name;
      EXPECT_NEAR(number(row, "stress_" + name), force / volume, 1e-11 * most / volume) << name;
      EXPECT_NEAR(number(row, "strain_" + name), sum["strain_" + name] / volume, 1e-12) << name;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(stress);
    EXPECT_NEAR(number(row, "principal_stress_1"), principal.eigenvalues()[2],
                1e-11 * most / volume);
    double turned = 0.0;
    for (int d = 0; d < 3; ++d)
      turned += number(row, "principal_direction_" + std::string(1, "xyz"[d])) *
                principal.eigenvectors()(d, 2);
    EXPECT_NEAR(std::abs(turned), 1.0, 1e-9);
  }
}

void expect_tables(const fs::path& folder) {
  expect_material_tables(folder);
  expect_wall_table(folder);
  expect_object_table(folder);
}

const std::string viscous = ", Viscosity: {Moduli: [0.5], \"Relaxation Times [s]\": [1]}";

// V-TABLE-1
TEST(Tables, AreThoseOfTheParticles) {
  for (const int ranks : {1, 2, 4})
    for (const bool resets : {false, true}) {
      SCOPED_TRACE(std::to_string(ranks) + (resets ? " ranks, reset" : " ranks"));
      const TemporaryFolder folder;
      const std::string time = "  Loading: {Steps: 3, \"Duration [s]\": 2}\n";
      run(folder, block("", resets ? "\n    Reset: true" : "", viscous) + time, "out", ranks);
      expect_tables(folder / "out");
      EXPECT_EQ(run_stroma(folder.path(), "verify out").status, 0);
    }
}

TEST(Tables, FindTheVoxelsOfParticlesInAnyLayout) {
  for (const auto& [layout, functions] : {std::pair{"Gauss", "Linear"},
                                          {"Per Element, Per Element: 3", "GIMP"},
                                          {"Voxel Centers, Per Voxel: 2", "Linear"}}) {
    SCOPED_TRACE(layout);
    const TemporaryFolder folder;
    run(folder,
        block("", std::string("\n    Shape Functions: ") + functions) +
            "  Particles: {Layout: " + layout + "}\n  Loading: {Steps: 1}\n",
        "out", 2);
    expect_wall_table(folder / "out");
    expect_object_table(folder / "out");
  }
}

/// All tables, number for number.
void expect_same(const fs::path& one, const fs::path& other, double tolerance) {
  for (const char* file : {"materials.csv", "histograms.csv", "wall_distance.csv", "objects.csv"}) {
    const auto a = rows_of(one / file), b = rows_of(other / file);
    ASSERT_EQ(a.size(), b.size()) << file;
    ASSERT_FALSE(a.empty());
    // Of the columns of a quantity; of a tensor's components together.
    std::map<std::string, double> size;
    const auto group = [&](const auto& row, const std::string& name) {
      return (row.count("quantity") > 0 ? row.at("quantity") : "") +
             (name.substr(0, name.find('_')) == "principal" ? name
                                                            : name.substr(0, name.find('_')));
    };
    for (const auto& row : a)
      for (const auto& [name, text] : row) {
        double& most = size[group(row, name)];
        most = std::max(most, std::abs(output::csv_number(text).value_or(0.0)));
      }
    for (std::size_t r = 0; r < a.size(); ++r)
      for (const auto& [name, text] : a[r]) {
        const auto is = output::csv_number(text), was = output::csv_number(b[r].at(name));
        ASSERT_EQ(is.has_value(), was.has_value());
        if (!is) {
          EXPECT_EQ(text, b[r].at(name));
          continue;
        }
        EXPECT_NEAR(*is, *was, tolerance * size[group(a[r], name)])
            << file << " " << r << " " << name;
      }
  }
}

// V-TABLE-2
TEST(Tables, AreTheSameOnAnyNumberOfRanks) {
  const TemporaryFolder folder;
  const std::string deck = block("", "", viscous) + "  Loading: {Steps: 4, \"Duration [s]\": 2}\n";
  run(folder, deck, "one");
  for (const int ranks : {2, 4}) {
    const std::string name = "on_" + std::to_string(ranks);
    run(folder, deck, name, ranks);
    expect_same(folder / "one", folder / name, 1e-12);
  }
}

TEST(Tables, AreThoseOfTheLastAcceptedStepOfARunThatStopsAndGoesOn) {
  for (const bool resets : {false, true}) {
    const TemporaryFolder folder;
    const std::string deck = block("", resets ? "\n    Reset: true" : "", viscous) +
                             "  Loading: {Steps: 3, \"Duration [s]\": 2}\n";
    run(folder, deck, "out", 1, "--time-limit 00:00:03" + endless, 1);
    expect_tables(folder / "out");
    run(folder, deck, "out", 2, "--restart");
    expect_tables(folder / "out");
    EXPECT_EQ(run_stroma(folder.path(), "verify out").status, 0);
  }
}

/// The step that fails is another time and another load: stress that relaxes would be less.
TEST(Tables, AreThoseOfTheLastAcceptedStepOfARunThatFails) {
  const TemporaryFolder folder;
  std::string deck = block("", "", viscous);
  const std::string strain = "Strain: 0.2", solver = "Solver: {Newton Tolerance: 1e-12";
  deck.replace(deck.find(strain), strain.size(), strain + ", Load Curve: late");
  deck.replace(deck.find(solver), solver.size(),
               "Solver: {Newton Iterations: 2, Newton Tolerance: 1e-9");
  deck +=
      "  Load Curves: {late: {\"Times [s]\": [0, 1, 2], Values: [0, 1e-4, 1]}}\n"
      "  Loading: {Steps: 2, \"Duration [s]\": 2, Smallest Step: 0.5}\n";
  run(folder, deck, "out", 1, "", 1);
  EXPECT_EQ(History(folder / "out/history.csv").rows(), 2U);
  expect_tables(folder / "out");
}

TEST(Tables, OfAHomogeneousStateHaveOneBin) {
  const TemporaryFolder folder;
  run(folder, R"(Stroma:
  Image: {Phantom: {Kind: Uniform, Size: [4, 6, 4], "Voxel Size [um]": [1, 1, 2]}}
  Materials: {gel: {Label: 0, "Shear Modulus [Pa]": 500, Poisson Ratio: 0.3}}
  Grid: {Elements: [2, 3, 2]}
  Boundary Conditions:
    all: {Face: all, Components: xyz, Displacement Gradient: [0, 0, 0, 0, 0.5, 0, 0, 0, 0]}
  Output: {Pictures: false, Report: false}
)",
      "out");
  const auto bins = rows_of(folder / "out/histograms.csv");
  ASSERT_EQ(bins.size(), 8U);
  for (const auto& bin : bins) EXPECT_NEAR(number(bin, "volume"), 1.5 * 192.0, 1e-9);
  EXPECT_NEAR(number(bins[4], "low"), 0.5 * (1.5 * 1.5 - 1.0), 1e-9);  // principal_strain_1
  EXPECT_NEAR(number(bins[7], "high"), 1.5, 1e-9);                     // jacobian
  EXPECT_TRUE(rows_of(folder / "out/wall_distance.csv").empty());      // there is none
  const auto objects = rows_of(folder / "out/objects.csv");            // the only label is one
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(number(objects[0], "volume"), 192.0);
  EXPECT_NEAR(number(objects[0], "axis_1"), 2.0 * std::sqrt(5.0 / 12.0) * 8.0, 1e-12);
  EXPECT_EQ(number(objects[0], "axis_1_z"), 1.0);
}

TEST(Tables, BelongToTheRun) {
  const TemporaryFolder folder;
  const std::string deck = block() + "  Loading: {Steps: 1}\n";
  run(folder, deck, "out");
  run(folder, deck, "out", 1, "--set 'Output|Tables=false'");  // removes what the first has left
  for (const char* table : {"materials", "histograms", "wall_distance", "objects"})
    EXPECT_FALSE(fs::exists(folder / "out" / (std::string(table) + ".csv"))) << table;
  folder.write("out/materials.csv", "my,own\n");
  run(folder, deck, "out", 1, "--set 'Output|Tables=false'");
  run(folder, deck, "out", 1, "", 2);
  EXPECT_EQ(content_of(folder / "out/materials.csv"), "my,own\n");
}

}  // namespace
}  // namespace stroma::test
