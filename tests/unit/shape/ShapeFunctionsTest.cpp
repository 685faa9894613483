// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Shape functions wider than hats: what they owe the method, and what makes them smooth. Claim
/// V-SHA-2, docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/shape/Cpdi.hpp"

namespace stroma::shape {
namespace {

using shape::ShapeFunctions;

template <class Shape_, ShapeFunctions kind_>
struct Kind {
  using Shape = Shape_;
  static constexpr ShapeFunctions kind = kind_;
};

/// The grid of one kind over a lattice of 5 x 4 x 3 elements, and points anywhere in it.
template <class Kind>
class ShapeFunctionsOf : public ::testing::Test {
 protected:
  using Shape = typename Kind::Shape;
  static constexpr int nodes = Shape::nodes;
  static constexpr int w = Shape::width;

  static grid::Grid make_grid() {
    grid::Grid lattice;
    lattice.elements = {5, 4, Shape::dimensions == 3 ? 3 : 1};
    lattice.origin = {-1.0, 2.0, 0.5};
    lattice.spacing = {2.1, 0.7, 3.3};
    lattice.flat = Shape::dimensions == 2;
    return grid::grid_for(Kind::kind, lattice);
  }

  struct Support {
    Place place;
    double N[nodes];
    double gradient[3][nodes];
  };

  /// Supports at a position, taken as a point of an element that may be given.
  static Support at(const grid::Grid& grid, const std::array<double, 3>& x, double extent,
                    const int* element = nullptr) {
    Support s{};
    for (int d = 0; d < 3; ++d) {
      const auto i = static_cast<std::size_t>(d);
      const double place = (x[i] - grid.origin[i]) / grid.spacing[i];
      s.place.element[d] = element ? element[d] : static_cast<int>(std::floor(place));
      s.place.elements[d] = static_cast<int>(grid.elements[i]);
      s.place.inverse_h[d] = 1.0 / grid.spacing[i];
      s.place.xi[d] = place - s.place.element[d];
      for (int e = 0; e < 3; ++e)  // sheared and turned a little
        s.place.domain[d][e] = extent * grid.spacing[i] * (d == e ? 1.0 : 0.2 * (d - e));
    }
    Shape::evaluate(s.place, s.N, s.gradient);
    return s;
  }

  static grid::Index3 node_of(const Support& s, int a) {
    return {s.place.element[0] + a % w, s.place.element[1] + a / w % w,
            Shape::dimensions == 3 ? s.place.element[2] + a / (w * w) : 0};
  }

  /// Points in the elements, some of them, or of their domains, beyond the ends.
  template <class Check>
  static void for_points(const Check& check) {
    const grid::Grid grid = make_grid();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inside(0.0, 1.0);
    for (int n = 0; n < 200; ++n) {
      std::array<double, 3> x;
      for (std::size_t d = 0; d < 3; ++d)
        x[d] = grid.origin[d] + inside(random) * grid.length(static_cast<int>(d));
      check(grid, x, 0.05 + 0.3 * inside(random));
    }
  }

  static constexpr int directions = Shape::dimensions;
};

using Kinds =
    ::testing::Types<Kind<Gimp<3>, ShapeFunctions::gimp>, Kind<Gimp<2>, ShapeFunctions::gimp>,
                     Kind<Cpdi<3>, ShapeFunctions::cpdi>, Kind<Cpdi<2>, ShapeFunctions::cpdi>,
                     Kind<BSpline<2, 3>, ShapeFunctions::quadratic_b_spline>,
                     Kind<BSpline<2, 2>, ShapeFunctions::quadratic_b_spline>,
                     Kind<BSpline<3, 3>, ShapeFunctions::cubic_b_spline>,
                     Kind<BSpline<3, 2>, ShapeFunctions::cubic_b_spline>>;
TYPED_TEST_SUITE(ShapeFunctionsOf, Kinds);

TYPED_TEST(ShapeFunctionsOf, SumToOneAndReproduceLinearFields) {
  const double slope[3] = {0.3, -1.7, 0.9};
  this->for_points([&](const grid::Grid& grid, const std::array<double, 3>& x, double extent) {
    const auto s = this->at(grid, x, extent);
    bool is_inside = true;  // the domain too, which is smaller than an element
    for (int d = 0; d < this->directions; ++d) {
      const double place = s.place.element[d] + s.place.xi[d];
      is_inside = is_inside && place > 1.0 && place < s.place.elements[d] - 1.0;
    }
    double sum = 0.0, value = 0.0, gradient[3] = {}, exact = 0.4;
    for (int d = 0; d < this->directions; ++d) exact += slope[d] * x[static_cast<std::size_t>(d)];
    for (int a = 0; a < this->nodes; ++a) {
      const auto place = grid.node_position(this->node_of(s, a));
      double nodal = 0.4;
      for (int d = 0; d < this->directions; ++d)
        nodal += slope[d] * place[static_cast<std::size_t>(d)];
      if (is_inside) {
        EXPECT_GE(s.N[a], -1e-15);
      }
      sum += s.N[a];
      value += s.N[a] * nodal;
      for (int d = 0; d < 3; ++d) gradient[d] += s.gradient[d][a] * nodal;
    }
    EXPECT_NEAR(sum, 1.0, 1e-13);
    EXPECT_NEAR(value, exact, 1e-12);
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(gradient[d], d < this->directions ? slope[d] : 0.0, 1e-12 * 50.0);
  });
}

// What the crossing artefact is made of: a gradient that changes at once when a particle enters the
// next element. The same point, taken as one of either element, has the same values and gradients.
TYPED_TEST(ShapeFunctionsOf, GradientsDoNotJumpBetweenElements) {
  const grid::Grid grid = this->make_grid();
  for (int d = 0; d < this->directions; ++d)
    for (int face = 1; face < grid.elements[static_cast<std::size_t>(d)]; ++face) {
      std::array<double, 3> x;
      int below[3], above[3];
      for (int e = 0; e < 3; ++e) {
        const auto i = static_cast<std::size_t>(e);
        below[e] = above[e] = static_cast<int>(grid.elements[i]) / 2;
        x[i] = grid.origin[i] + (below[e] + 0.3) * grid.spacing[i];
      }
      below[d] = face - 1;
      above[d] = face;
      const auto along = static_cast<std::size_t>(d);
      x[along] = grid.origin[along] + face * grid.spacing[along];
      const auto lower = this->at(grid, x, 0.25, below), upper = this->at(grid, x, 0.25, above);
      double values[2] = {}, slopes[2] = {};  // of a field that has no pattern
      const auto coefficient = [](const grid::Index3& n) {
        return std::sin(1.0 + 12.3 * static_cast<double>(n[0]) + 4.7 * static_cast<double>(n[1]) +
                        9.1 * static_cast<double>(n[2]));
      };
      for (int a = 0; a < this->nodes; ++a) {
        values[0] += lower.N[a] * coefficient(this->node_of(lower, a));
        values[1] += upper.N[a] * coefficient(this->node_of(upper, a));
        slopes[0] += lower.gradient[d][a] * coefficient(this->node_of(lower, a));
        slopes[1] += upper.gradient[d][a] * coefficient(this->node_of(upper, a));
      }
      EXPECT_NEAR(values[0], values[1], 1e-13);
      EXPECT_NEAR(slopes[0], slopes[1], 1e-12);
    }
}

template <class Shape>
void expect_gradients_of_the_values(const Place& place) {
  const double step = 1e-6;
  for (int d = 0; d < Shape::dimensions; ++d) {
    Place lower = place, upper = place;
    lower.xi[d] -= step;
    upper.xi[d] += step;
    double N[3][Shape::nodes], gradient[3][Shape::nodes], unused[3][Shape::nodes];
    Shape::evaluate(lower, N[0], unused);
    Shape::evaluate(place, N[1], gradient);
    Shape::evaluate(upper, N[2], unused);
    for (int a = 0; a < Shape::nodes; ++a)
      EXPECT_NEAR(gradient[d][a], (N[2][a] - N[0][a]) / (2.0 * step) * place.inverse_h[d], 1e-8);
  }
}

// Not so for CPDI, whose values and gradients are two means of their own.
TEST(ShapeFunctions, GradientsAreThoseOfTheValues) {
  for (const int element : {0, 1, 2, 4}) {
    const Place place{{0.31, 0.77, 0.52},
                      {element, 2, 1},
                      {5, 4, 3},
                      {0.5, 1.3, 0.3},
                      {{0.5, 0.01, 0.02}, {0.03, 0.2, 0.0}, {0.0, 0.1, 0.9}}};
    expect_gradients_of_the_values<Gimp<3>>(place);
    expect_gradients_of_the_values<BSpline<2, 3>>(place);
    expect_gradients_of_the_values<BSpline<3, 3>>(place);
    expect_gradients_of_the_values<BSpline<3, 2>>(place);
  }
}

/// Values of the functions of one axis, averaged over a domain of half edge l [elements], at a
/// point x from the knot [elements].
template <class Axis>
void expect_values(int element, double x, double l, const std::vector<double>& expected) {
  const Place place{{x + 0.5, 0, 0}, {element, 0, 0}, {10, 1, 1}, {1, 1, 1}, {{l, 0, 0}, {}, {}}};
  double value[Axis::width], slope[Axis::width];
  Axis::evaluate(place, 0, value, slope);
  for (int f = 0; f < Axis::width; ++f)
    EXPECT_NEAR(value[f], expected[static_cast<std::size_t>(f)], 1e-13);
}

// The uniform B-splines' textbook values at a knot and in the middle of a span, where the domain is
// next to nothing. GIMP's at a node: 1 - l/2 (l = half edge in elements), l/4 at its neighbours
// (Bardenhagen, Kober 2004). And the mean of a uniform B-spline over a whole span is the B-spline
// of the next degree.
TEST(ShapeFunctions, HaveTheValuesThatTextbooksGive) {
  const double tiny = 1e-7;
  expect_values<BSplineAxis<2>>(4, 0.0, tiny, {0, 1.0 / 2, 1.0 / 2, 0});
  expect_values<BSplineAxis<3>>(4, 0.0, tiny, {0, 1.0 / 6, 2.0 / 3, 1.0 / 6, 0});
  expect_values<BSplineAxis<2>>(4, 0.5, tiny, {0, 1.0 / 8, 3.0 / 4, 1.0 / 8});
  expect_values<BSplineAxis<3>>(4, 0.5, tiny, {0, 1.0 / 48, 23.0 / 48, 23.0 / 48, 1.0 / 48});
  expect_values<BSplineAxis<3>>(4, -0.5, tiny, {1.0 / 48, 23.0 / 48, 23.0 / 48, 1.0 / 48, 0});
  expect_values<BSplineAxis<1>>(4, 0.0, 0.25, {0.25 / 4, 1.0 - 0.25 / 2, 0.25 / 4});
  expect_values<BSplineAxis<1>>(4, 0.0, 0.5, {1.0 / 8, 3.0 / 4, 1.0 / 8});
  expect_values<BSplineAxis<2>>(4, 0.0, 0.5, {1.0 / 48, 23.0 / 48, 23.0 / 48, 1.0 / 48});
  expect_values<BSplineAxis<3>>(4, 0.0, 0.5,
                                {1.0 / 384, 19.0 / 96, 115.0 / 192, 19.0 / 96, 1.0 / 384});
}

// Open knots: at the ends of the grid one function is 1 and the others 0, so that what is
// prescribed there holds along the whole face. Hats go on straight beyond it.
TEST(ShapeFunctions, InterpolateAtTheEnds) {
  const double tiny = 1e-14;
  expect_values<BSplineAxis<1>>(0, 0.0, tiny, {0, 1, 0});
  expect_values<BSplineAxis<2>>(0, 0.0, tiny, {0, 1, 0, 0});
  expect_values<BSplineAxis<3>>(0, 0.0, tiny, {0, 1, 0, 0, 0});
  expect_values<BSplineAxis<1>>(9, 0.0, tiny, {0, 1, 0});
  expect_values<BSplineAxis<2>>(9, 0.0, tiny, {0, 0, 1, 0});
  expect_values<BSplineAxis<3>>(9, 0.0, tiny, {0, 0, 0, 1, 0});
  expect_values<BSplineAxis<1>>(0, -0.25, 0.25, {0, 1.25, -0.25});
  expect_values<BSplineAxis<1>>(9, 0.25, 0.25, {-0.25, 1.25, 0});
}

constexpr int spans = 6;

/// Domains of uneven sizes that tile the axis from the first knot to the last: (middle, half edge).
std::vector<std::pair<double, double>> tiles() {
  std::vector<std::pair<double, double>> tiles;
  const double size[5] = {0.37, 0.61, 0.22, 0.5, 0.3};  // 3 times their sum is `spans`
  double from = 0.0;
  for (int n = 0; n < 15; ++n) {
    tiles.emplace_back(from + 0.5 * size[n % 5], 0.5 * size[n % 5]);
    from += size[n % 5];
  }
  return tiles;
}

// Where domains tile the body, sums over the particles of values and gradients are their integrals
// over the body: 1 or -1 for the gradient of the functions that are 1 at the ends, 0 for the
// others; and (t_(f+p+1) - t_f) / (p + 1) for the values of spline f.
template <class Axis>
void expect_integrals() {
  constexpr int degree = Axis::width - 2;
  double sum[spans + degree + 2] = {}, slopes[spans + degree + 2] = {};
  for (const auto& [middle, l] : tiles()) {
    const int knot = static_cast<int>(std::floor(middle + 0.5));
    const Place place{
        {middle - knot + 0.5, 0, 0}, {knot, 0, 0}, {spans + 1, 1, 1}, {1, 1, 1}, {{l, 0, 0}}};
    double value[Axis::width], slope[Axis::width];
    Axis::evaluate(place, 0, value, slope);
    for (int f = 0; f < Axis::width; ++f) {
      sum[knot + f] += 2.0 * l * value[f];
      slopes[knot + f] += 2.0 * l * slope[f];
    }
  }
  const auto t = [](int i) { return static_cast<double>(std::clamp(i, 0, spans)); };
  for (int f = 0; f < spans + degree; ++f) {
    EXPECT_NEAR(sum[f + 1], (t(f + 1) - t(f - degree)) / (degree + 1), 1e-13);
    EXPECT_NEAR(slopes[f + 1], f == 0 ? -1.0 : (f == spans + degree - 1 ? 1.0 : 0.0), 1e-13);
  }
}

TEST(ShapeFunctions, IntegrateGradientsExactly) {
  expect_integrals<BSplineAxis<1>>();
  expect_integrals<BSplineAxis<2>>();
  expect_integrals<BSplineAxis<3>>();
}

// Without shear CPDI is GIMP for values and gradients that are linear along each domain edge, and
// the domain that is too large is cut down to half an element.
TEST(ShapeFunctions, CpdiOfADomainInsideOneElementIsThatOfHats) {
  const Place place{
      {0.2, 0.8, 0.7}, {1, 1, 1}, {4, 4, 4}, {1, 1, 1}, {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}};
  double N[27], gradient[3][27], gimp[27], gimp_gradient[3][27];
  Cpdi<3>::evaluate(place, N, gradient);
  Gimp<3>::evaluate(place, gimp, gimp_gradient);
  for (int a = 0; a < 27; ++a) {
    EXPECT_NEAR(N[a], gimp[a], 1e-15);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(gradient[d][a], gimp_gradient[d][a], 1e-13);
  }
}

}  // namespace
}  // namespace stroma::shape
