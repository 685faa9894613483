// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The tables of a run's last step.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/Specimen.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/tables/ObjectTable.hpp"
#include "stroma/output/tables/WallTable.hpp"
#include "stroma/particles/Seeding.hpp"

namespace stroma {

/// Knows, from the image, to which object each particle belongs and how far it is from walls, and
/// writes materials.csv, histograms.csv, wall_distance.csv and objects.csv, if the deck asks for
/// them. Member functions are collective.
///
/// Objects and walls are those of all labels but the one with the most voxels, which is the ground
/// between them; of that one where it is the only one. There are walls of up to eight labels, those
/// with the most voxels.
class Tables {
 public:
  /// Keeps 4 bytes of each particle, and 2 for each label with walls.
  Tables(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
         const voxels::LabelVolume& labels);

  /// \param folder     of the run
  /// \param row        of the step
  /// \param particles  this rank's, in the specimen's order
  /// \param states     theirs
  /// \param room       bytes that it may take on this rank, about; it takes no less than 26 a particle
  /// \throws base::RunError when a file cannot be written
  /// \return  what there is to say of them; on all ranks
  std::string write(const output::RunFolder& folder, const output::HistoryRow& row,
                    const output::ParticleSet& particles, const output::StatePieces& states,
                    double room);

 private:
  void find_objects(const particles::ParticleVoxels& where, const voxels::LabelVolume& labels,
                    std::int32_t ground);
  void find_walls(const particles::ParticleVoxels& where, const Specimen& specimen,
                  const voxels::LabelVolume& labels, std::int32_t label);

  base::Communicator communicator_;
  bool are_wanted_;
  std::vector<std::string> materials_;
  std::string ground_;  ///< the material between the objects; empty: there is none
  std::map<std::int64_t, std::string> material_of_label_;
  output::ObjectLattice lattice_;
  image::NumberedObjects objects_;    // without the numbers of voxels
  std::vector<std::int32_t> object_;  // (particle) number of its object, or 0
  std::vector<output::WallParticles> walls_;
};

}  // namespace stroma
