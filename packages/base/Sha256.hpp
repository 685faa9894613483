// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// SHA-256 (FIPS 180-4): 256 bits that tell one content from another.

#include <string>
#include <string_view>

namespace stroma::base {

/// The SHA-256 of some bytes: 64 hexadecimal digits, in lower case.
/// \throws RunError when the library refuses
std::string sha256(std::string_view bytes);

/// The SHA-256 of a file's content, as `sha256sum` prints it; the file is read once, a piece at a time. For one rank.
/// \throws RunError when the file cannot be read, with its path and the reason
std::string sha256_of_file(const std::string& path);

}  // namespace stroma::base
