// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/BoundaryConditions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stroma/base/Log.hpp"
#include "stroma/material/FiberDirections.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::mechanics {

int axis_of(Face face) { return face == Face::all ? -1 : static_cast<int>(face) / 2; }

bool is_upper(Face face) { return face != Face::all && static_cast<int>(face) % 2 == 1; }

std::string name_of(Face face) {
  if (face == Face::all) return "all";
  return {"xyz"[axis_of(face)], is_upper(face) ? '+' : '-'};
}

BoundaryCondition hold(Face face, const std::string& components) {
  BoundaryCondition condition;
  condition.face = face;
  condition.components = components;
  return condition;
}

namespace {

using Vector = std::array<double, 3>;

constexpr double radians = 0.017453292519943295;  // in a degree

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// How a point with an arm r moves when it is turned about a unit axis.
Vector turned(const Vector& axis, const Vector& arm, double angle) {
  const Vector once = cross(axis, arm), twice = cross(axis, once);
  const double s = std::sin(0.5 * angle);
  Vector u;
  for (std::size_t c = 0; c < 3; ++c) u[c] = std::sin(angle) * once[c] + 2.0 * s * s * twice[c];
  return u;
}

}  // namespace

Vector BoundaryCondition::unit_axis() const {
  if (axis) return material::normalised(*axis);
  Vector unit{};
  unit[static_cast<std::size_t>(axis_of(*face))] = 1.0;
  return unit;
}

Vector BoundaryCondition::arm(const Vector& position, const Vector& corner,
                              const Vector& length) const {
  Vector arm;
  for (std::size_t d = 0; d < 3; ++d)
    arm[d] = position[d] - (center ? (*center)[d] : corner[d] + 0.5 * length[d]);
  return arm;
}

double BoundaryCondition::at_factor(int component, const Vector& position, const Vector& corner,
                                    const Vector& length, double factor) const {
  const auto c = static_cast<std::size_t>(component);
  if (displacement) return factor * (*displacement)[c];
  if (field) return factor * field->at(component, position);
  if (strain && axis_of(*face) == component)
    return factor * ((is_upper(*face) ? 1.0 : -1.0) * *strain * length[c]);
  if (displacement_gradient) {
    double sum = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
      sum += (*displacement_gradient)[3 * c + d] * (position[d] - corner[d]);
    return factor * sum;
  }
  if (rotation)
    return turned(unit_axis(), arm(position, corner, length), factor * *rotation * radians)[c];
  return 0.0;
}

double BoundaryCondition::value(int component, const Vector& position, const Vector& corner,
                                const Vector& length, double load) const {
  return at_factor(component, position, corner, length, factor(load));
}

double BoundaryCondition::full(int component, const Vector& position, const Vector& corner,
                               const Vector& length) const {
  return at_factor(component, position, corner, length, 1.0);
}

double BoundaryCondition::rate_of_factor(int component, const Vector& position,
                                         const Vector& corner, const Vector& length,
                                         double factor) const {
  if (!rotation) return full(component, position, corner, length);
  const double angle = *rotation * radians;
  const Vector moved = turned(unit_axis(), arm(position, corner, length), factor * angle);
  Vector x = position;
  for (std::size_t d = 0; d < 3; ++d) x[d] += moved[d];
  return angle * lever(x, corner, length)[static_cast<std::size_t>(component)];
}

Vector BoundaryCondition::lever(const Vector& x, const Vector& corner, const Vector& length) const {
  return cross(unit_axis(), arm(x, corner, length));
}

double BoundaryCondition::rate(int component, const Vector& position, const Vector& corner,
                               const Vector& length, double load) const {
  return curve.slope(load) * rate_of_factor(component, position, corner, length, factor(load));
}

double BoundaryCondition::direction(int component, const Vector& position, const Vector& corner,
                                    const Vector& length) const {
  return rate_of_factor(component, position, corner, length, 0.0);
}

std::array<double, 3> BoundaryCondition::carried_from(const Vector& x, double load,
                                                      const Vector& corner,
                                                      const Vector& length) const {
  const double factor = this->factor(load);
  Vector X = x;
  if (field) return X;
  if (displacement_gradient) {
    tensor::Tensor3 motion = tensor::identity();
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3 && prescribes(c); ++d)
        motion(c, d) += factor * (*displacement_gradient)[static_cast<std::size_t>(3 * c + d)];
    const tensor::Tensor3 back = tensor::inverse(motion);
    for (int c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(c);
      X[i] = corner[i];
      for (int d = 0; d < 3; ++d)
        X[i] += back(c, d) * (x[static_cast<std::size_t>(d)] - corner[static_cast<std::size_t>(d)]);
    }
    return X;
  }
  if (rotation) {
    const Vector back = turned(unit_axis(), arm(x, corner, length), -factor * *rotation * radians);
    for (int c = 0; c < 3; ++c)
      if (prescribes(c)) X[static_cast<std::size_t>(c)] += back[static_cast<std::size_t>(c)];
    return X;
  }
  for (int c = 0; c < 3; ++c)
    if (prescribes(c)) X[static_cast<std::size_t>(c)] -= value(c, x, corner, length, load);
  return X;
}

bool BoundaryCondition::is_self_contained() const {
  if (rotation)
    for (int d = 0; d < 3; ++d)
      if (!prescribes(d) && std::abs(unit_axis()[static_cast<std::size_t>(d)]) != 1.0) return false;
  if (!displacement_gradient) return true;
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3 && prescribes(c); ++d)
      if (!prescribes(d) && (*displacement_gradient)[static_cast<std::size_t>(3 * c + d)] != 0.0)
        return false;
  return true;
}

bool BoundaryCondition::keeps_plane(Face of_its_faces) const {
  const int normal = axis_of(of_its_faces);
  if (!prescribes(normal) || field) return false;
  const auto n = static_cast<std::size_t>(normal);
  if (rotation) return *rotation == 0.0 || std::abs(unit_axis()[n]) == 1.0;
  if (!displacement_gradient) return true;
  for (std::size_t d = 0; d < 3; ++d)
    if (d != n && (*displacement_gradient)[3 * n + d] != 0.0) return false;
  return true;
}

int BoundaryCondition::loaded_component(const std::array<double, 3>& length) const {
  int loaded = -1;
  if (rotation || images) return loaded;
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    if (!prescribes(c)) continue;
    const double moved = std::abs(full(c, length, {0.0, 0.0, 0.0}, length));
    if (moved > largest) {
      largest = moved;
      loaded = c;
    }
  }
  return loaded;
}

std::optional<Disagreement> disagreement(const ConditionAt& a, const ConditionAt& b, int component,
                                         const Vector& corner, const Vector& length) {
  const double negligible = 1e-12 * *std::max_element(length.begin(), length.end());
  // A full turn is no motion at full load, and a curve may come back to where it was.
  for (const double load : {1.0, 0.037, 0.21, 0.37, 0.52, 0.68, 0.83}) {
    const Disagreement found{load, a.condition.value(component, a.X, corner, length, load),
                             b.condition.value(component, b.X, corner, length, load)};
    if (std::abs(found.a - found.b) > negligible) return found;
  }
  return std::nullopt;
}

std::string conflict(const std::string& first, const std::string& second, int component,
                     const std::array<double, 3>& x, const Disagreement& found) {
  return base::format(
      "Boundary Conditions|%s: its %c displacement, %.10g um, and that of \"%s\", %.10g um, differ at "
      "their common point (%g, %g, %g) um%s; admissible: equal values, or %c left out of the "
      "Components of one of them",
      first.c_str(), "xyz"[component], found.a, second.c_str(), found.b, x[0], x[1], x[2],
      found.load == 1.0 ? "" : base::format(" at %g of the load", found.load).c_str(),
      "xyz"[component]);
}

std::string moved_across_plane_strain(const std::string& name, const Disagreement& found) {
  return base::format(
      "Boundary Conditions|%s: its z displacement is %.10g um%s, and Grid|Plane Strain holds z "
      "everywhere; admissible: motions along x and y, or Plane Strain = false",
      name.c_str(), found.a,
      found.load == 1.0 ? "" : base::format(" at %g of the load", found.load).c_str());
}

std::string no_particle_at(const std::string& section, const std::string& face) {
  return section + "|Face: there is no particle at " + face +
         "; admissible: a face at which the image has a label "
         "other than -1 (empty). Image|Region leaves out a margin around the body";
}

}  // namespace stroma::mechanics
