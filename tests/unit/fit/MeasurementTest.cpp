// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// V-FIT-4: Tables of measured forces: units, errors, and what is wrong with them.

#include <gtest/gtest.h>

#include <cmath>

#include "fit/Measurement.hpp"
#include "stroma/base/Error.hpp"
#include "support/TemporaryFolder.hpp"

namespace stroma {
namespace {

MeasurementParameters columns() {
  MeasurementParameters p;
  p.abscissa_column = "strain";
  p.force_column = "force, uN";
  p.force_unit = 1e6;
  return p;
}

std::string mistake_in(const std::string& text, const MeasurementParameters& p) {
  const test::TemporaryFolder folder;
  folder.write("table.csv", text);
  try {
    read_measurement((folder.path() / "table.csv").string(), p);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

/// As a spreadsheet writes it: a byte-order mark, quotes, carriage returns, no line break at the end.
TEST(Measurement, HasUnitsAndErrors) {
  const test::TemporaryFolder folder;
  folder.write("table.csv",
               "\xef\xbb\xbf"
               "strain,\"force, uN\",sd\r\n0.05,2,0.03\r\n\r\n0.1,-4,0.06");
  MeasurementParameters p = columns();
  p.error_column = "sd";
  p.error = 0.04;
  p.relative_error = 0.01;
  const auto table = read_measurement((folder.path() / "table.csv").string(), p);
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0].abscissa, 0.05);
  EXPECT_EQ(table[0].force, 2e6);
  EXPECT_NEAR(table[0].error, 1e6 * std::sqrt(0.03 * 0.03 + 0.04 * 0.04 + 0.02 * 0.02), 1e-6);
  EXPECT_EQ(table[1].force, -4e6);
}

TEST(Measurement, SaysWhatIsWrong) {
  MeasurementParameters p = columns();
  p.relative_error = 0.01;
  EXPECT_NE(mistake_in("strain,force\n0,1\n", p).find("no column \"force, uN\""),
            std::string::npos);
  EXPECT_NE(mistake_in("strain,\"force, uN\"\n0.1,4 uN\n", p).find("line 2"), std::string::npos);
  EXPECT_NE(mistake_in("strain,\"force, uN\"\n0.1,4\n0.2\n", p).find("line 3"), std::string::npos);
  EXPECT_NE(mistake_in("strain,\"force, uN\"\n0,0\n", p).find("has no error"), std::string::npos);
  EXPECT_NE(mistake_in("strain,\"force, uN\"\n", p).find("no rows"), std::string::npos);
  EXPECT_NE(mistake_in("", p).find("cannot read"), std::string::npos);
}

}  // namespace
}  // namespace stroma
