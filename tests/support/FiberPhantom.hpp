// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A picture of parallel fibres as a microscope would show it.

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace stroma::test {

/// Straight fibres at random places, all along one direction. A fibre has a Gaussian profile, its
/// own 0.5 um and the microscope's blur of 0.4 um across and 0.8 um along z as standard deviations,
/// and the noise of a voxel is half of a fibre's brightness.
class FiberPhantom {
 public:
  FiberPhantom(const std::array<std::int64_t, 3>& size, const std::array<double, 3>& voxel_size,
               const std::array<double, 3>& direction, unsigned seed = 1)
      : size_(size), voxel_size_(voxel_size), direction_(direction) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::array<double, 3> length{};
    for (std::size_t d = 0; d < 3; ++d) length[d] = static_cast<double>(size[d]) * voxel_size[d];
    const double volume = length[0] * length[1] * length[2];
    constexpr double crossing = 12.0;  // a fibre for so much area across [um^2]
    const auto count = static_cast<int>(std::pow(volume, 2.0 / 3.0) / crossing * 2.0);
    for (int n = 0; n < count; ++n)
      through_.push_back(
          {share(random) * length[0], share(random) * length[1], share(random) * length[2]});
    noise_.resize(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    std::normal_distribution<double> normal(0.0, 0.5);
    for (float& value : noise_) value = static_cast<float>(normal(random));
  }

  const std::array<std::int64_t, 3>& size() const { return size_; }
  const std::array<double, 3>& voxel_size() const { return voxel_size_; }

  /// Intensity of a voxel; a fibre's middle adds 100.
  double operator()(std::int64_t i, std::int64_t j, std::int64_t k) const {
    const std::array<double, 3> x{(static_cast<double>(i) + 0.5) * voxel_size_[0],
                                  (static_cast<double>(j) + 0.5) * voxel_size_[1],
                                  (static_cast<double>(k) + 0.5) * voxel_size_[2]};
    // Squares of standard deviations: the blurred profile of a line is that of its projection.
    constexpr double across = 0.25 + 0.16, along_z = 0.25 + 0.64;
    double sum = noise_[static_cast<std::size_t>(i + size_[0] * (j + size_[1] * k))];
    for (const auto& point : through_) {
      // the nearest point in the metric of the blur
      const std::array<double, 3> weight{1.0 / across, 1.0 / across, 1.0 / along_z};
      double dd = 0.0, rd = 0.0, rr = 0.0;
      for (std::size_t d = 0; d < 3; ++d) {
        const double r = x[d] - point[d];
        dd += weight[d] * direction_[d] * direction_[d];
        rd += weight[d] * r * direction_[d];
        rr += weight[d] * r * r;
      }
      sum += std::exp(-0.5 * (rr - rd * rd / dd));
    }
    return 100.0 * sum + 20.0;
  }

 private:
  std::array<std::int64_t, 3> size_;
  std::array<double, 3> voxel_size_, direction_;
  std::vector<std::array<double, 3>> through_;
  std::vector<float> noise_;
};

}  // namespace stroma::test
