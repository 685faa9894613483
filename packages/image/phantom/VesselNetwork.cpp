// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/phantom/VesselNetwork.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/image/phantom/CounterRandom.hpp"

namespace stroma::image {
namespace {

using Vector = std::array<double, 3>;

Vector along(const Vector& a, double s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
Vector minus(const Vector& a, const Vector& b) { return along(a, -1.0, b); }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& a) { return std::sqrt(dot(a, a)); }
Vector unit(const Vector& a) {
  const double l = length(a);
  return l > 0.0 ? Vector{a[0] / l, a[1] / l, a[2] / l} : Vector{1.0, 0.0, 0.0};
}

/// The growing end of a vessel.
struct Sprout {
  Vector position, direction;
  double radius;
  double until_branch;   ///< way left to the next branching [um]
  double capillary_way;  ///< way left as a capillary [um]
  int vessel;            ///< number of the vessel it started from
};

class Network {
 public:
  explicit Network(const NetworkParameters& parameters)
      : p_(parameters),
        random_(parameters.seed),
        step_(parameters.smallest_radius * 1.2),
        flatness_(std::min(1.0, 3.0 * p_.box[2] / std::max(p_.box[0], p_.box[1]))) {}

  std::vector<TubeSegment> grow() {
    for (int vessel = 0; volume_ < p_.tube_volume && vessel < 100000; ++vessel)
      start_vessel(vessel);
    return std::move(segments_);
  }

 private:
  /// A direction; the flatter the box, the more it lies in the plane.
  Vector any_direction() {
    return unit({random_.normal(), random_.normal(), flatness_ * random_.normal()});
  }

  void start_vessel(int vessel) {
    const Vector position = roomiest_point();
    const Vector direction = any_direction();
    const double radius = p_.largest_radius * std::pow(random_.uniform(0.15, 1.0), 0.5);
    std::vector<Sprout> sprouts;
    for (const double side : {1.0, -1.0}) {
      const Vector d{side * direction[0], side * direction[1], side * direction[2]};
      sprouts.push_back(new_sprout(position, d, radius, vessel));
    }
    while (!sprouts.empty() && volume_ < p_.tube_volume) {
      Sprout sprout = sprouts.back();
      sprouts.pop_back();
      grow_sprout(sprout, sprouts);
    }
  }

  Sprout new_sprout(const Vector& position, const Vector& direction, double radius, int vessel) {
    const double r = std::max(radius, p_.smallest_radius);
    return {position,
            direction,
            r,
            5.0 * r + random_.exponential(9.0 * r),
            random_.exponential(30.0 * p_.smallest_radius),
            vessel};
  }

  /// Of some random points, the one farthest from all vessels.
  Vector roomiest_point() {
    Vector best{};
    double best_room = -1.0;
    for (int trial = 0; trial < 12; ++trial) {
      const Vector point{random_.uniform(0.0, p_.box[0]), random_.uniform(0.0, p_.box[1]),
                         random_.uniform(0.0, p_.box[2])};
      double room = 1e300;
      for (const TubeSegment& segment : segments_)
        room = std::min(room, length(minus(segment.from, point)));
      if (room > best_room) {
        best_room = room;
        best = point;
      }
    }
    return best;
  }

  void grow_sprout(Sprout sprout, std::vector<Sprout>& sprouts) {
    while (volume_ < p_.tube_volume) {
      const double before = sprout.radius;
      sprout.radius =
          std::max(p_.smallest_radius, sprout.radius * (1.0 - 0.006 * step_ / sprout.radius));
      turn(sprout);
      const Vector next = along(sprout.position, step_, sprout.direction);
      add(sprout.position, next, before, sprout.radius, sprout.vessel);
      sprout.position = next;
      if (!near_box(next, 2.0 * sprout.radius)) return;

      const bool capillary = sprout.radius < 1.15 * p_.smallest_radius;
      if (capillary) {
        sprout.capillary_way -= step_;
        if (sprout.capillary_way < 0.0) return join_nearest(sprout);
      }
      sprout.until_branch -= step_;
      if (sprout.until_branch < 0.0 && !capillary) return branch(sprout, sprouts);
    }
  }

  void turn(Sprout& sprout) {
    Vector& d = sprout.direction;
    for (int i = 0; i < 3; ++i) d[i] += 0.16 * (i == 2 ? flatness_ : 1.0) * random_.normal();
    // The way back into a flat box, so that trunks run along it. Thin vessels may end in its faces.
    const double outside = 0.5 * sprout.radius;
    if (sprout.position[2] < -outside) d[2] = std::abs(d[2]);
    if (sprout.position[2] > p_.box[2] + outside) d[2] = -std::abs(d[2]);
    d = unit(d);
  }

  bool near_box(const Vector& point, double margin) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (point[i] < -margin || point[i] > p_.box[i] + margin) return false;
    }
    return true;
  }

  void branch(const Sprout& parent, std::vector<Sprout>& sprouts) {
    const double ratio = random_.uniform(0.5, 1.0);
    const double r = parent.radius;
    const double r1 = r / std::cbrt(1.0 + ratio * ratio * ratio), r2 = ratio * r1;
    const auto angle = [&](double own, double other) {
      const double cosine =
          (std::pow(r, 4) + std::pow(own, 4) - std::pow(other, 4)) / (2.0 * r * r * own * own);
      return std::acos(std::clamp(cosine, -0.2, 1.0));
    };
    const Vector random = any_direction();
    const Vector side = unit(along(random, -dot(random, parent.direction), parent.direction));
    const auto turned = [&](double a) {
      return unit(along({std::cos(a) * parent.direction[0], std::cos(a) * parent.direction[1],
                         std::cos(a) * parent.direction[2]},
                        std::sin(a), side));
    };
    sprouts.push_back(new_sprout(parent.position, turned(angle(r1, r2)), r1, parent.vessel));
    sprouts.push_back(new_sprout(parent.position, turned(-angle(r2, r1)), r2, parent.vessel));
  }

  /// Runs on, bending over, to the nearest vessel that it did not start from.
  void join_nearest(const Sprout& sprout) {
    const double reach = 25.0 * p_.smallest_radius;
    double nearest = reach;
    Vector goal{};
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (vessel_[s] == sprout.vessel) continue;
      const double distance = length(minus(segments_[s].from, sprout.position));
      const bool ahead = dot(minus(segments_[s].from, sprout.position), sprout.direction) > 0.0;
      if (ahead && distance < nearest) {
        nearest = distance;
        goal = segments_[s].from;
      }
    }
    if (nearest >= reach) return;
    Vector position = sprout.position, direction = sprout.direction;
    const int most = static_cast<int>(3.0 * nearest / step_) + 1;
    for (int i = 0; i < most && length(minus(goal, position)) > step_; ++i) {
      direction = unit(along(direction, 0.35, unit(minus(goal, position))));
      const Vector next = along(position, step_, direction);
      add(position, next, sprout.radius, sprout.radius, sprout.vessel);
      position = next;
    }
  }

  void add(const Vector& from, const Vector& to, double radius_from, double radius_to, int vessel) {
    segments_.push_back({from, to, radius_from, radius_to});
    vessel_.push_back(vessel);
    const double r = 0.5 * (radius_from + radius_to);
    if (near_box(from, 0.0)) volume_ += 3.14159265358979 * r * r * length(minus(to, from));
  }

  NetworkParameters p_;
  RandomSequence random_;
  double step_;
  double flatness_;  ///< how much directions leave the plane, 0 to 1
  double volume_ = 0.0;
  std::vector<TubeSegment> segments_;
  std::vector<int> vessel_;  ///< (segment) the vessel it belongs to
};

}  // namespace

std::vector<TubeSegment> grow_network(const NetworkParameters& parameters) {
  return Network(parameters).grow();
}

}  // namespace stroma::image
