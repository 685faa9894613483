// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A layer of particles as a regular raster: the numbers behind the pictures.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ParticleFile.hpp"

namespace stroma::output {

/// A picture's numbers; complete on rank 0, without values on the other ranks.
struct Raster {
  int columns = 0;  ///< pixels along x
  int rows = 0;     ///< pixels along y
  std::array<double, 2>
      first{};  ///< x, y of the centre of pixel (0, 0), where both are smallest [um]
  std::array<double, 2> pixel{};  ///< size of a pixel in x, y [um]
  std::vector<float> value;       ///< (row, column), column fastest; NaN: no particle there
};

/// One particle of the layer.
struct SlicePoint {
  std::array<double, 2> position{};  ///< x, y, where it is to be drawn [um]
  double value = 0;
};

/// The middle layer of the specimen in z: the particles of this rank (indices into the set) whose
/// reference position lies in the highest layer that is not above the middle of the specimen's
/// height. Particles of a layer have one height, but for rounding. Collective.
/// \param communicator  of the ranks that share the particles
/// \param particles     this rank's
/// \param z_spacing     distance of two layers of particles, about [um]
/// \param z             (out, if not null) the layer's reference height, the same on all ranks [um]
std::vector<std::int64_t> middle_layer(const base::Communicator& communicator,
                                       const ParticleSet& particles, double z_spacing,
                                       double* z = nullptr);

/// How the values of several particles in one pixel become the pixel's value.
enum class Merge {
  Mean,     ///< their mean
  Majority  ///< the value (an index, 0 to 255) that most of them have, the lowest of equals
};

/// Rasterises the points of all ranks. The raster spans their bounding box, with as many pixels a
/// direction as particles would stand there unstretched (at most max_pixels), so a pixel is about
/// the particles' current spacing. A pixel without a particle that has filled pixels on opposite
/// sides, both within 1.5 spacings, is a hole between particles and takes its nearest neighbours'
/// value (the mean of equally near ones, or the majority); all others stay empty. Collective;
/// memory is two numbers a pixel on every rank.
/// \param communicator      of the ranks that share the points
/// \param points            this rank's
/// \param reference_extent  width and height of the layer's particles at load 0 [um], all ranks
/// \param spacing           reference spacing of the particles in x and y [um]
/// \param merge             how the points in a pixel become one value
/// \param max_pixels        along a direction
Raster rasterise(const base::Communicator& communicator, const std::vector<SlicePoint>& points,
                 std::array<double, 2> reference_extent, std::array<double, 2> spacing, Merge merge,
                 int max_pixels = 2048);

}  // namespace stroma::output
