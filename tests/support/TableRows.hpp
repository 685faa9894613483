// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Tables of texts and numbers.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "stroma/output/files/HistoryTable.hpp"
#include "support/TemporaryFolder.hpp"

namespace stroma::test {

/// The rows of a table, by the names of its columns.
inline std::vector<std::map<std::string, std::string>> rows_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::map<std::string, std::string>> rows;
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> fields = output::csv_fields(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t n = 0; n < fields.size() && n < names.size(); ++n)
      rows.back()[names[n]] = fields[n];
  }
  return rows;
}

}  // namespace stroma::test
