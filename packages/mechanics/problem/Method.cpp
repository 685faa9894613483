// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Log.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"

namespace stroma::mechanics {

using material::Compressibility;

Method method_of(const GridParameters& parameters, const Compressibility& of_volume) {
  Method method;
  method.reset = parameters.reset;
  method.shape_functions = parameters.shape_functions;
  method.particle_domain = parameters.particle_domain;
  method.deformation_gradient = parameters.deformation_gradient;
  method.stabilization = parameters.stabilization.value_or(parameters.reset ? 0.01 : 2e-5);
  const bool needs_mean = shape::kind_of(parameters.shape_functions).locks &&
                          of_volume.largest_poisson_ratio > locking_poisson_ratio;
  const bool knows_mean = parameters.deformation_gradient == DeformationGradient::incremental &&
                          of_volume.may_be_averaged;
  const bool is_mean = parameters.dilatation == DilatationChoice::automatic
                           ? needs_mean && knows_mean
                           : parameters.dilatation == DilatationChoice::element_mean;
  method.springs_pull_on =
      parameters.reset;  // without, faces have nodes, and stiff ones cost little
  method.dilatation = is_mean ? Dilatation::element_mean : Dilatation::pointwise;
  return method;
}

std::string describe_dilatation(const GridParameters& parameters,
                                const Compressibility& of_volume) {
  const bool is_mean = method_of(parameters, of_volume).dilatation == Dilatation::element_mean;
  std::string text = is_mean ? "Element Mean" : "Pointwise";
  if (parameters.dilatation == DilatationChoice::automatic)
    text += base::format(" (Automatic, for Poisson ratios up to %.6g)",
                         of_volume.largest_poisson_ratio);
  return text;
}

std::string locking_note(const GridParameters& parameters, const Compressibility& of_volume) {
  const shape::ShapeKind& kind = shape::kind_of(parameters.shape_functions);
  if (!kind.locks || of_volume.largest_poisson_ratio < locking_poisson_ratio) return "";
  if (method_of(parameters, of_volume).dilatation != Dilatation::pointwise)
    return !kind.is_centered
               ? ""
               : base::format(
                     "Dilatation = Element Mean takes a part of their locking from Shape Functions = "
                     "%s at a Poisson ratio of %.6g: where few elements are across, the body is still "
                     "too stiff; Linear with Element Mean, or B-splines, cure it",
                     kind.name, of_volume.largest_poisson_ratio);
  const bool is_projected =
      parameters.deformation_gradient == DeformationGradient::projected_displacement;
  return base::format(
             "Grid|Dilatation = Pointwise%s lets these shape functions lock at a Poisson ratio of "
             "%.6g: the body is too stiff, the more so the nearer it is to 0.5; ",
             parameters.dilatation == DilatationChoice::automatic ? " (by Automatic)" : "",
             of_volume.largest_poisson_ratio) +
         (!of_volume.may_be_averaged
              ? "a law without an energy of volume admits no other; B-splines cure it"
          : is_projected ? "Deformation Gradient = Projected Displacement admits no other; "
                           "\"Incremental\" with \"Element Mean\", or B-splines, cure it"
                         : "\"Element Mean\", or B-splines, cure it");
}

}  // namespace stroma::mechanics
