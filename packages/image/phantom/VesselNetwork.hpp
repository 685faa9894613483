// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The course of the microvessels of a phantom: which tubes there are, before any voxel is drawn.

#include <array>
#include <cstdint>
#include <vector>

namespace stroma::image {

/// A short piece of a vessel: the radius runs linearly from end to end.
struct TubeSegment {
  std::array<double, 3> from, to;  ///< [um]
  double radius_from, radius_to;   ///< [um]
};

/// What a network should be like.
struct NetworkParameters {
  std::array<double, 3> box;  ///< sides of the specimen [um]
  double smallest_radius;     ///< of a capillary [um]
  double largest_radius;      ///< of the thickest trunk [um]
  double tube_volume;         ///< sum over all segments within the box [um^3]; overlaps count twice
  std::uint64_t seed;
};

/// Grows vessels until they have the volume asked for. Each starts where there is most room yet and
/// sprouts to both sides, as the vessel fragments of angiogenesis experiments do. A sprout is a
/// random walk with persistence; it tapers, and it branches by Murray's law,
///
///     r^3 = r1^3 + r2^3,   cos(angle_i) = (r^4 + r_i^4 - r_j^4) / (2 r^2 r_i^2),
///
/// until it is a capillary, which after a while joins the nearest other vessel within reach.
/// Sprouts turn away from the z faces, and leave the box through the others. The same segments for
/// the same parameters. About 70 bytes for each 3 um of vessel on every rank: 1 MB for 512 x 512 x
/// 52 voxels of 1 um.
///
/// Source: Murray (1926), Proc. Natl. Acad. Sci. 12, 207; J. Gen. Physiol. 9, 835 (angles).
std::vector<TubeSegment> grow_network(const NetworkParameters& parameters);

}  // namespace stroma::image
