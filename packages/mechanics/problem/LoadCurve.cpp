// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/LoadCurve.hpp"

#include <algorithm>
#include <cmath>

namespace stroma::mechanics {

LoadCurve::Place LoadCurve::place_of(double load) const {
  const double first = loads.front(), last = loads.back();
  if (beyond == Beyond::repeat && load >= last && last > first)
    load = first + std::fmod(load - first, last - first);
  const auto above = std::upper_bound(loads.begin(), loads.end(), load);
  if (above == loads.begin()) return {0, 0.0, 0.0};
  const auto point = static_cast<std::size_t>(above - loads.begin()) - 1;
  if (above == loads.end()) return {point, 0.0, 0.0};
  const double length = *above - loads[point];
  return {point, (load - loads[point]) / length, length};
}

double LoadCurve::at(double load) const {
  if (is_load()) return load;
  const auto [k, x, length] = place_of(load);
  if (length == 0.0 || interpolation == Interpolation::step) return values[k];
  const double way = interpolation == Interpolation::smooth ? x * x * (3.0 - 2.0 * x) : x;
  return values[k] + way * (values[k + 1] - values[k]);
}

double LoadCurve::slope(double load) const {
  if (is_load()) return 1.0;
  const auto [k, x, length] = place_of(load);
  if (length == 0.0 || interpolation == Interpolation::step) return 0.0;
  const double rate = interpolation == Interpolation::smooth ? 6.0 * x * (1.0 - x) : 1.0;
  return rate * (values[k + 1] - values[k]) / length;
}

bool LoadCurve::operator==(const LoadCurve& other) const {
  return loads == other.loads && values == other.values && interpolation == other.interpolation &&
         beyond == other.beyond;
}

LoadCurve load_curve(const LoadCurveParameters& parameters, double duration) {
  LoadCurve curve{parameters.times, parameters.values, parameters.interpolation, parameters.beyond};
  for (double& load : curve.loads) load /= duration;
  return curve;
}

}  // namespace stroma::mechanics
