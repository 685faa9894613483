// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/WriteFile.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "stroma/base/Error.hpp"

namespace stroma::output {

namespace {

/// \param name  for the message
void write(const std::string& name, const std::string& path, const std::string& text,
           const char* mode) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), mode);
  bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                 std::fflush(file) == 0;
  int reason = errno;
  // Closing is the last chance of a full disk to say so.
  if (file != nullptr && std::fclose(file) != 0 && written) {
    written = false;
    reason = errno;
  }
  if (!written) throw base::RunError("cannot write '" + name + "': " + std::strerror(reason));
}

}  // namespace

void write_file(const std::string& path, const std::string& text, WriteMode mode) {
  write(path, path, text, mode == WriteMode::replace ? "w" : "a");
}

void replace_file(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto found = fs::symlink_status(path, ignored);
  if (fs::exists(found) && !fs::is_regular_file(found)) {  // a device, say, stays what it is
    write_file(path, text);
    return;
  }
  const std::string draft = path + ".new";
  try {
    write(path, draft, text, "w");
  } catch (const base::RunError&) {
    std::remove(draft.c_str());
    throw;
  }
  if (std::rename(draft.c_str(), path.c_str()) != 0)
    throw base::RunError("cannot write '" + path + "': " + std::strerror(errno));
}

}  // namespace stroma::output
