// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One line at the bottom of a terminal that says how far the program is.

#include <string>

namespace stroma::base {

/// A line on standard output that is renewed in its place, and makes way for what is printed.
///
/// It is there only where someone can see it: where standard output is the terminal from which the
/// process was started, and the process is not in the background. TERM=dumb has none. Pipes, files,
/// and the terminals that mpirun puts between itself and its ranks get nothing. It needs a carriage
/// return and the sequence that clears a line (ESC [ K), and has no colours.
class ProgressLine {
 public:
  ProgressLine() = default;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { hide(); }

  /// Whether show() would be seen, now.
  static bool is_possible();

  /// \param text  one line of ASCII, cut at the terminal's width; nothing is shown of an empty one
  void show(const std::string& text);
  /// Takes it away: the next to print begins at the first column of an empty line.
  void hide();

 private:
  bool is_shown_ = false;
};

}  // namespace stroma::base
