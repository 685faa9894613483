// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Every field of a particle, once; and what is done to each of them alike.

#include <Kokkos_Core.hpp>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "stroma/particles/Particles.hpp"

namespace stroma::particles {

/// Which bodies' particles have a field.
enum class Presence {
  always,
  where_particles_move,  ///< across the grid, or with a displacement of their own (make_movable)
  where_particles_carry_motion,  ///< velocities, with inertia (begin_motion)
  where_motion_changes_grids,    ///< its gradients, with lumped masses on a grid that is reset
  where_materials_vary,          ///< from particle to particle
  where_laws_remember            ///< what happened to the particle
};

/// What a step does to it.
enum class Change {
  none,
  with_the_grid  ///< particles that move have another value then (transfer::Advance)
};

struct Field {
  const char* name;
  const char* unit;
  Presence presence;
  Change change = Change::none;
  bool is_shown = false;  ///< in particles.e, under its name; of fields of one double
};

/// Calls visit(Field, view) for each field of a set of particles; of several sets, whose views may
/// live in different memories, visit(Field, view of the first, view of the second ...). A member of
/// Particles that has a value of each particle has a line here.
template <class Visit, class... Sets>
void for_each_field(const Visit& visit, Sets&&... sets) {
  using P = Presence;
  visit(Field{"position", "um", P::always, Change::with_the_grid}, sets.position...);
  visit(Field{"volume", "um^3", P::always}, sets.volume...);
  visit(Field{"material", "-", P::always}, sets.material...);
  visit(Field{"id", "-", P::always}, sets.id...);
  visit(Field{"base_displacement", "um", P::where_particles_move, Change::with_the_grid},
        sets.base_displacement...);
  visit(Field{"base_gradient", "-", P::where_particles_move, Change::with_the_grid},
        sets.base_gradient...);
  visit(Field{"home", "-", P::where_particles_move}, sets.home...);
  visit(Field{"velocity", "um/s", P::where_particles_carry_motion}, sets.velocity...);
  visit(Field{"acceleration", "um/s^2", P::where_particles_carry_motion}, sets.acceleration...);
  visit(Field{"velocity_gradient", "1/s", P::where_motion_changes_grids},
        sets.velocity_gradient...);
  visit(Field{"own_numbers", "the law's", P::where_materials_vary}, sets.own_numbers...);
  visit(Field{"history", "the law's", P::where_laws_remember}, sets.history...);
}

/// Numbers that a field has of each particle; they stand one after the other.
template <class View>
std::size_t numbers_of(const View& field) {
  std::size_t numbers = 1;
  for (unsigned r = 1; r < static_cast<unsigned>(View::rank); ++r) numbers *= field.extent(r);
  return numbers;
}

/// Makes room for a field of `count` particles; what is in it is not set.
template <class View>
void allocate(View& field, const char* name, std::size_t count,
              std::size_t numbers = numbers_of(View())) {
  const auto unset = Kokkos::view_alloc(std::string(name), Kokkos::WithoutInitializing);
  if constexpr (static_cast<int>(View::rank_dynamic) == 2)
    field = View(unset, count, numbers);
  else
    field = View(unset, count);
}

/// Particles where the host's loops read and write them. Where that is the memory of the kernels
/// too, the views are the same.
using HostParticles =
    Particles<Kokkos::Device<Kokkos::DefaultHostExecutionSpace, Kokkos::HostSpace>>;

/// The fields on the host, but for element_begin.
template <class Device>
HostParticles on_host(const Particles<Device>& particles) {
  HostParticles host;
  for_each_field(
      [](const Field&, auto& copy, const auto& field) {
        copy = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), field);
      },
      host, particles);
  return host;
}

/// Bytes of a particle that has the fields of these kinds of presence, but for those of as many
/// numbers as laws ask for.
inline std::size_t bytes_of_particle(std::initializer_list<Presence> kinds) {
  std::size_t bytes = 0;
  for_each_field(
      [&](const Field& field, const auto& view) {
        for (const Presence kind : kinds)
          if (field.presence == kind) bytes += numbers_of(view) * sizeof(*view.data());
      },
      HostParticles());
  return bytes;
}

/// Gives particles a history of this many numbers, zeros, if they have none yet.
template <class Device>
void begin_history(Particles<Device>& particles, int numbers) {
  const auto count = static_cast<std::size_t>(particles.count());
  if (numbers == 0 || (count > 0 && particles.history.extent(0) == count)) return;
  allocate(particles.history, "history", count, static_cast<std::size_t>(numbers));
  Kokkos::deep_copy(particles.history, 0.0);
}

/// Gives particles a velocity and an acceleration, zeros, if they have none yet.
/// \param particles      of this rank
/// \param with_gradient  whether they get a velocity gradient, too
/// \return whether they had none
template <class Device>
bool begin_motion(Particles<Device>& particles, bool with_gradient) {
  const auto count = static_cast<std::size_t>(particles.count());
  if (particles.velocity.extent(0) == count) return false;
  for (auto* field : {&particles.velocity, &particles.acceleration}) {
    allocate(*field, "motion", count);
    Kokkos::deep_copy(*field, 0.0);
  }
  if (with_gradient) {
    allocate(particles.velocity_gradient, "motion", count);
    Kokkos::deep_copy(particles.velocity_gradient, 0.0);
  }
  return true;
}

/// The same particles, with room of their own for what a step changes.
template <class Device>
Particles<Device> with_room_to_move(const Particles<Device>& particles) {
  Particles<Device> moved = particles;
  for_each_field(
      [&](const Field& field, auto& view) {
        if (field.change == Change::with_the_grid)
          allocate(view, field.name, static_cast<std::size_t>(particles.count()));
      },
      moved);
  return moved;
}

}  // namespace stroma::particles
