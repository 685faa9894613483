// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/StepControl.hpp"

#include <algorithm>
#include <cmath>

namespace stroma::solver {

namespace {

constexpr double rounding = 1e-9;  // of a step

}  // namespace

StepControl::StepControl(const LoadingParameters& parameters, const LoadProgress& progress)
    : parameters_(parameters), now_(progress) {
  if (finished()) return;
  const double whole = step_at(now_.load).length;
  now_.size = now_.size > 0.0 ? std::min(now_.size, whole) : whole;
}

StepControl::Step StepControl::step_at(double load) const {
  if (!parameters_.times) {
    const double passed = std::floor(load * parameters_.equal_steps() + rounding);
    return {std::min((passed + 1.0) / parameters_.equal_steps(), 1.0),
            1.0 / parameters_.equal_steps()};
  }
  const std::vector<double>& times = *parameters_.times;
  double begin = 0.0, end = 1.0;
  for (std::size_t n = 0; n < times.size(); ++n) {
    end = n + 1 == times.size() ? 1.0 : times[n] / parameters_.seconds();
    if (load < end - rounding * (end - begin)) break;
    begin = end;
  }
  return {end, end - begin};
}

double StepControl::next() const {
  const Step step = step_at(now_.load);
  return now_.load + now_.size > step.end - rounding * step.length ? step.end
                                                                   : now_.load + now_.size;
}

void StepControl::accept(double time_error) {
  const bool was_whole = now_.size >= step_at(now_.load).length;
  // A step of double length has eight times the error.
  const bool may_grow = !is_too_long(8.0 * time_error);
  now_.load = next();
  ++now_.accepted;
  if (finished()) return;
  const double whole = step_at(now_.load).length;
  now_.size = was_whole ? whole : std::min(may_grow ? 2.0 * now_.size : now_.size, whole);
}

int StepControl::remaining() const {
  StepControl rest = *this;
  while (!rest.finished()) rest.accept();
  return rest.accepted() - accepted();
}

bool StepControl::reject() {
  const double half = 0.5 * (next() - now_.load);
  if (half < parameters_.smallest_step) return false;
  now_.size = half;
  return true;
}

}  // namespace stroma::solver
