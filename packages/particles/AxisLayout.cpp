// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/particles/AxisLayout.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Log.hpp"

namespace stroma::particles {
namespace {

/// Distance of Gauss points from the middle of their element [elements].
const double gauss_offset = 0.5 / std::sqrt(3.0);

/// Points along axis d in each voxel (Voxel Centers) or element (the others).
int points_along(const ParticleParameters& parameters, const grid::Grid& grid, int d) {
  if (parameters.layout == Layout::gauss) return 2;
  if (grid.flat && d == 2) return 1;
  return parameters.layout == Layout::voxel_centers ? parameters.per_voxel : parameters.per_element;
}

/// Voxel Centers, `parts` to a voxel.
void lay_pieces(AxisLayout& axis, const grid::Grid& grid, int d, std::int64_t first,
                std::int64_t last, std::int64_t voxels, double voxel_size, int parts) {
  const std::int64_t elements = grid.elements[d];
  const bool varies = !(grid.flat && d == 2);
  const auto units = static_cast<double>(4 * elements);  // of twice a part
  const auto add = [&](std::int64_t part, std::int64_t begin, std::int64_t end) {
    const double centre = static_cast<double>(begin + end) / units;
    const double share = static_cast<double>(2 * (end - begin)) / units;
    axis.position.push_back(grid.origin[d] + centre / parts * voxel_size);
    axis.length.push_back(share * (voxel_size / parts));
    axis.half_edge.push_back(0.5 * axis.length.back());
    axis.voxel.push_back(part / parts);
  };
  for (std::int64_t e = 0; e < elements; ++e) {
    const bool is_kept = e >= first && e < last;
    if (is_kept) axis.element_begin.push_back(static_cast<int>(axis.position.size()));
    for_each_piece(
        e, elements, voxels * parts, [&](std::int64_t part, std::int64_t begin, std::int64_t end) {
          const bool is_long = varies && 2 * (end - begin) > 3 * voxels * parts;
          const std::int64_t points = is_long ? 2 : 1;
          axis.total += points;
          if (e < first) axis.first += points;
          for (std::int64_t n = 0; is_kept && n < points; ++n)
            add(part, begin + n * (end - begin) / points, begin + (n + 1) * (end - begin) / points);
        });
  }
}

/// The same points in each element: Gauss's, or equally spaced ones; their shares are equal.
void lay_points(AxisLayout& axis, const grid::Grid& grid, int d, std::int64_t first,
                std::int64_t last, std::int64_t voxels, double voxel_size, bool gauss, int points) {
  const double h = grid.spacing[d];
  axis.total = grid.elements[d] * points;
  axis.first = first * points;
  for (std::int64_t e = first; e < last; ++e) {
    axis.element_begin.push_back(static_cast<int>(axis.position.size()));
    for (int n = 0; n < points; ++n) {
      const double xi = gauss ? 0.5 + (n == 0 ? -gauss_offset : gauss_offset) : (n + 0.5) / points;
      const double distance = (static_cast<double>(e) + xi) * h;
      axis.position.push_back(grid.origin[d] + distance);
      axis.length.push_back(h / points);
      axis.half_edge.push_back(gauss ? (0.5 - gauss_offset) * h : 0.5 * axis.length.back());
      const auto voxel = static_cast<std::int64_t>(std::floor(distance / voxel_size));
      axis.voxel.push_back(std::clamp<std::int64_t>(voxel, 0, voxels - 1));
    }
  }
}

/// "x and y", of the axes for which a statement holds.
template <class Holds>
std::string axes_where(const Holds& holds) {
  std::string axes;
  for (int d = 0; d < 3; ++d)
    if (holds(d)) axes += (axes.empty() ? "" : " and ") + std::string(1, "xyz"[d]);
  return axes;
}

}  // namespace

AxisLayout axis_layout(const ParticleParameters& parameters, const grid::Grid& grid, int d,
                       std::int64_t begin, std::int64_t end, std::int64_t voxels,
                       double voxel_size) {
  AxisLayout axis;
  const int points = points_along(parameters, grid, d);
  if (parameters.layout == Layout::voxel_centers)
    lay_pieces(axis, grid, d, begin, end, voxels, voxel_size, points);
  else
    lay_points(axis, grid, d, begin, end, voxels, voxel_size, parameters.layout == Layout::gauss,
               points);
  axis.element_begin.push_back(static_cast<int>(axis.position.size()));
  return axis;
}

LayoutSizes layout_sizes(const ParticleParameters& parameters, const grid::Grid& grid,
                         const std::array<std::int64_t, 3>& voxels,
                         const std::array<double, 3>& voxel_size) {
  LayoutSizes sizes;
  for (std::size_t d = 0; d < 3; ++d) {
    AxisLayout axis = axis_layout(parameters, grid, static_cast<int>(d), 0, grid.elements[d],
                                  voxels[d], voxel_size[d]);
    sizes.spacing[d] = *std::max_element(axis.length.begin(), axis.length.end());
    sizes.outer_thickness[d] = axis.length.front();
    sizes.half_edge[d] = std::move(axis.half_edge);
  }
  return sizes;
}

std::vector<std::string> layout_notes(const ParticleParameters& parameters, const grid::Grid& grid,
                                      const std::array<std::int64_t, 3>& voxels) {
  std::vector<std::string> notes;
  const auto varies = [&](int d) { return !(grid.flat && d == 2); };
  const auto voxels_along = [&](int d) { return voxels[static_cast<std::size_t>(d)]; };
  const std::string finer =
      axes_where([&](int d) { return varies(d) && grid.elements[d] > voxels_along(d); });
  if (!finer.empty())
    notes.push_back(
        "elements are finer than voxels along " + finer +
        ": the grid resolves the steps of the voxels, which the specimen does not have");
  if (parameters.layout == Layout::voxel_centers) return notes;

  const std::string cut = axes_where([&](int d) {
    return varies(d) && grid.elements[d] * points_along(parameters, grid, d) % voxels_along(d) != 0;
  });
  const std::string layout =
      parameters.layout == Layout::gauss
          ? "Gauss"
          : base::format("Per Element with Per Element = %d", parameters.per_element);
  if (!cut.empty())
    notes.push_back("Particles|Layout = " + layout + " does not resolve the voxels along " + cut +
                    ": a particle stands for more than the voxel whose label it has; \"Voxel "
                    "Centers\" resolves every voxel");
  if (parameters.layout == Layout::per_element && parameters.per_element == 1)
    notes.push_back(
        "Particles|Layout = Per Element with Per Element = 1 under-integrates: some motions of an "
        "element's nodes do not deform its only particle and are not resisted; \"Voxel Centers\", "
        "or Per Element = 2 or more, does not");
  return notes;
}

}  // namespace stroma::particles
