// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/FacesReached.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "stroma/base/Error.hpp"
#include "stroma/particles/UndeformedPositions.hpp"

namespace stroma::mechanics {

std::array<double, 6> filled_shares_of_faces(const base::Communicator& communicator,
                                             const grid::Grid& box,
                                             const std::array<double, 3>& outer_thickness,
                                             const particles::Particles<grid::Device>& particles) {
  const auto X = particles::undeformed_positions(particles);
  const auto V = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.volume);
  std::array<double, 6> shares{};
  for (std::size_t p = 0; p < X.size(); ++p)
    for (std::size_t face = 0; face < 6; ++face) {
      const std::size_t d = face / 2;
      const double at = box.origin[d] + (face % 2 == 1 ? box.length(static_cast<int>(d)) : 0.0);
      if (std::abs(X[p][d] - at) <= outer_thickness[d]) shares[face] += V(p);
    }
  communicator.sum_all(shares.data(), shares.size());
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t d = face / 2;
    shares[face] /= outer_thickness[d] * box.length(static_cast<int>((d + 1) % 3)) *
                    box.length(static_cast<int>((d + 2) % 3));
  }
  return shares;
}

void refuse_faces_out_of_reach(const base::Communicator& communicator, const Problem& problem,
                               const particles::Particles<grid::Device>& particles) {
  const auto shares =
      filled_shares_of_faces(communicator, problem.body, problem.outer_thickness, particles);
  const auto look_at = [&](Face wanted, const std::string& where) {
    for (std::size_t f = 0; f < shares.size(); ++f) {
      const auto face = static_cast<Face>(f);
      const bool is_known = problem.outer_thickness[f / 2] > 0.0;
      if ((wanted == Face::all || wanted == face) && is_known && shares[f] == 0.0)
        throw base::InputError(
            no_particle_at(where, wanted == Face::all ? name_of(face) : "this face"));
    }
  };
  for (const auto& [name, condition] : problem.conditions)
    if (problem.imposed_by(condition) != ImposedBy::grip)
      look_at(*condition.face, "Boundary Conditions|" + name);
  for (const auto& [name, force] : problem.forces)
    if (force.traction) look_at(*force.face, "External Forces|" + name);
}

}  // namespace stroma::mechanics
