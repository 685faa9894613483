// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What report.html is made of: particles.e read back in pieces, maps of it, packed arrays, the page.

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/files/ParticleReader.hpp"
#include "stroma/output/report/Packed.hpp"
#include "stroma/output/report/ParticleMaps.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {
namespace {

using output::MapLattice;
using output::ParticleReader;

constexpr std::int64_t nx = 6, ny = 4, nz = 3;
constexpr double hx = 0.5, hy = 2.0, hz = 1.5;
constexpr int steps = 5;

/// A lattice of particles, one after the other to the ranks in turn; those with i = 2 are missing.
/// Material 1 is where i > 3. Stress is uniaxial along y, s = step (1 + i + 10 j + 100 k), and so
/// are the strains, E_yy = s / 1000; the displacement is (3 s, 0, -4 s).
struct Block {
  explicit Block(const std::string& path) {
    const auto world = base::Communicator::world();
    for (std::int64_t n = 0; n < nx * ny * nz; ++n) {
      const std::int64_t i = n % nx, j = n / nx % ny, k = n / nx / ny;
      if (i == 2 || n % world.size() != world.rank()) continue;
      id.push_back(n);
      material.push_back(i > 3 ? 1 : 0);
      volume.push_back(hx * hy * hz * (i == 1 ? 0.25 : 1.0));
      for (const double x :
           {10.0 + (0.5 + static_cast<double>(i)) * hx, (0.5 + static_cast<double>(j)) * hy,
            (0.5 + static_cast<double>(k)) * hz})
        position.push_back(x);
      pattern.push_back(1.0 + static_cast<double>(i + 10 * j + 100 * k));
    }
    const auto count = static_cast<std::int64_t>(id.size());
    const output::ParticleSet set{count, position.data(), volume.data(), id.data(),
                                  material.data()};
    output::ParticleFile file(world, path, set, {"gel", "vessel"}, {"step", "load", "time"},
                              {"title", "0", "deck"});
    const std::vector<double> one(id.size(), 1.0);
    for (int step = 0; step < steps; ++step) {
      std::vector<double> stress(id.size() * 6), gradient(id.size() * 9),
          displacement(id.size() * 3);
      for (std::size_t p = 0; p < id.size(); ++p) {
        stress[6 * p + 1] = step * pattern[p];
        displacement[3 * p] = 3.0 * step * pattern[p];
        displacement[3 * p + 2] = -4.0 * step * pattern[p];
        gradient[9 * p + 4] = std::sqrt(1.0 + 2.0 * step * pattern[p] / 1000.0) - 1.0;
      }
      file.write(0.25 * step, set,
                 output::in_one_piece(count, {displacement.data(), stress.data(), gradient.data(),
                                              one.data(), one.data()}),
                 {static_cast<double>(step), 0.25 * step, 2.5 * step});
    }
  }

  std::vector<std::int64_t> id;
  std::vector<std::uint8_t> material;
  std::vector<double> position, volume, pattern;
};

double pattern_at(std::int64_t i, std::int64_t j, std::int64_t k) {
  return 1.0 + static_cast<double>(i + 10 * j + 100 * k);
}

TEST(ParticleReader, ReadsAllRanksFilesInPieces) {
  const TemporaryFolder folder;
  const Block block(folder / "particles.e");
  base::Communicator::world().barrier();
  const ParticleReader reader(folder / "particles.e");
  EXPECT_EQ(reader.materials(), (std::vector<std::string>{"gel", "vessel"}));
  EXPECT_EQ(reader.steps(), static_cast<std::size_t>(steps));
  EXPECT_EQ(reader.global("time"), (std::vector<double>{0.0, 2.5, 5.0, 7.5, 10.0}));
  EXPECT_THROW(reader.global("none"), base::RunError);
  std::size_t count = 0;
  double volume = 0.0;
  reader.for_pieces(3, {"von_mises", "stress_yy"}, [&](const output::ParticlePiece& piece) {
    for (std::size_t p = 0; p < piece.count; ++p) {
      const auto i = std::llround((piece.position[0][p] - 10.0) / hx - 0.5);
      const auto j = std::llround(piece.position[1][p] / hy - 0.5),
                 k = std::llround(piece.position[2][p] / hz - 0.5);
      EXPECT_EQ(piece.material, i > 3 ? 1u : 0u);
      EXPECT_DOUBLE_EQ(piece.values[1][p], 3.0 * pattern_at(i, j, k));
      EXPECT_NEAR(piece.values[0][p], 3.0 * pattern_at(i, j, k), 1e-10);
      volume += piece.volume[p];
    }
    count += piece.count;
  });
  EXPECT_EQ(count, static_cast<std::size_t>((nx - 1) * ny * nz));
  EXPECT_NEAR(volume, (nx - 1.75) * ny * nz * hx * hy * hz, 1e-10);
}

TEST(ParticleReader, TellsWhatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_THROW(ParticleReader(folder / "particles.e"), base::RunError);
}

// V-REPORT
TEST(ParticleMaps, HaveACellForEachParticle) {
  const TemporaryFolder folder;
  const Block block(folder / "particles.e");
  base::Communicator::world().barrier();
  const output::ParticleMaps maps =
      output::particle_maps(ParticleReader(folder / "particles.e"), 32, 1'000'000);
  const MapLattice& lattice = maps.lattice;
  EXPECT_EQ(lattice.count, (std::array<std::int64_t, 3>{nx, ny, nz}));
  EXPECT_NEAR(lattice.cell[0], hx, 1e-12);
  EXPECT_NEAR(lattice.origin[0], 10.0, 1e-12);
  ASSERT_EQ(maps.fields.size(), 4u);
  EXPECT_EQ(maps.fields[3].name, "displacement");
  EXPECT_EQ(maps.fields[2].name, "principal_strain_1");
  for (std::int64_t n = 0; n < nx * ny * nz; ++n) {
    const std::int64_t i = n % nx, j = n / nx % ny, k = n / nx / ny;
    const auto cell = static_cast<std::size_t>(n);
    EXPECT_EQ(maps.material[cell], i == 2 ? 0 : i > 3 ? 2 : 1);
    for (std::size_t step = 0; step < steps; ++step) {
      const double wanted = static_cast<double>(step) * pattern_at(i, j, k);
      if (i == 2) {
        EXPECT_TRUE(std::isnan(maps.fields[0].values[step][cell]));
      } else {
        EXPECT_NEAR(maps.fields[0].values[step][cell], wanted, 1e-6 * wanted);
        EXPECT_NEAR(maps.fields[1].values[step][cell], wanted, 1e-6 * wanted);
        EXPECT_NEAR(maps.fields[2].values[step][cell], wanted / 1000.0, 1e-6 * wanted);
        EXPECT_NEAR(maps.fields[3].values[step][cell], 5.0 * wanted, 1e-6 * wanted);
      }
    }
  }
}

// V-REPORT
TEST(ParticleMaps, MergeCellsByVolumeAndSkipStepsToStaySmall) {
  const TemporaryFolder folder;
  const Block block(folder / "particles.e");
  base::Communicator::world().barrier();
  const output::ParticleMaps maps =
      output::particle_maps(ParticleReader(folder / "particles.e"), 3, 3 * 4 * 18);
  EXPECT_EQ(maps.steps, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(maps.lattice.merged, (std::array<std::int64_t, 3>{2, 2, 1}));
  EXPECT_EQ(maps.lattice.count, (std::array<std::int64_t, 3>{3, 2, 3}));
  EXPECT_NEAR(maps.lattice.length[0], nx * hx, 1e-12);
  // i = 0 and 1 (a quarter as large), j = 0 and 1, at step 4
  const double mean = 4.0 * (1.0 + 0.25 * 1.0 / 1.25 + 5.0);
  EXPECT_NEAR(maps.fields[0].values[2][0], mean, 1e-6 * mean);
}

TEST(Packed, IsUnpackedAsBrowsersDo) {
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 1000; ++i) bytes.push_back(static_cast<std::uint8_t>(i * i));
  const std::string text = output::packed(bytes);
  std::vector<unsigned char> deflated(text.size());
  const int size =
      EVP_DecodeBlock(deflated.data(), reinterpret_cast<const unsigned char*>(text.data()),
                      static_cast<int>(text.size()));
  ASSERT_GT(size, 0);
  std::vector<std::uint8_t> back(bytes.size());
  uLongf length = back.size();
  ASSERT_EQ(uncompress(back.data(), &length, deflated.data(), static_cast<uLong>(size)), Z_OK);
  EXPECT_EQ(back, bytes);
}

TEST(Packed, NumbersComeBackToHalfAStep) {
  const std::vector<float> values{-1.0f, 0.25f, NAN, 3.0f, 2.999f};
  const auto bytes = output::quantised(values, -1.0, 3.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int q = bytes[i] + 256 * bytes[values.size() + i];
    if (std::isnan(values[i]))
      EXPECT_EQ(q, 65535);
    else
      EXPECT_NEAR(-1.0 + q * 4.0 / 65534.0, values[i], 2.0 / 65534.0 + 1e-7);
  }
}

TEST(ReportPage, HoldsAnyTextAsText) {
  const std::string bad = "</script><script>alert(1)</script> \xff & <b>";
  const std::string page = output::report_page(bad, {{"title", bad}}, {{"one", "AAAA"}});
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_EQ(page.rfind("<!doctype html>\n<!-- A report of Stroma", 0), 0u);  // see Manifest
  EXPECT_NE(page.find("<script type=\"text/plain\" id=\"one\">AAAA</script>"), std::string::npos);
  EXPECT_NE(page.find("Permission is hereby granted"), std::string::npos);
  EXPECT_NE(page.find("Chart.js v"), std::string::npos);
}

TEST(ReportPage, TakesSomeRowsOfALongTable) {
  const std::string table = "a\n1\n2\n3\n4\n5\n";
  EXPECT_EQ(output::table_excerpt(table, 3, true)["text"], "a\n1\n3\n5\n");
  EXPECT_EQ(output::table_excerpt(table, 3, false)["text"], "a\n1\n2\n3\n");
  EXPECT_EQ(output::table_excerpt(table, 9, true)["rows"], 5);
  EXPECT_EQ(output::table_excerpt(table, 3, true)["of"], 5);
}

}  // namespace
}  // namespace stroma
