// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The particles of one step as a file of VTKHDF: what particles.e has of it.

#include <string>
#include <vector>

#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/files/VtkhdfFile.hpp"

namespace stroma::output {

/// Writes the particles as vertices at their reference positions [um], and at each point what
/// particles.e has of it in the step, by the same names and in the same units: displacement as a
/// vector, stress and strain as symmetric tensors (xx yy zz xy yz zx, as VTK has them), the other
/// variables as they are, and `id` (from 1), `material` (from 1), `radius` [um] and `volume`
/// [um^3]. Field data: the row of history.csv. Collective.
/// \param communicator      of the ranks that share the particles
/// \param path              of the file
/// \param particles         this rank's
/// \param states            in pieces of any size
/// \param fields            those of the states, in their order; the same on all ranks
/// \param numbers           the row
/// \param precision         of what is real
/// \throws base::RunError on all ranks; a file of before is still there
void write_vtkhdf_particles(const base::Communicator& communicator, const std::string& path,
                            const ParticleSet& particles, const StatePieces& states,
                            const std::vector<ShownField>& fields,
                            const std::vector<VtkhdfNumber>& numbers, Precision precision);

}  // namespace stroma::output
