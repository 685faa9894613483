// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Particles from labels: the same particles whatever the number of ranks. Run on 1, 2 and 4 ranks.
/// Claim V-PAR-2, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/particles/Seeding.hpp"
#include "support/World.hpp"

namespace stroma::particles {
namespace {

grid::Grid grid_of(const grid::Index3& elements, const std::array<double, 3>& spacing) {
  grid::Grid grid;
  grid.elements = elements;
  grid.spacing = spacing;
  return grid;
}

std::int32_t stripes(std::int64_t i, std::int64_t j, std::int64_t k) {
  return static_cast<std::int32_t>((i + 2 * j + 3 * k) % 4) - 1;  // -1 (empty), 0, 1, 2
}

voxels::LabelVolume striped(const base::Communicator& communicator, const grid::Grid& grid,
                            const std::array<std::int64_t, 3>& voxels) {
  std::array<double, 3> size;
  for (int d = 0; d < 3; ++d)
    size[static_cast<std::size_t>(d)] =
        grid.length(d) / static_cast<double>(voxels[static_cast<std::size_t>(d)]);
  voxels::LabelVolume labels(communicator, voxels, size);
  std::size_t n = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k)
    for (std::int64_t j = 0; j < voxels[1]; ++j)
      for (std::int64_t i = 0; i < voxels[0]; ++i)
        labels.values[n++] = stripes(i, j, labels.first_plane + k);
  return labels;
}

const std::map<std::int32_t, int> materials{{0, 2}, {1, 0}, {2, 1}};

/// Sums over all particles of all ranks that change when any of them is lost, doubled or misplaced.
struct Sums {
  std::int64_t count = 0, ids = 0, squares = 0;
  double volume = 0.0, moment = 0.0;
};

Sums sums_of(const base::Communicator& communicator, const ParticleParameters& layout,
             const grid::Grid& grid, const std::array<std::int64_t, 3>& voxels) {
  const voxels::LabelVolume labels = striped(communicator, grid, voxels);
  const auto partition = grid::Partition::balanced(grid, communicator.size(),
                                                   layer_weights(communicator, grid, labels));
  const auto particles = seed(communicator, layout, partition, labels, materials);
  const auto elements = partition.elements(communicator.rank());
  const auto host = [](const auto& view) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
  };
  const auto position = host(particles.position);
  const auto volume = host(particles.volume);
  const auto material = host(particles.material);
  const auto id = host(particles.id);
  const auto begin = host(particles.element_begin);
  Sums sums;
  EXPECT_EQ(begin(elements.count()), particles.count());
  for (std::int64_t e = 0; e < elements.count(); ++e)
    for (int p = begin(e); p < begin(e + 1); ++p) {
      const grid::Index3 element = elements.index(e);
      std::array<std::int64_t, 3> voxel;
      for (int d = 0; d < 3; ++d) {
        const double xi = position(p, d) / grid.spacing[static_cast<std::size_t>(d)];
        EXPECT_GE(xi, static_cast<double>(element[static_cast<std::size_t>(d)]) - 1e-9);
        EXPECT_LT(xi, static_cast<double>(element[static_cast<std::size_t>(d)]) + 1.0);
        voxel[static_cast<std::size_t>(d)] = static_cast<std::int64_t>(
            std::floor(position(p, d) / labels.voxel_size[static_cast<std::size_t>(d)] + 1e-9));
      }
      const std::int32_t label = stripes(voxel[0], voxel[1], voxel[2]);
      EXPECT_GE(label, 0) << "label -1 is empty space";
      if (label < 0) continue;
      EXPECT_EQ(material(p), materials.at(label));
      ++sums.count;
      sums.ids += id(p);
      sums.squares += id(p) * id(p);
      sums.volume += volume(p);
      sums.moment += volume(p) * (position(p, 0) + 2 * position(p, 1) + 3 * position(p, 2)) *
                     static_cast<double>(1 + id(p));
    }
  sums.count = communicator.sum(sums.count);
  sums.ids = communicator.sum(sums.ids);
  sums.squares = communicator.sum(sums.squares);
  sums.volume = communicator.sum(sums.volume);
  sums.moment = communicator.sum(sums.moment);
  return sums;
}

TEST(Seeding, ParticlesDoNotDependOnTheRanks) {
  const grid::Grid grid = grid_of({6, 5, 4}, {2.1, 2.1, 2.0});
  for (const auto& voxels :
       {std::array<std::int64_t, 3>{12, 10, 8}, std::array<std::int64_t, 3>{9, 11, 7}})
    for (const ParticleParameters& layout :
         {ParticleParameters{Layout::gauss, 1, 2}, ParticleParameters{Layout::voxel_centers, 1, 2},
          ParticleParameters{Layout::voxel_centers, 2, 2},
          ParticleParameters{Layout::per_element, 1, 3}}) {
      const Sums together = sums_of(world(), layout, grid, voxels);
      const Sums alone = sums_of(base::Communicator::self(), layout, grid, voxels);
      EXPECT_GT(alone.count, 0);
      EXPECT_EQ(together.count, alone.count);
      EXPECT_EQ(together.ids, alone.ids);
      EXPECT_EQ(together.squares, alone.squares);
      EXPECT_NEAR(together.volume, alone.volume, 1e-12 * alone.volume);
      EXPECT_NEAR(together.moment, alone.moment, 1e-12 * alone.moment);
    }
}

TEST(Seeding, VolumeIsThatOfTheVoxelsThatAreNotEmpty) {
  const grid::Grid grid = grid_of({6, 5, 4}, {2.1, 2.1, 2.0});
  const std::array<std::int64_t, 3> voxels{9, 11, 7};  // not aligned with the elements
  std::int64_t filled = 0;
  for (std::int64_t k = 0; k < 7; ++k)
    for (std::int64_t j = 0; j < 11; ++j)
      for (std::int64_t i = 0; i < 9; ++i) filled += stripes(i, j, k) >= 0 ? 1 : 0;
  const double voxel = grid.length(0) * grid.length(1) * grid.length(2) / (9 * 11 * 7);
  for (const int per_voxel : {1, 2}) {
    const Sums sums = sums_of(world(), {Layout::voxel_centers, per_voxel, 2}, grid, voxels);
    EXPECT_GE(sums.count, filled * per_voxel * per_voxel * per_voxel);
    EXPECT_NEAR(sums.volume, static_cast<double>(filled) * voxel, 1e-12 * sums.volume);
  }
}

// Only the last voxel of the image has the label without a material: one rank alone meets it, and
// all of them must refuse.
TEST(Seeding, ALabelWithoutMaterialIsAnInputErrorOnAllRanks) {
  const grid::Grid grid = grid_of({4, 4, 4}, {1.0, 1.0, 1.0});
  voxels::LabelVolume labels(world(), {4, 4, 4}, {1.0, 1.0, 1.0});
  if (labels.planes > 0 && labels.first_plane + labels.planes == 4) labels.values.back() = 7;
  const auto partition =
      grid::Partition::balanced(grid, world().size(), layer_weights(world(), grid, labels));
  try {
    seed(world(), {Layout::voxel_centers, 1, 2}, partition, labels, {{0, 0}, {1, 1}});
    FAIL() << "label 7 has no material";
  } catch (const base::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("label 7"), std::string::npos) << message;
    EXPECT_NE(message.find("0, 1"), std::string::npos) << message;
  }
}

TEST(Seeding, AnEmptyImageHasNoParticles) {
  const grid::Grid grid = grid_of({4, 4, 4}, {1.0, 1.0, 1.0});
  voxels::LabelVolume labels(world(), {4, 4, 4}, {1.0, 1.0, 1.0});
  for (auto& label : labels.values) label = -1;
  std::array<std::vector<double>, 3> even;
  for (auto& weights : even) weights.assign(4, 1.0);
  const auto partition = grid::Partition::balanced(grid, world().size(), even);
  EXPECT_EQ(seed(world(), {Layout::gauss, 1, 2}, partition, labels, {{0, 0}}).count(), 0);
}

TEST(Seeding, LayerWeightsCountTheVoxelsOfEachLayer) {
  const grid::Grid grid = grid_of({2, 3, 4}, {2.0, 2.0, 2.0});
  voxels::LabelVolume labels(world(), {4, 6, 8}, {1.0, 1.0, 1.0});
  std::size_t n = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k)
    for (std::int64_t j = 0; j < 6; ++j)
      for (std::int64_t i = 0; i < 4; ++i)
        labels.values[n++] = labels.first_plane + k < 2 && i < 2 ? -1 : 0;
  const auto weights = layer_weights(world(), grid, labels);
  EXPECT_EQ(weights[0], (std::vector<double>{2 * 6 * 6, 2 * 6 * 8}));
  EXPECT_EQ(weights[1], (std::vector<double>{56, 56, 56}));
  EXPECT_EQ(weights[2], (std::vector<double>{24, 48, 48, 48}));
}

TEST(Seeding, LayerWeightsShareTheVoxelsThatLayersCut) {
  const grid::Grid grid = grid_of({2, 8, 1}, {1.5, 0.25, 1.0});
  const voxels::LabelVolume labels(world(), {3, 2, 1}, {1.0, 1.0, 1.0});
  const auto weights = layer_weights(world(), grid, labels);
  EXPECT_EQ(weights[0], (std::vector<double>{3, 3}));
  EXPECT_EQ(weights[1], std::vector<double>(8, 0.75));
  EXPECT_EQ(weights[2], (std::vector<double>{6}));
}

}  // namespace
}  // namespace stroma::particles
