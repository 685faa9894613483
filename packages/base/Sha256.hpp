// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// SHA-256 (FIPS 180-4): 256 bits that tell one content from another.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stroma::base {

/// The SHA-256 of some bytes: 64 hexadecimal digits, in lower case.
/// \throws RunError when the library refuses
std::string sha256(std::string_view bytes);

/// The SHA-256 of a file's content, as `sha256sum` prints it; the file is read once, a piece at a time. For one rank.
/// \throws RunError when the file cannot be read, with its path and the reason
std::string sha256_of_file(const std::string& path);

/// The SHA-256 of pieces of a file that is too large to be read whole, spread evenly from its first
/// bytes to its last.
/// \param path    of the file
/// \param size    its bytes, at least `length`
/// \param pieces  how many, at least 2
/// \param length  bytes of each
/// \throws RunError when the file cannot be read, with its path and the reason
std::string sha256_of_samples(const std::string& path, std::uintmax_t size, int pieces,
                              std::size_t length);

/// The SHA-256 of what `sha256sum` prints of files of a folder when it is called there: of each its
/// SHA-256, two blanks, its name and a line break. For one rank.
/// \param folder  its path
/// \param files   their names, relative to the folder, in the order of the list
/// \throws RunError when a file cannot be read, with its path and the reason
std::string sha256_of_files(const std::string& folder, const std::vector<std::string>& files);

}  // namespace stroma::base
