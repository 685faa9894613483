// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A state of strain and a direction by which laws are tried, and what a tangent is held against.

#include <cmath>

#include "stroma/material/AnyLaw.hpp"

namespace stroma::material::test {

/// Stretch, shear and rotation at once, and a direction that moves all nine entries.
inline const Tensor3 H{{{0.10, 0.30, -0.05}, {-0.20, 0.05, 0.15}, {0.08, -0.12, 0.02}}};
inline const Tensor3 D{{{0.7, -0.4, 0.2}, {0.5, 0.3, -0.6}, {-0.1, 0.8, 0.9}}};

inline double norm(const Tensor3& a) { return std::sqrt(tensor::contract(a, a)); }

/// First Piola-Kirchhoff stress tau F^-T.
inline Tensor3 piola(const AnyLaw& law, const Tensor3& at) {
  return kirchhoff_stress(law, at) * tensor::transpose(tensor::inverse(tensor::identity() + at));
}

/// a : D.
inline Tensor3 product(const Tensor4& a, const Tensor3& direction) {
  Tensor3 sum;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum(i, j) += a(i, j, k, l) * direction(k, l);
  return sum;
}

/// | dW/dh by central differences - tau : (D F^-1) |  [Pa], at H along D.
inline double stress_error(const AnyLaw& law, double h) {
  const double slope = (energy(law, H + h * D) - energy(law, H - h * D)) / (2.0 * h);
  const Tensor3 F = tensor::identity() + H;
  return std::abs(slope - tensor::contract(kirchhoff_stress(law, H), D * tensor::inverse(F)));
}

/// d(tau F^-T)/dh by central differences, dF = D F, at H [Pa].
inline Tensor3 stress_slope(const AnyLaw& law, double h) {
  const Tensor3 dF = D * (tensor::identity() + H);
  return (0.5 / h) * (piola(law, H + h * dF) - piola(law, H - h * dF));
}

/// || that - (a : D) F^-T ||  [Pa].
inline double tangent_error(const AnyLaw& law, double h) {
  const Tensor3 back = tensor::transpose(tensor::inverse(tensor::identity() + H));
  return norm(stress_slope(law, h) - product(tangent(law, H).in_full(), D) * back);
}

}  // namespace stroma::material::test
