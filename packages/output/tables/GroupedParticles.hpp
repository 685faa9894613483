// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What tables tell of the particles of a step, group by group.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "stroma/output/tables/Distributions.hpp"

namespace stroma::output {

/// Numbers of each particle, by their places in table_quantities().
enum Quantity : std::size_t {
  von_mises,
  principal_stress_1,
  principal_stress_2,
  principal_stress_3,
  principal_strain_1,
  principal_strain_2,
  principal_strain_3,
  jacobian
};

struct TableQuantity {
  const char* name;
  const char* unit;
};

/// Principal stresses are Cauchy's, principal strains those of Green and Lagrange's E = (F^T F - I)
/// / 2, both descending.
const std::vector<TableQuantity>& table_quantities();

/// Particles in groups, and how the quantities that are asked for are distributed over each, by
/// deformed volume. Percentiles are those of 5, 25, 50, 75 and 95 %.
struct GroupedParticles {
  Groups groups;                                 ///< of this rank's particles
  std::vector<Quantity> quantities;              ///< that are asked for
  std::vector<std::vector<Distribution>> found;  ///< (quantity of the table) (group), or empty
};

/// Fills in what is found. Some quantities are evaluated and kept at once, in 8 bytes a particle for
/// each and 8 more; then the next ones, in another pass over the particles. Collective.
/// \param communicator  of the ranks that share the particles
/// \param set           the particles of this rank
/// \param states        theirs
/// \param all           groupings; of the same particles, in the same order
/// \param at_once       quantities to be kept at once; the same on all ranks
/// \param look          is called once for each particle, with its state and deformed volume
void find_distributions(
    const base::Communicator& communicator, const ParticleSet& set, const StatePieces& states,
    const std::vector<GroupedParticles*>& all, std::size_t at_once,
    const std::function<void(std::int64_t p, const ParticleAt& particle, double volume)>& look);

}  // namespace stroma::output
