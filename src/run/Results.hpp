// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a run leaves on disk, step by step.

#include <functional>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "run/FieldFiles.hpp"
#include "run/ImageStacks.hpp"
#include "run/KnownFiles.hpp"
#include "run/Specimen.hpp"
#include "run/Tables.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/pictures/Pictures.hpp"

namespace stroma {

/// What a run has left on disk up to some step.
struct ResultsSoFar {
  std::vector<output::HistoryRow> rows;
  FieldFilesEnd files;
};

/// Writes history.csv, particles.e, grid.e, image stacks, tables, deck.xml and the pictures of one run.
class Results {
 public:
  /// Writes deck.xml and begins history.csv; or goes on with what there is, and cuts off what comes
  /// behind it. Collective.
  Results(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
          const std::vector<KnownFile>& files, Tables& tables, const output::RunFolder& folder,
          base::Log& log, const ResultsSoFar& so_far = {});

  /// Collective.
  ResultsSoFar so_far() const { return {rows_, fields_.end()}; }
  /// Of the last accepted step.
  const output::HistoryRow& last_row() const { return rows_.back(); }

  /// Writes an accepted step: its row always, the fields as often as the deck asks. The row's
  /// reactions, energy and material figures are computed here from u. Collective.
  void write(output::HistoryRow row, mechanics::MomentumBalance& balance, const grid::Vector& u);

  /// Writes what was due of the last step that there is and could not be written. Collective.
  void write_missing(mechanics::MomentumBalance& balance, const grid::Vector& u);

  /// See FieldFiles::adopt(): for a run that goes on on another number of ranks. Collective.
  bool adopt(const mechanics::MomentumBalance& balance) { return fields_.adopt(balance); }
  /// Removes what was copied then, once a checkpoint knows of the copies. Collective.
  void remove_adopted() const { fields_.remove_adopted(); }

  /// What is on disk so far, in a few words.
  std::string on_disk() const;

  /// Writes the last accepted step's fields if they were not due. Collective.
  void write_last(mechanics::MomentumBalance& balance, const grid::Vector& u);
  /// Writes the tables of the last accepted step, if the deck asks for them. Collective.
  /// \param room  bytes that it may take on this rank, about
  void write_tables(const mechanics::MomentumBalance& balance, const grid::Vector& u, double room);
  /// Takes the checksums of what was written, for nothing more will be. Collective.
  void finish_files();
  /// Draws the pictures and prints a table of all steps: at the end of a run, and of one that
  /// failed. Collective.
  void finish(mechanics::MomentumBalance& balance, const grid::Vector& u,
              const std::function<double()>& seconds);

 private:
  void draw(const std::vector<output::MovingSupport>& moving,
            const mechanics::MomentumBalance& balance, const grid::Vector& u);

  base::Communicator communicator_;
  const Deck* deck_;
  const Specimen* specimen_;
  output::RunFolder folder_;
  base::Log* log_;
  output::Pictures pictures_;
  output::History history_;
  FieldFiles fields_;
  ImageStacks stacks_;
  Tables* tables_;
  std::string said_of_tables_;
  std::vector<output::HistoryRow> rows_;
};

}  // namespace stroma
