// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The bounds of a specimen's stiffness, as `stroma check` and `stroma run` print them.

#include <cstddef>
#include <string>
#include <vector>

#include "stroma/material/Bounds.hpp"
#include "stroma/material/Material.hpp"

namespace stroma {

/// The materials of a specimen as phases of a mixture, those with a share alone.
struct Mixture {
  std::vector<material::Phase> soft, stiff;  ///< at the extremes of each, where particles differ
  std::vector<std::size_t> which;            ///< material of each phase
};

/// \param shares    of each material, in any unit
/// \param extremes  see bounds_table()
Mixture mixture_of(const material::NamedMaterials& materials, const std::vector<double>& shares,
                   const std::vector<material::SmallStrainModuli>& extremes);

/// Bounds of a mixture in space, or in plane strain: the lower ones of the softest particles, the
/// upper ones of the stiffest, for both grow with the moduli.
material::MixtureBounds bounds_of(const Mixture& mixture, bool plane_strain);

/// Whether bounds of isotropic materials say something of these: none has fibres.
bool are_isotropic(const material::NamedMaterials& materials);

/// A table of Reuss, Hashin-Shtrikman and Voigt bounds (material/Bounds.hpp): shear, bulk and
/// Young's modulus, or shear, plane bulk and plane stiffness in plane strain; in Pa, and as gain
/// over one material: that of label 0, or the first with a share where label 0 has none.
///
/// \param shares  of each material, in any unit (volume, fraction of the voxels)
/// \param extremes  the softest and the stiffest of each material's particles (Specimen), or empty;
///                  the lower bounds are then those of the softest, the upper ones of the stiffest,
///                  and the gain is over the material with its own moduli
/// \param plane_strain  of cylinders along z, else in three dimensions
/// \param has_empty_space  a line says that the bounds are those of the solid without it, as it does of
///                         materials that press, which are no solid
/// \return  lines for the log; none where fewer than two materials have a share and none varies,
///          nor where one has fibres, of which bounds of isotropic materials say nothing
std::vector<std::string> bounds_table(const material::NamedMaterials& materials,
                                      const std::vector<double>& shares,
                                      const std::vector<material::SmallStrainModuli>& extremes,
                                      bool plane_strain, bool has_empty_space);

}  // namespace stroma
