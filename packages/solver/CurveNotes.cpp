// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/CurveNotes.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Log.hpp"
#include "stroma/solver/StepControl.hpp"

namespace stroma::solver {

using base::format;
using mechanics::Beyond;
using mechanics::LoadCurve;

namespace {

constexpr double rounding = 1e-9;    // of a curve's values, and of the run
constexpr double noticeable = 1e-2;  // of a curve's range

/// A curve's value at a load factor.
struct Point {
  double load, value;
};

/// What the steps have of a curve: its values where they end, and where momentum is in balance.
std::vector<Point> met_by_steps(const LoadCurve& curve, const LoadingParameters& loading) {
  const auto dynamics = loading.dynamics();
  const double back = dynamics ? dynamics->scheme.alpha_f : 0.0;  // of a step
  std::vector<Point> met;
  for (StepControl control(loading); !control.finished();) {
    const double begin = control.load();
    control.accept();
    const double end = control.load();
    if (back > 0.0) met.push_back({end - back * (end - begin), 0.0});
    met.push_back({end, 0.0});
  }
  for (Point& point : met) point.value = curve.at(point.load);
  return met;
}

/// Where a load that is repeated first comes after the begin of the run.
double first_in_run(double load, double period) {
  return load > 0.0 ? load : load + period * (std::floor(-load / period) + 1.0);
}

/// The points of a curve after the begin of the run and before its end, one that is repeated where it
/// comes first; without the last one of a curve that repeats, whose place its first point takes.
std::vector<Point> points_within(const LoadCurve& curve) {
  const bool repeats = curve.beyond == Beyond::repeat;
  const double period = curve.loads.back() - curve.loads.front();
  std::vector<Point> within;
  for (std::size_t k = 0; k < curve.loads.size() - (repeats ? 1 : 0); ++k) {
    double load = curve.loads[k];
    if (repeats) load = first_in_run(load, period);
    if (load > 0.0 && load <= 1.0) within.push_back({load, curve.values[k]});
  }
  return within;
}

/// How steps would meet a time.
std::string help_between(const LoadingParameters& loading) {
  return loading.times ? "; Loading|Times [s] with that time in them would meet it"
                       : "; Loading|Times [s] with that time in them, or more Steps, would meet it";
}

/// How a run would end later.
std::string help_after(const LoadingParameters& loading) {
  if (!loading.has_time())
    return "; without Loading|Duration [s] time is the load factor, which is 1 there";
  return loading.times ? "; the last of Loading|Times [s] sets its end"
                       : "; Loading|Duration [s] sets its end";
}

/// A curve that is 0 at all steps, and where its other values are; empty where it has none.
std::string nothing_note(const std::string& where, const LoadCurve& curve,
                         const LoadingParameters& loading) {
  const auto is_larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(curve.values.begin(), curve.values.end(), is_larger);
  if (*largest == 0.0) return "";
  const std::string none = where + " is 0 at all planned steps, so that it loads nothing: it is ";
  std::size_t at = curve.loads.size();
  bool goes_on = false;
  for (std::size_t k = 0; k < curve.loads.size(); ++k) {
    if (curve.loads[k] > 1.0 + rounding)
      goes_on = goes_on || curve.values[k] != 0.0;
    else if (curve.loads[k] > 0.0 && curve.values[k] != 0.0 &&
             (at == curve.loads.size() || is_larger(curve.values[at], curve.values[k])))
      at = k;
  }
  if (at < curve.loads.size())
    return none +
           format("%g at %g s, where no step ends", curve.values[at],
                  curve.loads[at] * loading.seconds()) +
           help_between(loading);
  if (goes_on)
    return none + format("something else after the end of the run, %g s, only", loading.seconds()) +
           help_after(loading);
  return none + format("%g at the start only", curve.at(0.0));
}

/// A largest (sign 1) or smallest (-1) value that no step comes near to; empty where one does.
std::string missed_note(const std::string& where, const LoadCurve& curve, double sign,
                        const std::vector<Point>& met, const LoadingParameters& loading) {
  const auto is_less = [&](const Point& a, const Point& b) {
    return sign * a.value < sign * b.value;
  };
  const std::vector<Point> within = points_within(curve);
  if (within.empty()) return "";
  double low = std::min(curve.at(0.0), curve.at(1.0)),
         high = std::max(curve.at(0.0), curve.at(1.0));
  for (const Point& point : within) {
    low = std::min(low, point.value);
    high = std::max(high, point.value);
  }
  const Point own = *std::max_element(within.begin(), within.end(), is_less);
  const Point most =
      std::max({*std::max_element(met.begin(), met.end(), is_less), Point{0.0, curve.at(0.0)}},
               is_less);  // the run begins with the curve's start
  if (sign * (own.value - most.value) <= noticeable * (high - low)) return "";
  const auto after = std::upper_bound(met.begin(), met.end() - 1, own.load,
                                      [](double load, const Point& p) { return load < p.load; });
  const Point before = after == met.begin() ? Point{0.0, curve.at(0.0)} : *(after - 1);
  const double seconds = loading.seconds();
  return where +
         format(
             " is %g at %g s, its %s value in the run, but no step is planned to end there: about "
             "it steps have %g at %g s and %g at %g s",
             own.value, own.load * seconds, sign > 0.0 ? "largest" : "smallest", before.value,
             before.load * seconds, after->value, after->load * seconds) +
         help_between(loading);
}

/// Values that a curve has after the end of the run only; empty where it has none.
std::string cut_note(const std::string& where, const LoadCurve& curve,
                     const LoadingParameters& loading) {
  const auto [low, high] = std::minmax_element(curve.values.begin(), curve.values.end());
  const double least = noticeable * (*high - *low), last = curve.at(1.0);
  for (std::size_t k = 0; k < curve.loads.size(); ++k)
    if (curve.loads[k] > 1.0 + rounding && std::abs(curve.values[k] - last) > least)
      return where +
             format(" goes on until %g s, to %g, but the run ends at %g s, where it is %g",
                    curve.loads.back() * loading.seconds(), curve.values.back(), loading.seconds(),
                    last) +
             help_after(loading);
  return "";
}

/// A curve that ends with another value than it begins again with; empty where it does not.
std::string jump_note(const std::string& where, const LoadCurve& curve,
                      const LoadingParameters& loading) {
  if (curve.beyond != Beyond::repeat || curve.interpolation == mechanics::Interpolation::step)
    return "";
  const auto [low, high] = std::minmax_element(curve.values.begin(), curve.values.end());
  const double first = curve.values.front(), last = curve.values.back();
  const double period = curve.loads.back() - curve.loads.front();
  const double jump = first_in_run(curve.loads.back(), period);
  if (jump > 1.0 + rounding || std::abs(last - first) <= noticeable * (*high - *low)) return "";
  return where + format(
                     " jumps from %g to %g at %g s, where it begins again: a step that ends "
                     "there has %g",
                     last, first, jump * loading.seconds(), first);
}

}  // namespace

std::vector<std::string> curve_notes(const std::string& name,
                                     const mechanics::LoadCurveParameters& parameters,
                                     const LoadingParameters& loading) {
  const LoadCurve curve = mechanics::load_curve(parameters, loading.seconds());
  const std::string where = "Load Curves|" + name;
  const std::vector<Point> met = met_by_steps(curve, loading);
  double size = 0.0;
  for (const double value : curve.values) size = std::max(size, std::abs(value));
  const bool is_nothing = std::all_of(met.begin(), met.end(), [&](const Point& point) {
    return std::abs(point.value) <= rounding * size;
  });
  std::vector<std::string> notes;
  for (const std::string& note :
       is_nothing ? std::vector<std::string>{nothing_note(where, curve, loading)}
                  : std::vector<std::string>{missed_note(where, curve, 1.0, met, loading),
                                             missed_note(where, curve, -1.0, met, loading),
                                             jump_note(where, curve, loading),
                                             cut_note(where, curve, loading)})
    if (!note.empty()) notes.push_back(note);
  return notes;
}

std::string advice_on_start(const std::string& name,
                            const mechanics::LoadCurveParameters& parameters) {
  const double start = mechanics::load_curve(parameters, 1.0).at(0.0);
  if (start == 0.0) return "";
  return "Load Curves|" + name +
         format(
             " is %g from the start, however small the first step is: a first point of 0 at 0 s, "
             "from which it rises",
             start);
}

}  // namespace stroma::solver
