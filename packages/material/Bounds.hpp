// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Bounds of the effective stiffness of a mixture of isotropic materials, in small strain.

#include <vector>

#include "stroma/material/Law.hpp"

namespace stroma::material {

/// One material of a mixture.
struct Phase {
  double share;  ///< of the volume, in any unit: f_i = share_i / (sum of all shares); >= 0
  SmallStrainModuli moduli;  ///< K_i and mu_i [Pa]
};

/// Reuss <= Hashin-Shtrikman lower <= effective modulus <= Hashin-Shtrikman upper <= Voigt [Pa].
struct Bounds {
  double reuss = 0;
  double lower = 0;  ///< Hashin-Shtrikman
  double upper = 0;  ///< Hashin-Shtrikman
  double voigt = 0;
};

struct MixtureBounds {
  Bounds shear, bulk, young;
};

/// A mixture in three dimensions. With y = mu_s/6 (9 K_s + 8 mu_s) / (K_s + 2 mu_s),
///
///     Reuss:  1/K  = sum f_i / K_i              1/mu = sum f_i / mu_i
///     HS:     1/(K + 4/3 mu_s) = sum f_i / (K_i + 4/3 mu_s)
///             1/(mu + y)       = sum f_i / (mu_i + y)
///     Voigt:  K    = sum f_i K_i                mu   = sum f_i mu_i
///     E = 9 K mu / (3 K + mu), of the bounds of K and mu: it grows with both
///
/// K_s and mu_s are the least of all K_i and of all mu_i for the lower bound, the greatest for the
/// upper one (Walpole's form for any number of phases, well-ordered or not). Reuss and Voigt hold
/// for any body under uniform tractions or displacements; so do E's between rollers with free
/// sides. Hashin and Shtrikman's hold for mixtures that are isotropic on the average.
///
/// \param phases  at least one with a share above 0; moduli > 0
/// Source: Z. Hashin and S. Shtrikman, J. Mech. Phys. Solids 11 (1963) 127; L. J. Walpole, J. Mech.
/// Phys. Solids 14 (1966) 151 and 289; R. Hill, Proc. Phys. Soc. A 65 (1952) 349.
MixtureBounds bounds_in_space(const std::vector<Phase>& phases);

/// Cylinders along z of any cross-section, in plane strain: a slice. With the plane bulk modulus
/// k_i = K_i + mu_i / 3 and y = k_s mu_s / (k_s + 2 mu_s),
///
///     HS:     1/(k + mu_s) = sum f_i / (k_i + mu_s)
///             1/(mu + y)   = sum f_i / (mu_i + y)
///     E' = 4 k mu / (k + mu):  stress by strain of a specimen between rollers, its sides free
///
/// and Reuss and Voigt as above, with k for K. `bulk` is that of k, `young` that of E'.
/// Source: Z. Hashin, J. Mech. Phys. Solids 13 (1965) 119; R. Hill, ibid. 12 (1964) 199.
MixtureBounds bounds_in_plane_strain(const std::vector<Phase>& phases);

}  // namespace stroma::material
