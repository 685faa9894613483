// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/Scales.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::mechanics {
namespace {

/// The smallest and the largest of some sizes that are not zero.
struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;

  void add(double value) {
    if (value == 0.0) return;
    least = std::min(least, std::abs(value));
    most = std::max(most, std::abs(value));
  }
  bool empty() const { return most == 0.0; }
};

void check_force(const std::string& where, const std::string& of_what, double least, double most) {
  constexpr double smallest = 1e-120, largest = 1e120;
  if (least >= smallest && most <= largest) return;
  throw base::InputError(base::format(
      "%s: forces of the size of %.3g pN (%s): their squares are beyond what a double holds; "
      "admissible: sizes between %g and %g pN",
      where.c_str(), least >= smallest ? most : least, of_what.c_str(), smallest, largest));
}

/// Multigrid keeps stiffnesses and residuals in single precision, which ends at 1e-38 and 1e38.
void check_single(const std::string& where, const std::string& of_what, double least, double most) {
  constexpr double smallest = 1e-28, largest = 1e32;
  if (least >= smallest && most <= largest) return;
  throw base::InputError(base::format(
      "%s: %s of the size of %.3g are beyond what single precision, in which preconditioners "
      "compute, holds with all digits; admissible: sizes between %g and %g",
      where.c_str(), of_what.c_str(), least >= smallest ? most : least, smallest, largest));
}

/// The digits that a double has beside 1, in squares of stretches, and in pressures beside shear
/// stresses.
void check_digits(const std::string& where, const std::string& of_what, double ratio,
                  double largest) {
  if (ratio <= largest) return;
  throw base::InputError(base::format(
      "%s: %s is %.3g, and rounding alone would be as large as the stresses; admissible: up to %g",
      where.c_str(), of_what.c_str(), ratio, largest));
}

/// The largest factor of a curve in a run, apart from its sign.
double largest_factor(const LoadCurve& curve) {
  double largest = std::abs(curve.at(1.0));
  for (const double load : curve.loads)
    if (load <= 1.0) largest = std::max(largest, std::abs(curve.at(load)));
  return largest;
}

/// Displacements that a condition prescribes at the corners of the body, or the largest of images;
/// those of the whole angle where it turns.
Range displacements(const BoundaryCondition& condition, const grid::Grid& body) {
  const std::array<double, 3> length = body.lengths();
  const double factor = condition.rotation ? 1.0 : largest_factor(condition.curve);
  Range range;
  if (condition.field) {
    range.add(factor * condition.field->largest());
    return range;
  }
  for (int corner = 0; corner < 8; ++corner) {
    std::array<double, 3> X = body.origin;
    for (std::size_t d = 0; d < 3; ++d) X[d] += (corner >> d & 1) * length[d];
    for (int c = 0; c < 3; ++c)
      if (condition.prescribes(c)) range.add(factor * condition.full(c, X, body.origin, length));
  }
  return range;
}

}  // namespace

void check_scales(const Problem& problem) {
  const grid::Grid& body = problem.body;
  Range moduli, lengths, densities;
  for (const material::SmallStrainModuli& material : problem.laws.range())
    for (const double modulus : {material.shear, material.bulk}) moduli.add(modulus);
  for (const material::SmallStrainModuli& material : problem.laws.range())
    if (material.shear > 0.0)
      check_digits("Materials", "the bulk modulus over the shear modulus",
                   material.bulk / material.shear, 1e10);
  for (int d = 0; d < 3; ++d) {
    lengths.add(body.spacing[static_cast<std::size_t>(d)]);
    lengths.add(body.length(d));
  }
  for (const double density : problem.density) densities.add(density);
  if (densities.empty()) densities.add(1.0);
  const double least_area = lengths.least * lengths.least, most_area = lengths.most * lengths.most;

  check_force("Materials", "moduli times areas", moduli.least * least_area,
              moduli.most * most_area);
  check_single("Materials", "moduli [Pa] times lengths [um]", moduli.least * lengths.least,
               moduli.most * lengths.most);
  double largest_force = 0.0;
  for (const auto& [name, condition] : problem.conditions) {
    const Range u = displacements(condition, body);
    if (u.empty()) continue;
    check_digits("Boundary Conditions|" + name, "the displacement over the body's longest edge",
                 u.most / lengths.most, 1e5);
    check_force("Boundary Conditions|" + name, "modulus times length times displacement",
                moduli.least * lengths.least * u.least, moduli.most * lengths.most * u.most);
    largest_force = std::max(largest_force, moduli.most * lengths.most * u.most);
  }
  for (const auto& [name, force] : problem.forces) {
    const std::string where = "External Forces|" + name;
    const auto range_of = [](const std::array<double, 3>& vector) {
      Range range;
      for (const double component : vector) range.add(component);
      return range;
    };
    if (force.traction) {
      const Range t = range_of(*force.traction);
      largest_force = std::max(largest_force, t.most * most_area);
      if (!t.empty())
        check_force(where, "traction times area", t.least * least_area, t.most * most_area);
    } else {
      const Range b = range_of(force.body_force ? *force.body_force : *force.acceleration);
      const double unit = force.body_force ? 1.0 : 1e-6;
      largest_force = std::max(largest_force, unit * (force.body_force ? 1.0 : densities.most) *
                                                  b.most * most_area * lengths.most);
      if (!b.empty())
        check_force(
            where, "force per volume times volume",
            unit * (force.body_force ? 1.0 : densities.least) * b.least * least_area *
                lengths.least,
            unit * (force.body_force ? 1.0 : densities.most) * b.most * most_area * lengths.most);
    }
  }
  if (largest_force > 0.0)
    check_single(problem.conditions.empty() ? "External Forces" : "Boundary Conditions",
                 "forces [pN]", largest_force, largest_force);
}

}  // namespace stroma::mechanics
