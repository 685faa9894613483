#pragma once

/// \file
/// Gaussian smoothing of a distributed volume.

#include <array>
#include <vector>

#include "base/Communicator.hpp"
#include "image/Volume.hpp"

namespace stroma::image {

/// Weights of a Gaussian of standard deviation sigma [voxels], sampled at -r, ..., r with r =
/// floor(4 sigma + 1/2) and scaled to a sum of 1. A sigma of 0 gives the single weight 1.
std::vector<double> gaussian_weights(double sigma);

/// Convolves with a Gaussian, axis by axis, with gaussian_weights() truncated at 4 standard
/// deviations. Beyond its faces the volume is continued by its mirror image (the face lies between
/// a voxel and its mirror: d c b a | a b c d). The same bits on any number of ranks. Collective;
/// each rank holds its slab and, while it works along z, the planes within 4 sigma of it.
/// \param sigma  standard deviation along x, y, z [voxels], >= 0
template <class T>
void smooth(const base::Communicator& communicator, Volume<T>& volume,
            const std::array<double, 3>& sigma);

}  // namespace stroma::image
