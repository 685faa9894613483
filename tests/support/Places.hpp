// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Where the clone and what was built of it lie. Only one object knows: the others are the same in
/// every clone, and a compiler's cache finds them.

#include <filesystem>

namespace stroma::test {

/// The project's folder, with tests/data in it.
std::filesystem::path clone_folder();

/// The path of the program that was built with the tests.
std::filesystem::path stroma_program();

}  // namespace stroma::test
