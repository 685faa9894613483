// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The stiffness of a specimen as a whole, in small strain about its unloaded state.

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "run/Specimen.hpp"
#include "stiffness/ElasticTensor.hpp"
#include "stroma/mechanics/problem/StiffnessCases.hpp"

namespace stroma {

/// What is to be solved for load cases that share their constraints.
mechanics::Problem problem_of(const Deck& deck, const Specimen& specimen,
                              mechanics::UniformBoundary boundary,
                              const mechanics::LoadCases& cases);

/// The share of each face of the specimen's box that is solid, by the outermost particles; x-, x+,
/// y-, ... 1 for all: no empty space cuts the surface. Collective.
std::array<double, 6> solid_shares_of_faces(const base::Communicator& communicator,
                                            const Specimen& specimen);
bool are_solid(const std::array<double, 6>& shares);

/// How the linear problem of a load case was solved.
struct SolvedCase {
  std::int64_t iterations;
  double residual;  ///< ||K u - f|| / ||f||
};

/// Of the stiffness with one kind of boundary [Pa].
struct ApparentStiffness {
  /// (k, l) Mean stress k of the box under the unit load l, over the whole box, empty space
  /// included; and its mean strain, engineering shears.
  Matrix6 stress, strain;
  Matrix6 stiffness;      ///< the symmetric part of stress strain^-1
  double symmetry_error;  ///< |C - C^T| / |C| before that (Euclidean, of the tensors)
  std::array<SolvedCase, 6> cases;
  /// The largest residual of a case [pN, Euclidean norm over nodes], and the largest force on the
  /// surface by the mean stress of one: inclusions of a large contrast may leave of the one more than
  /// of the other, however small it is against what acts within them.
  double largest_residual = 0.0, largest_force = 0.0;

  std::int64_t iterations() const;  ///< of all cases
};

/// The mean of the materials' stiffnesses over the box, by the stress of uniform strains [Pa]:
/// Voigt's bound. The body's supports do not matter. Collective.
Matrix6 voigt_stiffness(const mechanics::Body& body);

/// Solves the six load cases on u = 0. With u_l the displacement of case l, K the tangent, v_k and
/// f_k the displacement of unit strain k and the surface forces of unit stress k
/// (mechanics/terms/UnitLoads.hpp) and V the volume of the box:
///
///     stress_kl = v_k . K u_l / V,   strain_kl = f_k . u_l / V,   C = stress strain^-1
///
/// With uniform displacement strain is the identity, with uniform traction stress is. Where empty
/// space cuts the surface the mean strain of the box is not known; that of the case is taken for it.
///
/// \param report  called with the balance of each set of constraints before it is solved
/// \throws base::InputError  see mechanics::Supports
/// \throws std::logic_error  with uniform traction, where empty space cuts the surface
/// \throws base::RunError    when the linear solver does not come to its tolerance
/// Collective.
ApparentStiffness apparent_stiffness(
    const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
    mechanics::UniformBoundary boundary,
    const std::function<void(const mechanics::MomentumBalance&)>& report = {});

}  // namespace stroma
