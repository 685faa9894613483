// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Files as they are known again.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma {

struct KnownFile {
  std::string path;  ///< absolute
  std::int64_t bytes = 0;
  std::string sha256;
};

/// Files with their size and SHA-256; one that is named twice is listed once. A folder, of Zarr, has
/// the sizes of its files together, and the SHA-256 of a list of them, sorted by name: for each its
/// SHA-256, two blanks, its name within the folder, and a line break, as sha256sum prints it. Each is read once, by
/// rank 0, which tells the others. Collective.
/// \throws base::RunError on all ranks when a file cannot be read any more
std::vector<KnownFile> known_files(const base::Communicator& communicator,
                                   const std::vector<std::string>& paths);

}  // namespace stroma
