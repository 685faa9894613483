// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// grid.e: the background grid with vectors at its nodes, as an Exodus file.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ExodusFile.hpp"
#include "stroma/output/files/ExodusStep.hpp"
#include "stroma/output/files/GridPart.hpp"

namespace stroma::output {

/// Writes grid.e, or under N > 1 ranks the spread files grid.e.N.r: the active elements as one
/// block `grid` of HEX8, the nodes they use, and at each step the nodal variables NAME_x, NAME_y,
/// NAME_z of each vector. The number maps hold the numbers in the whole grid,
///
///     node = 1 + i + (nx+1) (j + (ny+1) k),   element = 1 + i + nx (j + ny k).
///
/// Boxes of different ranks share nodes but no elements; a spread file holds the communication maps
/// of the shared nodes. Format and flushing as in ParticleFile.
class GridFile {
 public:
  /// Creates the file(s), or continues those that an equal one wrote. Collective.
  /// \param communicator  of the ranks that share the grid
  /// \param path          of the file, without the ending of a spread one
  /// \param part          this rank's
  /// \param vectors       names of those at the nodes
  /// \param provenance    title, version and deck, kept in the file
  /// \param precision     of the numbers in it
  /// \param continued     where this rank's file is to be continued; what comes behind is cut off
  /// \throws RunError on all ranks, naming the file and what could not be written
  GridFile(const base::Communicator& communicator, const std::string& path, const GridPart& part,
           std::vector<std::string> vectors, const Provenance& provenance,
           Precision precision = Precision::Double, const std::optional<FileEnd>& continued = {});

  /// Adds one step. Collective.
  /// \param time     of the step, later than that of the step before
  /// \param vectors  those of the names, in their order; not read where the box is empty
  /// \throws RunError on all ranks, naming the file and what could not be written
  void write(double time, const std::vector<NodalVector>& vectors);

  /// Adds the steps that another number of ranks wrote, of the same grid, to a file that has none.
  /// Collective.
  /// \param path   of those files, without the ending of a spread one
  /// \param ranks  that wrote them
  /// \throws RunError on all ranks, when they cannot be read or this one cannot be written
  void copy_steps(const std::string& path, int ranks);

  /// Steps written so far.
  int steps() const { return static_cast<int>(end_.steps); }
  /// Where this rank's file ends.
  const FileEnd& end() const { return end_; }

 private:
  base::Communicator communicator_;
  std::string path_;  ///< of this rank's own file
  GridPart part_;     ///< but for which elements are active
  std::vector<std::string> vectors_;
  std::vector<std::uint8_t> used_;  ///< (node of the box) 1: an active element has this corner
  std::int64_t used_count_ = 0;
  FileEnd end_;
};

}  // namespace stroma::output
