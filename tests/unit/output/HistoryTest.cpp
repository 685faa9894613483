// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// history.csv to the last digit, row by row, and when it cannot be written.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/History.hpp"

namespace stroma {
namespace {

const output::HistoryNames sample_names{
    {"bottom", "top"}, {"top"}, {"collagen", "lumen"}, false, {"lumen"}};

output::HistoryRow sample_row() {
  output::HistoryRow row;
  row.step = 3;
  row.load = 0.1;
  row.time = 60.0;
  row.newton_iterations = 4;
  row.linear_iterations = 12345;
  row.residual = 1.0 / 3.0 * 1e-9;
  row.wall_seconds = 2.5;
  row.strain_energy = 1e300;
  row.reactions = {{-0.0, 1.0, std::nextafter(2.0, 3.0)}, {4.0, -5.5, 6.0}};
  row.torques = {-3.25e7};
  row.materials = {{7.0, 8.25, std::numeric_limits<double>::denorm_min()}, {1.0, 0.0, 0.0}};
  row.pressures = {-0.1};
  return row;
}

TEST(History, WritesTheColumnsOfTheContractInOrder) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  output::History history(world, folder / "history.csv", sample_names);
  EXPECT_EQ(
      content_of(folder / "history.csv"),
      "step,load,time,newton_iterations,linear_iterations,residual,wall_seconds,strain_energy,"
      "bottom.reaction_x,bottom.reaction_y,bottom.reaction_z,"
      "top.reaction_x,top.reaction_y,top.reaction_z,top.torque,"
      "collagen.volume,collagen.von_mises_mean,collagen.von_mises_max,"
      "lumen.volume,lumen.von_mises_mean,lumen.von_mises_max,lumen.pressure\n");
}

// Each row is in the file as soon as append() has returned, on every rank's eye.
TEST(History, AppendsRowsThatReadBackToTheSameBits) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  output::History history(world, folder / "history.csv", sample_names);
  const output::HistoryRow row = sample_row();
  for (int n = 1; n <= 2; ++n) {
    history.append(row);
    std::istringstream text(content_of(folder / "history.csv"));
    world.barrier();  // nobody appends before all have read
    std::string line;
    std::getline(text, line);
    for (int i = 0; i < n; ++i) EXPECT_TRUE(std::getline(text, line));
    EXPECT_EQ(line.substr(0, 33), "3,0.10000000000000001,60,4,12345,");
    std::istringstream cells(line);
    const std::vector<double> expected = output::history_values(row);
    std::size_t column = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++column) {
      ASSERT_LT(column, expected.size());
      EXPECT_EQ(std::strtod(cell.c_str(), nullptr), expected[column]) << "column " << column;
    }
    EXPECT_EQ(column, output::history_columns(sample_names).size());
    EXPECT_FALSE(std::getline(text, line));
  }
}

TEST(History, QuotesNamesThatWouldBreakARow) {
  const TemporaryFolder folder;
  output::History history(base::Communicator::world(), folder / "h.csv",
                          {{}, {}, {"gel, \"soft\""}});
  EXPECT_NE(content_of(folder / "h.csv").find(",\"gel, \"\"soft\"\".volume\","), std::string::npos);
}

TEST(History, FullDiskIsARunErrorOnEveryRank) {
  const auto world = base::Communicator::world();
  const std::string message =
      message_of<base::RunError>([&] { output::History(world, "/dev/full", sample_names); });
  EXPECT_EQ(message, "cannot write '/dev/full': No space left on device");
  const TemporaryFolder folder;
  const std::string path = folder / "missing/history.csv";
  EXPECT_EQ(message_of<base::RunError>([&] { output::History(world, path, sample_names); }),
            "cannot write '" + path + "': No such file or directory");
}

TEST(History, RefusesARowThatDoesNotFitTheHeader) {
  const TemporaryFolder folder;
  for (const output::HistoryNames& names :
       {output::HistoryNames{{"bottom"}, {"top"}, {"collagen", "lumen"}, false, {"lumen"}},
        output::HistoryNames{{"bottom", "top"}, {}, {"collagen", "lumen"}, false, {"lumen"}},
        output::HistoryNames{{"bottom", "top"}, {"top"}, {"lumen"}, false, {"lumen"}},
        output::HistoryNames{{"bottom", "top"}, {"top"}, {"collagen", "lumen"}}}) {
    output::History history(base::Communicator::world(), folder / "h.csv", names);
    EXPECT_THROW(history.append(sample_row()), base::RunError);
  }
}

}  // namespace
}  // namespace stroma
