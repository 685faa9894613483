// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What changes in a material by itself: cells that contract, tissue that grows.

#include "stroma/tensor/Tensor3.hpp"

namespace stroma::material {

using tensor::Tensor3;

/// Factors of a material's drives at a time, from their load curves.
struct MaterialFactors {
  double active = 0.0;  ///< of the active stress, or of a pressure
  double growth = 0.0;  ///< of the growth beyond 1
};

/// Gives a law the factors of its material; most have nothing that they drive.
template <class Law>
KOKKOS_INLINE_FUNCTION void drive(Law&, const MaterialFactors&) {}

/// A constant second Piola-Kirchhoff stress S = T0 A, T0 > 0 contracts: A = I (isotropic), N x N
/// (fiber) or I - N x N (transverse). So the Kirchhoff stress is T0 b, T0 n x n with n = F N, or
/// T0 (b - n x n).
struct ActiveStress {
  enum class Kind { isotropic, fiber, transverse };

  double t0 = 0.0;  ///< [Pa]; 0: none
  Kind kind = Kind::isotropic;
  double direction[3] = {0.0, 0.0, 1.0};  ///< N, a unit vector

  KOKKOS_INLINE_FUNCTION Tensor3 second_piola() const {
    const Tensor3 along = tensor::square_of(direction), all = tensor::identity();
    return t0 * (kind == Kind::isotropic ? all : kind == Kind::fiber ? along : all - along);
  }
};

/// Growth F = F_e F_g of the stress-free shape, with the ratio g of volumes:
///
///     F_g = g^(1/3) I (volume), I + (g - 1) N x N (fiber), sqrt(g) (I - N x N) + N x N (area).
///
/// Source: Rodriguez, Hoger, McCulloch (1994), J Biomech 27:455.
struct Growth {
  enum class Kind { volume, fiber, area };

  double ratio = 1.0;  ///< g at a factor of 1, > 0; 1: none
  Kind kind = Kind::volume;
  double direction[3] = {0.0, 0.0, 1.0};  ///< N, a unit vector

  KOKKOS_INLINE_FUNCTION double ratio_at(double factor) const {
    return 1.0 + factor * (ratio - 1.0);
  }
  /// F_e - I of H = F - I at a ratio g, with the digits of small ones:
  /// F_g^-1 = I + a I + b N x N.
  KOKKOS_INLINE_FUNCTION Tensor3 elastic_part(const Tensor3& H, double g) const {
    const double third = expm1(-log(g) / 3.0), half = expm1(-0.5 * log(g));
    const double a = kind == Kind::volume ? third : kind == Kind::area ? half : 0.0;
    const double b = kind == Kind::volume ? 0.0 : kind == Kind::area ? -half : 1.0 / g - 1.0;
    const Tensor3 added = a * tensor::identity() + b * tensor::square_of(direction);
    return H + added + H * added;
  }
};

}  // namespace stroma::material
