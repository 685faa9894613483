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

/// A file that is written under another name, path.new, and renamed once it is whole, so that there
/// is the old file or the new one at any time; what is no plain file is written in place. For one
/// rank.
class Draft {
 public:
  explicit Draft(std::string path);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  /// Removes what was not finished.
  ~Draft();

  /// \throws base::RunError  when not all of it could be written; the old file is then as it was
  void add(const std::string& text);
  /// \throws base::RunError  when it cannot be renamed
  void finish();

 private:
  std::string path_, draft_;
  bool is_begun_ = false, is_finished_ = false;
};

/// A draft of this one text.
/// \throws base::RunError  when not all of it could be written; the old file is then as it was
void replace_file(const std::string& path, const std::string& text);

}  // namespace stroma::output
