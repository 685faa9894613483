// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The body of all consumers: a block of collagen, made from labels that the application holds
/// itself, clamped below and pulled by 10 % above at full load.

#include <memory>

#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/particles/Seeding.hpp"

namespace consumer {

/// Force of the upper support at full load [pN], by two unrelated finite element codes.
constexpr double expected_force = 10559.99691;
/// Where it stands among the reactions: y of the second condition.
constexpr int force_number = 4;

inline std::unique_ptr<stroma::mechanics::MomentumBalance> make_block() {
  using namespace stroma;
  const auto world = base::Communicator::world();
  // 4 x 4 x 4 elements, two voxels an element and direction.
  grid::Grid grid;
  grid.elements = {4, 4, 4};
  grid.spacing = {2.1, 2.1, 2.0};
  const voxels::LabelVolume labels(world, {8, 8, 8}, {1.05, 1.05, 1.0});
  const auto partition =
      grid::Partition::balanced(grid, world.size(), particles::layer_weights(world, grid, labels));
  particles::ParticleParameters layout;
  layout.layout = particles::Layout::gauss;
  const auto particles = particles::seed(world, layout, partition, labels, {{0, 0}});

  mechanics::BoundaryCondition bottom, top;
  bottom.face = mechanics::Face::y_lower;
  bottom.components = "xyz";
  top.face = mechanics::Face::y_upper;
  top.components = "xyz";
  top.strain = 0.1;
  const mechanics::NamedConditions conditions{{"bottom", bottom}, {"top", top}};
  return std::make_unique<mechanics::MomentumBalance>(world, partition, particles,
                                                      mechanics::Laws{{520.8, 2430.4}}, conditions);
}

}  // namespace consumer
