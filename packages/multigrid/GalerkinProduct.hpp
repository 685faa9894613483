// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The operator of a coarser level from that of a finer one.

#include "stroma/multigrid/LevelTransfer.hpp"
#include "stroma/tangent/Stencil.hpp"

namespace stroma::multigrid {

/// coarse = P^T K P, with P the trilinear interpolation: an operator on the 27-point stencil again,
/// formed plane by plane, of which one at a time is held besides the two stencils. Each rank
/// transforms its own part; nothing is exchanged.
///
/// Rows and columns of prescribed components are zero in K (its constant diagonal is kept apart),
/// so those of a coarse component are zero when all that it stands for is prescribed.
void galerkin_product(const tangent::Stencil& fine, const LevelTransfer& transfer,
                      const tangent::Stencil& coarse);

}  // namespace stroma::multigrid
