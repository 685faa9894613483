// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace stroma::image {
namespace {

/// The voxel that position i of a line of n voxels mirrors: ... 1 0 | 0 1 ... n-1 | n-1 n-2 ...
std::int64_t mirrored(std::int64_t i, std::int64_t n) {
  const std::int64_t period = 2 * n;
  const std::int64_t folded = ((i % period) + period) % period;
  return folded < n ? folded : period - 1 - folded;
}

/// One line of n values, continued by its mirror image over r values to each side, under the
/// weights.
template <class T>
void convolve_line(const std::vector<double>& weights, std::int64_t n, T* line,
                   std::vector<double>& extended) {
  const auto r = static_cast<std::int64_t>(weights.size() / 2);
  extended.resize(static_cast<std::size_t>(n + 2 * r));
  for (std::int64_t i = -r; i < n + r; ++i)
    extended[static_cast<std::size_t>(i + r)] = line[mirrored(i, n)];
  for (std::int64_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t w = 0; w < weights.size(); ++w)
      sum += weights[w] * extended[static_cast<std::size_t>(i) + w];
    line[i] = static_cast<T>(sum);
  }
}

/// Along y, whole rows at a time: much faster than line by line.
template <class T>
void convolve_rows(const std::vector<double>& weights, std::int64_t rows, std::int64_t row_length,
                   T* plane) {
  const auto r = static_cast<std::int64_t>(weights.size() / 2);
  const std::vector<T> original(plane, plane + rows * row_length);
  std::vector<double> sum(static_cast<std::size_t>(row_length));
  for (std::int64_t j = 0; j < rows; ++j) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (std::int64_t w = -r; w <= r; ++w) {
      const double weight = weights[static_cast<std::size_t>(w + r)];
      const T* row = original.data() + mirrored(j + w, rows) * row_length;
      for (std::int64_t i = 0; i < row_length; ++i)
        sum[static_cast<std::size_t>(i)] += weight * row[i];
    }
    std::transform(sum.begin(), sum.end(), plane + j * row_length,
                   [](double s) { return static_cast<T>(s); });
  }
}

/// Along z: the planes within reach come from the ranks that hold them.
template <class T>
void convolve_planes(const base::Communicator& communicator, voxels::Volume<T>& volume,
                     const std::vector<double>& weights) {
  const auto r = static_cast<std::int64_t>(weights.size() / 2);
  const std::int64_t planes = volume.size[2];
  // A mirrored plane may lie anywhere when the reach exceeds the volume; the range below covers
  // that too.
  std::int64_t first = planes, last = -1;
  for (std::int64_t k = volume.first_plane - r;
       k < volume.first_plane + volume.planes + r && volume.planes > 0; ++k) {
    first = std::min(first, mirrored(k, planes));
    last = std::max(last, mirrored(k, planes));
  }
  voxels::Box reach{{0, 0, first}, {volume.size[0], volume.size[1], last - first + 1}};
  if (volume.planes == 0) reach = voxels::Box{};
  const std::vector<T> around = voxels::extract(communicator, volume, reach);
  const auto plane_voxels = static_cast<std::size_t>(volume.plane_voxels());
  std::vector<double> sum(plane_voxels);
  for (std::int64_t k = 0; k < volume.planes; ++k) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (std::int64_t w = -r; w <= r; ++w) {
      const double weight = weights[static_cast<std::size_t>(w + r)];
      const std::int64_t source = mirrored(volume.first_plane + k + w, planes) - first;
      const T* plane = around.data() + source * volume.plane_voxels();
      for (std::size_t i = 0; i < plane_voxels; ++i) sum[i] += weight * plane[i];
    }
    std::transform(sum.begin(), sum.end(), volume.plane(k),
                   [](double s) { return static_cast<T>(s); });
  }
}

/// From a standard deviation of so many image lengths on, what is left of the slowest variation, of
/// which the image is half a wave, exp(-2 pi^2), 3e-9, is less than what cutting the weights
/// changes.
constexpr double mean_from = 2.0;

/// The mean of every line along x, and of every column along y.
template <class T>
void average_line(std::int64_t n, T* line) {
  const double sum = std::accumulate(line, line + n, 0.0);
  std::fill(line, line + n, static_cast<T>(sum / static_cast<double>(n)));
}

template <class T>
void average_rows(std::int64_t rows, std::int64_t row_length, T* plane) {
  std::vector<double> sum(static_cast<std::size_t>(row_length), 0.0);
  for (std::int64_t j = 0; j < rows; ++j) {
    for (std::int64_t i = 0; i < row_length; ++i)
      sum[static_cast<std::size_t>(i)] += plane[j * row_length + i];
  }
  for (std::int64_t v = 0; v < rows * row_length; ++v)
    plane[v] =
        static_cast<T>(sum[static_cast<std::size_t>(v % row_length)] / static_cast<double>(rows));
}

/// Along z: every rank adds up all planes in their order, one at a time.
template <class T>
void average_planes(const base::Communicator& communicator, voxels::Volume<T>& volume) {
  std::vector<double> sum(static_cast<std::size_t>(volume.plane_voxels()), 0.0);
  for (std::int64_t k = 0; k < volume.size[2]; ++k) {
    const std::vector<T> plane =
        voxels::extract(communicator, volume, {{0, 0, k}, {volume.size[0], volume.size[1], 1}});
    std::transform(sum.begin(), sum.end(), plane.begin(), sum.begin(), std::plus<double>());
  }
  for (std::int64_t k = 0; k < volume.planes; ++k) {
    std::transform(sum.begin(), sum.end(), volume.plane(k), [&](double s) {
      return static_cast<T>(s / static_cast<double>(volume.size[2]));
    });
  }
}

}  // namespace

bool smooths_to_mean(double sigma, std::int64_t n) {
  return sigma > mean_from * static_cast<double>(n);
}

std::vector<double> gaussian_weights(double sigma) {
  const int r = static_cast<int>(std::floor(4.0 * sigma + 0.5));
  std::vector<double> weights;
  double sum = 0.0;
  for (int i = -r; i <= r; ++i) {
    weights.push_back(r == 0 ? 1.0 : std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

template <class T>
void smooth(const base::Communicator& communicator, voxels::Volume<T>& volume,
            const std::array<double, 3>& sigma) {
  std::array<std::vector<double>, 3> weights;  // none along an axis: the mean is taken there
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!smooths_to_mean(sigma[axis], volume.size[axis]))
      weights[axis] = gaussian_weights(sigma[axis]);
  }
  const auto& [along_x, along_y, along_z] = weights;
  std::vector<double> line;
  for (std::int64_t k = 0; k < volume.planes; ++k) {
    T* plane = volume.plane(k);
    for (std::int64_t j = 0; j < volume.size[1]; ++j) {
      T* row = plane + j * volume.size[0];
      if (along_x.empty()) average_line(volume.size[0], row);
      if (along_x.size() > 1) convolve_line(along_x, volume.size[0], row, line);
    }
    if (along_y.empty()) average_rows(volume.size[1], volume.size[0], plane);
    if (along_y.size() > 1) convolve_rows(along_y, volume.size[1], volume.size[0], plane);
  }
  if (along_z.empty()) average_planes(communicator, volume);
  if (along_z.size() > 1) convolve_planes(communicator, volume, along_z);
}

template void smooth(const base::Communicator&, voxels::Volume<float>&,
                     const std::array<double, 3>&);
template void smooth(const base::Communicator&, voxels::Volume<double>&,
                     const std::array<double, 3>&);

}  // namespace stroma::image
