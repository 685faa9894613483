// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/report/MapLattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_set>
#include <vector>

namespace stroma::output {
namespace {

/// Distinct coordinates, ascending; those that differ by rounding are one.
std::vector<double> distinct(const std::unordered_set<double>& found) {
  std::vector<double> sorted(found.begin(), found.end());
  std::sort(sorted.begin(), sorted.end());
  if (sorted.size() < 2) return sorted;
  const double rounding =
      1e-3 * (sorted.back() - sorted.front()) / static_cast<double>(sorted.size());
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                           [&](double a, double b) { return b - a <= rounding; }),
               sorted.end());
  return sorted;
}

/// The mean of the distances between neighbours but for those of half as much again as the median:
/// of Gauss points, whose distances take turns, and across planes that are empty. 0 if there is one
/// coordinate only.
double usual_distance(const std::vector<double>& coordinates) {
  if (coordinates.size() < 2) return 0.0;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < coordinates.size(); ++i)
    gaps.push_back(coordinates[i] - coordinates[i - 1]);
  const auto median = gaps.begin() + static_cast<std::ptrdiff_t>((gaps.size() - 1) / 2);
  std::nth_element(gaps.begin(), median, gaps.end());
  const double most = 1.5 * *median;
  const auto wide =
      std::partition(gaps.begin(), gaps.end(), [&](double gap) { return gap <= most; });
  return std::accumulate(gaps.begin(), wide, 0.0) / static_cast<double>(wide - gaps.begin());
}

}  // namespace

std::size_t MapLattice::cell_of(double x, double y, double z) const {
  const std::array<double, 3> place{x, y, z};
  std::int64_t index = 0;
  for (std::size_t d = 3; d-- > 0;) {
    const auto along = static_cast<std::int64_t>(std::floor((place[d] - origin[d]) / cell[d]));
    index = index * count[d] + std::clamp<std::int64_t>(along, 0, count[d] - 1);
  }
  return static_cast<std::size_t>(index);
}

MapLattice lattice_of(const ParticleReader& particles) {
  std::array<std::unordered_set<double>, 3> found;
  double volume = 0.0;  // of a particle
  particles.for_pieces(0, {}, [&](const ParticlePiece& piece) {
    for (std::size_t d = 0; d < 3; ++d) {
      double last = NAN;
      for (const double x : piece.position[d])
        if (x != last) found[d].insert(last = x);
    }
    if (volume == 0.0) volume = piece.volume.front();
  });
  MapLattice lattice;
  double known = 1.0;  // product of the edges that are
  int unknown = 0;
  std::array<std::vector<double>, 3> coordinates;
  for (std::size_t d = 0; d < 3; ++d) {
    coordinates[d] = distinct(found[d]);
    found[d] = {};
    lattice.cell[d] = usual_distance(coordinates[d]);
    if (lattice.cell[d] > 0.0)
      known *= lattice.cell[d];
    else
      ++unknown;
  }
  for (std::size_t d = 0; d < 3; ++d) {
    if (lattice.cell[d] == 0.0) lattice.cell[d] = std::pow(volume / known, 1.0 / unknown);
    const std::vector<double>& x = coordinates[d];
    const double extent = x.empty() ? 0.0 : x.back() - x.front();
    lattice.count[d] = std::llround(extent / lattice.cell[d]) + 1;
    lattice.cell[d] = std::max(lattice.cell[d], extent / static_cast<double>(lattice.count[d]));
    lattice.length[d] = static_cast<double>(lattice.count[d]) * lattice.cell[d];
    lattice.origin[d] = (x.empty() ? 0.0 : x.front()) - 0.5 * lattice.cell[d];
  }
  return lattice;
}

MapLattice merged(const MapLattice& lattice, std::size_t most_cells) {
  MapLattice coarse = lattice;
  while (coarse.cells() > std::max<std::size_t>(most_cells, 1)) {
    const bool is_flat = coarse.count[0] == 1 && coarse.count[1] == 1;
    const bool in_plane =
        !is_flat &&
        (coarse.count[2] == 1 || coarse.cell[2] >= 2.0 * std::min(coarse.cell[0], coarse.cell[1]));
    for (std::size_t axis = in_plane ? 0 : 2; axis < (in_plane ? 2 : 3); ++axis) {
      const std::int64_t factor = ++coarse.merged[axis];
      coarse.count[axis] = (lattice.count[axis] + factor - 1) / factor;
      coarse.cell[axis] = lattice.cell[axis] * static_cast<double>(factor);
    }
  }
  return coarse;
}

}  // namespace stroma::output
