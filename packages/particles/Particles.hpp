// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The state of the particles (material points) of one rank.

#include <Kokkos_Core.hpp>
#include <cstdint>

namespace stroma::particles {

/// Particles of one rank, sorted by element, so that element e of the rank's box (local number, x
/// fastest) holds the particles element_begin(e) ... element_begin(e + 1) - 1.
///
/// The state refers to the base configuration: the one at which the grid was last Cartesian.
/// Without grid reset that is the undeformed body for the whole run: positions never change,
/// base_gradient and base_displacement stay empty (extent 0, meaning zero), and the deformation is
/// the grid's. With reset, the state moves on with each step, and particles change their order and
/// their rank with their element (Migration.hpp).
///
/// A member that holds something of each particle is a field: Fields.hpp lists them all, and what
/// is done to each of them (seeding's room, the way between ranks, what memory they take) follows
/// from that list.
template <class Device>
struct Particles {
  using Vector3 = Kokkos::View<double* [3], Kokkos::LayoutRight, Device>;
  using Tensor = Kokkos::View<double* [3][3], Kokkos::LayoutRight, Device>;

  Vector3 position;                              ///< x at the base configuration [um]
  Kokkos::View<double*, Device> volume;          ///< V0, in the undeformed body [um^3]
  Kokkos::View<std::uint8_t*, Device> material;  ///< index into the list of materials
  Kokkos::View<std::int64_t*, Device> id;        ///< number in the layout's global order
  Kokkos::View<int*, Device> element_begin;      ///< (elements of the rank + 1)
  Vector3 base_displacement;                     ///< u less what the nodes carry [um], or empty
  Tensor base_gradient;                          ///< H = F - I there [-], or empty
  Kokkos::View<std::int64_t*, Device> home;      ///< where results belong (Exchange.hpp), or empty
  Vector3 velocity;                              ///< v [um/s], or empty
  Vector3 acceleration;                          ///< a [um/s^2], or empty
  Tensor velocity_gradient;                      ///< dv/dx [1/s], or empty
  /// (particle, number) What stands in place of numbers of its material's law (material::AnyLaw::
  /// let_vary), in their units, or empty.
  Kokkos::View<double**, Kokkos::LayoutRight, Device> own_numbers;
  /// (particle, number) What the material's law remembers of accepted steps, in its units, or empty.
  Kokkos::View<double**, Kokkos::LayoutRight, Device> history;

  int count() const { return static_cast<int>(volume.extent(0)); }

  /// X, where the particle was in the undeformed body [um]; device code.
  KOKKOS_INLINE_FUNCTION double undeformed_position(int p, int d) const {
    return base_gradient.extent(0) == 0 ? position(p, d) : position(p, d) - base_displacement(p, d);
  }
};

}  // namespace stroma::particles
