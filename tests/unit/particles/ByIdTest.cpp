// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Rows that any rank has read come to the particles of their ids.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "stroma/particles/ById.hpp"

namespace stroma {
namespace {

/// Ids that are far from dense, by a rule that both sides follow: the n-th of all.
std::int64_t id_of(std::int64_t n) { return 7 * n * n + 3; }

TEST(ById, RowsComeToTheirParticles) {
  const auto world = base::Communicator::world();
  constexpr std::int64_t count = 500;
  std::vector<std::int64_t> own, read;
  std::vector<double> rows;
  for (std::int64_t n = 0; n < count; ++n) {
    if ((n * n) % world.size() == world.rank()) own.insert(own.begin(), id_of(n));
    if (n / 5 % world.size() == world.size() - 1 - world.rank()) {
      read.push_back(id_of(n));
      rows.push_back(static_cast<double>(id_of(n)));
      rows.push_back(0.5 * static_cast<double>(id_of(n)));
    }
  }
  const particles::ById by_id(world, own, read);
  const std::vector<double> values = by_id(rows, 2);
  ASSERT_EQ(values.size(), 2 * own.size());
  for (std::size_t p = 0; p < own.size(); ++p) {
    EXPECT_EQ(values[2 * p], static_cast<double>(own[p]));
    EXPECT_EQ(values[2 * p + 1], 0.5 * static_cast<double>(own[p]));
  }
}

TEST(ById, OtherParticlesAreRefusedOnEveryRank) {
  const auto world = base::Communicator::world();
  const auto on_root = [&](std::vector<std::int64_t> ids) {
    return world.is_root() ? ids : std::vector<std::int64_t>();
  };
  const auto match = [&](const std::vector<std::int64_t>& own,
                         const std::vector<std::int64_t>& read) {
    particles::ById(world, on_root(own), on_root(read));
  };
  EXPECT_NO_THROW(match({1, 2, 3}, {3, 1, 2}));
  EXPECT_THROW(match({1, 2, 3}, {3, 1, 4}), base::InputError);
  EXPECT_THROW(match({1, 2, 3}, {3, 1}), base::InputError);
  EXPECT_THROW(match({1, 2, 3}, {3, 1, 1}), base::InputError);
  EXPECT_THROW(match({1, 2, 3}, {3, 1, -2}), base::InputError);
}

}  // namespace
}  // namespace stroma
