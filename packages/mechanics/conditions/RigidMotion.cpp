// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/RigidMotion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace stroma::mechanics {
namespace {

using Mode = RigidMode;
using Frame = RigidFrame;

Frame frame_of(const base::Communicator& communicator, const NodeComponents& a,
               const NodeComponents& b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lowest{infinity, infinity, infinity};
  std::array<double, 3> highest{-infinity, -infinity, -infinity};
  for (const auto* components : {&a, &b})
    (*components)([&](const NodeComponent& at) {
      for (std::size_t d = 0; d < 3; ++d) {
        lowest[d] = std::min(lowest[d], at.position[d]);
        highest[d] = std::max(highest[d], at.position[d]);
      }
    });
  Frame frame;
  frame.length = 0.0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double lower = communicator.min(lowest[d]);
    const double upper = communicator.max(highest[d]);
    frame.centre[d] = 0.5 * (lower + upper);
    frame.length = std::max(frame.length, 0.5 * (upper - lower));
  }
  return frame;
}

/// Orthonormal basis of the motions that the prescribed components leave free.
std::vector<Mode> null_space(const base::Communicator& communicator, const Frame& frame,
                             const NodeComponents& prescribed) {
  RigidGram gram{};
  prescribed([&](const NodeComponent& at) { add_product(gram, frame.motion(at)); });
  communicator.sum_all(gram.data(), gram.size());
  return HeldMotions(gram).free();
}

/// Removes from an orthonormal basis the direction that holding motion m takes away.
void remove_direction(std::vector<Mode>& basis, const Mode& m) {
  Mode held{};
  for (const Mode& z : basis)
    for (std::size_t i = 0; i < 6; ++i) held[i] += dot(z, m) * z[i];
  const double norm = std::sqrt(dot(held, held));
  for (double& h : held) h /= norm;

  std::vector<Mode> rest;
  const std::size_t size = basis.size() - 1;
  std::vector<Mode> candidates = basis;
  std::vector<Mode> taken{held};
  while (rest.size() < size) {  // Gram-Schmidt with pivoting
    Mode best{};
    double longest = -1.0;
    for (Mode z : candidates) {
      for (const Mode& t : taken) {
        const double projection = dot(z, t);
        for (std::size_t i = 0; i < 6; ++i) z[i] -= projection * t[i];
      }
      const double length = std::sqrt(dot(z, z));
      if (length > longest) {
        longest = length;
        best = z;
      }
    }
    for (double& b : best) b /= longest;
    rest.push_back(best);
    taken.push_back(best);
  }
  basis = rest;
}

/// The candidate that stops most of what is free, agreed on by all ranks; ties go to the lowest
/// node. Returns false if none stops anything.
bool best_candidate(const base::Communicator& communicator, const Frame& frame,
                    const std::vector<Mode>& basis, const NodeComponents& free,
                    const std::function<bool(const NodeComponent&)>& admissible,
                    NodeComponent& chosen) {
  double best = 0.0;
  NodeComponent mine{std::numeric_limits<std::int64_t>::max(), {}, 0};
  free([&](const NodeComponent& at) {
    if (!admissible(at)) return;
    double stopped = 0.0;
    const Mode m = frame.motion(at);
    for (const Mode& z : basis) stopped += dot(z, m) * dot(z, m);
    if (stopped > best * (1.0 + 1e-9)) {
      best = stopped;
      mine = at;
    }
  });
  const double most = communicator.max(best);
  if (most < 1e-6) return false;
  const bool in_race = best >= most * (1.0 - 1e-9);
  const std::int64_t node =
      communicator.min(in_race ? mine.node : std::numeric_limits<std::int64_t>::max());
  const int winner =
      communicator.min(in_race && mine.node == node ? communicator.rank() : communicator.size());
  communicator.broadcast(mine.node, winner);
  communicator.broadcast(mine.position.data(), 3, winner);
  communicator.broadcast(mine.component, winner);
  chosen = mine;
  return true;
}

/// Position of the free node next to the body's centre (the lowest of equals).
std::array<double, 3> central_node(const base::Communicator& communicator, const Frame& frame,
                                   const NodeComponents& free) {
  double nearest = std::numeric_limits<double>::infinity();
  NodeComponent mine{std::numeric_limits<std::int64_t>::max(), {}, 0};
  free([&](const NodeComponent& at) {
    double distance = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
      distance += std::pow((at.position[d] - frame.centre[d]) / frame.length, 2);
    distance = std::round(distance * 1e9);  // so that equal distances tie
    if (distance < nearest || (distance == nearest && at.node < mine.node)) {
      nearest = distance;
      mine = at;
    }
  });
  const bool in_race = nearest == communicator.min(nearest);
  const std::int64_t node =
      communicator.min(in_race ? mine.node : std::numeric_limits<std::int64_t>::max());
  const int winner =
      communicator.min(in_race && mine.node == node ? communicator.rank() : communicator.size());
  if (winner < communicator.size()) communicator.broadcast(mine.position.data(), 3, winner);
  return mine.position;
}

}  // namespace

std::vector<NodeComponent> free_rigid_motions(const base::Communicator& communicator,
                                              const NodeComponents& prescribed,
                                              const NodeComponents& free) {
  const Frame frame = frame_of(communicator, prescribed, free);
  std::vector<Mode> basis = null_space(communicator, frame, prescribed);
  std::vector<NodeComponent> held;
  if (basis.empty()) return held;

  const std::array<double, 3> centre = central_node(communicator, frame, free);
  const auto axes_off_centre = [&](const NodeComponent& at) {
    int off = 0;
    for (std::size_t d = 0; d < 3; ++d)
      if (std::abs(at.position[d] - centre[d]) > 1e-9 * frame.length) ++off;
    return off;
  };
  for (const int reach : {0, 1, 3}) {  // the centre; straight along an axis; anywhere
    NodeComponent chosen;
    while (!basis.empty() &&
           best_candidate(
               communicator, frame, basis, free,
               [&](const NodeComponent& at) { return axes_off_centre(at) <= reach; }, chosen)) {
      held.push_back(chosen);
      remove_direction(basis, frame.motion(chosen));
    }
  }
  return held;
}

}  // namespace stroma::mechanics
