// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/FacesReached.hpp"

#include <array>
#include <cstddef>

#include "stroma/base/Error.hpp"

namespace stroma::mechanics {
namespace {

/// (face) Whether a particle is in the outermost layer; where its thickness is not known (0), taken
/// for granted.
std::array<bool, 6> reached_faces(const base::Communicator& communicator, const Problem& problem,
                                  const particles::Particles<grid::Device>& particles) {
  Kokkos::Array<double, 6> face{};
  Kokkos::Array<double, 3> thickness{};
  for (std::size_t d = 0; d < 3; ++d) {
    thickness[d] = problem.outer_thickness[d];
    face[2 * d] = problem.body.origin[d];
    face[2 * d + 1] = problem.body.origin[d] + problem.body.length(static_cast<int>(d));
  }
  int bits = 0;
  Kokkos::parallel_reduce(
      "faces reached", Kokkos::RangePolicy<grid::ExecutionSpace>(0, particles.count()),
      KOKKOS_LAMBDA(const int p, int& found) {
        for (int f = 0; f < 6; ++f)
          if (fabs(face[f] - particles.undeformed_position(p, f / 2)) <= thickness[f / 2])
            found |= 1 << f;
      },
      Kokkos::BOr<int>(bits));
  std::array<bool, 6> reached{};
  for (std::size_t f = 0; f < 6; ++f)
    reached[f] = thickness[f / 2] <= 0.0 || communicator.any((bits >> f & 1) != 0);
  return reached;
}

}  // namespace

void refuse_faces_out_of_reach(const base::Communicator& communicator, const Problem& problem,
                               const particles::Particles<grid::Device>& particles) {
  const auto reached = reached_faces(communicator, problem, particles);
  const auto look_at = [&](Face face, const std::string& where) {
    if (face != Face::all && !reached[static_cast<std::size_t>(face)])
      throw base::InputError(no_particle_at(where));
  };
  for (const auto& [name, condition] : problem.conditions)
    if (problem.imposed_by(condition) != ImposedBy::grip)
      look_at(*condition.face, "Boundary Conditions|" + name);
  for (const auto& [name, force] : problem.forces)
    if (force.traction) look_at(*force.face, "External Forces|" + name);
}

}  // namespace stroma::mechanics
