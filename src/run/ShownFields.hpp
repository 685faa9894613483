// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What particles.e shows of particles beside a step's results.

#include <vector>

#include "run/Specimen.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Types.hpp"
#include "stroma/output/files/ParticleVariables.hpp"
#include "stroma/transfer/GridToParticles.hpp"

namespace stroma {

/// A variable with its values on this rank.
struct ShownValues {
  output::ShownField field;
  Kokkos::View<const double*, grid::Device> values;  ///< (particle)
};

/// The fields that the list of fields has shown (particles::Field) and that the particles of some
/// rank have, the numbers of laws that vary, and velocities of a body with inertia; the same on all
/// ranks. Collective.
/// \param materials  the deck's
/// \param specimen   which of their numbers vary
/// \param balance    of the particles as they are now
std::vector<ShownValues> shown_fields(const base::Communicator& communicator,
                                      const material::NamedMaterials& materials,
                                      const Specimen& specimen,
                                      const mechanics::MomentumBalance& balance);

/// Results and shown values of consecutive particles, as files take them.
/// \param fields  results; must outlive the state
/// \param shown   of all particles
/// \param first   the particle that the fields begin with
output::ParticleState state_of(const transfer::ParticleFields<grid::Device>& fields,
                               const std::vector<ShownValues>& shown = {}, int first = 0);

}  // namespace stroma
