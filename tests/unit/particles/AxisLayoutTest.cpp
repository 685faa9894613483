/// \file
/// Where particles lie along one axis. Claim V-PAR-1, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "particles/Seeding.hpp"

namespace stroma::particles {
namespace {

grid::Grid grid_of(std::int64_t elements, double size, double origin = 0.0) {
  grid::Grid grid;
  grid.elements = {elements, 1, 1};
  grid.spacing = {size, 1.0, 1.0};
  grid.origin = {origin, 0.0, 0.0};
  return grid;
}

/// What holds of every layout: points in ascending order, each in its element and in its voxel,
/// and, over all elements, shares that fill the axis.
void check_whole_axis(const ParticleParameters& parameters, const grid::Grid& grid,
                      std::int64_t voxels) {
  const double voxel = grid.length(0) / static_cast<double>(voxels);
  const AxisLayout axis = axis_layout(parameters, grid, 0, 0, grid.elements[0], voxels, voxel);
  ASSERT_EQ(axis.first, 0);
  ASSERT_EQ(axis.total, static_cast<std::int64_t>(axis.position.size()));
  ASSERT_EQ(axis.element_begin.size(), static_cast<std::size_t>(grid.elements[0] + 1));
  EXPECT_NEAR(std::accumulate(axis.length.begin(), axis.length.end(), 0.0), grid.length(0),
              1e-13 * grid.length(0));
  for (std::size_t e = 0; e + 1 < axis.element_begin.size(); ++e)
    for (int p = axis.element_begin[e]; p < axis.element_begin[e + 1]; ++p) {
      const auto n = static_cast<std::size_t>(p);
      const double in_elements = (axis.position[n] - grid.origin[0]) / grid.spacing[0];
      EXPECT_GE(in_elements, static_cast<double>(e) - 1e-9);
      EXPECT_LT(in_elements, static_cast<double>(e) + 1.0 - 1e-9)
          << "the upper face is the next one's";
      const double in_voxels = (axis.position[n] - grid.origin[0]) / voxel;
      EXPECT_EQ(axis.voxel[n], static_cast<std::int64_t>(std::floor(in_voxels + 1e-9)));
      if (n > 0) {
        EXPECT_GT(axis.position[n], axis.position[n - 1]);
      }
    }
}

/// A layout cut anywhere is the same points, numbered as in the whole.
void check_parts(const ParticleParameters& parameters, const grid::Grid& grid,
                 std::int64_t voxels) {
  const double voxel = grid.length(0) / static_cast<double>(voxels);
  const AxisLayout whole = axis_layout(parameters, grid, 0, 0, grid.elements[0], voxels, voxel);
  for (std::int64_t cut = 1; cut < grid.elements[0]; ++cut) {
    std::size_t n = 0;
    for (const auto& [begin, end] :
         {std::pair{std::int64_t{0}, cut}, std::pair{cut, grid.elements[0]}}) {
      const AxisLayout part = axis_layout(parameters, grid, 0, begin, end, voxels, voxel);
      EXPECT_EQ(part.total, whole.total);
      if (!part.position.empty()) {
        EXPECT_EQ(part.first, static_cast<std::int64_t>(n)) << "cut " << cut;
      }
      for (std::size_t p = 0; p < part.position.size(); ++p, ++n) {
        ASSERT_LT(n, whole.position.size());
        EXPECT_EQ(part.position[p], whole.position[n]);
        EXPECT_EQ(part.voxel[p], whole.voxel[n]);
      }
    }
    EXPECT_EQ(n, whole.position.size()) << "cut " << cut;
  }
}

const ParticleParameters gauss{Layout::gauss, 1, 2};
ParticleParameters voxel_centers(int n) { return {Layout::voxel_centers, n, 2}; }
ParticleParameters per_element(int n) { return {Layout::per_element, 1, n}; }

TEST(AxisLayout, EveryLayoutFillsTheAxis) {
  for (const auto& parameters : {gauss, voxel_centers(1), voxel_centers(2), voxel_centers(3),
                                 per_element(1), per_element(2), per_element(5)})
    for (const double origin : {0.0, -3.7})
      for (const std::int64_t voxels : {8, 16, 24, 20, 5, 3, 13}) {  // 20, 5, 3, 13: not aligned
        const grid::Grid grid = grid_of(8, 2.1, origin);
        SCOPED_TRACE(testing::Message() << "layout " << static_cast<int>(parameters.layout) << ", "
                                        << parameters.per_voxel << " per voxel, " << voxels
                                        << " voxels in 8 elements, origin " << origin);
        check_whole_axis(parameters, grid, voxels);
        check_parts(parameters, grid, voxels);
      }
}

TEST(AxisLayout, GaussPointsAreTheGaussPoints) {
  const AxisLayout axis = axis_layout(gauss, grid_of(3, 2.0), 0, 1, 2, 6, 1.0);
  ASSERT_EQ(axis.position.size(), 2u);
  EXPECT_NEAR(axis.position[0], 3.0 - 1.0 / std::sqrt(3.0), 1e-15 * 3);
  EXPECT_NEAR(axis.position[1], 3.0 + 1.0 / std::sqrt(3.0), 1e-15 * 4);
  EXPECT_EQ(axis.first, 2);
  EXPECT_EQ(axis.total, 6);
  EXPECT_EQ(axis.voxel, (std::vector<std::int64_t>{2, 3}));
  EXPECT_EQ(axis.length, (std::vector<double>{1.0, 1.0}));
}

TEST(AxisLayout, VoxelCentresAreTheVoxelsCentres) {
  const AxisLayout axis = axis_layout(voxel_centers(1), grid_of(4, 2.1), 0, 2, 4, 8, 1.05);
  ASSERT_EQ(axis.position.size(), 4u);
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_DOUBLE_EQ(axis.position[p], (4.5 + static_cast<double>(p)) * 1.05);
    EXPECT_EQ(axis.voxel[p], static_cast<std::int64_t>(4 + p));
  }
}

// 3 voxels over 2 elements: the centre of the middle voxel lies on the face between them.
TEST(AxisLayout, APointOnAFaceBelongsToTheUpperElement) {
  const AxisLayout axis = axis_layout(voxel_centers(1), grid_of(2, 1.5), 0, 0, 2, 3, 1.0);
  EXPECT_EQ(axis.element_begin, (std::vector<int>{0, 1, 3}));
  const AxisLayout lower = axis_layout(voxel_centers(1), grid_of(2, 1.5), 0, 0, 1, 3, 1.0);
  EXPECT_EQ(lower.position.size(), 1u);
  const AxisLayout upper = axis_layout(voxel_centers(1), grid_of(2, 1.5), 0, 1, 2, 3, 1.0);
  EXPECT_EQ(upper.position.size(), 2u);
  EXPECT_EQ(upper.first, 1);
}

// Sizes without an exact binary form put such points a rounding error to either side of the face.
TEST(AxisLayout, PointsOnFacesAreFoundOnceWhateverTheRounding) {
  for (const double voxel : {0.1, 0.93, 1.05, 1.0 / 3.0})
    for (const std::int64_t elements : {7, 50, 331}) {
      const grid::Grid grid = grid_of(elements, 1.5 * voxel * 2.0);
      check_whole_axis(voxel_centers(1), grid, 3 * elements);
      check_parts(voxel_centers(1), grid_of(7, 1.5 * voxel), 21 / 2);
      const AxisLayout axis = axis_layout(voxel_centers(1), grid_of(2 * elements, 1.5 * voxel), 0,
                                          0, 2 * elements, 3 * elements, voxel);
      ASSERT_EQ(axis.position.size(), static_cast<std::size_t>(3 * elements));
      for (std::size_t e = 0; e < static_cast<std::size_t>(2 * elements); ++e)
        EXPECT_EQ(axis.element_begin[e + 1] - axis.element_begin[e], e % 2 == 0 ? 1 : 2)
            << "element " << e;
    }
}

// Coarse voxels: an element may hold no particle at all.
TEST(AxisLayout, ElementsMayStayEmpty) {
  const AxisLayout axis = axis_layout(voxel_centers(1), grid_of(8, 1.0), 0, 0, 8, 2, 4.0);
  EXPECT_EQ(axis.element_begin, (std::vector<int>{0, 0, 0, 1, 1, 1, 1, 2, 2}));
}

}  // namespace
}  // namespace stroma::particles
