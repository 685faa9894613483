// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Small files that are written whole.

#include <string>

namespace stroma::output {

enum class WriteMode { replace, append };

/// Writes a text to a file, and through to the system before it returns. For one rank.
/// \throws base::RunError  when not all of it could be written, as on a full disk
void write_file(const std::string& path, const std::string& text,
                WriteMode mode = WriteMode::replace);

}  // namespace stroma::output
