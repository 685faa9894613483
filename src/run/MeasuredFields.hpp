// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// From images of a vector to what a rank needs of them.

#include <memory>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/ReadImages.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Partition.hpp"

namespace stroma {

/// The displacement of each condition that has images, null of the others. Each rank reads a slab of
/// an image, one image at a time, and keeps the voxels around what it has of the condition's faces,
/// an element deep; with Grid|Reset, around all of them. Collective.
/// \param communicator  of the ranks that share the body
/// \param deck          it names the images
/// \param body          the grid that fills the body's box
/// \param partition     of the grid under it
/// \param seen          gains the files that were read, and what is to be known of them
/// \throws base::InputError, naming the condition: an image cannot be had, has no voxel size or
///   another size than the first, or does not reach to all of the face
std::vector<std::shared_ptr<const mechanics::VectorField>> measured_displacements(
    const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
    const grid::Partition& partition, ReadImages& seen);

/// The velocity of each initial condition that has images, null of the others; the same, of all that
/// a rank has of the body.
std::vector<std::shared_ptr<const mechanics::VectorField>> measured_velocities(
    const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
    const grid::Partition& partition, ReadImages& seen);

}  // namespace stroma
