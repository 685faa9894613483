// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Means over voxels of what fills boxes that lie anywhere between them, some planes at a time.

#include <array>
#include <cstdint>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::voxels {

/// How what lies in a voxel becomes its value.
enum class Rule {
  mean,    ///< by volume; of a voxel that is empty NaN
  largest  ///< the value that fills the largest box in it (of equal ones the smallest value), as
           ///< labels ask for; of an empty voxel -1
};

/// A box with even contents. Lengths are in voxels, from the volume's corner.
struct FilledBox {
  std::array<double, 3> low{}, high{};
  double filling = 1.0;  ///< share of the box's volume that its contents take
};

/// Some planes of a volume, into which ranks put boxes with values.
///
/// With V_p the volume that the contents of box p have in a voxel, V_p = filling times volume of
/// what box and voxel share, a value is sum_p V_p q_p / sum_p V_p where the sum of V_p is half a
/// voxel or more; else the voxel is empty. Sums are taken in the order of the ranks.
///
/// A rank keeps a double for each mean, two for each largest, and one more, of each voxel that its
/// own boxes reach.
class BandMeans {
 public:
  /// Collective.
  /// \param communicator  of the ranks that share the volume
  /// \param size          voxels of the volume: x, y, z
  /// \param first_plane   of the band
  /// \param planes        of it
  /// \param reach         voxels that this rank's boxes touch; what lies beyond is left out
  /// \param rules         of the values that a box has
  BandMeans(const base::Communicator& communicator, const std::array<std::int64_t, 3>& size,
            std::int64_t first_plane, std::int64_t planes, const Box& reach,
            std::vector<Rule> rules);

  /// Whether a box reaches into this rank's part of the band. Not collective.
  bool is_reached_by(const FilledBox& box) const;
  /// Puts a box with a value for each rule. Not collective.
  void add(const FilledBox& box, const double* values);

  /// (value) the band as a volume of its own, spread over the ranks in slabs. Ends the adding.
  /// Collective.
  std::vector<Volume<float>> values();

 private:
  /// (plane, y, x, number) of this rank's reach.
  using Sums = std::vector<double>;
  template <class Take>
  void for_owners(const Sums& sums, std::size_t numbers, const Take& take) const;
  Volume<float> means(const Sums& sums, const std::vector<double>& volume) const;
  Volume<float> largest(const Sums& sums, const std::vector<double>& volume) const;

  base::Communicator communicator_;
  std::array<std::int64_t, 3> size_;  // of the band
  Box reach_;                         // planes are those of the band
  std::vector<Box> reach_of_;         // (rank)
  std::vector<Rule> rules_;
  Sums volume_;             // sum of V_p
  std::vector<Sums> sums_;  // (value) sum of V_p q_p; or the value of the largest, and its V_p
};

}  // namespace stroma::voxels
