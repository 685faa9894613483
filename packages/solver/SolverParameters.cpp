// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

std::optional<mechanics::Dynamics> LoadingParameters::dynamics() const {
  using mechanics::TimeScheme;
  if (!inertia) return std::nullopt;
  mechanics::Dynamics dynamics;
  dynamics.scheme = scheme == TimeIntegration::newmark
                        ? TimeScheme::newmark(beta.value_or(0.25), gamma.value_or(0.5))
                        : TimeScheme::generalised_alpha(spectral_radius.value_or(0.9));
  dynamics.lumped = mass == MassMatrix::lumped;
  dynamics.mass_damping = mass_damping;
  dynamics.stiffness_damping = stiffness_damping;
  return dynamics;
}

}  // namespace stroma::solver
