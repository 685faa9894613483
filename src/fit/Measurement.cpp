// SPDX-License-Identifier: BSD-3-Clause

#include "fit/Measurement.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/deck/Nearest.hpp"
#include "stroma/output/files/HistoryTable.hpp"

namespace stroma {
namespace {

/// A column of a table whose first line names it.
class Column {
 public:
  Column(const std::string& path, const std::vector<std::string>& names, const std::string& name)
      : path_(path), name_(name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw base::InputError("'" + path + "' has no column \"" + name + "\"; " +
                             deck::suggestion(name, names));
    place_ = static_cast<std::size_t>(found - names.begin());
  }

  double in(const std::vector<std::string>& row, int line) const {
    const std::string text = place_ < row.size() ? row[place_] : "";
    const auto number = output::csv_number(text);
    if (number && std::isfinite(*number)) return *number;
    throw base::InputError(base::format("'%s', line %d, column \"%s\": \"%s\" is not a number",
                                        path_.c_str(), line, name_.c_str(), text.c_str()));
  }

 private:
  std::string path_, name_;
  std::size_t place_;
};

}  // namespace

std::vector<MeasuredForce> read_measurement(const std::string& path,
                                            const MeasurementParameters& p) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) throw base::InputError("cannot read '" + path + "'");
  if (line.rfind("\xef\xbb\xbf", 0) == 0) line.erase(0, 3);  // as spreadsheets begin
  const std::vector<std::string> names = output::csv_fields(line);
  const Column abscissa(path, names, p.abscissa_column), force(path, names, p.force_column);
  const Column errors(path, names, p.error_column.value_or(p.force_column));
  std::vector<MeasuredForce> table;
  for (int number = 2; std::getline(file, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::vector<std::string> row = output::csv_fields(line);
    MeasuredForce one{abscissa.in(row, number), force.in(row, number), 0.0};
    one.error = std::abs(p.force_unit) * std::hypot(p.error_column ? errors.in(row, number) : 0.0,
                                                    p.error.value_or(0.0),
                                                    p.relative_error.value_or(0.0) * one.force);
    one.force *= p.force_unit;
    if (!(one.error > 0.0))
      throw base::InputError(base::format(
          "'%s', line %d: the force has no error; admissible: > 0 (give Error besides)",
          path.c_str(), number));
    table.push_back(one);
  }
  if (table.empty()) throw base::InputError("'" + path + "' has no rows");
  return table;
}

}  // namespace stroma
