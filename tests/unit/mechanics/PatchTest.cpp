// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Patch tests. A convected grid of hats holds every linear displacement, so that, under nodal
/// values u = G X,
///
/// 1. F = I + G at EVERY particle, however the particles lie (also beside empty space);
/// 2. where a uniform material's particles give each element its own volume and integrate
///    functions that are linear in each coordinate exactly (any symmetric n^3, n different from
///    element to element), the internal force vanishes at every node inside the full body:
///    sum_p V_p grad N_I(x_p) = integral of grad N_I = 0.
///
/// Voxels that are not aligned with the elements obey the first, not the second. Claim V-PATCH,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::mechanics {
namespace {

using test::Specimen;

const std::array<double, 9> G{0.05, 0.20, -0.04, -0.10, 0.08, 0.06, 0.03, -0.07, -0.05};

tensor::Tensor3 gradient() {
  tensor::Tensor3 H;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) H(i, j) = G[static_cast<std::size_t>(3 * i + j)];
  return H;
}

grid::Vector homogeneous(const MomentumBalance& balance) {
  grid::Vector u(balance.owned_map());
  const grid::Grid& grid = balance.halo().partition().grid();
  test::fill(balance.halo(), u,
             [&](const grid::Index3& node, int c) { return test::linear_field(grid, G, node, c); });
  return u;
}

/// Equally spaced particles, n^3 of them with n from 1 to 4 changing from element to element.
particles::Particles<grid::Device> uneven_particles(const grid::Partition& partition, int rank) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(rank);
  const auto number = [](const grid::Index3& e) {
    return static_cast<int>(1 + (e[0] * 5 + e[1] * 3 + e[2] * 7) % 4);
  };
  std::size_t count = 0;
  grid::for_each_index(elements, [&](const grid::Index3& e) {
    count += static_cast<std::size_t>(number(e) * number(e) * number(e));
  });
  particles::Particles<grid::Device> particles;
  particles.position = decltype(particles.position)("position", count);
  particles.volume = decltype(particles.volume)("volume", count);
  particles.material = decltype(particles.material)("material", count);
  particles.id = decltype(particles.id)("id", count);
  particles.element_begin =
      decltype(particles.element_begin)("begin", static_cast<std::size_t>(elements.count() + 1));
  const auto position = Kokkos::create_mirror_view(particles.position);
  const auto volume = Kokkos::create_mirror_view(particles.volume);
  const auto begin = Kokkos::create_mirror_view(particles.element_begin);
  const double element_volume = grid.spacing[0] * grid.spacing[1] * grid.spacing[2];
  int p = 0;
  grid::for_each_index(elements, [&](const grid::Index3& e) {
    begin(elements.local(e)) = p;
    const int n = number(e);
    for (int q = 0; q < n * n * n; ++q, ++p) {
      const int place[3] = {q % n, q / n % n, q / (n * n)};
      const auto corner = grid.node_position(e);
      for (int d = 0; d < 3; ++d)
        position(p, d) = corner[static_cast<std::size_t>(d)] +
                         (place[d] + 0.5) / n * grid.spacing[static_cast<std::size_t>(d)];
      volume(p) = element_volume / (n * n * n);
    }
  });
  begin(elements.count()) = p;
  Kokkos::deep_copy(particles.position, position);
  Kokkos::deep_copy(particles.volume, volume);
  Kokkos::deep_copy(particles.element_begin, begin);
  return particles;
}

bool inside(const grid::Grid& grid, const grid::Index3& node) {
  for (int d = 0; d < 3; ++d)
    if (node[d] == 0 || node[d] == grid.elements[d]) return false;
  return true;
}

/// Largest internal force inside the body, relative to the largest anywhere (the reactions).
double force_inside(const MomentumBalance& balance) {
  grid::Vector f(balance.owned_map());
  EXPECT_EQ(balance.internal_force(homogeneous(balance), f), 0);
  const grid::Grid& grid = balance.halo().partition().grid();
  double largest_inside = 0.0, largest = 0.0;
  test::for_each_unknown(balance.halo(), f, [&](const grid::Index3& node, int, double value) {
    largest = std::max(largest, std::abs(value));
    if (inside(grid, node)) largest_inside = std::max(largest_inside, std::abs(value));
  });
  return world().max(largest_inside) / world().max(largest);
}

void expect_uniform_state(const MomentumBalance& balance, const material::NeoHookean& law) {
  const auto fields = balance.body().particle_fields(homogeneous(balance));
  const auto jacobian = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fields.jacobian);
  const auto stress = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fields.stress);
  const double j = tensor::det(tensor::identity() + gradient());
  const auto sigma = material::cauchy_stress(law, gradient());
  const double expected[6] = {sigma(0, 0), sigma(1, 1), sigma(2, 2),
                              sigma(0, 1), sigma(1, 2), sigma(2, 0)};
  for (std::size_t p = 0; p < jacobian.extent(0); ++p) {
    EXPECT_NEAR(jacobian(p), j, 1e-13);
    for (int c = 0; c < 6; ++c) EXPECT_NEAR(stress(p, c), expected[c], 1e-12 * law.bulk_modulus);
  }
}

TEST(PatchTest, UnevenParticlesAreInEquilibriumUnderUniformStrain) {
  Specimen specimen;
  specimen.elements = {6, 5, 4};
  const auto partition = specimen.partition(world());
  const MomentumBalance balance(world(), partition, uneven_particles(partition, world().rank()),
                                {{520.8, 2430.4}}, test::clamped(0.1));
  EXPECT_LT(force_inside(balance), 1e-12);
  expect_uniform_state(balance, {520.8, 2430.4});
}

TEST(PatchTest, EveryLayoutIsInEquilibriumUnderUniformStrain) {
  for (const particles::ParticleParameters& layout :
       {particles::ParticleParameters{particles::Layout::gauss, 1, 2},
        particles::ParticleParameters{particles::Layout::voxel_centers, 1, 2},
        particles::ParticleParameters{particles::Layout::voxel_centers, 3, 2},
        particles::ParticleParameters{particles::Layout::per_element, 1, 1},
        particles::ParticleParameters{particles::Layout::per_element, 1, 3}}) {
    Specimen specimen;
    specimen.conditions = test::clamped(0.1);
    specimen.layout = layout;
    const auto balance = specimen.balance(world());
    EXPECT_LT(force_inside(*balance), 1e-12);
    expect_uniform_state(*balance, specimen.laws[0]);
  }
}

// Random empty voxels: the state is uniform, and nodes all of whose elements are full are in
// balance. Empty voxels are drawn in the upper half of the block, so that there are such nodes
// below.
TEST(PatchTest, EmptySpaceLeavesTheStateUniform) {
  Specimen specimen;
  specimen.elements = {5, 6, 4};
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.label = [](const grid::Index3& voxel) {
    return voxel[1] >= 6 && test::scatter(voxel, 0) > 0.2 ? -1 : 0;
  };
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")}};
  const auto balance = specimen.balance(world());
  expect_uniform_state(*balance, specimen.laws[0]);

  grid::Vector f(balance->owned_map());
  balance->internal_force(homogeneous(*balance), f);
  const grid::Grid grid = specimen.grid();
  double in_full_part = 0.0, largest = 0.0;
  std::int64_t nodes = 0;
  test::for_each_unknown(balance->halo(), f, [&](const grid::Index3& node, int, double value) {
    largest = std::max(largest, std::abs(value));
    if (!inside(grid, node) || node[1] > 2) return;  // elements above node 2 are below voxel 6
    in_full_part = std::max(in_full_part, std::abs(value));
    ++nodes;
  });
  EXPECT_GT(world().sum(nodes), 0);
  EXPECT_LT(world().max(in_full_part), 1e-12 * world().max(largest));
}

// 9 voxels along 6 elements: every other voxel is cut (QuadratureTest has equilibrium).
TEST(PatchTest, VoxelsAcrossElementsKeepTheStateUniform) {
  Specimen specimen;
  specimen.elements = {6, 4, 4};
  specimen.voxels_per_element = {2, 2, 2};
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.conditions = test::clamped(0.1);
  voxels::LabelVolume labels(world(), {9, 8, 8}, {6 * 2.1 / 9, 2.1 / 2, 1.0});
  const grid::Grid grid = specimen.grid();
  const auto partition = grid::Partition::balanced(grid, world().size(),
                                                   particles::layer_weights(world(), grid, labels));
  const MomentumBalance balance(
      world(), partition, particles::seed(world(), specimen.layout, partition, labels, {{0, 0}}),
      std::vector<material::NeoHookean>{specimen.laws[0]}, specimen.conditions);
  expect_uniform_state(balance, specimen.laws[0]);
}

// Gradients of hats sum to zero, so the forces on all nodes do too, whatever the displacement.
TEST(MomentumBalance, InternalForcesSumToZero) {
  Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.conditions = test::clamped(0.1);
  const auto balance = specimen.balance(world());
  grid::Vector u(balance->owned_map()), f(balance->owned_map());
  test::fill(balance->halo(), u,
             [](const grid::Index3& node, int c) { return 0.15 * test::scatter(node, c); });
  EXPECT_EQ(balance->internal_force(u, f), 0);
  std::array<double, 3> sum{};
  double size = 0.0;
  test::for_each_unknown(balance->halo(), f, [&](const grid::Index3&, int c, double value) {
    sum[static_cast<std::size_t>(c)] += value;
    size += std::abs(value);
  });
  world().sum_all(sum.data(), 3);
  size = world().sum(size);
  for (const double s : sum) EXPECT_NEAR(s, 0.0, 1e-13 * size);
}

// The same particle on one rank and on several, with a node pushed through its neighbours.
TEST(MomentumBalance, TheWorstParticleIsNamedAlikeOnAllRanks) {
  Specimen specimen;
  specimen.conditions = test::clamped(0.1);
  const auto alone = specimen.balance(base::Communicator::self());
  const auto together = specimen.balance(world());
  const auto push = [](const grid::Index3& node, int c) {
    return node == grid::Index3{2, 3, 1} && c == 1 ? -6.0 : 0.0;
  };
  grid::Vector u1(alone->owned_map()), un(together->owned_map()), f(together->owned_map());
  test::fill(alone->halo(), u1, push);
  test::fill(together->halo(), un, push);
  const WorstParticle a = alone->body().worst_particle(u1), b = together->body().worst_particle(un);
  EXPECT_GE(a.id, 0);
  EXPECT_EQ(a.id, b.id);
  EXPECT_LT(a.figure, 0.0);
  EXPECT_NEAR(a.figure, b.figure, 1e-14);
  EXPECT_EQ(a.position, b.position);
  grid::Vector f1(alone->owned_map());
  const std::int64_t bad = alone->internal_force(u1, f1);
  EXPECT_GT(bad, 0);
  EXPECT_EQ(together->internal_force(un, f), bad);
}

}  // namespace
}  // namespace stroma::mechanics
