// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Arrays that ranks share, written together and read in any pieces.

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/StateFile.hpp"

namespace stroma {
namespace {

using output::Slab;
using output::StateArray;

/// An array of (rows, 3), whose rows the ranks have by turns of their own length, and one that rank 0
/// has alone.
struct Sample {
  explicit Sample(std::uint64_t of_a_rank) {
    const auto world = base::Communicator::world();
    const auto rank = static_cast<std::uint64_t>(world.rank());
    const std::uint64_t mine = world.size() > 1 && world.rank() == 1 ? 0 : of_a_rank + rank;
    rows = world.sum(mine);
    const std::uint64_t begin = world.sum_before(mine);
    for (std::uint64_t n = 0; n < 3 * mine; ++n)
      values.push_back(1.0 / static_cast<double>(1 + 3 * begin + n));
    text = {'g', 'e', 'l'};
    StateArray array;
    array.name = "group/values";
    array.about = "(row, axis) [um]";
    array.shape = {rows, 3};
    array.mine = {{begin, 0}, {mine, 3}};
    array.values = values.data();
    arrays.push_back(array);
    StateArray word;
    word.name = "word";
    word.type = StateArray::Type::byte;
    word.shape = {3};
    word.mine = {{0}, {world.is_root() ? 3U : 0U}};
    word.values = text.data();
    arrays.push_back(word);
  }

  std::uint64_t rows = 0;
  std::vector<double> values;
  std::vector<std::uint8_t> text;
  std::vector<StateArray> arrays;
};

TEST(StateFile, IsReadInAnyPieces) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const Sample sample(300000);  // several chunks, in several pieces
  output::write_state(world, folder / "state.h5", sample.arrays, 1000000);
  const output::StateReader reader(folder / "state.h5");
  EXPECT_FALSE(reader.has("group/other"));
  EXPECT_FALSE(reader.has("other/values"));
  ASSERT_TRUE(reader.has("group/values"));
  EXPECT_EQ(reader.shape("group/values"), (std::vector<std::uint64_t>{sample.rows, 3}));
  const auto all = reader.get<double>("group/values");
  for (std::size_t n = 0; n < all.size(); ++n)
    ASSERT_EQ(all[n], 1.0 / static_cast<double>(1 + n)) << n;
  const auto piece = reader.get<double>("group/values", {{sample.rows - 2, 1}, {2, 2}});
  EXPECT_EQ(piece[3], all.back());
  EXPECT_EQ(reader.get<std::uint8_t>("word"), (std::vector<std::uint8_t>{'g', 'e', 'l'}));
  EXPECT_THROW(reader.get<double>("word"), base::InputError);                      // its type
  EXPECT_THROW(reader.get<double>("group/values", {{0}, {1}}), base::InputError);  // its axes
  EXPECT_THROW(reader.get<double>("group/values", {{sample.rows, 0}, {1, 3}}), base::InputError);
  EXPECT_THROW(reader.get<double>("nothing"), base::InputError);
}

TEST(StateFile, ReplacesTheOneBeforeWhenItIsWhole) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const std::string path = folder / "state.h5";
  output::write_state(world, path, Sample(10).arrays);
  const std::uint64_t rows = output::StateReader(path).shape("group/values").front();
  output::write_state(world, path, Sample(20).arrays);
  EXPECT_GT(output::StateReader(path).shape("group/values").front(), rows);
  EXPECT_FALSE(std::filesystem::exists(output::draft_of_state(path)));
  EXPECT_THROW(output::write_state(world, folder / "none/state.h5", Sample(10).arrays),
               base::RunError);
}

TEST(StateFile, TellsWhatIsDamaged) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const std::string path = folder / "state.h5";
  output::write_state(world, path, Sample(1000).arrays);
  if (world.is_root()) {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-2000, std::ios::end);
    file.write("damage", 6);
  }
  world.barrier();
  EXPECT_THROW(
      {
        const output::StateReader reader(path);
        reader.get<double>("group/values");
        reader.get<std::uint8_t>("word");
      },
      base::InputError);
  if (world.is_root()) std::ofstream(folder / "text.h5") << "a user's notes";
  world.barrier();
  EXPECT_THROW(output::StateReader(folder / "text.h5"), base::InputError);
  EXPECT_THROW(output::StateReader(folder / "none.h5"), base::InputError);
  EXPECT_THROW(output::StateReader(folder / ""), base::InputError);
}

}  // namespace
}  // namespace stroma
