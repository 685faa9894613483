// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/Problem.hpp"

#include <algorithm>
#include <array>

namespace stroma::mechanics {
namespace {

constexpr std::array<Face, 6> all_faces{Face::x_lower, Face::x_upper, Face::y_lower,
                                        Face::y_upper, Face::z_lower, Face::z_upper};

}  // namespace

const BoundaryCondition* Problem::keeper_of_plane(Face face) const {
  for (const auto& [name, condition] : conditions)
    if (condition.imposed_by.value_or(ImposedBy::nodes) == ImposedBy::nodes &&
        condition.applies_to(face) && condition.keeps_plane(face))
      return &condition;
  return nullptr;
}

ImposedBy Problem::imposed_by(const BoundaryCondition& condition) const {
  if (condition.imposed_by) return *condition.imposed_by;
  const auto can_follow = [&](Face face) {
    return !condition.applies_to(face) || is_kept_plane(face) || (body.flat && axis_of(face) == 2);
  };
  return !method.reset || std::all_of(all_faces.begin(), all_faces.end(), can_follow)
             ? ImposedBy::nodes
             : ImposedBy::penalty;
}

double Problem::place_of_plane(Face face, double load) const {
  const int d = axis_of(face);
  const auto i = static_cast<std::size_t>(d);
  std::array<double, 3> X = body.origin;
  if (is_upper(face)) X[i] += body.length(d);
  const BoundaryCondition* keeper = method.reset ? keeper_of_plane(face) : nullptr;
  if (keeper == nullptr) return X[i];
  return X[i] + keeper->value(d, X, body.origin, body.lengths(), load);
}

double Problem::spring_stiffness(const BoundaryCondition& condition, int axis) const {
  const double modulus = laws.stiffest_modulus();
  if (pulls_on(condition)) return 10.0 * modulus / body.spacing[static_cast<std::size_t>(axis)];
  return condition.penalty_factor.value_or(2e4) * modulus / body.length(axis);
}

}  // namespace stroma::mechanics
