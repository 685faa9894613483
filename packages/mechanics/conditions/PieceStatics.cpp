// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/PieceStatics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "stroma/base/Log.hpp"

namespace stroma::mechanics {
namespace {

using base::format;
using Vector = std::array<double, 3>;

constexpr double negligible_load = 1e-6;  // so many digits a deck's numbers have at least

double norm(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// "x", or "(0.6, 0.8, 0)" for a direction along no axis.
std::string direction(const Vector& v) {
  const double length = norm(v);
  Vector unit;
  for (std::size_t d = 0; d < 3; ++d) {
    unit[d] = v[d] / length;
    if (std::abs(unit[d]) < 1e-6) unit[d] = 0.0;
  }
  for (std::size_t d = 0; d < 3; ++d)
    if (std::abs(unit[d]) == norm(unit)) return std::string(1, "xyz"[d]);
  return format("(%.3g, %.3g, %.3g)", unit[0], unit[1], unit[2]);
}

/// The part of a sum that lies in the span of orthonormal motions.
RigidMode projected(const RigidMode& sum, const std::vector<RigidMode>& basis) {
  RigidMode part{};
  for (const RigidMode& z : basis) {
    const double share = dot(sum, z);
    for (std::size_t i = 0; i < 6; ++i) part[i] += share * z[i];
  }
  return part;
}

}  // namespace

void PieceSums::add_held(const RigidFrame& frame, const NodeComponent& at, double u) {
  const RigidMode m = frame.motion(at);
  add_product(held, m);
  for (std::size_t i = 0; i < 6; ++i) forced[i] += m[i] * u;
  squares[static_cast<std::size_t>(at.component)] += u * u;
}

void PieceSums::add_load(const RigidFrame& frame, const Vector& position, const Vector& force) {
  for (int c = 0; c < 3; ++c) {
    const RigidMode m = frame.motion({0, position, c});
    for (std::size_t i = 0; i < 6; ++i) load[i] += m[i] * force[static_cast<std::size_t>(c)];
  }
  load_size += norm(force);
}

void PieceSums::add(const PieceSums& other) {
  elements += other.elements;
  particles += other.particles;
  for (std::size_t d = 0; d < 3; ++d) {
    lower[d] = std::min(lower[d], other.lower[d]);
    upper[d] = std::max(upper[d], other.upper[d]);
    squares[d] += other.squares[d];
  }
  for (std::size_t i = 0; i < held.size(); ++i) held[i] += other.held[i];
  for (std::size_t i = 0; i < forced.size(); ++i) forced[i] += other.forced[i];
  for (std::size_t i = 0; i < load.size(); ++i) load[i] += other.load[i];
  load_size += other.load_size;
  turned += other.turned;
  stress_size += other.stress_size;
}

RigidFrame PieceSums::own_frame() const {
  RigidFrame frame;
  frame.length = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    frame.centre[d] = 0.5 * (lower[d] + upper[d]);
    frame.length = std::max(frame.length, 0.5 * (upper[d] - lower[d]));
  }
  return frame;
}

bool is_misfit(double misfit, double squares) { return misfit > 1e-12 * squares; }

PieceVerdict judge(const PieceSums& piece, const RigidFrame& frame) {
  const RigidFrame own = piece.own_frame();
  const HeldMotions motions(frame.sums_in(own, piece.held));
  const double squares = piece.squares[0] + piece.squares[1] + piece.squares[2];
  PieceVerdict verdict;
  verdict.has_free_motion = !motions.free().empty();
  verdict.is_strained =
      is_misfit(motions.misfit(frame.sums_in(own, piece.forced), squares), squares);
  double misfit = squares;
  for (std::size_t c = 0; c < 3; ++c) {
    const double count = piece.held[7 * c];
    if (count == 0.0) continue;
    verdict.translation[c] = piece.forced[c] / count;
    misfit -= piece.forced[c] * piece.forced[c] / count;
  }
  verdict.is_idle = piece.load_size == 0.0 && piece.stress_size == 0.0 && piece.turned == 0.0 &&
                    !is_misfit(misfit, squares);
  return verdict;
}

std::string free_resultant(const PieceSums& piece, const RigidFrame& frame, bool with_moments,
                           bool with_size) {
  const RigidFrame own = piece.own_frame();
  const RigidGram held = frame.sums_in(own, piece.held);
  const RigidMode load = frame.sums_in(own, piece.load);
  // With all rotations held besides, translations alone are left.
  RigidGram held_upright = held;
  double trace = 0.0;
  for (std::size_t i = 0; i < 6; ++i) trace += held[7 * i];
  for (std::size_t i = 3; i < 6; ++i) held_upright[7 * i] += trace > 0.0 ? trace : 1.0;

  const RigidMode push = projected(load, HeldMotions(held_upright).free());
  const Vector force{push[0], push[1], push[2]};
  if (norm(force) > negligible_load * piece.load_size)
    return "along " + direction(force) + (with_size ? format(": %.6g pN", norm(force)) : "");

  RigidMode turn = projected(load, HeldMotions(held).free());
  for (std::size_t i = 0; i < 6; ++i) turn[i] -= push[i];
  const double work = std::sqrt(dot(turn, turn));
  if (!with_moments || !(work > negligible_load * piece.load_size)) return "";
  const Vector t{turn[0], turn[1], turn[2]}, w{turn[3], turn[4], turn[5]};
  Vector point = own.centre;  // on the axis, where u = t + w x r vanishes
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
    point[d] += own.length * (w[e] * t[f] - w[f] * t[e]) / (norm(w) * norm(w));
    if (std::abs(point[d] - own.centre[d]) < 1e-6 * own.length) point[d] = own.centre[d];
  }
  return format("about the axis along %s through (%.6g, %.6g, %.6g) um", direction(w).c_str(),
                point[0], point[1], point[2]) +
         (with_size ? format(": %.6g pN um", own.length * work * work / norm(w)) : "");
}

std::string describe(const PieceSums& piece) {
  const Vector at = piece.own_frame().centre;
  Vector size;
  for (std::size_t d = 0; d < 3; ++d) size[d] = piece.upper[d] - piece.lower[d];
  return format(
      "%lld element%s with %lld particle%s around (%.4g, %.4g, %.4g) um, %.4g x %.4g x %.4g um "
      "large",
      static_cast<long long>(piece.elements), piece.elements == 1 ? "" : "s",
      static_cast<long long>(piece.particles), piece.particles == 1 ? "" : "s", at[0], at[1], at[2],
      size[0], size[1], size[2]);
}

}  // namespace stroma::mechanics
