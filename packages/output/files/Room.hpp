// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Whether a disk has room for a file that all ranks will write.

#include <cstdint>
#include <string>

namespace stroma::output {

/// Makes sure, on one rank, that the disk takes a file of this size: what fails here fails cleanly,
/// before others depend on it. There is no file of that name afterwards.
/// \throws base::RunError with the reason
void require_room(const std::string& path, std::uint64_t bytes);

}  // namespace stroma::output
