// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Log.hpp"

#include <cerrno>
#include <cstdarg>
#include <cstring>

#include "stroma/base/Error.hpp"

namespace stroma::base {
namespace {

/// Writes all of it through to the system, unless an error was met before, which it keeps.
void write_through(std::FILE* stream, const std::string& text, int& error) {
  if (error != 0) return;
  errno = 0;
  const bool done =
      std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
  if (!done) error = errno != 0 ? errno : EIO;
}

}  // namespace

void Log::open_file(const std::string& path, bool continued) {
  if (!communicator_.is_root()) return;
  path_ = path;
  file_.reset(std::fopen(path.c_str(), continued ? "a" : "w"));
  if (!file_) throw RunError("cannot write the log file '" + path + "': " + std::strerror(errno));
  write_through(file_.get(), before_file_, file_error_);
  before_file_.clear();
}

void Log::line(const std::string& text) {
  if (!communicator_.is_root()) return;
  progress_line_.hide();
  if (!quiet_) write_through(stdout, text + "\n", output_error_);
  progress_line_.show(progress_text_);
  if (file_) {
    write_through(file_.get(), text + "\n", file_error_);
  } else {
    before_file_ += text + "\n";
  }
}

void Log::progress(const std::string& text) {
  if (!communicator_.is_root() || quiet_) return;
  progress_text_ = text;
  if (text.empty()) progress_line_.hide();
  progress_line_.show(text);
}

void Log::require_written() const {
  collectively(communicator_, [&] {
    if (file_error_ != 0)
      throw RunError("cannot write the log file '" + path_ + "': " + std::strerror(file_error_));
    if (!file_ && output_error_ != 0)
      throw RunError(std::string("cannot write to standard output: ") +
                     std::strerror(output_error_) +
                     (path_.empty() ? "" : "; all of it is in '" + path_ + "'"));
  });
}

void Log::finish() {
  if (std::FILE* file = file_.release(); file != nullptr) {
    errno = 0;
    if (std::fclose(file) != 0 && file_error_ == 0) file_error_ = errno != 0 ? errno : EIO;
    if (output_error_ == EPIPE) output_error_ = 0;
  }
  require_written();
}

std::string format(const char* pattern, ...) {
  va_list arguments;
  va_start(arguments, pattern);
  va_list again;
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, pattern, arguments);
  va_end(arguments);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  return text;
}

}  // namespace stroma::base
