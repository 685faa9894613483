// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Whether the body reaches the faces of its box, at which it is held and loaded.

#include <array>

#include "stroma/base/Communicator.hpp"
#include "stroma/mechanics/problem/Problem.hpp"
#include "stroma/particles/Particles.hpp"

namespace stroma::mechanics {

/// (face) Which share of the layer next to each face of the box is filled, one layer of particles
/// thick (outer_thickness across each axis [um]): the volume of the particles whose centres lay in
/// it in the undeformed body, by that of the layer [1]; NaN where the thickness is 0, not known.
/// Collective.
std::array<double, 6> filled_shares_of_faces(const base::Communicator& communicator,
                                             const grid::Grid& box,
                                             const std::array<double, 3>& outer_thickness,
                                             const particles::Particles<grid::Device>& particles);

/// Refuses conditions and tractions at faces that no particle of the undeformed body reaches, with a
/// box around it in the outermost layer there (Problem::outer_thickness). The box is the image's,
/// which may have a margin of empty voxels: nodes would then move what lies deeper through elements
/// filled in part, by too little, and a traction would act on nothing. Grips hold what lies deeper by
/// itself. Collective.
/// \throws base::InputError  naming the condition or the force
void refuse_faces_out_of_reach(const base::Communicator& communicator, const Problem& problem,
                               const particles::Particles<grid::Device>& particles);

}  // namespace stroma::mechanics
