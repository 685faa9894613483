// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Directions by the structure tensor: exact ones, and those of a blurred and noisy picture of
/// fibres. Claim V-DIR-1, docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "stroma/image/StructureTensor.hpp"
#include "support/FiberPhantom.hpp"
#include "support/World.hpp"

namespace stroma::test {
namespace {

using image::Orientation;
using image::SymmetricTensor;
using voxels::IntensityVolume;
using Vector = std::array<double, 3>;
using Size = std::array<std::int64_t, 3>;

/// Of each of this rank's voxels.
std::vector<Orientation> orientations(const IntensityVolume& image,
                                      const image::StructureTensorScales& scales) {
  std::vector<SymmetricTensor> tensor(image.values.size());
  image::structure_tensor(world(), image, scales, [&](int c, const voxels::Volume<float>& values) {
    for (std::size_t v = 0; v < tensor.size(); ++v)
      tensor[v][static_cast<std::size_t>(c)] = values.values[v];
  });
  std::vector<Orientation> found;
  for (const SymmetricTensor& J : tensor)
    found.push_back(image::orientation_of(J, image.size[2] == 1));
  return found;
}

/// Between two directions without sense [degrees].
double angle(const Vector& a, const Vector& b) {
  const Vector cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
  const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return std::atan2(std::hypot(cross[0], cross[1], cross[2]), std::abs(along)) * 180.0 / M_PI;
}

Vector unit(Vector v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  for (double& c : v) c /= length;
  return v;
}

TEST(StructureTensor, OrientationOfAKnownTensor) {
  // N along (1, 2, 2) / 3 with eigenvalue 1, and 4 and 9 across it
  const Vector n = unit({1, 2, 2}), a = unit({2, 1, -2}), b = unit({2, -2, 1});
  SymmetricTensor J{};
  const std::size_t first[] = {0, 1, 2, 0, 1, 2}, second[] = {0, 1, 2, 1, 2, 0};
  for (std::size_t c = 0; c < 6; ++c)
    J[c] = n[first[c]] * n[second[c]] + 4.0 * a[first[c]] * a[second[c]] +
           9.0 * b[first[c]] * b[second[c]];
  const Orientation found = image::orientation_of(J, false);
  EXPECT_LT(angle(found.direction, n), 1e-10);
  EXPECT_NEAR(found.coherence, 3.0 / 5.0, 1e-12);

  // in the plane the direction across (3, 1), whatever zz says
  const Orientation flat = image::orientation_of({9.0, 1.0, 0.0, 3.0, 0.0, 0.0}, true);
  EXPECT_LT(angle(flat.direction, unit({1, -3, 0})), 1e-10);
  EXPECT_NEAR(flat.coherence, 1.0, 1e-12);
}

// Two plane waves across N: the image is constant along it. Voxels are twice as long along z.
TEST(StructureTensor, OfWavesAcrossADirection) {
  const Vector n = unit({2, 3, 1}), a = unit({3, -2, 0}), b = unit({2, 3, -13});
  IntensityVolume image(world(), Size{40, 36, 30}, {0.5, 0.5, 1.0});
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < image.planes; ++z)
    for (std::int64_t y = 0; y < image.size[1]; ++y)
      for (std::int64_t x = 0; x < image.size[0]; ++x) {
        const Vector X{0.5 * static_cast<double>(x), 0.5 * static_cast<double>(y),
                       static_cast<double>(z + image.first_plane)};
        const auto wave = [&](const Vector& k) {
          return std::cos(k[0] * X[0] + k[1] * X[1] + k[2] * X[2]);
        };
        image.values[voxel++] = 100.0 + 40.0 * wave(a) + 40.0 * wave(b);
      }
  double worst = 0.0;
  for (const Orientation& found : orientations(image, {1.0, 3.0}))
    worst = std::max(worst, angle(found.direction, n));
  EXPECT_LT(worst, 0.5);  // at the corners
}

// V-DIR-1. Fibres of 1 um diameter, blurred and noisy as a confocal microscope's.
TEST(StructureTensor, OfAPhantomOfFibres) {
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{2, 3, 1}, Vector{0, 1, 2}}) {
    const Vector n = unit(axis);
    const FiberPhantom phantom(Size{64, 64, 32}, {0.5, 0.5, 1.0}, n);
    IntensityVolume image(world(), phantom.size(), phantom.voxel_size());
    std::size_t voxel = 0;
    for (std::int64_t z = 0; z < image.planes; ++z)
      for (std::int64_t y = 0; y < image.size[1]; ++y)
        for (std::int64_t x = 0; x < image.size[0]; ++x)
          image.values[voxel++] = phantom(x, y, z + image.first_plane);
    std::vector<double> errors;
    double coherence = 0.0;
    for (const Orientation& found : orientations(image, {1.0, 4.0})) {
      errors.push_back(angle(found.direction, n));
      coherence += found.coherence;
    }
    std::nth_element(errors.begin(),
                     errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
    const double median = errors[errors.size() / 2];
    EXPECT_LT(median, 2.0);
    std::printf("  median %.2f degrees, mean coherence %.2f\n", median,
                coherence / static_cast<double>(errors.size()));
    EXPECT_GT(coherence / static_cast<double>(errors.size()), 0.5);
  }
}

TEST(StructureTensor, OfOnePlaneLiesInIt) {
  IntensityVolume image(world(), Size{40, 40, 1}, {1.0, 1.0, 5.0});
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < image.planes; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) image.values[voxel++] = std::sin(0.4 * x + 0.3 * y);
  for (const Orientation& found : orientations(image, {1.0, 3.0})) {
    EXPECT_LT(angle(found.direction, unit({3, -4, 0})), 0.5);
    EXPECT_GT(found.coherence, 0.99);
  }
}

}  // namespace
}  // namespace stroma::test
