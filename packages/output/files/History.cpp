// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/History.hpp"

#include <type_traits>
#include <utility>

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
  if (row.motion) {
    use(row.motion->kinetic_energy);
    use(row.motion->external_work);
    use(row.motion->damping_work);
    use(row.motion->external_power);
    use(row.motion->damping_power);
  }
  for (auto& reaction : row.reactions) {
    for (auto& component : reaction) use(component);
  }
  for (auto& torque : row.torques) use(torque);
  for (auto& material : row.materials) {
    use(material.volume);
    use(material.von_mises_mean);
    use(material.von_mises_max);
  }
  for (auto& pressure : row.pressures) use(pressure);
}

}  // namespace

std::vector<std::string> history_columns(const HistoryNames& names) {
  std::vector<std::string> columns = {
      "step",     "load",         "time",         "newton_iterations", "linear_iterations",
      "residual", "wall_seconds", "strain_energy"};
  if (names.has_inertia)
    columns.insert(columns.end(), {"kinetic_energy", "external_work", "damping_work",
                                   "external_power", "damping_power"});
  for (const std::string& name : names.conditions) {
    for (const char* component : {"x", "y", "z"})
      columns.push_back(name + ".reaction_" + component);
  }
  for (const std::string& name : names.turning) columns.push_back(name + ".torque");
  for (const std::string& name : names.materials) {
    for (const char* figure : {"volume", "von_mises_mean", "von_mises_max"}) {
      columns.push_back(name + "." + figure);
    }
  }
  for (const std::string& name : names.pressing) columns.push_back(name + ".pressure");
  return columns;
}

std::vector<double> history_values(const HistoryRow& row) {
  std::vector<double> values;
  for_each_value(row, [&](auto value) { values.push_back(static_cast<double>(value)); });
  return values;
}

HistoryRow history_row(const std::vector<double>& values, const HistoryNames& names) {
  HistoryRow row;
  if (names.has_inertia) row.motion = HistoryRow::Motion();
  row.reactions.resize(names.conditions.size());
  row.torques.resize(names.turning.size());
  row.materials.resize(names.materials.size());
  row.pressures.resize(names.pressing.size());
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

History::History(const base::Communicator& communicator, std::string path, HistoryNames names,
                 const std::vector<HistoryRow>& rows)
    : communicator_(communicator), path_(std::move(path)), names_(std::move(names)) {
  std::string header;
  for (const std::string& column : history_columns(names_)) {
    header += (header.empty() ? "" : ",") + csv_field(column);
  }
  std::string text = header + "\n";
  for (const HistoryRow& row : rows) text += line_of(row);
  base::collectively(communicator_, [&] {
    if (communicator_.is_root()) replace_file(path_, text);
  });
}

void History::append(const HistoryRow& row) {
  if (row.reactions.size() != names_.conditions.size() ||
      row.torques.size() != names_.turning.size() ||
      row.materials.size() != names_.materials.size() ||
      row.pressures.size() != names_.pressing.size()) {
    throw base::RunError(base::format(
        "a row for '%s' has %zu reactions, %zu torques, %zu materials and %zu pressures; its "
        "header has %zu, %zu, %zu and %zu",
        path_.c_str(), row.reactions.size(), row.torques.size(), row.materials.size(),
        row.pressures.size(), names_.conditions.size(), names_.turning.size(),
        names_.materials.size(), names_.pressing.size()));
  }
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    // Opened for each row and closed again, so that a reader finds whole lines at any time.
    write_file(path_, line_of(row), WriteMode::append);
  });
}

}  // namespace stroma::output
