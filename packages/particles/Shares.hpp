// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The boxes of the undeformed body that particles stand for.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/grid/Grid.hpp"
#include "stroma/particles/AxisLayout.hpp"

namespace stroma::particles {

/// A box with the particle in it, from the body's lower corner [um], and the voxel that the
/// particle lies in.
struct Share {
  std::array<double, 3> low, high, point;
  std::array<std::int64_t, 3> voxel;
};

/// The shares of all particles of a layout, which fill the body without a gap. They are known from
/// the layout along the axes alone.
class Shares {
 public:
  /// \param parameters  the deck's section
  /// \param body        the grid of the undeformed body
  /// \param voxels      of the image: x, y, z
  /// \param voxel_size  [um]
  Shares(const ParticleParameters& parameters, const grid::Grid& body,
         const std::array<std::int64_t, 3>& voxels, const std::array<double, 3>& voxel_size);

  /// \param id  of a particle (Particles::id)
  Share of(std::int64_t id) const;

 private:
  struct Axis {
    std::vector<double> face;   // (point + 1) faces of shares
    std::vector<double> point;  // (point)
    std::vector<std::int64_t> voxel;
  };
  std::array<Axis, 3> axes_;
};

}  // namespace stroma::particles
