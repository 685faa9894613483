// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Exodus files that another number of ranks wrote, read by the numbers of their nodes and elements.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "stroma/output/files/ExodusStep.hpp"

namespace stroma::output {

/// The values that some nodes or elements have in a set of spread files. For one rank; it opens only
/// those files that hold any of them.
class SpreadFiles {
 public:
  /// \param path   of the files, without the ending of a spread one
  /// \param ranks  that wrote them
  /// \param at     nodes or elements
  /// \param ids    their numbers in the whole, from 1, in any order
  /// \throws base::RunError when a file cannot be read, or they do not hold all of these
  SpreadFiles(const std::string& path, int ranks, ExodusStep::At at,
              const std::vector<std::int64_t>& ids);

  /// (step) of all that they hold.
  const std::vector<double>& times() const { return times_; }
  /// Of a step, from 1.
  std::vector<double> globals(std::int64_t step) const;
  /// (id) of a variable, counted from 1, at a step.
  std::vector<double> values(std::int64_t step, int variable) const;

 private:
  struct Entry {
    std::size_t in_file, wanted;
  };
  struct File {
    std::string path;
    std::shared_ptr<const int> id;    ///< of netCDF; closed with the last copy
    std::vector<std::size_t> blocks;  ///< elements of each
    std::vector<Entry> entries;
  };

  static std::vector<double> read(const File& file, const std::string& name, std::int64_t step,
                                  std::size_t count);

  ExodusStep::At at_;
  std::size_t wanted_;
  std::vector<File> files_;
  std::vector<double> times_;
};

}  // namespace stroma::output
