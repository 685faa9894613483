// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/ProgressLine.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace stroma::base {
namespace {

std::size_t columns() {
  winsize size{};
  const bool is_known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : 80;
}

/// To a terminal that cannot be written, nothing is to be said.
void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

}  // namespace

bool ProgressLine::is_possible() {
  const char* terminal = std::getenv("TERM");
  return terminal != nullptr && std::string(terminal) != "dumb" &&
         tcgetpgrp(STDOUT_FILENO) == getpgrp();
}

void ProgressLine::show(const std::string& text) {
  if (text.empty() || !is_possible()) return;
  // The last column stays free: a cursor behind it would be in the next line.
  print("\r" + text.substr(0, columns() - 1) + "\033[K");
  is_shown_ = true;
}

void ProgressLine::hide() {
  if (!is_shown_) return;
  print("\r\033[K");
  is_shown_ = false;
}

}  // namespace stroma::base
