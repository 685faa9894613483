// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/InitialConditions.hpp"

namespace stroma::mechanics {

std::function<std::array<double, 3>(const std::array<double, 3>&)> initial_velocity(
    const InitialConditionsParameters& parameters, const grid::Grid& body) {
  if (parameters.conditions.empty()) return {};
  std::array<double, 3> middle;
  for (std::size_t d = 0; d < 3; ++d)
    middle[d] = body.origin[d] + 0.5 * body.length(static_cast<int>(d));
  return [conditions = parameters.conditions, middle](const std::array<double, 3>& X) {
    std::array<double, 3> v{};
    for (const auto& named : conditions) {
      const InitialCondition& one = named.second;
      const std::array<double, 3> center = one.center.value_or(middle);
      for (std::size_t i = 0; i < 3; ++i) {
        if (one.velocity) v[i] += (*one.velocity)[i];
        if (one.field) v[i] += one.field->at(static_cast<int>(i), X);
        for (std::size_t j = 0; one.velocity_gradient && j < 3; ++j)
          v[i] += (*one.velocity_gradient)[3 * i + j] * (X[j] - center[j]);
      }
    }
    return v;
  };
}

}  // namespace stroma::mechanics
