// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Nearly incompressible blocks in plane strain, nu = 0.499: hats, GIMP and CPDI lock, and the mean
/// dilatation of elements cures them; B-splines lock little. The figures they should tend to were
/// found by another program (docs/verification.md, "Locking"). Claims V-LOCK-5 to V-LOCK-7.

#include <gtest/gtest.h>

#include "stroma/material/Material.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::Dilatation;
using mechanics::Face;
using shape::ShapeFunctions;
using test::Specimen;

/// A square of 8 x 8 um.
Specimen block(ShapeFunctions shape_functions, Dilatation dilatation, int elements) {
  Specimen specimen;
  specimen.elements = {elements, elements, 1};
  specimen.spacing = {8.0 / elements, 8.0 / elements, 1.0};
  specimen.plane_strain = true;
  specimen.layout = {particles::Layout::per_element, 1, 2};
  specimen.laws = {{520.8, material::bulk_modulus(520.8, 0.499)}};
  specimen.shape_functions = shape_functions;
  specimen.dilatation = dilatation;
  return specimen;
}

solver::SolverParameters direct() {
  solver::SolverParameters parameters;
  parameters.preconditioner = solver::PreconditionerKind::direct;
  return parameters;
}

/// Force [pN] of the block that is stretched by 5 % between clamps, less the true one, by the true
/// one.
double excess_force(ShapeFunctions shape_functions, Dilatation dilatation, int elements) {
  constexpr double exact = 1012.0;
  Specimen specimen = block(shape_functions, dilatation, elements);
  specimen.conditions = test::clamped(0.05);
  mechanics::MovingBody body = specimen.moving_body(world());
  double force = 0.0;
  test::take_steps(body, 5, direct(),
                   [&](double, const grid::Vector& u) { force = test::reactions(body, u)[1][1]; });
  return force / exact - 1.0;
}

/// Mean displacement along x [um] of the block that stands on a clamp under a body force along x,
/// on a grid that is reset, by the true one.
double motion(ShapeFunctions shape_functions, Dilatation dilatation, int elements) {
  constexpr double exact = 0.306;
  Specimen specimen = block(shape_functions, dilatation, elements);
  specimen.reset = true;
  specimen.stabilization = 0.01;
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")}};
  specimen.conditions[0].second.imposed_by = mechanics::ImposedBy::nodes;
  mechanics::ExternalForce push;
  push.body_force = {5.0, 0.0, 0.0};
  specimen.forces = {{"push", push}};
  mechanics::MovingBody body = specimen.moving_body(world());
  double mean = 0.0;
  test::take_steps(body, 5, direct(), [&](double, const grid::Vector& u) {
    const auto displacement = Kokkos::create_mirror_view_and_copy(
        Kokkos::HostSpace(), body.balance().body().particle_fields(u).displacement);
    double sum = 0.0;
    for (std::size_t p = 0; p < displacement.extent(0); ++p) sum += displacement(p, 0);
    mean = world().sum(sum) / world().sum(static_cast<double>(displacement.extent(0)));
  });
  return mean / exact;
}

struct Kind {
  const char* name;
  ShapeFunctions shape_functions;
};

const Kind that_lock[] = {{"linear", ShapeFunctions::linear},
                          {"gimp", ShapeFunctions::gimp},
                          {"cpdi", ShapeFunctions::cpdi}};
const Kind splines[] = {{"quadratic", ShapeFunctions::quadratic_b_spline},
                        {"cubic", ShapeFunctions::cubic_b_spline}};

/// A figure on 4 x 4 and 8 x 8 elements, with the mean and pointwise.
struct Found {
  double mean_4, mean_8, pointwise_4, pointwise_8;
};

template <class Figure>
Found found(const Kind& kind, const Figure& figure) {
  const Found f{figure(kind.shape_functions, Dilatation::element_mean, 4),
                figure(kind.shape_functions, Dilatation::element_mean, 8),
                figure(kind.shape_functions, Dilatation::pointwise, 4),
                figure(kind.shape_functions, Dilatation::pointwise, 8)};
  if (world().is_root())
    std::printf("  %s, 4 and 8 elements: mean %+.3f %+.3f, pointwise %+.3f %+.3f\n", kind.name,
                f.mean_4, f.mean_8, f.pointwise_4, f.pointwise_8);
  return f;
}

// V-LOCK-5.
TEST(Locking, OfAStretchedBlockIsCured) {
  for (const Kind& kind : that_lock) {
    SCOPED_TRACE(kind.name);
    const Found f = found(kind, excess_force);
    const bool hats = kind.shape_functions == ShapeFunctions::linear;
    EXPECT_LT(f.mean_4, hats ? 0.04 : 0.26);  // the elements of GIMP and CPDI overhang the clamps
    EXPECT_LT(f.mean_8, hats ? 0.02 : 0.08);
    EXPECT_GT(f.mean_8, 0.0);
    EXPECT_GT(f.pointwise_4, 4.0);
    EXPECT_GT(f.pointwise_8, 1.0);
  }
}

// V-LOCK-6. On a grid that is reset, where the same block moves too little when it locks.
TEST(Locking, OfAPushedBlockIsCuredOnAGridThatIsReset) {
  for (const Kind& kind : that_lock) {
    SCOPED_TRACE(kind.name);
    const Found f = found(kind, motion);
    EXPECT_GT(f.mean_8, 0.9);
    EXPECT_LT(f.mean_8, 1.0);
    EXPECT_GT(f.mean_4, 0.8);
    EXPECT_LT(f.pointwise_4, 0.75);
    EXPECT_LT(f.pointwise_8, 0.8);
    EXPECT_GT((f.mean_8 - f.pointwise_8) / (1.0 - f.pointwise_8), 0.6);  // of what is missing
  }
}

// V-LOCK-7. Splines hardly lock, with the mean or without.
TEST(Locking, OfSplinesIsSlight) {
  for (const Kind& kind : splines) {
    SCOPED_TRACE(kind.name);
    const Found f = found(kind, excess_force);
    EXPECT_LT(std::abs(f.pointwise_4), 0.05);
    EXPECT_LT(std::abs(f.pointwise_8), 0.03);
    EXPECT_LT(std::abs(f.mean_4), 0.05);
    EXPECT_LT(std::abs(f.mean_8), 0.03);
    const Found g = found(kind, motion);
    EXPECT_NEAR(g.mean_8, 1.0, 0.12);
    EXPECT_NEAR(g.pointwise_8, 1.0, 0.12);
  }
}

}  // namespace
}  // namespace stroma
