// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Whether numbers of the sizes that a problem has can be computed with.

#include "stroma/mechanics/problem/Problem.hpp"

namespace stroma::mechanics {

/// Forces are compared by their squares, to many digits. With moduli M, lengths l and displacements
/// u of the problem, forces of the sizes M l^2 and M l u, and the external ones, must lie between
/// 1e-120 and 1e120 pN: a square that under- or overflows would pass for equilibrium, or for none.
/// And multigrid computes in single precision: M l and the largest of the forces must lie between
/// 1e-28 and 1e32, or entries would be infinite, or lost. What is computed beside 1 needs its digits:
/// prescribed displacements may be 1e5 times the body's longest edge, and bulk moduli 1e10 times the
/// shear modulus, of which rounding leaves 1e-6 in squares of stretches and in pressures.
/// \throws base::InputError naming what is too small or too large
void check_scales(const Problem& problem);

}  // namespace stroma::mechanics
