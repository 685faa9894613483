// SPDX-License-Identifier: BSD-3-Clause

#include "LibraryMessages.hpp"

#include <unistd.h>

#include <iostream>
#include <sstream>
#include <vector>

namespace stroma::test {

LibraryMessages::LibraryMessages() : file_(std::tmpfile()) {
  if (!file_) return;  // no room for it: the messages are seen
  std::cerr.flush();
  std::fflush(stderr);
  standard_error_ = dup(STDERR_FILENO);
  dup2(fileno(file_), STDERR_FILENO);
}

LibraryMessages::~LibraryMessages() {
  if (!file_) return;
  std::cerr.flush();
  std::fflush(stderr);
  dup2(standard_error_, STDERR_FILENO);
  close(standard_error_);
  std::fclose(file_);
}

std::string LibraryMessages::text() const {
  if (!file_) return "";
  std::cerr.flush();
  std::fflush(stderr);
  char raw[1000];
  const ssize_t length = pread(fileno(file_), raw, sizeof raw, 0);
  std::istringstream words(std::string(raw, length > 0 ? static_cast<std::size_t>(length) : 0));
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

}  // namespace stroma::test
