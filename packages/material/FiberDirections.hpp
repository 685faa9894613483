// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How the fibres of a family are directed in the undeformed body.

#include <Kokkos_Core.hpp>
#include <array>
#include <vector>

namespace stroma::material {

/// One direction of fibres, and the share of the family that it stands for.
struct FiberDirection {
  double n[3];    ///< unit vector N
  double weight;  ///< all weights of a family sum to 1
};

enum class Distribution { single, spherical, ellipsoidal, axial };

struct DistributionParameters {
  Distribution distribution = Distribution::single;
  std::array<double, 3> direction{0.0, 0.0, 1.0};  ///< of single and axial; any length but 0
  std::array<double, 3> axes{1.0, 1.0, 1.0};       ///< a of ellipsoidal, > 0
  double concentration = 0.0;                      ///< b of axial
  int quadrature = 16;                             ///< rings of directions from pole to equator
};

/// Directions in the memory of kernels.
using FiberDirections = Kokkos::View<FiberDirection*>;

/// The vector's direction; it must have a length.
std::array<double, 3> normalised(const std::array<double, 3>& vector);

/// The family's directions: one, or a quadrature of the mean over the sphere
///
///     <f> = integral rho(N) f(N) dA / integral rho(N) dA,
///
/// rho = 1 (spherical), (sum (N_i/a_i)^2)^(-1/2) (ellipsoidal), exp(2 b (N.A)^2) (axial). Fibres have
/// no sense, f(-N) = f(N): Gauss's rule in the cosine of the polar angle over a half sphere, with n
/// = quadrature rings of up to 4 n equal angles, about 3 n^2 directions. Exact for polynomials of N
/// of degree 10 (n >= 6); fibres that carry no compression make a kink, by which the error falls as
/// n^-2: docs/theory.md.
std::vector<FiberDirection> directions(const DistributionParameters& parameters);

}  // namespace stroma::material
