// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// materials.csv and histograms.csv: how stress and strain are distributed over each material.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/tables/GroupedParticles.hpp"

namespace stroma::output {

/// The particles of each material, and all quantities.
GroupedParticles by_material(const ParticleSet& set, std::size_t materials);

/// Writes both tables. Where the values of a material differ by less than 1e-9 of the largest of that
/// unit, they have one bin. Collective.
/// \param communicator  of the run
/// \param files         of the run
/// \param step          its number
/// \param time          [s]
/// \param materials     their names
/// \param particles     by_material(), with what was found
/// \throws base::RunError on all ranks when a file cannot be written
void write_material_tables(const base::Communicator& communicator, const RunFiles& files,
                           std::int64_t step, double time,
                           const std::vector<std::string>& materials,
                           const GroupedParticles& particles);

}  // namespace stroma::output
