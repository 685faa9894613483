// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a family of fibres asks of its law.
///
/// A fibre of direction N in the undeformed body is stretched by lambda, lambda^2 = I = N.C.N. A law
/// of fibres gives its energy as a function of I; with x = I - 1 given, for small stretches keep
/// their digits in x. It has
///
///     // psi [Pa], and its first two derivatives by I; the derivatives without branches, and by the
///     // functions of VectorMath.hpp, so that those of several fibres are found at once
///     double energy(double x) const;
///     FiberSlopes slopes(double x) const;
///     // of small stretches, the larger of tension's and compression's: d2psi/dlambda2 at 1 [Pa]
///     double small_strain_modulus() const;
///     // in the deck
///     static const char* name();
///     static const char* meaning();
///     template <class Parameters> static void declare(Parameters&);  // as of laws: LawParameters.hpp
///
/// the first two for host and device.

#include "stroma/material/LawParameters.hpp"
#include "stroma/tensor/VectorMath.hpp"

namespace stroma::material {

/// Derivatives of a fibre's energy per volume of the body by I = lambda^2 [Pa].
struct FiberSlopes {
  double first, second;
};

/// A fibre of direction N, carried along by F = I + H: m = F N, and x = I - 1 = 2 N.H.N + |H N|^2.
struct StretchedFiber {
  double m[3], x = 0.0;

  KOKKOS_INLINE_FUNCTION StretchedFiber(const Tensor3& H, const double n[3]) {
    for (int i = 0; i < 3; ++i) {
      double change = 0.0;
      for (int j = 0; j < 3; ++j) change += H(i, j) * n[j];
      m[i] = n[i] + change;
      x += change * (2.0 * n[i] + change);
    }
  }
};

/// 1 where x is positive or 0, else 0; without a branch.
KOKKOS_INLINE_FUNCTION double in_tension(double x) { return 0.5 + copysign(0.5, x); }

/// lambda - 1 of x = lambda^2 - 1, to all digits.
KOKKOS_INLINE_FUNCTION double stretch_minus_one(double x) { return x / (1.0 + sqrt(1.0 + x)); }

/// From derivatives by the stretch lambda to those by I:
/// psi' = w' / (2 lambda), psi'' = (w'' - w' / lambda) / (4 I).
KOKKOS_INLINE_FUNCTION FiberSlopes by_square(double first, double second, double stretch) {
  return {0.5 * first / stretch, 0.25 * (second - first / stretch) / (stretch * stretch)};
}

}  // namespace stroma::material
