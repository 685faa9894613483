// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Gaussian smoothing of a distributed volume.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Weights of a Gaussian of standard deviation sigma [voxels], sampled at -r, ..., r with r =
/// floor(4 sigma + 1/2) and scaled to a sum of 1. A sigma of 0 gives the single weight 1.
std::vector<double> gaussian_weights(double sigma);

/// Whether a standard deviation [voxels] is so far beyond a line of n voxels, continued by its
/// mirror images, that nothing but the mean is left: sigma > 2 n.
bool smooths_to_mean(double sigma, std::int64_t n);

/// Convolves with a Gaussian, axis by axis, with gaussian_weights() truncated at 4 standard
/// deviations. Beyond its faces the volume is continued by its mirror image (the face lies between
/// a voxel and its mirror: d c b a | a b c d). Along an axis where smooths_to_mean(), takes the
/// mean, at the cost of one sum. The same bits on any number of ranks. Collective; each rank holds
/// its slab and, while it works along z, the planes within 4 sigma of it.
/// \param communicator  of the ranks that share the volume
/// \param volume        smoothed in place
/// \param sigma         standard deviation along x, y, z [voxels], >= 0
template <class T>
void smooth(const base::Communicator& communicator, voxels::Volume<T>& volume,
            const std::array<double, 3>& sigma);

/// The derivative along an axis of the volume smoothed by a Gaussian [1/voxel]: along the axis with
/// weights i exp(-i^2 / (2 sigma^2)), scaled such that a linear volume has its own; 0 at a face, where
/// the volume continues as its mirror image. Collective.
/// The standard deviation sigma is that along x, y, z [voxels], >= 0; of 0 along the axis, it is the
/// central difference.
template <class T>
void differentiate(const base::Communicator& communicator, voxels::Volume<T>& volume, int axis,
                   const std::array<double, 3>& sigma);

/// The mean around each voxel, weighted by a Gaussian, of the voxels that lie inside and at least
/// `margin` voxels off the faces. Collective.
/// \pre margin within 4 sigma, and less than half the volume
template <class T>
void average_inside(const base::Communicator& communicator, voxels::Volume<T>& volume,
                    const std::array<double, 3>& sigma, const std::array<std::int64_t, 3>& margin);

}  // namespace stroma::image
