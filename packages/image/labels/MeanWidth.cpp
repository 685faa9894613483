// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/MeanWidth.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace stroma::image {

double mean_width(const base::Communicator& communicator, const voxels::LabelVolume& labels,
                  std::int32_t label) {
  const std::int64_t nx = labels.size[0], ny = labels.size[1];
  // The plane above this slab, whose owner is some later rank.
  voxels::Box above{{0, 0, labels.first_plane + labels.planes}, {nx, ny, 1}};
  if (labels.planes == 0 || above.first[2] >= labels.size[2]) above.count = {0, 0, 0};
  const std::vector<std::int32_t> next = voxels::extract(communicator, labels, above);

  std::array<std::int64_t, 4> counts{0, 0, 0, 0};  // crossings along x, y, z; voxels of the label
  for (std::int64_t k = 0; k < labels.planes; ++k) {
    const std::int32_t* plane = labels.plane(k);
    const std::int32_t* upper = k + 1 < labels.planes ? labels.plane(k + 1)
                                : next.empty()        ? nullptr
                                                      : next.data();
    for (std::int64_t v = 0; v < nx * ny; ++v) {
      const bool inside = plane[v] == label;
      counts[3] += inside ? 1 : 0;
      if (v % nx + 1 < nx && (plane[v + 1] == label) != inside) ++counts[0];
      if (v + nx < nx * ny && (plane[v + nx] == label) != inside) ++counts[1];
      if (upper && (upper[v] == label) != inside) ++counts[2];
    }
  }
  communicator.sum_all(counts.data(), counts.size());
  if (counts[3] == 0) return 0.0;

  const bool solid = labels.size[2] > 1;
  const int directions = solid ? 3 : 2;
  const auto voxels = static_cast<double>(labels.voxels());
  double crossings = 0.0;  // per length
  for (int d = 0; d < directions; ++d)
    crossings += static_cast<double>(counts[d]) / (voxels * labels.voxel_size[d]) / directions;
  if (crossings == 0.0) return std::numeric_limits<double>::infinity();
  const double fraction = static_cast<double>(counts[3]) / voxels;
  const double surface = (solid ? 2.0 : std::acos(-1.0) / 2.0) * crossings;
  return 4.0 * fraction / surface;
}

}  // namespace stroma::image
