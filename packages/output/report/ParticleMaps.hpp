// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Fields of particles as maps on a lattice of the undeformed body.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/output/report/MapLattice.hpp"

namespace stroma::output {

/// A field at all steps that are shown; empty cells are not a number.
struct FieldMap {
  std::string name, unit;
  std::vector<std::vector<float>> values;  ///< (step) (cell)
};

struct ParticleMaps {
  MapLattice lattice;
  std::vector<std::size_t> steps;  ///< in the file, from 0
  std::size_t steps_in_file = 0;
  std::vector<std::string> materials;
  std::vector<std::uint8_t> material;  ///< (cell) from 1: the one with most volume there; 0: empty
  std::vector<FieldMap> fields;        ///< von_mises, principal_stress_1, principal_strain_1
};

/// Von Mises stress, largest principal stress and largest principal strain (of Green and Lagrange's
/// E; where the file has it) of particles, in cells that hold a particle each, or, lest it be too
/// much, several: means by undeformed volume; of the strain, the largest principal value of the
/// mean. For one rank.
///
/// \param particles   of a run
/// \param most_steps  where there are more, so many are taken, evenly, the first and the last among them
/// \param most_values cells times fields times steps, at most
/// \throws base::RunError when they cannot be read
ParticleMaps particle_maps(const ParticleReader& particles, std::size_t most_steps,
                           std::size_t most_values);

}  // namespace stroma::output
