// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The load cases by which the stiffness of a specimen is found.

#include <array>
#include <string>
#include <vector>

#include "stroma/mechanics/problem/Rigs.hpp"

namespace stroma::mechanics {

/// What is uniform on the surface of the specimen's box.
enum class UniformBoundary { displacement, mixed, traction };

/// All of them with the names that a deck gives them, the stiffest first.
using NamedBoundaries = std::vector<std::pair<std::string, UniformBoundary>>;
const NamedBoundaries& uniform_boundaries();
/// Those that a rig asks for, in that order.
NamedBoundaries wanted_boundaries(const RigParameters& rig);

/// Unit strains and stresses are numbered in Voigt's order: xx, yy, zz, yz, xz, xy. The two axes of
/// one:
std::array<int, 2> axes_of_unit(int unit);
/// "xx" ... "xy".
std::string name_of_unit(int unit);

/// Load cases that share their constraints, and so a tangent.
struct LoadCases {
  NamedConditions conditions;  ///< components at which u does not depart from the unit strain's
  std::vector<int> units;      ///< the cases
};

/// How the six unit loads are solved. With v_k the linear field of unit strain k (of shear, both
/// components: v_xy = (y/2, x/2, 0)):
///
///     Displacement   u = v_k on all faces
///     Traction       t = sigma_k n on all faces, which hold nothing
///     Mixed, normal  u.n = v_k.n on all faces, no tangential traction
///     Mixed, shear   of the axes i and j, with k the third: on the faces across i, the components j
///                    and k are those of v, on those across j, i and k, on those across k, k; the
///                    others bear no traction
///
/// Each is of a kind for which the mean of stress times strain is the product of their means (Hill).
/// The mixed ones give what periodic conditions give, of a specimen with three planes of mirror
/// symmetry along its box. Sources: R. Hill, J. Mech. Phys. Solids 11 (1963) 357; S. Hazanov and
/// M. Amieur, Int. J. Eng. Sci. 33 (1995) 1289; D. H. Pahr and P. K. Zysset, Biomech. Model.
/// Mechanobiol. 7 (2008) 463.
std::vector<LoadCases> load_cases(UniformBoundary boundary);

}  // namespace stroma::mechanics
