// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/History.hpp"

#include <type_traits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma::output {
namespace {

std::string digits(std::int64_t value) { return std::to_string(value); }
std::string digits(double value) { return csv_number(value); }

/// Calls use(value) with the entries of a row in the order of the columns, counts as integers.
template <class Row, class Use>
void for_each_value(Row& row, const Use& use) {
  use(row.step);
  use(row.load);
  use(row.time);
  use(row.newton_iterations);
  use(row.linear_iterations);
  use(row.residual);
  use(row.wall_seconds);
  use(row.strain_energy);
  for (auto& reaction : row.reactions) {
    for (auto& component : reaction) use(component);
  }
  for (auto& material : row.materials) {
    use(material.volume);
    use(material.von_mises_mean);
    use(material.von_mises_max);
  }
}

}  // namespace

std::vector<std::string> history_columns(const std::vector<std::string>& boundary_conditions,
                                         const std::vector<std::string>& materials) {
  std::vector<std::string> columns = {
      "step",     "load",         "time",         "newton_iterations", "linear_iterations",
      "residual", "wall_seconds", "strain_energy"};
  for (const std::string& name : boundary_conditions) {
    for (const char* component : {"x", "y", "z"})
      columns.push_back(name + ".reaction_" + component);
  }
  for (const std::string& name : materials) {
    for (const char* figure : {"volume", "von_mises_mean", "von_mises_max"}) {
      columns.push_back(name + "." + figure);
    }
  }
  return columns;
}

std::vector<double> history_values(const HistoryRow& row) {
  std::vector<double> values;
  for_each_value(row, [&](auto value) { values.push_back(static_cast<double>(value)); });
  return values;
}

HistoryRow history_row(const std::vector<double>& values, std::size_t boundary_conditions,
                       std::size_t materials) {
  HistoryRow row;
  row.reactions.resize(boundary_conditions);
  row.materials.resize(materials);
  std::size_t next = 0;
  for_each_value(row, [&](auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(values.at(next++));
  });
  return row;
}

namespace {

std::string line_of(const HistoryRow& row) {
  std::string line;
  for_each_value(row, [&](auto value) { line += (line.empty() ? "" : ",") + digits(value); });
  return line + "\n";
}

}  // namespace

History::History(const base::Communicator& communicator, std::string path,
                 const std::vector<std::string>& boundary_conditions,
                 const std::vector<std::string>& materials, const std::vector<HistoryRow>& rows)
    : communicator_(communicator),
      path_(std::move(path)),
      boundary_conditions_(boundary_conditions.size()),
      materials_(materials.size()) {
  std::string header;
  for (const std::string& column : history_columns(boundary_conditions, materials)) {
    header += (header.empty() ? "" : ",") + csv_field(column);
  }
  std::string text = header + "\n";
  for (const HistoryRow& row : rows) text += line_of(row);
  base::collectively(communicator_, [&] {
    if (communicator_.is_root()) replace_file(path_, text);
  });
}

void History::append(const HistoryRow& row) {
  if (row.reactions.size() != boundary_conditions_ || row.materials.size() != materials_) {
    throw base::RunError(base::format(
        "a row for '%s' has %zu reactions and %zu materials; its header has %zu and %zu",
        path_.c_str(), row.reactions.size(), row.materials.size(), boundary_conditions_,
        materials_));
  }
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    // Opened for each row and closed again, so that a reader finds whole lines at any time.
    write_file(path_, line_of(row), WriteMode::append);
  });
}

}  // namespace stroma::output
