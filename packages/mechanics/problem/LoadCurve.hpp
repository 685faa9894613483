// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How a quantity follows the load.

#include <string>
#include <utility>
#include <vector>

namespace stroma::mechanics {

enum class Interpolation { linear, smooth, step };
enum class Beyond { hold, repeat };

/// The factor of a quantity as a function of the load factor, which is the time as a share of the
/// run's duration. Without points it is the load factor itself: the quantity grows in proportion to
/// its full value at the end.
///
/// Between two points (s_k, v_k): linear; smooth, v_k + (v_(k+1) - v_k) (3 x^2 - 2 x^3), x the share
/// of the way, so that it starts and stops without a jerk; or step, v_k until s_(k+1). Before the
/// first point it is the first value; beyond the last, the last value, or the curve from its first
/// point on, again and again.
struct LoadCurve {
  std::vector<double> loads;   ///< s, ascending
  std::vector<double> values;  ///< v, one each
  Interpolation interpolation = Interpolation::linear;
  Beyond beyond = Beyond::hold;

  bool is_load() const { return loads.empty(); }
  /// The factor at a load factor.
  double at(double load) const;
  /// Its derivative; at a corner, that which follows.
  double slope(double load) const;
  bool operator==(const LoadCurve& other) const;

 private:
  /// The last point before a load, and the way from it as a share of the piece.
  struct Place {
    std::size_t point;
    double share, length;  ///< length 0: there is no piece, the value is the point's
  };
  Place place_of(double load) const;
};

/// A load curve as the deck has it.
struct LoadCurveParameters {
  std::vector<double> times;   ///< [s], ascending
  std::vector<double> values;  ///< one each [-]
  Interpolation interpolation = Interpolation::linear;
  Beyond beyond = Beyond::hold;
};

struct LoadCurvesParameters {
  std::vector<std::pair<std::string, LoadCurveParameters>> curves;
};

/// The curve of the deck over load factors.
///
/// \param parameters  the deck's
/// \param duration    of the run [s]
LoadCurve load_curve(const LoadCurveParameters& parameters, double duration);

}  // namespace stroma::mechanics
