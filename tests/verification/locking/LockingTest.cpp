/// \file
/// A nearly incompressible block between clamps, nu = 0.499: with the mean dilatation of elements
/// its force hardly depends on the elements, without it they lock. Claim V-LOCK-5,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "material/Material.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

using grid::Dilatation;
using grid::ShapeFunctions;
using mechanics::Face;
using test::Specimen;

struct Method {
  const char* name;
  ShapeFunctions shape_functions;
  bool reset;
  double same;    ///< largest departure of 4 elements from 8 with the element's mean
  double locked;  ///< least departure without it
};

/// Force [pN] at 5 % of stretch in plane strain, on elements x elements.
double force(const Method& method, Dilatation dilatation, int elements) {
  const base::Communicator world = base::Communicator::world();
  Specimen specimen;
  specimen.elements = {elements, elements, 1};
  specimen.spacing = {8.4 / elements, 8.4 / elements, 1.0};
  specimen.plane_strain = true;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.laws = {{520.8, material::bulk_modulus(520.8, 0.499)}};
  specimen.shape_functions = method.shape_functions;
  specimen.reset = method.reset;
  specimen.stabilization = method.reset ? 0.01 : 0.0;
  specimen.dilatation = dilatation;
  specimen.conditions = test::clamped(0.05);
  mechanics::MovingBody body = specimen.moving_body(world);
  solver::SolverParameters parameters;
  parameters.preconditioner = solver::PreconditionerKind::direct;
  double result = 0.0;
  test::take_steps(body, 5, parameters,
                   [&](double, const grid::Vector& u) { result = test::reactions(body, u)[1][1]; });
  return result;
}

class Locking : public ::testing::TestWithParam<Method> {};

TEST_P(Locking, IsCuredByTheMeanDilatation) {
  const Method& method = GetParam();
  const double fine = force(method, Dilatation::element_mean, 8);
  const double mean = force(method, Dilatation::element_mean, 4) / fine - 1.0;
  const double locked = force(method, Dilatation::pointwise, 4) / fine - 1.0;
  const double locked_fine = force(method, Dilatation::pointwise, 8) / fine - 1.0;
  if (base::Communicator::world().is_root())
    std::printf("  %.1f pN with the mean of 8 x 8 elements; 4 x 4: %+.3f; pointwise: %+.3f, %+.3f\n",
                fine, mean, locked, locked_fine);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Locking,
    ::testing::Values(Method{"linear", ShapeFunctions::linear, false, 0.1, 0.5},
                      Method{"gimp", ShapeFunctions::gimp, false, 0.1, 0.5},
                      Method{"cpdi", ShapeFunctions::cpdi, false, 0.1, 0.5},
                      Method{"quadratic", ShapeFunctions::quadratic_b_spline, false, 0.1, 0.1},
                      Method{"cubic", ShapeFunctions::cubic_b_spline, false, 0.1, 0.1},
                      Method{"linear_reset", ShapeFunctions::linear, true, 0.1, 0.5},
                      Method{"gimp_reset", ShapeFunctions::gimp, true, 0.1, 0.5},
                      Method{"cpdi_reset", ShapeFunctions::cpdi, true, 0.1, 0.5},
                      Method{"quadratic_reset", ShapeFunctions::quadratic_b_spline, true, 0.1, 0.1},
                      Method{"cubic_reset", ShapeFunctions::cubic_b_spline, true, 0.1, 0.1}),
    [](const auto& method) { return std::string(method.param.name); });

}  // namespace
}  // namespace stroma
