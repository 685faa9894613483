// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Whether the body reaches the faces of its box, at which it is held and loaded.

#include "stroma/base/Communicator.hpp"
#include "stroma/mechanics/problem/Problem.hpp"
#include "stroma/particles/Particles.hpp"

namespace stroma::mechanics {

/// Refuses conditions and tractions at faces that no particle of the undeformed body reaches, with a
/// box around it in the outermost layer there (Problem::outer_thickness). The box is the image's,
/// which may have a margin of empty voxels: nodes would then move what lies deeper through elements
/// filled in part, by too little, and a traction would act on nothing. Grips hold what lies deeper by
/// itself. Collective.
/// \throws base::InputError  naming the condition or the force
void refuse_faces_out_of_reach(const base::Communicator& communicator, const Problem& problem,
                               const particles::Particles<grid::Device>& particles);

}  // namespace stroma::mechanics
