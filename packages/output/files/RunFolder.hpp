// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The output folder of a run and the names of the files in it.

#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {

/// Names of the tables of a run's last step.
std::vector<std::string> table_files();
/// Names of the files that a run leaves in its folder; with pictures, their data and scripts too;
/// with a report or tables, these.
std::vector<std::string> run_files(bool pictures, bool report, bool tables);
/// Of a run that finds a stiffness.
std::vector<std::string> stiffness_files(bool report);
/// Of a study, beside the folders of its members.
std::vector<std::string> study_files();
/// Of a fit, beside the folders of its members.
std::vector<std::string> fit_files();

/// Refuses a folder in which a file of the names given, spread over so many ranks, is in the way: a
/// run would write it, and it is the user's own; or from which the run would remove one of its own
/// inputs, which an earlier run left there. A folder that does not exist is not refused.
/// \param communicator  of all ranks of the run
/// \param folder        the output folder
/// \param names         of the files to be written
/// \param inputs        decks, images and tables, which stay, by whatever path they are named
/// \throws InputError on all ranks, naming every such file. Collective
void refuse_foreign_files(const base::Communicator& communicator, const std::string& folder,
                          const std::vector<std::string>& names,
                          const std::vector<std::string>& inputs);

/// The paths of what a run leaves in a folder.
class RunFiles {
 public:
  explicit RunFiles(std::string folder);

  const std::string& folder() const { return folder_; }
  std::string history() const { return file("history.csv"); }
  std::string particles() const { return file("particles.e"); }
  /// Grid files are numbered from 1: grid.e, then, for other elements, grid.e-s002, grid.e-s003:
  /// the names by which ParaView takes files with different meshes for one sequence.
  std::string grid(int number = 1) const;
  std::string checkpoint() const { return file("checkpoint.h5"); }
  std::string deck() const { return file("deck.xml"); }
  std::string log() const { return file("log.txt"); }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }

 private:
  std::string folder_;
};

/// A folder that exists, can be written and is locked against other runs, and what a run does
/// with it. Copies share the lock.
class RunFolder : public RunFiles {
 public:
  /// Makes the folder, with its parents, unless it is there already, and locks it. What was made is
  /// removed with the last copy, if nothing was written. Collective.
  /// \param communicator  of all ranks of the run
  /// \param folder        its path
  /// \param names         of the files to be written
  /// \throws InputError on all ranks when the folder cannot be made or written, is a file, or
  /// another run writes into it
  RunFolder(const base::Communicator& communicator, std::string folder,
            std::vector<std::string> names);

  /// See above.
  /// \param inputs       decks, images and tables
  /// \param is_continued  whether the run goes on from the checkpoint in the folder, wherever that is from
  void refuse_foreign_files(const std::vector<std::string>& inputs,
                            bool is_continued = false) const;
  /// Of the above what regards inputs that are known only later: data beside a header, slices.
  void refuse_inputs(const std::vector<std::string>& inputs, bool is_continued = false) const;

  /// Removes what an earlier run left, of any number of ranks, so that no stale file passes for a
  /// result of this run; only what a run is known to have left, as it left it. From now on, files
  /// of this run's names count as left by it. Collective.
  /// \throws InputError on all ranks when a file cannot be removed
  void remove_old_results(base::Log& log) const;

  /// Leaves what an earlier run left, for this one goes on with it. Collective.
  void continue_results(base::Log& log) const;

  /// A file is written and will not change: of the log, when its last line is there. Collective.
  void finish(const std::string& file) const;
  /// So are all of them but the log. Collective.
  void finish() const;

  /// When the run took it, which is what it does first.
  std::time_t taken() const { return taken_; }

 private:
  struct Hold;

  /// Of the files to be written; a run that goes on has its checkpoint already.
  std::vector<std::string> names(bool is_continued) const;

  base::Communicator communicator_;
  std::vector<std::string> names_;
  std::time_t taken_ = std::time(nullptr);
  std::shared_ptr<Hold> hold_;  ///< of rank 0
};

}  // namespace stroma::output
