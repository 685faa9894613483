// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the program tells its user while it works: to standard output and to log.txt, from one
/// rank.

#include <cstdio>
#include <memory>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/base/ProgressLine.hpp"

namespace stroma::base {

/// Prints lines on rank 0 and silently does nothing on the others, so that callers need no rank
/// tests. A line that cannot be written is remembered, for require_written() to answer.
class Log {
 public:
  /// \param communicator  its rank 0 writes
  /// \param quiet         nothing on standard output (the file is written all the same)
  explicit Log(const Communicator& communicator, bool quiet = false)
      : communicator_(communicator), quiet_(quiet) {}

  /// From now on every line goes to this file too. Lines printed before are written first.
  /// \param path       of the file
  /// \param continued  whether to write behind what is there
  /// \throws RunError when the file cannot be opened
  void open_file(const std::string& path, bool continued = false);

  /// Prints one line (or several, separated by \n); a line break is added.
  void line(const std::string& text);

  /// A line that the user should not overlook: prefixed "note: ".
  void note(const std::string& text) { line("note: " + text); }

  /// Renews the line at the bottom of the terminal, where there is one (ProgressLine); lines are
  /// printed above it. It is in no file.
  /// \param text  of the line; empty: it goes
  void progress(const std::string& text);
  /// Whether that can be seen.
  bool shows_progress() const {
    return communicator_.is_root() && !quiet_ && ProgressLine::is_possible();
  }

  /// Collective. \throws RunError on all ranks when a line did not reach the file, or, where there
  /// is no file, standard output
  void require_written() const;

  /// The same at the end of a command, after which nothing is printed. Standard output counts here
  /// even where there is a file, but for a pipe whose reader has left: the file has it all.
  /// Collective. \throws RunError on all ranks
  void finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  Communicator communicator_;
  bool quiet_;
  ProgressLine progress_line_;
  std::string progress_text_;
  std::string before_file_;
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  int file_error_ = 0, output_error_ = 0;  ///< errno of the first line that failed; 0: none
};

/// printf into a std::string.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

}  // namespace stroma::base
