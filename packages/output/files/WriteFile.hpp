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

/// Writes a text under another name and renames it, so that the file holds the old text or the new
/// one at any time; what is no plain file is written in place. For one rank.
/// \throws base::RunError  when not all of it could be written; the old file is then as it was
void replace_file(const std::string& path, const std::string& text);

}  // namespace stroma::output
