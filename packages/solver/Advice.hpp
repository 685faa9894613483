// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What helps a run whose steps fail, by what is known of it.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

/// What may make a tangent indefinite.
struct Circumstances {
  double contrast = 1.0;             ///< stiffest over softest shear modulus of the particles [-]
  double incompressibility = 0.0;    ///< largest bulk over shear modulus of a particle [-]
  bool is_single_precision = false;  ///< the tangent, see takes_stencil()
  std::int64_t barely_filled = 0;    ///< elements filled by less than half
  double stabilization = 0.0;        ///< Grid|Stabilization [-]
  std::string locking;               ///< mechanics::locking_note()
  std::int64_t pieces = 1;           ///< of the body, that carry load
  bool has_free_motion = false;      ///< a rigid motion that nodes hold, for want of a support
};

/// Collective.
/// \param solver                 the deck's section
/// \param grid                   the deck's section
/// \param of_volume  how the materials resist a change of volume
/// \param balance                the body as it stands
Circumstances circumstances(const SolverParameters& solver, const mechanics::GridParameters& grid,
                            const material::Compressibility& of_volume,
                            const mechanics::MomentumBalance& balance);

/// Names the preconditioner for a contrast above 1e6, which a tangent in single precision may not
/// resolve; empty for any other run.
std::string contrast_note(const Circumstances& known);

/// What to try, the most promising first, each with its reason; a smaller load, step or element
/// last, whatever is known.
std::vector<std::string> advice(const Circumstances& known);

}  // namespace stroma::solver
