// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/body/FittedGrid.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/particles/Migration.hpp"

namespace stroma::mechanics {
namespace {

/// \param most  elements of the undeformed body
std::int64_t elements_between(double length, double asked_size, std::int64_t last_count,
                              std::int64_t most) {
  constexpr double a_quarter = 1.25;
  const double stretch = length / (static_cast<double>(last_count) * asked_size);
  if (stretch < a_quarter && stretch > 1.0 / a_quarter) return last_count;
  return std::clamp<std::int64_t>(std::llround(length / asked_size), 1, most);
}

/// An end of the body along an axis.
struct End {
  bool is_plane;  ///< nodes keep it a plane
  bool is_fixed;  ///< the lattice ends there
  double place;   ///< [um]
};

/// \param outermost  how far the body reaches there
End end_of(const Problem& problem, double load, Face face, double outermost) {
  if (problem.is_kept_plane(face)) return {true, true, problem.place_of_plane(face, load)};
  const auto is_gripped = [&](const auto& named) {
    return named.second.applies_to(face) && problem.imposed_by(named.second) != ImposedBy::penalty;
  };
  const bool is_known = problem.outer_thickness[static_cast<std::size_t>(axis_of(face))] > 0.0;
  const bool is_fixed =
      is_known && !problem.dynamics &&
      std::none_of(problem.conditions.begin(), problem.conditions.end(), is_gripped);
  return {false, is_fixed, outermost};
}

/// Lays an axis of the lattice between its ends.
/// \param last_count  elements of the lattice of the step before
void fit_axis(double load, std::int64_t last_count, int d, const End& lower, const End& upper,
              grid::Grid& lattice) {
  const auto i = static_cast<std::size_t>(d);
  if (lower.is_fixed && upper.is_fixed) {
    const double length = upper.place - lower.place;
    if (!(length > 0.0))
      throw base::RunError(base::format(
          "at load %.6g the body's faces across %c have met or passed each other", load, "xyz"[d]));
    lattice.elements[i] =
        elements_between(length, lattice.spacing[i], last_count, lattice.elements[i]);
    lattice.spacing[i] = length / static_cast<double>(lattice.elements[i]);
    lattice.origin[i] = lower.place;
  } else if (lower.is_plane) {
    lattice.origin[i] = lower.place;
  } else if (upper.is_plane) {
    lattice.origin[i] = upper.place - lattice.length(d);
  }
}

/// Adds a knot at a free end beyond which particles lie too far: functions are negative there, and
/// the masses of nodes would be with them.
void enclose(const particles::FixedEnds& is_fixed, const particles::ParticleExtent& extent,
             grid::Grid& grid) {
  constexpr double share = 0.1;  // of an element
  for (int d = 0; d < 3; ++d) {
    if (!grid.centered || (grid.flat && d == 2)) continue;
    const auto i = static_cast<std::size_t>(d);
    const double h = grid.spacing[i], first = grid.origin[i] + 0.5 * h,
                 last = first + static_cast<double>(grid.elements[i] - 1) * h;
    if (extent.lowest[i] + share * h < first && !is_fixed[i][0]) {
      grid.origin[i] -= h;
      ++grid.elements[i];
    }
    if (extent.highest[i] - share * h > last && !is_fixed[i][1]) ++grid.elements[i];
  }
}

}  // namespace

grid::Grid fitted_grid(const base::Communicator& communicator, const Problem& problem, double load,
                       const grid::Grid& last,
                       const particles::Particles<grid::Device>& particles) {
  std::array<double, 3> half_edge = problem.outer_thickness;
  for (double& edge : half_edge) edge *= 0.5;
  const particles::ParticleExtent centers = particles::extent_of(communicator, particles),
                                  boxes = particles::extent_of(communicator, particles, half_edge);
  particles::require_together(boxes, problem.body);
  grid::Grid lattice = problem.body;
  particles::FixedEnds is_fixed{};
  for (int d = 0; d < (lattice.flat ? 2 : 3); ++d) {
    const auto i = static_cast<std::size_t>(d);
    const End lower = end_of(problem, load, face_of(d, false), boxes.lowest[i]),
              upper = end_of(problem, load, face_of(d, true), boxes.highest[i]);
    fit_axis(load, last.elements[i] - (last.centered ? 1 : 0), d, lower, upper, lattice);
    is_fixed[i] = lower.is_fixed && upper.is_fixed
                      ? std::array<bool, 2>{true, true}
                      : std::array<bool, 2>{lower.is_plane, upper.is_plane};
  }
  grid::Grid grid = particles::covering_grid(
      centers, grid::grid_for(problem.method.shape_functions, lattice), is_fixed);
  if (problem.dynamics) enclose(is_fixed, centers, grid);
  return grid;
}

}  // namespace stroma::mechanics
