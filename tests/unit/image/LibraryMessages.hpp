// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Keeps what a library writes to standard error.

#include <cstdio>
#include <string>

namespace stroma::test {

/// While it lives, standard error (C's and C++'s) goes to a temporary file. Not for use beside
/// other threads that write there.
class LibraryMessages {
 public:
  LibraryMessages();
  ~LibraryMessages();
  LibraryMessages(const LibraryMessages&) = delete;
  LibraryMessages& operator=(const LibraryMessages&) = delete;

  /// What has been written so far, in one line.
  std::string text() const;

 private:
  std::FILE* file_ = nullptr;
  int standard_error_ = -1;
};

}  // namespace stroma::test
