// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The geometric multigrid: Galerkin operators, a symmetric cycle, convergence that does not depend
/// on size, contrast, ranks or the shape of the body. Claims V-GMG-1 to V-GMG-6,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/LinearSolver.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma::solver {
namespace {

using grid::NodeField;
using multigrid::ElementPatches;
using multigrid::GeometricMultigrid;
using multigrid::MultigridSettings;
using test::Specimen;

/// Bars of label 1 through the whole body, one in four along each direction.
std::int32_t lattice(const grid::Index3& voxel) {
  const auto in_bar = [&](int a, int b) { return voxel[a] % 8 < 3 && voxel[b] % 8 < 3; };
  return in_bar(0, 1) || in_bar(1, 2) || in_bar(0, 2) ? 1 : 0;
}

Specimen block(const grid::Index3& elements) {
  Specimen specimen;
  specimen.elements = elements;
  specimen.label = lattice;
  specimen.conditions = test::clamped(0.1);
  return specimen;
}

/// Odd counts, empty space, rollers and held rigid motions; or a slice in plane strain.
Specimen awkward(bool slice) {
  Specimen specimen = block({13, 11, 7});
  specimen.label = [](const grid::Index3& voxel) {
    return voxel[0] > 15 && voxel[1] > 11 ? -1 : lattice(voxel);
  };
  specimen.conditions = {{"bottom", test::hold(mechanics::Face::y_lower, "y")},
                         {"top", test::stretch(mechanics::Face::y_upper, "y", 0.1)}};
  if (slice) {
    specimen.elements = {21, 18, 1};
    specimen.plane_strain = true;
    specimen.label = [](const grid::Index3& voxel) {
      return voxel[0] > 25 && voxel[1] > 21 ? -1 : lattice({voxel[0], voxel[1], 4});
    };
  }
  return specimen;
}

/// A body's tangent at some displacement, and cycles for it.
struct Problem {
  std::unique_ptr<mechanics::MomentumBalance> balance;
  grid::RCP<tangent::StencilMatrix> matrix;
  grid::RCP<GeometricMultigrid> cycle;

  Problem(const Specimen& specimen, const base::Communicator& communicator,
          const MultigridSettings& settings, double displaced = 0.05, bool with_patches = true)
      : balance(specimen.balance(communicator)) {
    balance->choose_tangent(mechanics::TangentForm::stencil);
    grid::Vector u = scattered(0, displaced);
    balance->supports().clear(u);
    balance->assemble_tangent(u);
    matrix = Teuchos::rcp_dynamic_cast<tangent::StencilMatrix>(balance->tangent());
    cycle = Teuchos::rcp(new GeometricMultigrid(
        matrix, balance->halo().partition().grid().spacing,
        with_patches ? mechanics::barely_held_elements(*balance) : ElementPatches::Chosen(),
        settings));
    cycle->compute();
  }

  grid::Vector scattered(int seed, double size) const {
    grid::Vector v(balance->owned_map());
    test::fill(balance->halo(), v, [&](const grid::Index3& node, int c) {
      return size * test::scatter(node, c, seed);
    });
    return v;
  }
};

/// A level that takes so little work to factorise that there are many above it.
MultigridSettings many_levels() {
  MultigridSettings settings;
  settings.direct_work = 1e6;
  return settings;
}

/// Iterations of conjugate gradients to 1e-6 for a right-hand side K v, v without pattern.
int iterations(const Problem& problem) {
  grid::Vector v = problem.scattered(1, 1.0), b(v, Teuchos::Copy), x(v.getMap());
  problem.balance->supports().clear(v);
  problem.matrix->apply(v, b);
  // Plain preconditioned conjugate gradients.
  grid::Vector r(b, Teuchos::Copy), z(v.getMap()), p(v.getMap()), Kp(v.getMap());
  double rho = 1.0;
  for (int n = 1; n <= 400; ++n) {
    problem.cycle->apply(r, z);
    const double next = r.dot(z);
    EXPECT_GT(next, 0.0) << "the cycle is indefinite";
    if (n == 1)
      p.update(1.0, z, 0.0);
    else
      p.update(1.0, z, next / rho);
    rho = next;
    problem.matrix->apply(p, Kp);
    const double alpha = rho / p.dot(Kp);
    x.update(alpha, p, 1.0);
    r.update(-alpha, Kp, 1.0);
    if (r.norm2() <= 1e-6 * b.norm2()) {
      problem.matrix->apply(x, b, Teuchos::NO_TRANS, -1.0, 1.0);
      EXPECT_NEAR(b.norm2(), r.norm2(), 0.1 * r.norm2());  // that is the true residual
      return n;
    }
  }
  return 401;
}

class Bodies : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(GeometricMultigrid, Bodies, ::testing::Bool(),
                         [](const auto& slice) { return slice.param ? "slice" : "block"; });

// K_c w = P^T K P w on every level, whatever w.
TEST_P(Bodies, CoarseOperatorsAreGalerkins) {
  const Problem problem(awkward(GetParam()), world(), many_levels());
  const GeometricMultigrid& cycle = *problem.cycle;
  ASSERT_GE(cycle.levels(), GetParam() ? 2 : 3);
  for (int level = 0; level + 1 < cycle.levels(); ++level) {
    const grid::BoxExchange fine(world(), cycle.grid(level)),
        coarse(world(), cycle.grid(level + 1));
    const NodeField<float> w("w", coarse.grid()), Kw("Kw", coarse.grid()), Pw("Pw", fine.grid()),
        KPw("KPw", fine.grid()), projected("PKPw", coarse.grid());
    const grid::LevelGrid& grid = coarse.grid();
    for (int k = 0; k < w.nodes[2]; ++k)
      for (int j = 0; j < w.nodes[1]; ++j)
        for (int c = 0; c < 3; ++c)
          for (int i = 0; i < w.nodes[0]; ++i)
            w.line(c, j + w.nodes[1] * k)[i] = static_cast<float>(test::scatter(
                {grid.first_node(0) + i, grid.first_node(1) + j, grid.first_node(2) + k}, c));
    cycle.stencil(level + 1).multiply(w, Kw);
    coarse.sum(Kw);
    cycle.transfer(level).add_interpolated(w, Pw);
    cycle.stencil(level).multiply(Pw, KPw);
    cycle.transfer(level).restrict_to(KPw, projected);
    coarse.sum(projected);
    double largest = 0.0, difference = 0.0;
    for (int line = 0; line < w.lines(); ++line)
      for (int c = 0; c < 3; ++c)
        for (int i = 0; i < w.nodes[0]; ++i) {
          const double a = Kw.line(c, line)[i], b = projected.line(c, line)[i];
          largest = std::max(largest, std::abs(a));
          difference = std::max(difference, std::abs(a - b));
        }
    largest = world().max(largest);
    EXPECT_GT(largest, 0.0);
    EXPECT_LT(difference, 1e-5 * largest) << "level " << level;
  }
}

// V-GMG-2.
TEST_P(Bodies, TheCycleIsSymmetric) {
  const Problem problem(awkward(GetParam()), world(), many_levels());
  for (int seed = 1; seed < 4; ++seed) {
    const grid::Vector x = problem.scattered(seed, 1.0), y = problem.scattered(seed + 7, 1.0);
    grid::Vector Mx(x.getMap()), My(x.getMap());
    problem.cycle->apply(x, Mx);
    problem.cycle->apply(y, My);
    EXPECT_NEAR(x.dot(My), y.dot(Mx), 3e-6 * x.norm2() * My.norm2());
    EXPECT_GT(x.dot(Mx), 0.0);
  }
}

// Each rank also has the whole problem to itself. Coarse grids differ where a rank's odd count is
// cut elsewhere, so that counts may differ by one or two.
TEST_P(Bodies, CountsHardlyDependOnTheRanks) {
  const Problem together(awkward(GetParam()), world(), many_levels());
  const Problem alone(awkward(GetParam()), base::Communicator::self(), many_levels());
  const int several = iterations(together), one = iterations(alone);
  EXPECT_LE(one, 20);
  EXPECT_NEAR(several, one, 2);
}

/// ||error|| after a cycle / before, in the energy norm, of the worst of many.
double worst_reduction(const Problem& problem) {
  grid::Vector e = problem.scattered(3, 1.0), Ke(e.getMap()), correction(e.getMap());
  problem.balance->supports().clear(e);
  double worst = 0.0, before = 0.0;
  for (int n = 0; n < 15; ++n) {
    problem.matrix->apply(e, Ke);
    const double energy = e.dot(Ke);
    if (n > 0) worst = std::max(worst, std::sqrt(energy / before));
    before = energy;
    problem.cycle->apply(Ke, correction);
    e.update(-1.0, correction, 1.0);
    const double scale = 1.0 / std::sqrt(energy);  // stays clear of rounding
    e.scale(scale);
    before *= scale * scale;
  }
  return worst;
}

// V-GMG-3.
// Two levels, the second solved exactly: the error's energy norm shrinks at least threefold a
// cycle, at two sizes.
TEST(GeometricMultigrid, TwoLevelsConverge) {
  for (const std::int64_t n : {8, 16}) {
    MultigridSettings settings;
    settings.direct_work = n == 8 ? 1e7 : 3e8;
    const Problem problem(block({n, n, n}), world(), settings);
    ASSERT_EQ(problem.cycle->levels(), 2);
    const double reduction = worst_reduction(problem);
    EXPECT_LT(reduction, 1.0 / 3.0) << n << " elements a side";
    RecordProperty("reduction_" + std::to_string(n), std::to_string(reduction));
  }
}

// V-GMG-4.
TEST(GeometricMultigrid, CountsDoNotGrowWithSize) {
  for (const std::int64_t n : {8, 16, 32}) {
    const Problem problem(block({n, n, n / 2 + 1}), world(), many_levels());
    const int count = iterations(problem);
    EXPECT_LE(count, 12) << n << " elements a side";
    if (world().is_root()) std::printf("  %d elements a side: %d\n", static_cast<int>(n), count);
  }
}

// V-GMG-5.
TEST(GeometricMultigrid, CopesWithContrast) {
  for (const double contrast : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    Specimen specimen = block({16, 16, 16});
    specimen.laws[1] = {contrast * specimen.laws[0].shear_modulus,
                        contrast * specimen.laws[0].bulk_modulus};
    const Problem problem(specimen, world(), many_levels());
    const int count = iterations(problem);
    EXPECT_LE(count, contrast <= 100.0 ? 40 : 400) << "vessels " << contrast << " times stiffer";
    if (world().is_root()) std::printf("  contrast %g: %d\n", contrast, count);
  }
}

TEST(GeometricMultigrid, CopesWithNearlyIncompressibleMaterials) {
  Specimen specimen = block({16, 16, 16});
  for (auto& law : specimen.laws)
    law.bulk_modulus = 2.0 * law.shear_modulus * 1.49 / (3.0 * (1.0 - 2.0 * 0.49));
  const Problem problem(specimen, world(), many_levels());
  const int count = iterations(problem);
  EXPECT_LE(count, 40);
  if (world().is_root()) std::printf("  nu = 0.49: %d\n", count);
}

// A part that hangs free has a singular tangent; a right-hand side that does not push it is solved.
TEST(GeometricMultigrid, CopesWithAPartThatHangsFree) {
  Specimen specimen = block({16, 16, 8});
  specimen.label = [](const grid::Index3& voxel) {
    const auto inside = [&](int least, int most) {
      for (int d = 0; d < 3; ++d)
        if (voxel[d] < least || voxel[d] > most - (d == 2 ? 16 : 0)) return false;
      return true;
    };
    return inside(6, 25) ? 0 : inside(4, 27) ? -1 : lattice(voxel);
  };
  const Problem problem(specimen, world(), many_levels());
  EXPECT_LE(iterations(problem), 40);
}

/// A gyroid's solid third: struts of two voxels or so, elements that hold one to seven of eight.
Specimen sponge(const grid::Index3& elements) {
  Specimen specimen;
  specimen.elements = elements;
  specimen.layout = {particles::Layout::voxel_centers, 1, 2};
  specimen.label = [](const grid::Index3& voxel) {
    double s[3], c[3];
    for (std::size_t d = 0; d < 3; ++d) {
      const double phase = 0.83 * static_cast<double>(voxel[d]);
      s[d] = std::sin(phase);
      c[d] = std::cos(phase);
    }
    return s[0] * c[1] + s[1] * c[2] + s[2] * c[0] > 0.5 ? 0 : -1;
  };
  specimen.conditions = test::clamped(0.001);
  specimen.stabilization = 2e-5;
  return specimen;
}

// V-GMG-7.
// Barely filled elements have soft modes of their own. A cycle that solves on them is definite and
// needs a fraction of the iterations; on several ranks about as many.
TEST(GeometricMultigrid, SolvesOnBarelyFilledElementsByThemselves) {
  const Specimen specimen = sponge({12, 12, 12});
  const Problem together(specimen, world(), many_levels(), 0.0);
  const Problem alone(specimen, base::Communicator::self(), many_levels(), 0.0);
  const Problem plain(specimen, world(), many_levels(), 0.0, false);
  const int several = iterations(together), one = iterations(alone), without = iterations(plain);
  if (world().is_root()) std::printf("  %d, by block Jacobi %d\n", several, without);
  EXPECT_LE(one, 40);
  EXPECT_LE(several, 1.25 * one);
  EXPECT_GT(without, 1.5 * several);
  const grid::Vector x = together.scattered(1, 1.0), y = together.scattered(2, 1.0);
  grid::Vector Mx(x.getMap()), My(x.getMap());
  together.cycle->apply(x, Mx);
  together.cycle->apply(y, My);
  EXPECT_NEAR(x.dot(My), y.dot(Mx), 1e-4 * x.norm2() * My.norm2());
}

}  // namespace
}  // namespace stroma::solver
