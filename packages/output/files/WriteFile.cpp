// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/WriteFile.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "stroma/base/Error.hpp"

namespace stroma::output {

void write_file(const std::string& path, const std::string& text, WriteMode mode) {
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), mode == WriteMode::replace ? "w" : "a");
  bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                 std::fflush(file) == 0;
  int reason = errno;
  // Closing is the last chance of a full disk to say so.
  if (file != nullptr && std::fclose(file) != 0 && written) {
    written = false;
    reason = errno;
  }
  if (!written) throw base::RunError("cannot write '" + path + "': " + std::strerror(reason));
}

void replace_file(const std::string& path, const std::string& text) {
  const std::string draft = path + ".new";
  try {
    write_file(draft, text);
  } catch (const base::RunError&) {
    std::remove(draft.c_str());
    throw;
  }
  if (std::rename(draft.c_str(), path.c_str()) != 0)
    throw base::RunError("cannot write '" + path + "': " + std::strerror(errno));
}

}  // namespace stroma::output
