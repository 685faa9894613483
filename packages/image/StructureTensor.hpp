// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// In which direction an image varies least: along its fibres.

#include <array>
#include <functional>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

struct StructureTensorScales {
  double gradient;  ///< standard deviation of the Gaussian whose derivatives are taken [um], > 0
  double window;    ///< of that over which their products are averaged [um], >= gradient
};

/// xx, yy, zz, xy, yz, zx.
using SymmetricTensor = std::array<double, 6>;

/// The structure tensor of an image at each voxel,
///
///     J = G_window * (grad I (x) grad I),   grad I = (grad G_gradient) * I     [intensity^2/um^2]
///
/// one component after the other, so that nobody keeps all six. Gradients nearer than two of their
/// scales to a face count nowhere, for the image beyond is not known, unless the image is thinner than
/// four of these. Collective.
///
/// \param communicator  of the ranks that share the image
/// \param image,scales  of a voxel size that is known
/// \param take          take(component, its values), of SymmetricTensor in its order
/// Source: J. Bigun, G. Granlund, Proc. First Int. Conf. Computer Vision (1987) 433.
void structure_tensor(const base::Communicator& communicator, const voxels::IntensityVolume& image,
                      const StructureTensorScales& scales,
                      const std::function<void(int, const voxels::Volume<float>&)>& take);

/// The direction in which an image varies least, and how clear it is.
struct Orientation {
  std::array<double, 3> direction;  ///< unit vector, of either sense
  double coherence;                 ///< (l2 - l3) / (l2 + l3) [-]: 0 none or a plane, 1 one alone
};

/// By the least eigenvalue l3 of J, l1 >= l2 >= l3.
/// \param tensor   J; not 0
/// \param is_flat  the image has one plane: the direction lies in it
Orientation orientation_of(const SymmetricTensor& tensor, bool is_flat);

}  // namespace stroma::image
