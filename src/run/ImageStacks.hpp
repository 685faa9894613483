// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Results of a run put back onto the voxels of its image.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/PlacedParticles.hpp"
#include "run/Specimen.hpp"
#include "stroma/image/stacks/StackWriter.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/RunFolder.hpp"

namespace stroma {

/// Writes image_undeformed and image_deformed, if the deck asks for them; else does nothing.
///
/// Voxels take means of what fills them (voxels::BandMeans): of cut voxels over their parts, of
/// voxels finer than particles of those that reach into them. Planes are made and written a band at
/// a time; for each, the layers of particles that reach into it are evaluated anew. Member
/// functions are collective.
class ImageStacks {
 public:
  ImageStacks(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
              const output::RunFolder& folder);

  /// Removes those of steps behind the one that a run goes on from.
  /// \throws base::RunError
  void resume(std::int64_t last_step) const;
  /// Writes an accepted step, as often as the deck asks.
  /// \throws base::RunError
  void write_due(const output::HistoryRow& row, const mechanics::Body& body, const grid::Vector& u);
  /// Writes the last accepted step where it was not due.
  /// \throws base::RunError
  void write_last(const output::HistoryRow& row, const mechanics::Body& body,
                  const grid::Vector& u);

 private:
  void write(const output::HistoryRow& row, const mechanics::Body& body, const grid::Vector& u);
  void write_frame(bool is_deformed, const output::HistoryRow& row,
                   PlacedParticles particles) const;
  image::StackHeader header(bool is_deformed, const output::HistoryRow& row,
                            const voxels::Box& box) const;

  base::Communicator communicator_;
  const Deck* deck_;
  output::RunFolder folder_;
  std::array<std::int64_t, 3> size_;           // voxels of the image or its region
  std::array<double, 3> voxel_size_, origin_;  // [um]
  particles::Shares shares_;
  std::vector<output::ParticleVariable> quantities_;
  std::int64_t step_ = -1;  // last one written
};

}  // namespace stroma
