#pragma once

/// \file
/// The output folder of a run and the names of the files in it.

#include <string>

#include "base/Communicator.hpp"

namespace stroma::output {

/// A folder that exists and can be written, and the paths of what a run leaves there.
class RunFolder {
 public:
  /// Makes the folder, with its parents, unless it is there already, and tries whether a file can
  /// be made in it. Collective; all ranks agree on the outcome.
  /// \throws InputError on all ranks when the folder cannot be made or written, or is a file
  RunFolder(const base::Communicator& communicator, std::string folder);

  /// Removes what an earlier run left under the names below, spread files of any number of ranks
  /// and pictures included, so that no stale file passes for a result of this run. Files with other
  /// names stay. Collective. Not to be called by a run that continues another one.
  /// \throws InputError on all ranks when a file cannot be removed
  void remove_old_results() const;

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
  base::Communicator communicator_;
  std::string folder_;
};

}  // namespace stroma::output
