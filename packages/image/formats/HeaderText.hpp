// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The pieces of a text header, taken strictly: a number is a whole word, and a field stands once.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stroma::image {

std::string trimmed(const std::string& text);
/// Words between blanks.
std::vector<std::string> words(const std::string& text);
std::string lower_case(std::string text);
/// At most 100 characters of it, fit for a message.
std::string printable(const std::string& text);

/// The whole word as a number, in whatever locale; nothing if it is none, or too large.
std::optional<std::int64_t> to_integer(const std::string& word);
/// May be nan or inf.
std::optional<double> to_real(const std::string& word);

/// The next line of a text, from `at` on, without its end; moves `at` behind it. False at the end.
bool next_line(const std::string& text, std::size_t& at, std::string& line);

/// The fields of a header, by name.
class HeaderFields {
 public:
  /// \param path, format  for the messages
  HeaderFields(std::string path, std::string format)
      : path_(std::move(path)), format_(std::move(format)) {}

  /// \throws base::InputError when the field is there already
  void add(const std::string& name, const std::string& value);

  bool has(const std::string& name) const { return fields_.count(name) > 0; }
  /// Its text; empty if the field is not there.
  std::string text(const std::string& name) const;
  /// \throws base::InputError when the field is not there
  std::string required(const std::string& name) const;

  /// \throws base::InputError unless the value is one whole number within the limits
  std::int64_t integer(const std::string& name, std::int64_t lowest, std::int64_t highest) const;
  /// Whole numbers, at least 1 each.
  /// \throws base::InputError unless there are `count` of them
  std::vector<std::int64_t> sizes(const std::string& name, std::size_t count) const;
  /// Numbers. \throws base::InputError unless there are `count` of them
  std::vector<double> reals(const std::string& name, std::size_t count) const;
  /// True or False, or 1 or 0. \throws base::InputError
  bool truth(const std::string& name, bool if_absent) const;

  /// \throws base::InputError  "PATH: its FORMAT header says NAME "VALUE"; admissible: ..."
  [[noreturn]] void refuse_field(const std::string& name, const std::string& admissible) const;

 private:
  std::string path_, format_;
  std::map<std::string, std::string> fields_;
};

/// More files than any volume has planes. A header that names more is not believed.
inline constexpr std::int64_t most_files = 100000;

/// The names that a pattern such as "slice%03d.raw" gives for `count` numbers.
/// \throws base::InputError unless the pattern holds one %d (with a width, if any) and nothing else
/// of printf's, and there are 1 to most_files of them
std::vector<std::string> numbered_files(const std::string& path, const std::string& pattern,
                                        std::int64_t first, std::int64_t step, std::int64_t count);

/// A file that a header names, which is relative to the header's folder.
std::string beside(const std::string& header, const std::string& name);

}  // namespace stroma::image
