// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The pictures that a run leaves: vessels.png, von_mises.png, force.png, drawn by gnuplot.

#include <array>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/pictures/RasterPlot.hpp"

namespace stroma::output {

/// A boundary condition that moves, for the picture of force against strain.
struct MovingSupport {
  std::string name;
  std::size_t index = 0;                 ///< of its reaction in HistoryRow::reactions
  std::array<double, 3> displacement{};  ///< at a factor of 1 [um]
  std::array<double, 3> along{};         ///< which its force is told, of length 1
  double strain = 0;                     ///< likewise [-]; 0 when the deck gave no strain
  bool follows_load = true;              ///< else a curve of its own is the factor
};

/// Draws pictures into a run's folder. Numbers and gnuplot scripts stay in its subfolder
/// `pictures`, where each script draws its picture again (`gnuplot von_mises.gp`), so that users
/// can change it. Every function is collective and returns a note for the log, the same on all
/// ranks: empty when the picture was made, else why not (gnuplot is missing, a file could not be
/// written, nothing to draw). A picture never makes a run fail.
class Pictures {
 public:
  /// \param communicator  rank 0 of it draws
  /// \param folder        the run's output folder, which exists
  /// \param title         the deck's title
  /// \param spacing       distance of neighbouring particles at load 0, in x, y, z [um]
  /// \param origin        of y, in maps
  Pictures(const base::Communicator& communicator, std::string folder, std::string title,
           std::array<double, 3> spacing, Origin origin);

  /// vessels.png: the materials on the middle layer in z, at load 0, named.
  std::string draw_materials(const ParticleSet& particles,
                             const std::vector<std::string>& materials) const;

  /// von_mises.png: von Mises stress [Pa] of the middle layer's particles at their current
  /// positions. The colour scale ends at the 99.5th percentile of the pixels when larger values are
  /// rare peaks.
  std::string draw_von_mises(const ParticleSet& particles, const StatePieces& states,
                             double load) const;

  /// force.png: the component of each moving support's reaction along its displacement, against
  /// strain (when all of them have one) or displacement, over the steps so far. In pN, nN or uN by
  /// size.
  std::string draw_force(const std::vector<MovingSupport>& supports,
                         const std::vector<HistoryRow>& history) const;

 private:
  std::string draw(const std::string& name, const std::string& data, const std::string& data_ending,
                   const std::string& script) const;

  base::Communicator communicator_;
  std::string folder_;
  std::string title_;
  std::array<double, 3> spacing_;
  Origin origin_;
};

}  // namespace stroma::output
