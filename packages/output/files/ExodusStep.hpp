// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The steps of an Exodus file: added whole, or not at all, and cut off again.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ExodusFile.hpp"

namespace stroma::output {

/// How far a file goes: steps, and the bytes that they take.
struct FileEnd {
  std::int64_t steps = 0;
  std::int64_t bytes = 0;
};

/// One step of a file, being written.
class ExodusStep {
 public:
  enum class At { nodes, elements };

  /// \param path    of the file
  /// \param record  the step's number, from 0
  ExodusStep(const std::string& path, std::int64_t record);
  ExodusStep(const ExodusStep&) = delete;
  ExodusStep& operator=(const ExodusStep&) = delete;
  ~ExodusStep();

  /// All global variables.
  void put_globals(const std::vector<double>& values) const;
  /// Some values of a variable of nodes, or of elements of one block.
  ///
  /// \param at        where the variable lives
  /// \param variable  its number, counted from 1
  /// \param block     the element block's number, from 1; of no meaning for nodes
  /// \param start     first entry of the block, or first node, counted from 1
  /// \param size      how many values
  /// \param values    (entry)
  void put_piece(At at, int variable, std::int64_t block, std::int64_t start, std::int64_t size,
                 const double* values) const;

  void put_time(double time) const;
  /// Closes the file, and reports what only then fails, such as a full disk.
  void close();

 private:
  void put(const std::string& name, std::int64_t start, std::int64_t size,
           const double* values) const;
  void check(int code, const std::string& what) const;

  int id_ = -1;
  std::string path_;
  std::size_t record_;
};

/// Adds a step to the files of all ranks, each to its own. The number of steps in the head of a
/// classic file is the last that is written of it: no reader sees a step that is not whole,
/// whenever a run is killed, and when one rank fails, all files end where they did before.
/// Collective.
///
/// \param communicator  of the ranks
/// \param path          of this rank's file
/// \param end           where it ends; afterwards, where it ends then
/// \param time          of the step
/// \param put           writes the variables; must not communicate
/// \throws base::RunError on all ranks, with the file and what could not be written
void add_step(const base::Communicator& communicator, const std::string& path, FileEnd& end,
              double time, const std::function<void(const ExodusStep&)>& put);

/// How far a file goes. \throws base::RunError when it cannot be read, or is no such file
FileEnd end_of(const std::string& path);

/// Cuts off what follows, and leaves a file that is as it was. Of a netCDF-4 file nothing is cut.
/// \return  whether the file goes as far as that
/// \throws base::RunError when it cannot be changed
bool cut_at(const std::string& path, const FileEnd& end);

}  // namespace stroma::output
