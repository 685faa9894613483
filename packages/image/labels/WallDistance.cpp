// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/WallDistance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stroma::image {
namespace {

/// Where a voxel is: the label's, or not.
using Side = std::uint8_t;

/// (distance in voxels) The square of the distance from a middle to the nearest face of a voxel so
/// many away, up to a limit [um^2].
std::vector<float> squares(double voxel_size, double limit) {
  std::vector<float> all{0.0F};
  for (int n = 1; (n - 0.5) * voxel_size < limit; ++n)
    all.push_back(static_cast<float>((n - 0.5) * (n - 0.5) * voxel_size * voxel_size));
  return all;
}

/// Calls use(first, step) for each line of a block of voxels along an axis.
template <class Use>
void for_each_line(const std::array<std::int64_t, 3>& size, std::size_t axis, const Use& use) {
  const std::array<std::int64_t, 3> step{1, size[0], size[0] * size[1]};
  const std::size_t a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  for (std::int64_t m = 0; m < size[b]; ++m)
    for (std::int64_t n = 0; n < size[a]; ++n) use(n * step[a] + m * step[b], step[axis]);
}

/// How many voxels along z the nearest one of the other side is away, up to 255, in strips of whole
/// rows: stored plane by plane of y, x fastest, then z.
voxels::Volume<std::uint8_t> along_z(const base::Communicator& communicator,
                                     const voxels::LabelVolume& labels, std::int32_t label) {
  const std::int64_t nx = labels.size[0], ny = labels.size[1], nz = labels.size[2];
  voxels::Volume<std::uint8_t> away(communicator, {nx, nz, ny}, {1.0, 1.0, 1.0});
  const std::vector<std::int32_t> strip =
      voxels::extract(communicator, labels, {{0, away.first_plane, 0}, {nx, away.planes, nz}});
  const auto is_label = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return strip[static_cast<std::size_t>(i + nx * (j + away.planes * k))] == label;
  };
  for (std::int64_t j = 0; j < away.planes; ++j)
    for (const bool is_upwards : {true, false})
      for (std::int64_t i = 0; i < nx; ++i) {
        int since = 255;  // voxels since the last one of the other side
        for (std::int64_t n = 0; n < nz; ++n) {
          const std::int64_t k = is_upwards ? n : nz - 1 - n, before = is_upwards ? k - 1 : k + 1;
          since =
              n > 0 && is_label(i, j, before) != is_label(i, j, k) ? 1 : std::min(since + 1, 255);
          std::uint8_t& here = away.plane(j)[i + nx * k];
          here = static_cast<std::uint8_t>(is_upwards ? since : std::min<int>(here, since));
        }
      }
  return away;
}

/// Searches the lines of a block along an axis: squares of distances within lines before become
/// those within planes, or space.
void search_along(const std::array<std::int64_t, 3>& size, std::size_t axis,
                  const std::vector<float>& square, const std::vector<Side>& side,
                  std::vector<float>& distance) {
  const std::int64_t length = size[axis];
  const auto window = static_cast<std::int64_t>(square.size());
  std::vector<float> before(static_cast<std::size_t>(length));
  std::vector<Side> of(before.size());
  for_each_line(size, axis, [&](std::int64_t first, std::int64_t step) {
    for (std::int64_t n = 0; n < length; ++n) {
      before[static_cast<std::size_t>(n)] = distance[static_cast<std::size_t>(first + n * step)];
      of[static_cast<std::size_t>(n)] = side[static_cast<std::size_t>(first + n * step)];
    }
    for (std::int64_t n = 0; n < length; ++n) {
      const Side here = of[static_cast<std::size_t>(n)];
      float best = before[static_cast<std::size_t>(n)];
      for (std::int64_t d = 1; d < window && square[static_cast<std::size_t>(d)] < best; ++d)
        for (const std::int64_t m : {n - d, n + d}) {
          if (m < 0 || m >= length) continue;
          const auto other = static_cast<std::size_t>(m);
          best = std::min(best, square[static_cast<std::size_t>(d)] +
                                    (of[other] == here ? before[other] : 0.0F));
        }
      distance[static_cast<std::size_t>(first + n * step)] = best;
    }
  });
}

}  // namespace

voxels::Volume<float> wall_distance(const base::Communicator& communicator,
                                    const voxels::LabelVolume& labels, std::int32_t label,
                                    double limit) {
  const auto [nx, ny, nz] = labels.size;
  voxels::Volume<float> found(communicator, labels.size, labels.voxel_size);
  const auto most = static_cast<float>(limit * limit);
  {
    const std::vector<std::uint8_t> away =
        voxels::extract(communicator, along_z(communicator, labels, label),
                        {{0, found.first_plane, 0}, {nx, found.planes, ny}});
    const std::vector<float> square = squares(labels.voxel_size[2], limit);
    for (std::int64_t k = 0; k < found.planes; ++k)
      for (std::int64_t j = 0; j < ny; ++j)
        for (std::int64_t i = 0; i < nx; ++i) {
          const std::size_t n = away[static_cast<std::size_t>(i + nx * (k + found.planes * j))];
          found.plane(k)[i + nx * j] = n < square.size() ? square[n] : most;
        }
  }
  std::vector<Side> side(labels.values.size());
  std::transform(labels.values.begin(), labels.values.end(), side.begin(),
                 [&](std::int32_t one) { return static_cast<Side>(one == label); });
  const std::array<std::int64_t, 3> slab{nx, ny, found.planes};
  for (const std::size_t axis : {1, 0})
    search_along(slab, axis, squares(labels.voxel_size[axis], limit), side, found.values);
  for (float& one : found.values) one = std::sqrt(std::min(one, most));
  return found;
}

}  // namespace stroma::image
