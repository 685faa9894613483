// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// history.csv comes back as History wrote it, to the last bit; half a row does not count.

#include <gtest/gtest.h>

#include <cmath>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/HistoryTable.hpp"

namespace stroma {
namespace {

const output::HistoryNames names{{"top", "a \"b\", c"}, {}, {"gel"}};

output::HistoryRow row(std::int64_t step, double load) {
  output::HistoryRow result;
  result.step = step;
  result.load = load;
  result.strain_energy = std::sqrt(2.0) * load;
  result.reactions = {{1e-300, load / 3.0, -0.0}, {1.0, 2.0, 3.0}};
  result.materials = {{1e5, 0.1 * load, 1e300}};
  return result;
}

/// A history of two rows, of which the last has the given load, and what follows it in the file.
output::HistoryTable table_of(double load, const std::string& rest = "") {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  output::History history(world, folder / "history.csv", names);
  history.append(row(0, 0.0));
  history.append(row(1, load));
  if (world.is_root()) std::ofstream(folder / "history.csv", std::ios::app) << rest;
  world.barrier();
  return output::HistoryTable(folder / "history.csv");
}

TEST(HistoryTable, ReadsWhatHistoryWrites) {
  const output::HistoryTable table = table_of(1.0);
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.names(), output::history_columns(names));
  for (const std::size_t step : {0u, 1u}) {
    const auto expected = output::history_values(row(static_cast<int>(step), step));
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(table.column(table.names()[i])[step], expected[i]) << table.names()[i];
  }
  EXPECT_EQ(table.find("nothing"), nullptr);
  EXPECT_THROW(table.column("nothing"), base::RunError);
}

TEST(HistoryTable, KnowsFullLoad) {
  EXPECT_TRUE(table_of(1.0).reached_full_load());
  EXPECT_FALSE(table_of(0.9999).reached_full_load());
  EXPECT_FALSE(output::HistoryTable().reached_full_load());
}

TEST(HistoryTable, CountsWholeRowsOnly) {
  const output::HistoryTable table = table_of(0.5, "2,1,3,20,1e-9,0.25");  // killed while writing
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_FALSE(table.reached_full_load());
}

TEST(HistoryTable, RefusesWhatIsNone) {
  EXPECT_THROW(table_of(0.5, "2,1,3\n"), base::RunError);
  EXPECT_THROW(table_of(0.5, "2,1,0,0,0,0,0,0,0,0,0,0,0,0,0,soft\n"), base::RunError);
  EXPECT_THROW(output::HistoryTable("/nowhere/history.csv"), base::RunError);
}

}  // namespace
}  // namespace stroma
