// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/HistoryTable.hpp"

#include <charconv>
#include <fstream>

#include "stroma/base/Error.hpp"

namespace stroma::output {
namespace {

/// The fields of a line, quotes taken off.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && in_quotes && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += '"';
      ++i;
    } else if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && !in_quotes) {
      fields.emplace_back();
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

bool read_number(const std::string& text, double& number) {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  return failure == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += (c == '"') ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

HistoryTable::HistoryTable(const std::string& path) : path_(path) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) throw base::RunError("cannot read '" + path + "'");
  names_ = fields_of(line);
  while (std::getline(file, line) && !file.eof()) {  // a line without its end was being written
    const std::vector<std::string> fields = fields_of(line);
    std::vector<double> numbers(fields.size());
    bool is_row = fields.size() == names_.size();
    for (std::size_t i = 0; is_row && i < fields.size(); ++i)
      is_row = read_number(fields[i], numbers[i]);
    if (!is_row)
      throw base::RunError("'" + path + "', row " + std::to_string(rows_) +
                           ": not a row of numbers under its header");
    for (std::size_t i = 0; i < numbers.size(); ++i) columns_[names_[i]].push_back(numbers[i]);
    ++rows_;
  }
}

const std::vector<double>* HistoryTable::find(const std::string& name) const {
  const auto found = columns_.find(name);
  return found == columns_.end() ? nullptr : &found->second;
}

const std::vector<double>& HistoryTable::column(const std::string& name) const {
  const std::vector<double>* found = find(name);
  if (found == nullptr) throw base::RunError("'" + path_ + "' has no column " + name);
  return *found;
}

bool HistoryTable::reached_full_load() const {
  const std::vector<double>* load = find("load");
  return load != nullptr && !load->empty() && load->back() >= 1.0;
}

}  // namespace stroma::output
