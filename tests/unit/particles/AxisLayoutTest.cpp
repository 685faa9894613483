// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Where particles lie along one axis. Claim V-PAR-1, docs/verification.md.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "stroma/particles/Seeding.hpp"

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

// To rounding, for compilers fuse products and sums where they like: what was right on the voxels'
// own centres stays as it was.
TEST(AxisLayout, WholeNumbersOfVoxelsAnElementAreNotCut) {
  for (const std::int64_t elements : {1, 3, 50, 331})
    for (const std::int64_t per_element : {2, 3, 5, 8})
      for (const int n : {1, 2, 3})
        for (const double voxel : {0.1, 0.93, 1.05, 1.0 / 3.0}) {
          const std::int64_t voxels = elements * per_element;
          const grid::Grid grid = grid_of(
              elements, static_cast<double>(voxels) * voxel / static_cast<double>(elements), -3.7);
          const AxisLayout axis =
              axis_layout(voxel_centers(n), grid, 0, 0, elements, voxels, voxel);
          ASSERT_EQ(axis.total, voxels * n);
          for (std::int64_t point = 0; point < axis.total; ++point) {
            const auto p = static_cast<std::size_t>(point);
            ASSERT_NEAR(axis.position[p],
                        grid.origin[0] + (static_cast<double>(point) + 0.5) / n * voxel,
                        1e-15 * (static_cast<double>(voxels) * voxel + 3.7));
            ASSERT_EQ(axis.length[p], voxel / n);
            ASSERT_EQ(axis.half_edge[p], 0.5 * (voxel / n));
          }
          for (std::size_t e = 0; e < axis.element_begin.size(); ++e)
            ASSERT_EQ(axis.element_begin[e], static_cast<int>(e) * per_element * n);
        }
}

// 3 voxels on 2 elements: the middle one is cut, and its halves have points of their own.
TEST(AxisLayout, VoxelsAreCutAtTheFacesOfElements) {
  const AxisLayout axis = axis_layout(voxel_centers(1), grid_of(2, 1.5), 0, 0, 2, 3, 1.0);
  EXPECT_EQ(axis.element_begin, (std::vector<int>{0, 2, 4}));
  EXPECT_EQ(axis.position, (std::vector<double>{0.5, 1.25, 1.75, 2.5}));
  EXPECT_EQ(axis.length, (std::vector<double>{1.0, 0.5, 0.5, 1.0}));
  EXPECT_EQ(axis.half_edge, (std::vector<double>{0.5, 0.25, 0.25, 0.5}));
  EXPECT_EQ(axis.voxel, (std::vector<std::int64_t>{0, 1, 1, 2}));
  const AxisLayout upper = axis_layout(voxel_centers(1), grid_of(2, 1.5), 0, 1, 2, 3, 1.0);
  EXPECT_EQ(upper.first, 2);
  EXPECT_EQ(upper.position, (std::vector<double>{1.75, 2.5}));
}

// 2 voxels on 8 elements.
TEST(AxisLayout, ElementsInsideAVoxelHaveTwoPoints) {
  const AxisLayout axis = axis_layout(voxel_centers(1), grid_of(8, 1.0), 0, 0, 8, 2, 4.0);
  ASSERT_EQ(axis.total, 16);
  for (std::size_t p = 0; p < 16; ++p) {
    EXPECT_EQ(axis.position[p], 0.25 + 0.5 * static_cast<double>(p));
    EXPECT_EQ(axis.length[p], 0.5);
    EXPECT_EQ(axis.voxel[p], p < 8 ? 0 : 1);
  }
}

/// Along an element: the sum of the shares, and of share times squared distance from its middle
/// [elements]; the latter is 1/12 of what varies linearly, and 1/16 with two equal points.
std::array<double, 2> moments(const AxisLayout& axis, const grid::Grid& grid, std::size_t e) {
  std::array<double, 2> sums{};
  for (int p = axis.element_begin[e]; p < axis.element_begin[e + 1]; ++p) {
    const auto n = static_cast<std::size_t>(p);
    const double share = axis.length[n] / grid.spacing[0];
    const double place = axis.position[n] / grid.spacing[0] - static_cast<double>(e) - 0.5;
    sums[0] += share;
    sums[1] += share * place * place;
  }
  return sums;
}

// Elements from a quarter of a voxel to eight of them, and the ratios next to whole ones, whose
// pieces are the shortest.
TEST(AxisLayout, EveryElementIsFilledAndResistsWhateverTheResolution) {
  for (const double voxel : {0.1, 1.05, 1.0 / 3.0})
    for (const std::int64_t elements : {4, 13, 100, 511})
      for (std::int64_t voxels = elements / 4; voxels <= 8 * elements; voxels += 1 + elements / 9)
        for (const std::int64_t count : {voxels, elements - 1, elements, elements + 1}) {
          const double h = voxel * static_cast<double>(count) / static_cast<double>(elements);
          const grid::Grid grid = grid_of(elements, h);
          const AxisLayout axis = axis_layout(voxel_centers(1), grid, 0, 0, elements, count, voxel);
          const double shortest = 0.5 * voxel * static_cast<double>(std::gcd(count, elements)) /
                                  static_cast<double>(elements);
          for (std::size_t e = 0; e < static_cast<std::size_t>(elements); ++e) {
            SCOPED_TRACE(testing::Message() << count << " voxels in " << elements << " elements");
            const auto [share, second] = moments(axis, grid, e);
            ASSERT_NEAR(share, 1.0, 1e-12);
            ASSERT_GE(second, 0.75 / 16.0 - 1e-12);
            ASSERT_GE(axis.element_begin[e + 1] - axis.element_begin[e], 2);
          }
          for (const double length : axis.length) ASSERT_GE(length, shortest * (1.0 - 1e-12));
        }
}

TEST(AxisLayout, PlaneStrainHasOnePointAVoxelThroughItsOneElement) {
  grid::Grid grid = grid_of(4, 1.0);
  grid.flat = true;
  for (const std::int64_t voxels : {1, 3}) {
    const AxisLayout axis =
        axis_layout(voxel_centers(2), grid, 2, 0, 1, voxels, 1.0 / static_cast<double>(voxels));
    EXPECT_EQ(axis.total, voxels);
  }
}

TEST(LayoutNotes, SayWhatALayoutLacks) {
  grid::Grid grid;
  grid.elements = {4, 4, 4};
  const auto notes = [&](const ParticleParameters& parameters,
                         const std::array<std::int64_t, 3>& voxels) {
    std::string all;
    for (const std::string& note : layout_notes(parameters, grid, voxels)) all += note + "\n";
    return all;
  };
  EXPECT_EQ(notes(voxel_centers(1), {4, 5, 9}), "");
  EXPECT_NE(notes(voxel_centers(1), {4, 3, 2}).find("finer than voxels along y and z"),
            std::string::npos);
  EXPECT_EQ(notes(gauss, {8, 4, 8}), "");
  EXPECT_NE(notes(gauss, {8, 8, 9}).find("does not resolve the voxels along z"), std::string::npos);
  EXPECT_EQ(notes(per_element(3), {12, 12, 4}), "");
  EXPECT_NE(notes(per_element(3), {8, 12, 12}).find("along x"), std::string::npos);
  EXPECT_NE(notes(per_element(1), {4, 4, 4}).find("under-integrates"), std::string::npos);
  grid.elements[2] = 1;
  grid.flat = true;
  EXPECT_EQ(notes(per_element(2), {8, 8, 3}), "");
}

}  // namespace
}  // namespace stroma::particles
