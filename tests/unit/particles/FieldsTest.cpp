// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The list of a particle's fields: complete, and what follows from it.

#include <gtest/gtest.h>

#include <set>

#include "stroma/particles/Fields.hpp"

namespace stroma::particles {
namespace {

// A member that is declared but not listed would stay behind when particles move.
TEST(Fields, EveryMemberOfParticlesIsListedOnce) {
  std::size_t bytes = sizeof(HostParticles::element_begin);
  std::set<const void*> views;
  std::set<std::string> names;
  HostParticles particles;
  for_each_field(
      [&](const Field& field, const auto& view) {
        bytes += sizeof(view);
        EXPECT_TRUE(views.insert(&view).second) << field.name;
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
      },
      particles);
  EXPECT_EQ(bytes, sizeof(HostParticles));
}

TEST(Fields, AParticleCostsTheBytesOfItsFields) {
  EXPECT_EQ(bytes_of_particle({Presence::always}), 24u + 8 + 1 + 8);
  EXPECT_EQ(bytes_of_particle({Presence::always, Presence::where_particles_move}),
            41u + 24 + 72 + 8);
}

TEST(Fields, WhatAStepChangesHasRoomOfItsOwn) {
  HostParticles particles;
  for_each_field([](const Field& field, auto& view) { allocate(view, field.name, 3, 2); },
                 particles);
  const HostParticles moved = with_room_to_move(particles);
  for_each_field(
      [](const Field& field, const auto& before, const auto& after) {
        EXPECT_EQ(before.data() != after.data(), field.change == Change::with_the_grid)
            << field.name;
        EXPECT_EQ(after.extent(0), 3u) << field.name;
        EXPECT_EQ(numbers_of(after), numbers_of(before)) << field.name;
      },
      particles, moved);
}

}  // namespace
}  // namespace stroma::particles
