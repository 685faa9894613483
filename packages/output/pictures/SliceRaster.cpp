// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/SliceRaster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stroma::output {
namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

/// Sums an array over the ranks; the result is complete on rank 0 only.
template <class T>
void sum_to_root(const base::Communicator& communicator, std::vector<T>& values) {
  const int count = static_cast<int>(values.size());
  const MPI_Datatype type = base::mpi_type<T>();
  if (communicator.is_root()) {
    MPI_Reduce(MPI_IN_PLACE, values.data(), count, type, MPI_SUM, 0, communicator.raw());
  } else {
    MPI_Reduce(values.data(), nullptr, count, type, MPI_SUM, 0, communicator.raw());
  }
}

/// Places a raster without values over the points of all ranks.
Raster frame(const base::Communicator& communicator, const std::vector<SlicePoint>& points,
             const std::array<double, 2>& reference_extent, const std::array<double, 2>& spacing,
             int max_pixels) {
  constexpr double far = std::numeric_limits<double>::max();
  Raster raster;
  std::array<int, 2> pixels{};
  for (std::size_t d = 0; d < 2; ++d) {
    double low = far, high = -far;
    for (const SlicePoint& point : points) {
      low = std::min(low, point.position[d]);
      high = std::max(high, point.position[d]);
    }
    low = communicator.min(low);
    high = communicator.max(high);
    if (low > high) return {};  // no point on any rank
    const double count = std::round(reference_extent[d] / spacing[d]) + 1.0;
    pixels[d] = static_cast<int>(std::clamp(count, 1.0, static_cast<double>(max_pixels)));
    raster.first[d] = low;
    const bool flat = pixels[d] == 1 || high <= low;
    if (flat) pixels[d] = 1;
    raster.pixel[d] = flat ? spacing[d] : (high - low) / (pixels[d] - 1);
  }
  raster.columns = pixels[0];
  raster.rows = pixels[1];
  return raster;
}

std::size_t pixel_of(const Raster& raster, const SlicePoint& point) {
  const auto along = [&](std::size_t d, int count) {
    const double place = std::round((point.position[d] - raster.first[d]) / raster.pixel[d]);
    return static_cast<std::size_t>(std::clamp(place, 0.0, count - 1.0));
  };
  return along(1, raster.rows) * static_cast<std::size_t>(raster.columns) +
         along(0, raster.columns);
}

void merge_mean(const base::Communicator& communicator, const std::vector<SlicePoint>& points,
                Raster& raster) {
  const auto pixels =
      static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  std::vector<double> sum(pixels, 0.0);
  std::vector<std::int32_t> count(pixels, 0);
  for (const SlicePoint& point : points) {
    const std::size_t pixel = pixel_of(raster, point);
    sum[pixel] += point.value;
    ++count[pixel];
  }
  sum_to_root(communicator, sum);
  sum_to_root(communicator, count);
  if (!communicator.is_root()) return;
  raster.value.assign(pixels, no_value);
  for (std::size_t i = 0; i < pixels; ++i) {
    if (count[i] > 0) raster.value[i] = static_cast<float>(sum[i] / count[i]);
  }
}

void merge_majority(const base::Communicator& communicator, const std::vector<SlicePoint>& points,
                    Raster& raster) {
  const auto pixels =
      static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  double largest = -1.0;
  for (const SlicePoint& point : points) largest = std::max(largest, point.value);
  largest = communicator.max(largest);
  std::vector<std::int32_t> most(communicator.is_root() ? pixels : 0, 0);
  if (communicator.is_root()) raster.value.assign(pixels, no_value);
  for (int value = 0; value <= largest; ++value) {
    std::vector<std::int32_t> count(pixels, 0);
    for (const SlicePoint& point : points) {
      if (static_cast<int>(point.value) == value) ++count[pixel_of(raster, point)];
    }
    sum_to_root(communicator, count);
    for (std::size_t i = 0; i < most.size(); ++i) {
      if (count[i] <= most[i]) continue;
      most[i] = count[i];
      raster.value[i] = static_cast<float>(value);
    }
  }
}

/// The filled pixels nearest to a hole, among those within reach along both axes and both
/// diagonals; none unless two of them lie on opposite sides.
std::vector<float> around_hole(const Raster& raster, const std::vector<float>& value, int column,
                               int row, const std::array<int, 2>& reach) {
  const auto look = [&](int di, int dj, int& distance) -> float {
    for (distance = 1; distance <= std::max(reach[0], reach[1]); ++distance) {
      const int i = column + distance * di, j = row + distance * dj;
      const bool near = (di == 0 || distance <= reach[0]) && (dj == 0 || distance <= reach[1]);
      if (!near || i < 0 || j < 0 || i >= raster.columns || j >= raster.rows) break;
      const float there =
          value[static_cast<std::size_t>(j) * static_cast<std::size_t>(raster.columns) +
                static_cast<std::size_t>(i)];
      if (!std::isnan(there)) return there;
    }
    return no_value;
  };
  std::vector<float> nearest;
  double nearest_distance = std::numeric_limits<double>::max();
  constexpr int directions[4][2] = {{1, 0}, {0, 1}, {1, 1}, {1, -1}};
  for (const auto& [di, dj] : directions) {
    int ahead = 0, behind = 0;
    const float a = look(di, dj, ahead), b = look(-di, -dj, behind);
    if (std::isnan(a) || std::isnan(b)) continue;
    const double step = std::hypot(di * raster.pixel[0], dj * raster.pixel[1]);
    for (const auto& [distance, there] :
         {std::pair(ahead * step, a), std::pair(behind * step, b)}) {
      if (distance < nearest_distance * (1.0 - 1e-9)) {
        nearest.clear();
        nearest_distance = distance;
      }
      if (distance <= nearest_distance * (1.0 + 1e-9)) nearest.push_back(there);
    }
  }
  return nearest;
}

float merged(std::vector<float> values, Merge merge) {
  if (merge == Merge::Mean) {
    double sum = 0.0;
    for (const float value : values) sum += value;
    return static_cast<float>(sum / static_cast<double>(values.size()));
  }
  std::sort(values.begin(), values.end());
  float winner = values.front();
  std::ptrdiff_t most = 0;
  for (auto begin = values.begin(); begin != values.end();) {
    const auto end = std::upper_bound(begin, values.end(), *begin);
    if (end - begin > most) {
      most = end - begin;
      winner = *begin;
    }
    begin = end;
  }
  return winner;
}

void fill_holes(Raster& raster, const std::array<double, 2>& stretched_spacing, Merge merge) {
  std::array<int, 2> reach{};
  for (std::size_t d = 0; d < 2; ++d) {
    reach[d] = static_cast<int>(1.5 * stretched_spacing[d] / raster.pixel[d] + 1e-9);
  }
  const std::vector<float> seen = raster.value;  // what is filled here must not grow further
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column) {
      const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns) +
          static_cast<std::size_t>(column);
      if (!std::isnan(seen[pixel])) continue;
      const std::vector<float> nearest = around_hole(raster, seen, column, row, reach);
      if (!nearest.empty()) raster.value[pixel] = merged(nearest, merge);
    }
  }
}

}  // namespace

std::vector<std::int64_t> middle_layer(const base::Communicator& communicator,
                                       const ParticleSet& particles, double z_spacing, double* z) {
  const auto height = [&](std::int64_t p) { return particles.position[3 * p + 2]; };
  double low = std::numeric_limits<double>::max(), high = -low;
  for (std::int64_t p = 0; p < particles.count; ++p) {
    low = std::min(low, height(p));
    high = std::max(high, height(p));
  }
  const double middle = 0.5 * (communicator.min(low) + communicator.max(high)) + 1e-6 * z_spacing;
  double layer = -std::numeric_limits<double>::max();
  for (std::int64_t p = 0; p < particles.count; ++p) {
    if (height(p) <= middle) layer = std::max(layer, height(p));
  }
  layer = communicator.max(layer);
  if (z != nullptr) *z = layer;
  std::vector<std::int64_t> members;
  for (std::int64_t p = 0; p < particles.count; ++p) {
    if (std::abs(height(p) - layer) < 1e-6 * z_spacing) members.push_back(p);
  }
  return members;
}

Raster rasterise(const base::Communicator& communicator, const std::vector<SlicePoint>& points,
                 std::array<double, 2> reference_extent, std::array<double, 2> spacing, Merge merge,
                 int max_pixels) {
  Raster raster = frame(communicator, points, reference_extent, spacing, max_pixels);
  if (raster.columns == 0) return raster;
  if (merge == Merge::Mean) {
    merge_mean(communicator, points, raster);
  } else {
    merge_majority(communicator, points, raster);
  }
  if (communicator.is_root()) {
    std::array<double, 2> stretched = spacing;
    const std::array<int, 2> pixels = {raster.columns, raster.rows};
    for (std::size_t d = 0; d < 2; ++d) {
      const double extent = raster.pixel[d] * (pixels[d] - 1);
      if (extent > 0.0 && reference_extent[d] > 0.0) stretched[d] *= extent / reference_extent[d];
    }
    fill_holes(raster, stretched, merge);
  }
  return raster;
}

}  // namespace stroma::output
