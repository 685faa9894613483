// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Pressure in a label, against Lame's solutions for a tube, a hollow ball and a hole in a block, and
/// its derivatives. Claims V-PRESS-1, V-PRESS-2, V-PRESS-3 and V-PRESS-4, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "stroma/mechanics/problem/VectorField.hpp"
#include "support/LoadSteps.hpp"
#include "support/Specimen.hpp"

namespace stroma {
namespace {

using mechanics::Face;

constexpr double mu = 500.0, nu = 0.3;
const double K = material::bulk_modulus(mu, nu), E = 2.0 * mu * (1.0 + nu);
constexpr double outer = 10.0, inner = 5.0;  // radii [um]

/// A wall between two radii, empty outside, filled with a pressure; a quarter of the tube, an eighth
/// of the ball, on rollers. Half an element is a voxel, with a particle at its centre.
test::Specimen hollow(bool ball, std::int64_t elements, double pressure) {
  test::Specimen specimen;
  const double h = outer / static_cast<double>(elements);
  specimen.elements = {elements, elements, ball ? elements : 1};
  specimen.spacing = {h, h, h};
  specimen.plane_strain = !ball;
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.label = [h, ball](const grid::Index3& voxel) {
    const auto at = [&](std::size_t d) { return 0.5 * h * (static_cast<double>(voxel[d]) + 0.5); };
    const double r = std::hypot(at(0), at(1), ball ? at(2) : 0.0);
    return r < inner ? 1 : r < outer ? 0 : -1;
  };
  specimen.other_laws = mechanics::LawList{
      {material::NeoHookean{mu, K}, material::Pressure{pressure, 1e-4 * mu}}, {}};
  specimen.drives.resize(2);
  specimen.stabilization = 2e-5;
  specimen.conditions = {{"left", test::hold(Face::x_lower, "x")},
                         {"bottom", test::hold(Face::y_lower, "y")}};
  if (ball) specimen.conditions.emplace_back("back", test::hold(Face::z_lower, "z"));
  return specimen;
}

/// Of the volumes of the whole and of the lumen, as voxels have them.
double ratio_of_volumes(const test::Specimen& specimen) {
  const auto size = specimen.voxels();
  double whole = 0.0, lumen = 0.0;
  for (std::int64_t k = 0; k < size[2]; ++k)
    for (std::int64_t j = 0; j < size[1]; ++j)
      for (std::int64_t i = 0; i < size[0]; ++i) {
        const std::int32_t label = specimen.label({i, j, k});
        whole += label >= 0 ? 1.0 : 0.0;
        lumen += label == 1 ? 1.0 : 0.0;
      }
  return whole / lumen;
}

solver::SolverParameters by_multigrid() {
  solver::SolverParameters parameters;
  parameters.newton_tolerance = 1e-9;
  parameters.linear_tolerance = 1e-8;
  return parameters;
}

/// How much the lumen's volume has grown, as a share of it.
double swelling(const test::Specimen& specimen, int steps = 1) {
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::world());
  double share = 0.0;
  test::take_steps(body, steps, by_multigrid(), [&](double, const grid::Vector& u) {
    const auto& particles = body.balance().body().particles();
    const auto fields = body.balance().body().particle_fields(u);
    double sums[2] = {};
    for (int p = 0; p < particles.count(); ++p) {
      if (particles.material(p) != 1) continue;
      sums[0] += particles.volume(p);
      sums[1] += particles.volume(p) * (fields.jacobian(p) - 1.0);
    }
    body.balance().body().communicator().sum_all(sums, 2);
    share = sums[1] / sums[0];
  });
  return share;
}

// u(a) = p a^2 / (b^2 - a^2) (1 + nu) / E ((1 - 2 nu) a + b^2 / a) in plane strain.
TEST(Pressure, WidensATubeAsLameSays) {
  const double p = 1e-3 * mu;
  double before = 1.0;
  for (const int elements : {8, 16, 32, 64}) {
    const test::Specimen tube = hollow(false, elements, p);
    const double ratio = ratio_of_volumes(tube);  // b^2 / a^2
    const double exact = 2.0 * p / (ratio - 1.0) * (1.0 + nu) / E * (1.0 - 2.0 * nu + ratio);
    const double error = std::abs(swelling(tube) / exact - 1.0);
    std::printf("  %d elements: %.2e\n", elements, error);
    if (elements > 8) {
      EXPECT_LT(error, 0.8 * before);
    }
    before = error;
  }
  EXPECT_LT(before, 1e-2);
}

// u(a) = p a^3 / (b^3 - a^3) / E ((1 - 2 nu) a + (1 + nu) b^3 / (2 a^2)).
TEST(Pressure, WidensAHollowBallAsLameSays) {
  const double p = 1e-3 * mu;
  double before = 1e-2;
  for (const int elements : {24, 32, 48}) {
    const test::Specimen ball = hollow(true, elements, p);
    const double ratio = ratio_of_volumes(ball);  // b^3 / a^3
    const double exact = 3.0 * p / (ratio - 1.0) / E * (1.0 - 2.0 * nu + 0.5 * (1.0 + nu) * ratio);
    const double error = std::abs(swelling(ball) / exact - 1.0);
    std::printf("  %d elements: %.2e\n", elements, error);
    EXPECT_LT(error, 0.85 * before);
    before = error;
  }
}

/// A condition that moves a face by Lame's displacement about a hole of pressure in an infinite solid,
/// u = A X / |X|^3, exact at the nodes of a lattice of so many elements.
mechanics::BoundaryCondition moved_as_lame_says(Face face, std::int64_t elements, double A) {
  const double h = outer / static_cast<double>(elements);
  const std::int64_t n = elements + 1;
  mechanics::VectorField::Block block{{{0, 0, 0}, {n, n, n}}, {}};
  grid::for_each_index(grid::Box{{0, 0, 0}, {n, n, n}}, [&](const grid::Index3& node) {
    std::array<double, 3> X{};
    for (std::size_t d = 0; d < 3; ++d) X[d] = h * static_cast<double>(node[d]);
    const double r = std::max(std::hypot(X[0], X[1], X[2]), 0.5 * h);
    for (std::size_t d = 0; d < 3; ++d) block.values[d].push_back(A * X[d] / (r * r * r));
  });
  mechanics::BoundaryCondition condition;
  condition.face = face;
  condition.components = "xyz";
  condition.images.emplace();
  condition.field = std::make_shared<mechanics::VectorField>(
      "Lame", mechanics::VoxelLattice{{n, n, n}, {h, h, h}, {-0.5 * h, -0.5 * h, -0.5 * h}},
      std::vector<mechanics::VectorField::Block>{block}, A / (outer * outer));
  return condition;
}

// u(r) = p a^3 / (4 mu r^2), in a block of four of the hole's radii whose outer faces move as they
// would in a solid without end. The hole's steps shrink with the voxels.
TEST(Pressure, WidensAHoleInABlockAsLameSays) {
  const double p = 1e-3 * mu;
  for (const int elements : {24, 32, 48, 64}) {
    test::Specimen block = hollow(true, elements, p);
    const double h = outer / elements;
    block.label = [h](const grid::Index3& voxel) {
      const auto at = [&](std::size_t d) {
        return 0.5 * h * (static_cast<double>(voxel[d]) + 0.5);
      };
      return std::hypot(at(0), at(1), at(2)) < 0.25 * outer ? 1 : 0;
    };
    const double hole = 8.0 * std::pow(outer, 3) / ratio_of_volumes(block);  // 4/3 pi a^3
    const double A = p / (4.0 * mu) * hole * 0.75 / std::acos(-1.0);
    for (const Face face : {Face::x_upper, Face::y_upper, Face::z_upper})
      block.conditions.emplace_back("far" + std::to_string(static_cast<int>(face)),
                                    moved_as_lame_says(face, elements, A));
    const double error = std::abs(swelling(block) / (0.75 * p / mu) - 1.0);
    std::printf("  %d elements: %.2e\n", elements, error);
    EXPECT_LT(error, 0.36 / elements);
  }
}

// It follows the deformation: the pressure that it takes to widen a tube of neo-Hookean solid that
// hardly changes its volume by a half, by the integral of mu (l^2 - l^-2) dr / r over the wall, l the
// stretch along the circumference.
TEST(Pressure, FollowsTheDeformation) {
  const double nearly = 0.49, bulk = material::bulk_modulus(mu, nearly);
  const double stretch = 1.5, a = stretch * inner;  // [um]
  double pressure = 0.0;
  constexpr int intervals = 4000;
  const double b = std::sqrt(outer * outer + a * a - inner * inner), dr = (b - a) / intervals;
  for (int n = 0; n < intervals; ++n) {
    const double r = a + (n + 0.5) * dr, R = std::sqrt(r * r - a * a + inner * inner), l = r / R;
    pressure += mu * (l * l - 1.0 / (l * l)) * dr / r;
  }
  test::Specimen specimen = hollow(false, 32, pressure);
  specimen.other_laws = mechanics::LawList{
      {material::NeoHookean{mu, bulk}, material::Pressure{pressure, 1e-4 * mu}}, {}};
  const double found = std::sqrt(1.0 + swelling(specimen, 20));
  std::printf("  widened to %.4f of %.4f by %.1f Pa\n", found, stretch, pressure);
  EXPECT_NEAR(found, stretch, 0.02 * stretch);
}

// Force is the derivative of the energy, and tangent that of the force.
TEST(Pressure, HasConsistentDerivatives) {
  material::AnyLaw law{material::Pressure{300.0, 20.0}};
  law.drive({0.7, 0.0});
  tensor::Tensor3 H;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) H(i, j) = 0.1 * std::sin(3.0 * i + 5.0 * j + 1.0);
  const tensor::Tensor3 sigma = material::cauchy_stress(law, H);
  const tensor::Tensor3 solid = material::cauchy_stress(material::Pressure{0.0, 20.0}.solid(), H);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(sigma(i, j) - solid(i, j), i == j ? -210.0 : 0.0, 1e-11);
  // dW = tau : D for dF = D F.
  const tensor::Tensor3 tau = material::kirchhoff_stress(law, H);
  const double step = 1e-5;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      tensor::Tensor3 D;
      D(i, j) = step;
      const tensor::Tensor3 change = D + D * H;
      const double rate =
          (material::energy(law, H + change) - material::energy(law, H - change)) / (2.0 * step);
      EXPECT_NEAR(rate, tau(i, j), 1e-6 * 300.0);
    }
}

}  // namespace
}  // namespace stroma
