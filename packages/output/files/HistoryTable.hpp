// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A run's history.csv, read back.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stroma::output {

/// Quotes a field of a CSV file where it has to be: a comma, a quote or a line break (RFC 4180).
std::string csv_field(const std::string& text);
/// A number in a CSV file, with all its digits.
std::string csv_number(double value);
/// The fields of a line of a CSV file, their quotes taken off.
std::vector<std::string> csv_fields(const std::string& line);
/// The number that a field holds and nothing else, or nothing.
std::optional<double> csv_number(const std::string& field);

/// The columns of a history.csv by name. Row s is the accepted step s; the last one may be missing
/// its end if the run was killed: only whole rows count.
class HistoryTable {
 public:
  HistoryTable() = default;
  /// \throws base::RunError  it cannot be read, or is no table of numbers
  explicit HistoryTable(const std::string& path);

  std::size_t rows() const { return rows_; }
  /// Names in the order of the file.
  const std::vector<std::string>& names() const { return names_; }
  /// A column, or null.
  const std::vector<double>* find(const std::string& name) const;
  /// \throws base::RunError  no such column
  const std::vector<double>& column(const std::string& name) const;
  /// Whether the run came to full load.
  bool reached_full_load() const;

 private:
  std::string path_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace stroma::output
