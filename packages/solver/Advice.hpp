#pragma once

/// \file
/// What helps where a run did not get on, by what is known of it.

#include <cstdint>
#include <string>
#include <vector>

#include "mechanics/MomentumBalance.hpp"
#include "solver/SolverSection.hpp"

namespace stroma::solver {

/// What makes a tangent indefinite, or conjugate gradients slow.
struct Circumstances {
  PreconditionerKind preconditioner = PreconditionerKind::geometric_multigrid;
  double contrast = 1.0;               ///< stiffest over softest shear modulus [-]
  double largest_poisson_ratio = 0.0;  ///< [-]
  bool has_pointwise_dilatation = true;
  double barely_filled = 0.0;    ///< share of the elements with particles that are filled by less
                                 ///< than half [-]
  double stabilization = 0.0;    ///< Grid|Stabilization [-]
  std::int64_t pieces = 1;       ///< of the body that are solved
  bool has_free_motion = false;  ///< a rigid motion is held at nodes only
};

Circumstances circumstances(const SolverParameters& parameters,
                            const mechanics::MomentumBalance& balance);

/// Contrast of moduli from which geometric multigrid needs another preconditioner's help.
constexpr double high_contrast = 1e6;

/// What to try, most promising first, each with its reason; a smaller load or step where nothing
/// in particular is known.
std::vector<std::string> advice(const Circumstances& known);

}  // namespace stroma::solver
