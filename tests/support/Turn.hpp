// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Rotations and rigid motions, for tests that move bodies.

#include <array>
#include <cmath>
#include <cstddef>

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::test {

/// Turn by an angle [rad] about an axis through the origin (Rodrigues).
inline tensor::Tensor3 turn(const std::array<double, 3>& axis, double angle) {
  tensor::Tensor3 W;
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (int c = 0; c < 3; ++c) {
    W((c + 2) % 3, (c + 1) % 3) = axis[static_cast<std::size_t>(c)] / length;
    W((c + 1) % 3, (c + 2) % 3) = -axis[static_cast<std::size_t>(c)] / length;
  }
  const tensor::Tensor3 WW = W * W;
  tensor::Tensor3 R = tensor::identity();
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d)
      R(c, d) += std::sin(angle) * W(c, d) + (1.0 - std::cos(angle)) * WW(c, d);
  return R;
}

/// x -> R x + t; at first none.
struct RigidMotion {
  tensor::Tensor3 R = tensor::identity();
  std::array<double, 3> t{};

  /// This motion after another.
  RigidMotion after(const RigidMotion& first) const {
    RigidMotion both{R * first.R, t};
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d)
        both.t[static_cast<std::size_t>(c)] += R(c, d) * first.t[static_cast<std::size_t>(d)];
    return both;
  }
  /// Of a point, a component.
  double displacement(const std::array<double, 3>& x, int c) const {
    const auto own = static_cast<std::size_t>(c);
    return R(c, 0) * x[0] + R(c, 1) * x[1] + R(c, 2) * x[2] + t[own] - x[own];
  }
};

}  // namespace stroma::test
