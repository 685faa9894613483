// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/StepControl.hpp"

#include <algorithm>
#include <cmath>

namespace stroma::solver {

StepControl::StepControl(const LoadingParameters& parameters)
    : parameters_(parameters), size_(1.0 / parameters.steps) {}

double StepControl::next() const {
  constexpr double rounding = 1e-9;  // of a regular step
  const double passed = std::floor(load_ * parameters_.steps + rounding);
  const double multiple = (passed + 1.0) / parameters_.steps;
  return load_ + size_ > multiple - rounding / parameters_.steps ? std::min(multiple, 1.0)
                                                                 : load_ + size_;
}

void StepControl::accept() {
  load_ = next();
  ++accepted_;
  size_ = std::min(2.0 * size_, 1.0 / parameters_.steps);
}

bool StepControl::reject() {
  const double half = 0.5 * (next() - load_);
  if (half < parameters_.smallest_step) return false;
  size_ = half;
  return true;
}

}  // namespace stroma::solver
