// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/HistoryTable.hpp"

#include <charconv>
#include <fstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {
std::vector<std::string> csv_fields(const std::string& line) {
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

std::optional<double> csv_number(const std::string& field) {
  double number = 0.0;
  const auto [end, failure] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (failure != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return number;
}

std::string csv_number(double value) { return base::format("%.17g", value); }

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
  names_ = csv_fields(line);
  while (std::getline(file, line) && !file.eof()) {  // a line without its end was being written
    const std::vector<std::string> fields = csv_fields(line);
    std::vector<double> numbers;
    for (const std::string& field : fields)
      if (const auto number = csv_number(field)) numbers.push_back(*number);
    const bool is_row = fields.size() == names_.size() && numbers.size() == fields.size();
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
