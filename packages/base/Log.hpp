#pragma once

/// \file
/// What the program tells its user while it works: to standard output and to log.txt, from one
/// rank.

#include <fstream>
#include <string>

#include "base/Communicator.hpp"

namespace stroma::base {

/// Prints lines on rank 0 and silently does nothing on the others, so that callers need no rank
/// tests.
class Log {
 public:
  /// \param quiet  nothing on standard output (the file is written all the same)
  explicit Log(const Communicator& communicator, bool quiet = false)
      : is_root_(communicator.is_root()), quiet_(quiet) {}

  /// From now on every line goes to this file too. Lines printed before are written first.
  /// \throws RunError when the file cannot be opened
  void open_file(const std::string& path);

  /// Prints one line (or several, separated by \n); a line break is added.
  void line(const std::string& text);

  /// A line that the user should not overlook: prefixed "note: ".
  void note(const std::string& text) { line("note: " + text); }

 private:
  bool is_root_;
  bool quiet_;
  std::string before_file_;
  std::ofstream file_;
};

/// printf into a std::string.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

}  // namespace stroma::base
