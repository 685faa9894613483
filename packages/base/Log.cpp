#include "base/Log.hpp"

#include <cstdarg>
#include <cstdio>
#include <iostream>

#include "base/Error.hpp"

namespace stroma::base {

void Log::open_file(const std::string& path) {
  if (!is_root_) return;
  file_.open(path);
  if (!file_) throw RunError("cannot write the log file '" + path + "'");
  file_ << before_file_ << std::flush;
  before_file_.clear();
}

void Log::line(const std::string& text) {
  if (!is_root_) return;
  if (!quiet_) std::cout << text << std::endl;
  if (file_.is_open()) {
    file_ << text << std::endl;
  } else {
    before_file_ += text + "\n";
  }
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
