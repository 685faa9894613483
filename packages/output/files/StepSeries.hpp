// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Files that are written one a step, and the list by which ParaView has them for one with times.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::output {

/// The files NAME-s0003.hdf of a folder, one for each step that was written, and NAME.hdf.series, a
/// list in JSON of those that are whole with their times, which is what ParaView is to open. A file
/// comes into the list when it is there, so that the list is good whenever a run is killed. Member
/// functions but path() are collective.
class StepSeries {
 public:
  using Step = std::pair<std::int64_t, double>;  ///< number, time [s]

  StepSeries(const base::Communicator& communicator, std::string folder, std::string name);

  /// The files that a list names, with their times. For one rank.
  /// \param path  of the list
  /// \throws base::RunError when it cannot be read, or is none
  static std::vector<std::pair<std::string, double>> listed(const std::string& path);

  /// Goes on with the files of an earlier run: of the steps given, those that have one; files of
  /// other steps are removed.
  /// \throws base::RunError
  void resume(const std::vector<Step>& steps);

  /// Of the file of a step.
  std::string path(std::int64_t step) const;
  /// The file of a step is there.
  /// \throws base::RunError when the list cannot be written
  void add(const Step& step);

 private:
  void write() const;

  base::Communicator communicator_;
  std::string folder_, name_;
  std::vector<Step> steps_;
};

}  // namespace stroma::output
