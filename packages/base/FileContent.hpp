// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The content of a file.

#include <fstream>
#include <iterator>
#include <string>

namespace stroma::base {

/// All bytes of a file; none if it cannot be read.
inline std::string file_content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace stroma::base
