// SPDX-License-Identifier: BSD-3-Clause

#include "support/Places.hpp"

namespace stroma::test {

std::filesystem::path clone_folder() { return STROMA_SOURCE_DIR; }
std::filesystem::path stroma_program() { return STROMA_EXECUTABLE; }

}  // namespace stroma::test
