// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Files of VTKHDF read back array by array, and their list.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ParticleSample.hpp"
#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/StateFile.hpp"
#include "stroma/output/files/StepSeries.hpp"
#include "stroma/output/files/VtkhdfGrid.hpp"
#include "stroma/output/files/VtkhdfParticles.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;
using Integers = std::vector<std::int64_t>;

/// A file of VTKHDF.
struct File : output::StateReader {
  explicit File(const std::string& path) : StateReader(path) {}
  Integers integers(const std::string& name) const { return get<std::int64_t>("VTKHDF/" + name); }
  std::vector<double> reals(const std::string& name) const { return get<double>("VTKHDF/" + name); }
  std::vector<double> points(const std::string& name) const { return reals("PointData/" + name); }
};

/// One part a rank, each with its own points and the offsets of cells of so many corners.
void expect_parts(const File& file, std::int64_t points, std::int64_t cells, std::int64_t corners) {
  const auto world = base::Communicator::world();
  EXPECT_EQ(file.integers("NumberOfPoints"), world.gather(points));
  EXPECT_EQ(file.integers("NumberOfCells"), world.gather(cells));
  EXPECT_EQ(file.integers("NumberOfConnectivityIds"), world.gather(cells * corners));
  Integers offsets;
  for (const std::int64_t of_rank : world.gather(cells))
    for (std::int64_t n = 0; n <= of_rank; ++n) offsets.push_back(corners * n);
  EXPECT_EQ(file.integers("Offsets"), offsets);
}

// V-VTKHDF-1.
TEST(Vtkhdf, HoldsTheParticlesOfAllRanks) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const std::vector<output::ShownField> shown{{"modulus", "Pa"}};
  for (const std::int64_t count : {50, 70000}) {  // a buffer holds 65536
    ParticleSample sample(count, 0);
    sample.state.fields = {sample.energy.data()};
    const auto pieces = [&](const auto& use) {
      const std::int64_t size = sample.set.count / 3 + 1;
      for (std::int64_t first = 0; first < sample.set.count; first += size)
        use(first, std::min(size, sample.set.count - first),
            output::ParticleState{sample.state.displacement + 3 * first,
                                  sample.state.stress + 6 * first,
                                  sample.state.gradient + 9 * first,
                                  sample.state.jacobian + first,
                                  sample.state.strain_energy_density + first,
                                  {sample.energy.data() + first}});
    };
    output::write_vtkhdf_particles(world, folder / "p.hdf", sample.set, pieces, shown,
                                   {{"load", 0.25}, {"a/b.volume", 3.0}},
                                   output::Precision::Double);
    const File file(folder / "p.hdf");
    expect_parts(file, sample.set.count, sample.set.count, 1);
    EXPECT_EQ(file.reals("FieldData/load"), std::vector<double>{0.25});
    EXPECT_EQ(file.reals("FieldData/a|b.volume"), std::vector<double>{3.0});
    for (const std::uint8_t type : file.get<std::uint8_t>("VTKHDF/Types")) ASSERT_EQ(type, 1);

    const Integers ids = file.integers("PointData/id"), corner = file.integers("Connectivity");
    const auto material = file.get<std::uint8_t>("VTKHDF/PointData/material");
    const auto place = file.reals("Points"), displacement = file.points("displacement"),
               stress = file.points("stress"), strain = file.points("strain"),
               von_mises = file.points("von_mises"), volume = file.points("volume"),
               radius = file.points("radius"), modulus = file.points("modulus");
    ASSERT_EQ(static_cast<std::int64_t>(ids.size()), world.sum(sample.set.count));
    for (std::size_t n = 0; n < ids.size(); ++n) {
      const std::int64_t id = ids[n] - 1;
      ASSERT_EQ(corner[n], id % count);
      ASSERT_EQ(material[n], (id / count % 2 == 0 && id % count % 3 == 1) ? 2 : 1);
      const double g = static_cast<double>(id % 1000);
      const auto s = [&](int i) { return ParticleSample::stress_of(id, i); };
      const auto H = [&](int i, int j) { return ParticleSample::gradient_of(id, i, j); };
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_DOUBLE_EQ(place[3 * n + i], g + 0.25 * static_cast<double>(i));
        ASSERT_DOUBLE_EQ(displacement[3 * n + i], 1e-3 * g + static_cast<double>(i));
      }
      for (int i = 0; i < 6; ++i)
        ASSERT_DOUBLE_EQ(stress[6 * n + static_cast<std::size_t>(i)], s(i));
      double zx = H(2, 0) + H(0, 2);
      for (int k = 0; k < 3; ++k) zx += H(k, 2) * H(k, 0);
      ASSERT_NEAR(strain[6 * n + 5], 0.5 * zx, 1e-12);
      ASSERT_NEAR(von_mises[n],
                  std::sqrt(0.5 * (std::pow(s(0) - s(1), 2) + std::pow(s(1) - s(2), 2) +
                                   std::pow(s(2) - s(0), 2)) +
                            3.0 * (s(3) * s(3) + s(4) * s(4) + s(5) * s(5))),
                  1e-9);
      ASSERT_EQ(volume[n], 1.0 + g);
      ASSERT_NEAR(4.0 / 3.0 * M_PI * std::pow(radius[n], 3), volume[n], 1e-9 * volume[n]);
      ASSERT_EQ(modulus[n], 1.0 / 3.0 + g);
    }
    world.barrier();
  }
}

/// 5 x 4 x 3 elements in slabs along z, those of j = 0 empty; of 4 ranks the last has none.
TEST(Vtkhdf, HoldsTheGridOfAllRanks) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  output::GridPart part;
  part.elements = {5, 4, 3};
  const std::int64_t begin = world.rank() * 3 / std::min(world.size(), 3),
                     end = (world.rank() + 1) * 3 / std::min(world.size(), 3);
  part.first_element = {0, 0, std::min<std::int64_t>(begin, 3)};
  part.element_count = {5, 4, std::min<std::int64_t>(end, 3) - part.first_element[2]};
  part.origin = {-1.0, 0.5, 10.0};
  part.spacing = {2.0, 1.0, 0.5};
  std::vector<std::uint8_t> active;
  for (std::int64_t n = 0; n < 20 * part.element_count[2]; ++n)
    active.push_back(n % 20 < 5 ? 0 : 1);
  part.active = active.data();
  const output::IndexBox box = output::node_box(part);
  std::vector<double> displacement, residual;
  for (std::int64_t n = 0; n < 3 * box.size(); ++n) {
    const auto id = static_cast<double>(output::node_id(part, box.place(n / 3)));
    displacement.push_back(id + 0.25 * static_cast<double>(n % 3));
    residual.push_back(-id);
  }
  output::write_vtkhdf_grid(
      world, folder / "g.hdf", part,
      {{"displacement", "um", displacement.data()}, {"residual", "pN", residual.data()}}, {},
      output::Precision::Double);
  const File file(folder / "g.hdf");
  const std::int64_t planes = part.element_count[2];
  expect_parts(file, planes == 0 ? 0 : 6 * 4 * (planes + 1), 15 * planes, 8);
  for (const std::uint8_t type : file.get<std::uint8_t>("VTKHDF/Types")) ASSERT_EQ(type, 12);
  const Integers id = file.integers("PointData/id"), corner = file.integers("Connectivity"),
                 of_part = file.integers("NumberOfPoints"),
                 cells_of_part = file.integers("NumberOfCells");
  const auto place = file.reals("Points"), moved = file.points("displacement"),
             force = file.points("residual");
  for (std::size_t n = 0; n < id.size(); ++n) {
    const std::int64_t at = id[n] - 1;
    ASSERT_EQ(place[3 * n], -1.0 + 2.0 * static_cast<double>(at % 6));
    ASSERT_EQ(place[3 * n + 1], 0.5 + static_cast<double>(at / 6 % 5));
    ASSERT_EQ(place[3 * n + 2], 10.0 + 0.5 * static_cast<double>(at / 30));
    ASSERT_EQ(moved[3 * n + 2], static_cast<double>(id[n]) + 0.5);
    ASSERT_EQ(force[3 * n + 1], -static_cast<double>(id[n]));
  }
  // From a corner of an element to the next: VTK's order, the numbers of the whole grid.
  const std::int64_t steps[8] = {0, 1, 7, 6, 30, 31, 37, 36};
  std::int64_t point = 0;
  std::size_t cell = 0;
  for (std::size_t r = 0; r < of_part.size(); point += of_part[r++])
    for (std::int64_t n = 0; n < cells_of_part[r]; ++n, ++cell)
      for (std::size_t c = 0; c < 8; ++c) {
        const auto number = [&](std::size_t k) {
          return id.at(static_cast<std::size_t>(point + corner[8 * cell + k]));
        };
        ASSERT_EQ(number(c) - number(0), steps[c]);
      }
}

TEST(Vtkhdf, InSinglePrecisionHasFourByteNumbers) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const ParticleSample sample(1000);
  for (const bool is_single : {false, true})
    output::write_vtkhdf_particles(
        world, folder / (is_single ? "4.hdf" : "8.hdf"), sample.set, sample.in_pieces(), {}, {},
        is_single ? output::Precision::Single : output::Precision::Double);
  // Coordinates, 3 + 6 + 6 components, eight fields, radius and volume.
  const auto apart = static_cast<std::int64_t>(fs::file_size(folder / "8.hdf")) -
                     static_cast<std::int64_t>(fs::file_size(folder / "4.hdf"));
  EXPECT_NEAR(static_cast<double>(apart),
              4.0 * (3 + 15 + 6 + 2) * static_cast<double>(world.sum(sample.set.count)), 8192);
}

// V-VTKHDF-2.
TEST(Vtkhdf, AFullDiskIsARunErrorOnEveryRankAndLeavesTheFileOfBefore) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const ParticleSample sample(20000);
  const auto write = [&](double load) {
    output::write_vtkhdf_particles(world, folder / "p.hdf", sample.set,
                                   output::in_one_piece(sample.set.count, sample.state), {},
                                   {{"load", load}}, output::Precision::Double);
  };
  write(0.5);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{200000, before.rlim_max};
  if (world.is_root()) setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write(1.0), base::RunError);
  if (world.is_root()) setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(File(folder / "p.hdf").reals("FieldData/load"), std::vector<double>{0.5});
}

std::vector<std::pair<std::string, double>> listed(const fs::path& path) {
  std::vector<std::pair<std::string, double>> all;
  const auto list = nlohmann::json::parse(std::ifstream(path));
  for (const auto& file : list["files"]) all.emplace_back(file["name"], file["time"]);
  return all;
}

TEST(StepSeries, ListsWhatIsThereAndForgetsWhatCameBehind) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const auto touch = [&](const std::string& path) {
    if (world.is_root()) std::ofstream(path) << "x";
    world.barrier();
  };
  output::StepSeries series(world, folder.path(), "grid");
  for (const auto& [step, time] : {std::pair{0, 0.0}, {2, 0.1}, {4, 0.3}}) {
    touch(series.path(step));
    series.add({step, time});
  }
  using List = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(listed(folder / "grid.hdf.series"),
            (List{{"grid-s0000.hdf", 0.0}, {"grid-s0002.hdf", 0.1}, {"grid-s0004.hdf", 0.3}}));
  touch(folder / "grid-s0005.hdf.new");
  touch(folder / "particles-s0005.hdf");
  world.barrier();

  output::StepSeries again(world, folder.path(), "grid");
  again.resume({{0, 0.0}, {1, 0.05}, {2, 0.1}});
  EXPECT_FALSE(fs::exists(folder / "grid-s0004.hdf"));
  EXPECT_FALSE(fs::exists(folder / "grid-s0005.hdf.new"));
  EXPECT_TRUE(fs::exists(folder / "particles-s0005.hdf"));
  EXPECT_EQ(listed(folder / "grid.hdf.series"),
            (List{{"grid-s0000.hdf", 0.0}, {"grid-s0002.hdf", 0.1}}));
  world.barrier();
  touch(again.path(3));
  again.add({3, 0.2});
  EXPECT_EQ(listed(folder / "grid.hdf.series").back(),
            (std::pair<std::string, double>{"grid-s0003.hdf", 0.2}));
}

}  // namespace
}  // namespace stroma
