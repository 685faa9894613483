// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where the particles of a body are among the voxels of an image.

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/mechanics/body/Body.hpp"
#include "stroma/output/files/ParticleVariables.hpp"
#include "stroma/particles/Shares.hpp"
#include "stroma/voxels/BandMeans.hpp"

namespace stroma {

/// What lies between two corners [voxels]; at first nothing.
struct Extent {
  std::array<double, 3> low, high;

  Extent() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void include(const std::array<double, 3>& other_low, const std::array<double, 3>& other_high);
  /// Whether it reaches into some planes.
  bool reaches(std::int64_t first_plane, std::int64_t planes) const {
    return low[2] < static_cast<double>(first_plane + planes) &&
           high[2] > static_cast<double>(first_plane);
  }
  /// The voxels into which it reaches by some share of a voxel, at least one along each axis; by
  /// default more than by rounding.
  voxels::Box voxels(double least = 1e-6) const;
};

/// The particles of this rank in a frame, evaluated a layer of elements at a time. Lengths are in
/// voxels, from the body's lower corner in the undeformed frame.
///
/// A particle stands for a share of the undeformed body (particles::Shares) and so, with x = X + u
/// and F there, for the box around what F makes of that share, filled to J V0 of its volume.
class PlacedParticles {
 public:
  /// Collective; evaluates all layers once if they are deformed.
  /// \param communicator  of the ranks that share the body
  /// \param body          its particles
  /// \param u             displacement of the grid's nodes [um]; what is made of it is good until
  ///                      the halo is used again
  /// \param shares        of the particles' layout
  /// \param voxel_size    [um]
  /// \param is_deformed   whether they are where the body has gone
  PlacedParticles(const base::Communicator& communicator, const mechanics::Body& body,
                  const grid::Vector& u, const particles::Shares& shares,
                  const std::array<double, 3>& voxel_size, bool is_deformed);

  /// Of all ranks' particles.
  const Extent& of_body() const { return of_body_; }
  /// Of this rank's.
  const Extent& of_rank() const { return of_rank_; }

  /// Takes a particle's box, its state, and the index of its material.
  using Use = std::function<void(const voxels::FilledBox&, const output::ParticleAt&, std::size_t)>;
  /// Calls use for the particles of the layers that reach into some planes. The layer that was
  /// evaluated last is kept. Not collective.
  void visit(std::int64_t first_plane, std::int64_t planes, const Use& use);

 private:
  const output::ParticleState& state_of_layer(int layer);
  voxels::FilledBox box_of(std::int64_t id, const output::ParticleAt& particle) const;
  Extent extent_of(int layer);

  const mechanics::Body* body_;
  mechanics::FieldLayers layers_;
  const particles::Shares* shares_;
  std::array<double, 3> voxel_size_;
  bool is_deformed_;
  std::vector<Extent> of_layer_;
  int kept_layer_ = -1;
  mechanics::FieldLayers::Fields kept_{0};
  output::ParticleState kept_state_;
  Extent of_rank_, of_body_;
};

}  // namespace stroma
