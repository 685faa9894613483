// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How a body moves when the load begins.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/grid/Grid.hpp"
#include "stroma/mechanics/problem/VectorField.hpp"

namespace stroma::mechanics {

/// v(X) = velocity + L (X - center) + that of images.
struct InitialCondition {
  std::optional<std::array<double, 3>> velocity;           ///< [um/s]
  std::optional<std::array<double, 9>> velocity_gradient;  ///< L, row by row [1/s]
  std::optional<std::array<double, 3>> center;    ///< [um]; absent: the middle of the body's box
  std::optional<VectorImages> images;             ///< of the velocity [um/s]
  std::shared_ptr<const VectorField> field = {};  ///< what they hold where this rank is
};

struct InitialConditionsParameters {
  std::vector<std::pair<std::string, InitialCondition>> conditions;
};

/// The sum of all of them [um/s] at a point X of the undeformed body [um]; empty without any.
///
/// \param parameters  the deck's
/// \param body        the grid at load 0; it fills the body's box
std::function<std::array<double, 3>(const std::array<double, 3>&)> initial_velocity(
    const InitialConditionsParameters& parameters, const grid::Grid& body);

}  // namespace stroma::mechanics
