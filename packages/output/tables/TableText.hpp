// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Rows of tables.

#include <string>
#include <vector>

#include "stroma/output/files/HistoryTable.hpp"

namespace stroma::output {

/// ",1,2,3": what stands behind the first fields of a row.
inline std::string csv_numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += "," + csv_number(value);
  return text;
}

}  // namespace stroma::output
