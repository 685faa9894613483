// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/material/FiberDirections.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stroma/tensor/UnitSize.hpp"

namespace stroma::material {

std::array<double, 3> normalised(const std::array<double, 3>& vector) {
  const std::array<double, 3> a = tensor::of_unit_size(vector);
  const double length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {a[0] / length, a[1] / length, a[2] / length};
}

namespace {

using Vector = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846, golden_section = 0.61803398874989485;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A right-handed frame whose third vector is along `axis`.
std::array<Vector, 3> frame_along(const Vector& axis) {
  const Vector third = normalised(axis);
  std::size_t least = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (std::abs(third[d]) < std::abs(third[least])) least = d;
  Vector beside{};
  beside[least] = 1.0;
  const Vector first = normalised(cross(beside, third));
  return {first, cross(third, first), third};
}

struct GaussPoint {
  double place, weight;
};

/// Gauss's rule of n points on [0, 1], by Newton's method for the roots of Legendre's polynomial.
std::vector<GaussPoint> gauss_rule(int n) {
  std::vector<GaussPoint> rule;
  for (int k = 0; k < n; ++k) {
    double x = std::cos(pi * (k + 0.75) / (n + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double before = 1.0, value = x;
      for (int d = 2; d <= n; ++d) {
        const double next = ((2 * d - 1) * x * value - (d - 1) * before) / d;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1.0);
      const double change = value / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    rule.push_back({0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return rule;
}

double density(const DistributionParameters& p, const Vector& n, const Vector& axis) {
  if (p.distribution == Distribution::axial) {
    const double along = dot(n, axis);
    // relative to its largest value, which may overflow
    return std::exp(2.0 * p.concentration * (along * along - (p.concentration > 0.0 ? 1.0 : 0.0)));
  }
  if (p.distribution == Distribution::ellipsoidal) {
    const Vector axes = tensor::of_unit_size(p.axes);  // weights are relative
    return 1.0 / std::hypot(n[0] / axes[0], n[1] / axes[1], n[2] / axes[2]);
  }
  return 1.0;
}

}  // namespace

std::vector<FiberDirection> directions(const DistributionParameters& p) {
  const Vector axis = normalised(p.direction);
  if (p.distribution == Distribution::single) return {{{axis[0], axis[1], axis[2]}, 1.0}};
  // The pole of the others is no axis of a specimen: where a ring as a whole passes from tension to
  // compression, the error is largest.
  const auto frame =
      frame_along(p.distribution == Distribution::axial ? p.direction : Vector{0.36, 0.48, 0.8});
  std::vector<FiberDirection> all;
  double sum = 0.0, start = 0.0;
  for (const GaussPoint& ring : gauss_rule(p.quadrature)) {
    const double height = ring.place, radius = std::sqrt(1.0 - height * height);
    const int around = std::max(12, 4 * static_cast<int>(std::ceil(radius * p.quadrature)));
    start += golden_section;  // no two rings begin alike
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * pi * (k + start) / around;
      Vector n{};
      for (std::size_t d = 0; d < 3; ++d)
        n[d] = radius * (std::cos(angle) * frame[0][d] + std::sin(angle) * frame[1][d]) +
               height * frame[2][d];
      const double weight = ring.weight / around * density(p, n, axis);
      sum += weight;
      all.push_back({{n[0], n[1], n[2]}, weight});
    }
  }
  for (FiberDirection& direction : all) direction.weight /= sum;
  return all;
}

}  // namespace stroma::material
