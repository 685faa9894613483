// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/WriteFile.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

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

Draft::Draft(std::string path) : path_(std::move(path)), draft_(path_ + ".new") {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto found = fs::symlink_status(path_, ignored);
  if (fs::exists(found) && !fs::is_regular_file(found))  // a device, say, stays what it is
    draft_ = path_;
}

Draft::~Draft() {
  if (is_begun_ && !is_finished_ && draft_ != path_) std::remove(draft_.c_str());
}

void Draft::add(const std::string& text) {
  const char* const mode = is_begun_ ? "a" : "w";
  is_begun_ = true;
  write(path_, draft_, text, mode);
}

void Draft::finish() {
  is_finished_ = true;
  if (draft_ != path_ && std::rename(draft_.c_str(), path_.c_str()) != 0)
    throw base::RunError("cannot write '" + path_ + "': " + std::strerror(errno));
}

void replace_file(const std::string& path, const std::string& text) {
  Draft draft(path);
  draft.add(text);
  draft.finish();
}

}  // namespace stroma::output
