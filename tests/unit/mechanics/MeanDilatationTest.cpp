// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The mean dilatation of elements: energy, force and tangent belong together, for all shape
/// functions, in space and in plane strain, on the undeformed base and on one that a grid reset has
/// made. Claims V-LOCK-1 to V-LOCK-4, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>

#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::mechanics {
namespace {

using material::VolumetricEnergy;
using shape::ShapeFunctions;
using test::Specimen;

struct Case {
  ShapeFunctions shape_functions;
  bool slice, reset;
  bool has_other_laws = false;
};

grid::Vector scattered(const MomentumBalance& balance, int seed, double size) {
  grid::Vector u(balance.owned_map());
  test::fill(balance.halo(), u,
             [&](const grid::Index3& node, int c) { return size * test::scatter(node, c, seed); });
  return u;
}

grid::Vector sum(const grid::Vector& a, double s, const grid::Vector& b) {
  grid::Vector result(a, Teuchos::Copy);
  result.update(s, b, 1.0);
  return result;
}

/// Elements of two materials with unlike energies of volume, some half empty.
Specimen specimen_of(const Case& c) {
  Specimen specimen;
  specimen.elements = {4, 4, 4};
  specimen.laws = {{520.8, 2430.4}, {1041.6, 9000.0, VolumetricEnergy::quadratic}};
  if (c.has_other_laws)
    specimen.other_laws = std::vector<material::AnyLaw>{
        material::MooneyRivlin{{2430.4}, 200.0, 60.4}, material::CoupledNeoHookean{1041.6, 9000.0}};
  specimen.label = [](const grid::Index3& voxel) {
    return voxel[0] > 5 && voxel[1] > 4 && voxel[2] > 4 ? -1 : test::crossing_bars(voxel);
  };
  if (c.slice) {
    specimen.elements = {6, 5, 1};
    specimen.plane_strain = true;
    specimen.label = [](const grid::Index3& voxel) {
      return voxel[0] > 9 && voxel[1] > 6 ? -1 : test::crossing_bars({voxel[0], voxel[1], 4});
    };
  }
  specimen.conditions = {{"bottom", test::hold(Face::y_lower, "xyz")}};
  specimen.shape_functions = c.shape_functions;
  specimen.dilatation = mechanics::Dilatation::element_mean;
  specimen.reset = c.reset;
  return specimen;
}

class MeanDilatation : public ::testing::TestWithParam<Case> {
 protected:
  /// A base that is the undeformed body, or a deformed one.
  static MovingBody body() {
    const Specimen specimen = specimen_of(GetParam());
    MovingBody body = specimen.moving_body(world());
    if (GetParam().reset) {
      body.accept(0.5, scattered(body.balance(), 7, 0.2));
      EXPECT_TRUE(body.begin_step());
    }
    return body;
  }

  static double energy(const MomentumBalance& balance, const grid::Vector& u) {
    const auto density = Kokkos::create_mirror_view_and_copy(
        Kokkos::HostSpace(), balance.body().particle_fields(u).energy);
    double total = 0.0;
    for (int p = 0; p < balance.body().particles().count(); ++p)
      total += balance.body().particles().volume(p) * density(p);
    return world().sum(total);
  }

  static grid::Vector force(const MomentumBalance& balance, const grid::Vector& u) {
    grid::Vector f(balance.owned_map());
    EXPECT_EQ(balance.internal_force(u, f), 0);
    return f;
  }
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto shape : {ShapeFunctions::linear, ShapeFunctions::gimp, ShapeFunctions::cpdi,
                           ShapeFunctions::quadratic_b_spline, ShapeFunctions::cubic_b_spline})
    for (const bool slice : {false, true})
      for (const bool reset : {false, true})
        for (const bool has_other_laws : {false, true})
          all.push_back({shape, slice, reset, has_other_laws});
  return all;
}

std::string name_of(const ::testing::TestParamInfo<Case>& c) {
  const char* const shapes[] = {"linear", "gimp", "cpdi", "quadratic", "cubic"};
  return std::string(shapes[static_cast<int>(c.param.shape_functions)]) +
         (c.param.slice ? "_slice" : "_block") + (c.param.reset ? "_reset" : "") +
         (c.param.has_other_laws ? "_other_laws" : "");
}

INSTANTIATE_TEST_SUITE_P(All, MeanDilatation, ::testing::ValuesIn(cases()), name_of);

TEST_P(MeanDilatation, ForceIsTheDerivativeOfTheEnergy) {
  const MovingBody moving = body();
  const MomentumBalance& balance = moving.balance();
  const grid::Vector u = scattered(balance, 0, 0.15), v = scattered(balance, 1, 1.0);
  const grid::Vector f = force(balance, u);
  const double power = f.dot(v);
  const auto error = [&](double h) {
    return std::abs((energy(balance, sum(u, h, v)) - energy(balance, sum(u, -h, v))) / (2.0 * h) -
                    power);
  };
  EXPECT_NEAR(std::log2(error(8e-3) / error(4e-3)), 2.0, 0.1);
  EXPECT_LT(error(1e-4), 1e-7 * f.norm2() * v.norm2());
}

TEST_P(MeanDilatation, TangentIsTheSymmetricDerivativeOfTheForce) {
  MovingBody moving = body();
  MomentumBalance& balance = moving.balance();
  const grid::Vector u = scattered(balance, 0, 0.15);
  grid::Vector v = scattered(balance, 1, 1.0), w = scattered(balance, 2, 1.0);
  balance.supports().clear(v);
  balance.supports().clear(w);

  grid::Vector product(balance.owned_map());
  balance.tangent_times(u, v, product);
  const auto error = [&](double h) {
    const grid::Vector change =
        sum(force(balance, sum(u, h, v)), -1.0, force(balance, sum(u, -h, v)));
    return sum(product, -0.5 / h, change).norm2();
  };
  EXPECT_NEAR(std::log2(error(8e-3) / error(4e-3)), 2.0, 0.1);
  EXPECT_LT(error(1e-5), 1e-7 * product.norm2());

  EXPECT_EQ(balance.assemble_tangent(u), 0);
  grid::Vector Kv(balance.owned_map()), Kw(balance.owned_map());
  balance.tangent()->apply(v, Kv);
  balance.tangent()->apply(w, Kw);
  balance.supports().clear(product);
  EXPECT_LT(sum(product, -1.0, Kv).normInf(), 1e-13 * Kv.normInf());
  EXPECT_NEAR(v.dot(Kw), w.dot(Kv), 1e-13 * v.norm2() * Kw.norm2());

  if (GetParam().shape_functions != ShapeFunctions::linear) return;
  balance.choose_tangent(TangentForm::stencil);
  balance.assemble_tangent(u);
  grid::Vector stencil(balance.owned_map());
  balance.tangent()->apply(v, stencil);
  EXPECT_LT(sum(stencil, -1.0, Kv).normInf(), 1e-6 * Kv.normInf());
}

// V-LOCK-2.
// The state that a step leaves to the next one is that of the mean: a grid reset changes no energy,
// and no volume. Of a law whose W1 is not isochoric (Law.hpp) it changes a little.
TEST_P(MeanDilatation, IsCarriedOnByAGridReset) {
  if (!GetParam().reset) GTEST_SKIP() << "without reset there is nothing to carry on";
  if (GetParam().has_other_laws) GTEST_SKIP() << "the coupled law's W1 is not isochoric";
  MovingBody moving = body();
  const grid::Vector u = scattered(moving.balance(), 0, 0.15);
  const double before = energy(moving.balance(), u);
  moving.accept(1.0, u);
  ASSERT_TRUE(moving.begin_step());
  const grid::Vector at_rest(moving.balance().owned_map());
  EXPECT_NEAR(energy(moving.balance(), at_rest), before, 1e-12 * before);
}

// V-LOCK-3.
// Where the strain is uniform the mean is everybody's own: energy and stress are those of the
// pointwise dilatation, and so is the force where the elements' material is uniform too; in a
// rotation by a radian, which strains nothing, there is none.
TEST_P(MeanDilatation, ChangesNothingWhereTheStrainIsUniform) {
  Specimen specimen = specimen_of(GetParam());
  specimen.label = [label = specimen.label](const grid::Index3& voxel) {
    return std::min(label(voxel), 0);
  };
  specimen.laws = {specimen.laws[1]};
  const auto mean = specimen.balance(world());
  specimen.dilatation = mechanics::Dilatation::pointwise;
  const auto pointwise = specimen.balance(world());
  const double c = std::cos(1.0), s = std::sin(1.0);
  const std::array<double, 9> strain{0.05, 0.20, 0, -0.10, 0.08, 0, 0, 0, 0};
  const std::array<double, 9> rotation{c - 1, -s, 0, s, c - 1, 0, 0, 0, 0};
  for (const auto& G : {strain, rotation}) {
    grid::Vector u(mean->owned_map());
    test::fill(mean->halo(), u, [&](const grid::Index3& node, int component) {
      return test::linear_field(mean->halo().partition().grid(), G, node, component);
    });
    const double stiffness = 9000.0 * 2.1 * 2.1;  // [pN] for a strain of one
    EXPECT_LT(sum(force(*mean, u), -1.0, force(*pointwise, u)).normInf(), 1e-12 * stiffness);
    EXPECT_NEAR(energy(*mean, u), energy(*pointwise, u), 1e-12 * (energy(*pointwise, u) + 9000.0));
    const auto a = mean->body().particle_fields(u), b = pointwise->body().particle_fields(u);
    for (int p = 0; p < mean->body().particles().count(); ++p) {
      EXPECT_NEAR(a.jacobian(p), b.jacobian(p), 1e-13);
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(a.stress(p, k), b.stress(p, k), 1e-12 * 9000.0);
    }
    if (G == rotation) {
      EXPECT_LT(force(*mean, u).normInf(), 1e-12 * stiffness);
    }
  }
  // Where it is not uniform, it is another force.
  const grid::Vector u = scattered(*mean, 0, 0.15);
  const grid::Vector f = force(*mean, u);
  EXPECT_GT(sum(f, -1.0, force(*pointwise, u)).norm2(), 0.05 * f.norm2());
}

// Turned by 0.4, three times, about a corner of the grid: on a grid that is reset, particles come
// to be averaged with others.
TEST_P(MeanDilatation, RigidMotionsLeaveNoStress) {
  Specimen specimen = specimen_of(GetParam());
  for (auto& named : specimen.conditions) named.second.imposed_by = ImposedBy::grip;  // rides along
  MovingBody moving = specimen.moving_body(world());
  for (int turn = 1; turn <= 3; ++turn) {
    const MomentumBalance& balance = moving.balance();
    const double angle = GetParam().reset ? 0.4 : 0.4 * turn;
    const double c = std::cos(angle), s = std::sin(angle);
    grid::Vector u(balance.owned_map());
    test::fill(balance.halo(), u, [&](const grid::Index3& node, int component) {
      return test::linear_field(balance.halo().partition().grid(),
                                {c - 1, -s, 0, s, c - 1, 0, 0, 0, 0}, node, component);
    });
    const auto fields = balance.body().particle_fields(u);
    for (int p = 0; p < balance.body().particles().count(); ++p) {
      EXPECT_NEAR(fields.jacobian(p), 1.0, 1e-12);
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(fields.stress(p, k), 0.0, 1e-11 * 9000.0);
    }
    moving.accept(turn, u);
    EXPECT_EQ(moving.begin_step(), GetParam().reset);
  }
}

// Displacements of 1e-12 um keep their digits: the force is the tangent at rest times them.
TEST_P(MeanDilatation, TinyStrainsKeepTheirDigits) {
  const auto balance = specimen_of(GetParam()).balance(world());
  const grid::Vector at_rest(balance->owned_map()), v = scattered(*balance, 1, 1e-12);
  grid::Vector Kv(balance->owned_map());
  balance->tangent_times(at_rest, v, Kv);
  const grid::Vector f = force(*balance, v);
  EXPECT_LT(sum(f, -1.0, Kv).normInf(), 1e-11 * Kv.normInf());
  EXPECT_NEAR(energy(*balance, v), 0.5 * v.dot(f), 1e-10 * v.dot(f));
}

}  // namespace
}  // namespace stroma::mechanics
