// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A loading whose steps end at given times.

#include <utility>
#include <vector>

#include "stroma/solver/StepControl.hpp"

namespace stroma::solver {

/// \param times  at which the steps end [s]
inline LoadingParameters at_times(std::vector<double> times) {
  LoadingParameters loading;
  loading.times = std::move(times);
  return loading;
}

}  // namespace stroma::solver
