// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a user says of the solver and of the load steps.

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>
#include <optional>
#include <vector>

#include "stroma/mechanics/problem/Dynamics.hpp"

namespace stroma::solver {

enum class PreconditionerKind { geometric_multigrid, jacobi, chebyshev, multigrid, direct };

enum class Forcing { adaptive, constant };

struct SolverParameters {
  double newton_tolerance = 1e-8;  ///< ||residual|| / largest ||reaction|| so far
  int newton_iterations = 12;      ///< more than these: the step is rejected
  double linear_tolerance = 1e-6;  ///< ||linear residual|| / ||right-hand side||
  Forcing forcing = Forcing::adaptive;
  int linear_iterations = 10000;
  PreconditionerKind preconditioner = PreconditionerKind::geometric_multigrid;
  Teuchos::RCP<Teuchos::ParameterList> nox;  ///< laid over Stroma's own settings; may be null
  Teuchos::RCP<Teuchos::ParameterList> belos;
  Teuchos::RCP<Teuchos::ParameterList> ifpack2;
  Teuchos::RCP<Teuchos::ParameterList> muelu;
};

enum class TimeIntegration { newmark, generalised_alpha };
enum class MassMatrix { lumped, consistent };

struct LoadingParameters {
  std::optional<int> steps;                       ///< equal ones; absent: `times`, or 10
  double smallest_step = 1e-4;                    ///< of the full load
  std::optional<std::vector<double>> times = {};  ///< ends of the steps [s], ascending, > 0
  std::optional<double> duration =
      {};  ///< [s]; absent: the last of `times`, or time is the load factor
  bool inertia = false;
  // Of a body with inertia:
  TimeIntegration scheme = TimeIntegration::newmark;
  std::optional<double> spectral_radius = {};   ///< of generalised alpha; absent: 0.9
  std::optional<double> beta = {}, gamma = {};  ///< of Newmark's; absent: 1/4, 1/2
  MassMatrix mass = MassMatrix::lumped;
  double mass_damping = 0.0;              ///< [1/s]
  double stiffness_damping = 0.0;         ///< [s]
  std::optional<double> step_error = {};  ///< of time, above which a step is halved [um]

  int equal_steps() const { return steps.value_or(10); }
  /// Whether time has a meaning of its own.
  bool has_time() const { return duration || times; }
  /// Seconds at full load; 1 where time has no meaning of its own.
  double seconds() const { return duration.value_or(times ? times->back() : 1.0); }
  /// What a body has of it, but for how its motion begins; nothing without inertia.
  std::optional<mechanics::Dynamics> dynamics() const;
};

}  // namespace stroma::solver
