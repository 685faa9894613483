// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Random numbers that depend on a seed and a counter alone, so that any rank can draw those of any
/// voxel.

#include <cmath>
#include <cstdint>

namespace stroma::image {

/// 64 well-mixed bits of (seed, counter). Source: the finaliser of SplitMix64, Steele, Lea & Flood
/// (2014).
inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = seed * 0xD1B54A32D192ED03u + (counter + 1) * 0x9E3779B97F4A7C15u;
  for (int round = 0; round < 2; ++round) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
  }
  return z;
}

/// Uniform in (0, 1).
inline double random_uniform(std::uint64_t seed, std::uint64_t counter) {
  return (static_cast<double>(random_bits(seed, counter) >> 11) + 0.5) * 0x1.0p-53;
}

/// A sequence of such numbers.
class RandomSequence {
 public:
  explicit RandomSequence(std::uint64_t seed) : seed_(seed) {}

  double uniform() { return random_uniform(seed_, counter_++); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1 (Box and Muller).
  double normal() {
    const double u = uniform(), v = uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * v);
  }
  /// Exponentially distributed.
  double exponential(double mean) { return -mean * std::log(uniform()); }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

}  // namespace stroma::image
