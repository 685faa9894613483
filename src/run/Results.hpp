// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a run leaves on disk, step by step.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/Specimen.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/output/files/GridFile.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/pictures/Pictures.hpp"

namespace stroma {

/// Writes history.csv, particles.e, grid.e, deck.xml and the pictures of one run.
class Results {
 public:
  /// Writes deck.xml and opens the files. Collective.
  Results(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
          const output::RunFolder& folder, base::Log& log);

  /// Writes an accepted step: its row always, the fields as often as the deck asks. The row's
  /// reactions, energy and material figures are computed here from u. Collective.
  void write(output::HistoryRow row, mechanics::MomentumBalance& balance, const grid::Vector& u);

  /// What is on disk so far, in a few words.
  std::string on_disk() const;

  /// Writes the last accepted step's fields if they were not due, draws the pictures and prints a
  /// table of all steps: at the end of a run, and of one that failed. Collective.
  void finish(mechanics::MomentumBalance& balance, const grid::Vector& u,
              const std::function<double()>& seconds);

 private:
  output::ParticleSet particle_set() const;
  output::HistoryRow with_figures(output::HistoryRow row, const mechanics::MomentumBalance& balance,
                                  const grid::Vector& u) const;
  /// The particles' states in the order of particle_set(), good until the balance is used again.
  output::StatePieces states(const mechanics::MomentumBalance& balance,
                             const grid::Vector& u) const;
  void write_particles(const mechanics::MomentumBalance& balance, const grid::Vector& u);
  void open_grid_file(const mechanics::MomentumBalance& balance, const grid::Partition& partition);
  void write_grid(mechanics::MomentumBalance& balance, const grid::Vector& u);
  /// How much the springs of conditions imposed by penalty give way.
  void print_give(const mechanics::MomentumBalance& balance, const grid::Vector& u) const;
  void print_bounds() const;
  void print_table(const std::vector<output::MovingSupport>& moving,
                   const grid::Partition& partition, double seconds) const;

  base::Communicator communicator_;
  const Deck* deck_;
  const Specimen* specimen_;
  output::RunFolder folder_;
  base::Log* log_;
  std::vector<std::string> conditions_, materials_;
  output::Provenance provenance_;
  output::Pictures pictures_;
  output::History history_;
  std::optional<output::ParticleFile> particle_file_;
  std::optional<output::GridFile> grid_file_;
  int grid_files_ = 0;
  std::vector<output::HistoryRow> rows_;
  std::int64_t particles_step_ = -1, grid_step_ = -1;  // last ones written
};

}  // namespace stroma
