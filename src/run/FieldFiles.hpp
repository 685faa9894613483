// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The files of fields of one run: particles.e and grid.e, and the same as VTKHDF.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/Specimen.hpp"
#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/output/files/GridFile.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/files/StepSeries.hpp"
#include "stroma/output/files/VtkhdfFile.hpp"

namespace stroma {

/// How far the files of fields go.
struct FieldFilesEnd {
  std::int64_t particles_step = -1;  ///< last one written; -1: none
  std::int64_t grid_step = -1;       ///< last one written; -1: none
  std::int64_t grid_files = 0;       ///< grid.e, grid.e-s002, ...
  /// (rank) of the run that wrote them: particles.e, and the last of the grid's files.
  std::vector<output::FileEnd> particles, grid;
};

/// Writes particles.e, grid.e and, on a grid that is reset, a file of the grid for each step; each
/// is opened when it is first written. Where the deck asks for VTKHDF, a file of that for each step
/// of both. All but on_disk() and particle_set() is collective.
class FieldFiles {
 public:
  FieldFiles(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
             const output::RunFolder& folder);

  /// Goes on with the files of an earlier run: what comes behind their ends is cut off. Collective.
  /// \param end   of those that go on from step to step
  /// \param rows  the steps so far
  /// \return  what a user should know of it, or empty
  /// \throws base::RunError when a file cannot be changed
  std::string resume(const FieldFilesEnd& end, const std::vector<output::HistoryRow>& rows);
  /// Copies what another number of ranks has written into files of this one's, but for grids that
  /// were reset, whose files stay: each has a mesh of its own. Collective.
  /// \return  whether there was anything
  /// \throws base::RunError
  bool adopt(const mechanics::MomentumBalance& balance);
  /// Removes what was copied. Collective.
  void remove_adopted() const;
  /// How far they go now. Collective.
  FieldFilesEnd end() const;

  /// Writes an accepted step, as often as the deck asks, unless it is written.
  void write_due(const output::HistoryRow& row, mechanics::MomentumBalance& balance,
                 const grid::Vector& u);
  /// Writes the last accepted step where it was not due.
  void write_last(const output::HistoryRow& row, mechanics::MomentumBalance& balance,
                  const grid::Vector& u);
  /// ", particles.e to step 3, grid.e to step 2": what there is so far.
  std::string on_disk() const;

  /// The particles at home, in the order of the files.
  output::ParticleSet particle_set() const;
  /// The particles' states in that order, good until the balance is used again.
  output::StatePieces states(const mechanics::MomentumBalance& balance,
                             const grid::Vector& u) const;

 private:
  std::vector<output::ShownField> shown(const mechanics::MomentumBalance& balance) const;
  void open_particle_file(const mechanics::MomentumBalance& balance);
  void write_particles(const output::HistoryRow& row, const mechanics::MomentumBalance& balance,
                       const grid::Vector& u);
  std::vector<output::VtkhdfNumber> numbers(const output::HistoryRow& row) const;
  void write_vtkhdf_particles(const output::HistoryRow& row, const output::StatePieces& pieces,
                              const std::vector<output::ShownField>& fields);
  void open_grid_file(const output::GridPart& part);
  void write_grid(const output::HistoryRow& row, mechanics::MomentumBalance& balance,
                  const grid::Vector& u);

  base::Communicator communicator_;
  const Deck* deck_;
  const Specimen* specimen_;
  output::RunFolder folder_;
  output::HistoryNames names_;
  output::StepSeries vtkhdf_particles_, vtkhdf_grid_;
  output::Provenance provenance_;
  std::optional<output::ParticleFile> particle_file_;
  std::optional<output::GridFile> grid_file_;
  std::optional<output::FileEnd> particles_continued_, grid_continued_;  // of files not opened yet
  FieldFilesEnd adopted_;  // of another number of ranks
  int grid_files_ = 0;
  std::int64_t particles_step_ = -1, grid_step_ = -1;  ///< last ones written
};

}  // namespace stroma
