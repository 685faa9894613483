// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Particles that move across the grid and between ranks. Run on 1, 2 and 4 ranks. Claim V-PAR-3,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/particles/Exchange.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/particles/Migration.hpp"
#include "stroma/particles/Seeding.hpp"
#include "support/World.hpp"

namespace stroma::particles {
namespace {

grid::Grid body() {
  grid::Grid grid;
  grid.elements = {5, 4, 6};
  grid.spacing = {2.0, 1.5, 1.0};
  grid.origin = {-3.0, 7.0, 0.5};
  return grid;
}

Particles<grid::Device> seeded() {
  const grid::Grid grid = body();
  voxels::LabelVolume labels(world(), {10, 8, 12}, {1.0, 0.75, 0.5});
  const auto partition =
      grid::Partition::balanced(grid, world().size(), layer_weights(world(), grid, labels));
  auto particles = seed(world(), {Layout::per_element, 1, 2}, partition, labels, {{0, 0}});
  make_movable(world(), particles);
  return particles;
}

/// A displacement that differs from particle to particle and carries some of them far.
double way(std::int64_t id, int d) {
  return 4.0 * std::sin(0.7 * static_cast<double>(id) + d) + 0.1 * d;
}

Particles<grid::Device> scattered() {
  auto particles = seeded();
  for (int p = 0; p < particles.count(); ++p)
    for (int d = 0; d < 3; ++d) {
      particles.position(p, d) += way(particles.id(p), d);
      particles.base_displacement(p, d) = way(particles.id(p), d);
      particles.base_gradient(p, d, 1) = static_cast<double>(particles.id(p)) + d;
    }
  begin_history(particles, 2);
  allocate(particles.own_numbers, "own_numbers", static_cast<std::size_t>(particles.count()), 2);
  for (int p = 0; p < particles.count(); ++p) {
    particles.own_numbers(p, 1) = 0.5 * static_cast<double>(particles.id(p));
    particles.history(p, 1) = -static_cast<double>(particles.id(p));
  }
  return particles;
}

grid::Partition partition_for(const Particles<grid::Device>& particles) {
  return balanced_partition(world(), covering_grid(extent_of(world(), particles), body()),
                            particles);
}

// Whoever sends them, they arrive whole, once, at the owner of their element, sorted by element and
// id.
TEST(Migration, EveryParticleArrivesWholeAtTheOwnerOfItsElement) {
  const auto before = scattered();
  const auto partition = partition_for(before);
  const grid::Grid& grid = partition.grid();
  const grid::Box box = partition.elements(world().rank());
  const auto after = migrate(world(), partition, before);
  EXPECT_EQ(world().sum(after.count()), world().sum(before.count()));
  ASSERT_EQ(after.element_begin.extent(0), static_cast<std::size_t>(box.count() + 1));

  const auto original = seeded();  // the same on every run: tells volume, home and place by id
  std::int64_t ids = 0, squares = 0;
  for (std::int64_t e = 0; e < box.count(); ++e) {
    const grid::Index3 element = box.index(e);
    for (int p = after.element_begin(e); p < after.element_begin(e + 1); ++p) {
      const std::int64_t id = after.id(p);
      ids += id;
      squares += id * id;
      if (p > after.element_begin(e)) {
        EXPECT_GT(id, after.id(p - 1));
      }
      EXPECT_EQ(after.material(p), 0);
      EXPECT_EQ(after.volume(p), 2.0 * 1.5 * 1.0 / 8.0);
      EXPECT_EQ(after.own_numbers(p, 1), 0.5 * static_cast<double>(id));
      EXPECT_EQ(after.history(p, 0), 0.0);
      EXPECT_EQ(after.history(p, 1), -static_cast<double>(id));
      for (int d = 0; d < 3; ++d) {
        const double xi = (after.position(p, d) - grid.origin[d]) / grid.spacing[d] -
                          static_cast<double>(element[d]);
        EXPECT_GE(xi, -1e-8);
        EXPECT_LT(xi, 1.0);
        EXPECT_EQ(after.base_displacement(p, d), way(id, d));
        EXPECT_EQ(after.base_gradient(p, d, 1), static_cast<double>(id) + d);
        EXPECT_EQ(after.base_gradient(p, d, 0), 0.0);
      }
    }
  }
  EXPECT_EQ(after.element_begin(box.count()), after.count());
  const std::int64_t n = world().sum(static_cast<std::int64_t>(before.count()));
  EXPECT_EQ(world().sum(ids), n * (n - 1) / 2);
  EXPECT_EQ(world().sum(squares), (n - 1) * n * (2 * n - 1) / 6);
}

// A rank without particles cannot see which fields the others' have, and receives all of them.
TEST(Migration, ARankWithoutParticlesReceivesEveryField) {
  auto all = scattered();
  const auto partition = partition_for(all);
  // All to the owner of the first element, and back.
  auto there = all;
  there.position = decltype(there.position)("position", all.position.extent(0));
  for (int p = 0; p < all.count(); ++p)
    for (int d = 0; d < 3; ++d) there.position(p, d) = partition.grid().origin[d];
  const auto gathered = migrate(world(), partition, there);
  EXPECT_EQ(gathered.count() > 0, partition.elements(world().rank()).contains({0, 0, 0}));
  auto back = gathered;
  for (int p = 0; p < back.count(); ++p)
    for (int d = 0; d < 3; ++d)
      back.position(p, d) += 0.9 * partition.grid().length(d) *
                             std::abs(std::sin(static_cast<double>(back.id(p)) + d));
  const auto after = migrate(world(), partition, back);
  EXPECT_EQ(world().sum(after.count()), world().sum(all.count()));
  for (int p = 0; p < after.count(); ++p) {
    EXPECT_EQ(after.own_numbers(p, 1), 0.5 * static_cast<double>(after.id(p)));
    EXPECT_EQ(after.history(p, 1), -static_cast<double>(after.id(p)));
    EXPECT_EQ(after.base_displacement(p, 1), way(after.id(p), 1));
  }
}

// A particle's home is where it was seeded, also after it has moved twice.
TEST(Migration, HomesAreKept) {
  const auto original = seeded();
  auto moved = scattered();
  moved = migrate(world(), partition_for(moved), moved);
  for (int p = 0; p < moved.count(); ++p) moved.position(p, 2) -= way(moved.id(p), 0);
  moved = migrate(world(), partition_for(moved), moved);
  struct Letter {
    std::int64_t home, id;
  };
  std::vector<std::vector<Letter>> letters(static_cast<std::size_t>(world().size()));
  for (int p = 0; p < moved.count(); ++p)
    letters[static_cast<std::size_t>(home_rank(moved.home(p)))].push_back(
        {moved.home(p), moved.id(p)});
  std::set<int> numbers;
  for (const Letter& letter : particles::exchange(world(), letters)) {
    EXPECT_EQ(letter.id, original.id(home_number(letter.home)));
    EXPECT_TRUE(numbers.insert(home_number(letter.home)).second);
  }
  EXPECT_EQ(numbers.size(), static_cast<std::size_t>(original.count()));
}

// The grid covers the body and nothing else, on the nodes of the body's lattice.
TEST(Migration, TheGridFollowsTheBody) {
  const auto at_rest = seeded();
  grid::Grid grid = covering_grid(extent_of(world(), at_rest), body());
  EXPECT_EQ(grid.elements, body().elements);
  EXPECT_EQ(grid.origin, body().origin);

  const std::array<double, 3> distance{7.0, -1.5,
                                       0.5 - 2e-13};  // 3.5, -1 and, but for rounding, 0.5
  for (int p = 0; p < at_rest.count(); ++p)
    for (int d = 0; d < 3; ++d) at_rest.position(p, d) += distance[static_cast<std::size_t>(d)];
  grid = covering_grid(extent_of(world(), at_rest), body());
  EXPECT_EQ(grid.elements, (grid::Index3{6, 4, 7}));
  EXPECT_NEAR(grid.origin[0], -3.0 + 3 * 2.0, 1e-14);
  EXPECT_NEAR(grid.origin[1], 7.0 - 1.5, 1e-14);
  EXPECT_NEAR(grid.origin[2], 0.5, 1e-14);
}

// A particle on a face, edge or node belongs to the upper element, also if rounding puts it below.
TEST(Migration, FacesBelongToTheUpperElement) {
  for (const double rounding : {0.0, -1e-12, 1e-12}) {
    auto particles = seeded();
    for (int p = 0; p < particles.count(); ++p) {
      const std::array<double, 3> h{2.0, 1.5, 1.0};
      for (int d = 0; d < 3; ++d)  // from a quarter and three quarters to a half and the upper face
        particles.position(p, d) += 0.25 * h[static_cast<std::size_t>(d)] + rounding;
    }
    const auto partition = partition_for(particles);
    EXPECT_EQ(partition.grid().elements, (grid::Index3{6, 5, 7}));
    const auto after = migrate(world(), partition, particles);
    const grid::Box box = partition.elements(world().rank());
    for (std::int64_t e = 0; e < box.count(); ++e) {
      int expected = 1;  // along each axis: a half, and the lower face; not both at the ends
      for (int d = 0; d < 3; ++d) {
        const bool at_end =
            box.index(e)[d] == 0 || box.index(e)[d] == partition.grid().elements[d] - 1;
        expected *= at_end ? 1 : 2;
      }
      EXPECT_EQ(after.element_begin(e + 1) - after.element_begin(e), expected);
    }
  }
}

// A lattice under a body that has flown apart would fill the memory.
TEST(Migration, LostParticlesAreRefusedOnAllRanks) {
  auto particles = seeded();
  if (particles.count() > 0 && world().is_root()) particles.position(0, 1) = 1e9;
  EXPECT_THROW(covering_grid(extent_of(world(), particles), body()), base::RunError);
}

}  // namespace
}  // namespace stroma::particles
