// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace stroma::image {
namespace {

/// The voxel that position i of a line of n voxels mirrors: ... 1 0 | 0 1 ... n-1 | n-1 n-2 ...
std::int64_t mirrored(std::int64_t i, std::int64_t n) {
  const std::int64_t period = 2 * n;
  const std::int64_t folded = ((i % period) + period) % period;
  return folded < n ? folded : period - 1 - folded;
}

/// Weights at -r, ..., r of each value's neighbours in lines of n values.
class LineFilter {
 public:
  /// Lines are continued by their mirror images.
  LineFilter(std::vector<double> weights, std::int64_t n)
      : weights_(std::move(weights)), n_(n), scale_(static_cast<std::size_t>(n), 1.0) {}
  /// Means of what lies inside, at least `margin` values off the ends.
  LineFilter(std::vector<double> weights, std::int64_t n, std::int64_t margin)
      : weights_(std::move(weights)), n_(n), is_mirrored_(false), margin_(margin) {
    for (std::int64_t i = 0; i < n; ++i) {
      double sum = 0.0;
      for (std::int64_t w = -reach(); w <= reach(); ++w)
        if (source(i + w) >= 0) sum += weight(w);
      scale_.push_back(1.0 / sum);
    }
  }

  std::int64_t reach() const { return static_cast<std::int64_t>(weights_.size() / 2); }
  double weight(std::int64_t w) const { return weights_[static_cast<std::size_t>(w + reach())]; }
  /// Whose value stands at position i, in the line or beyond; -1: none.
  std::int64_t source(std::int64_t i) const {
    if (is_mirrored_) return mirrored(i, n_);
    return i >= margin_ && i < n_ - margin_ ? i : -1;
  }
  /// What the sum at position i is multiplied by.
  double scale(std::int64_t i) const { return scale_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<double> weights_;
  std::int64_t n_;
  bool is_mirrored_ = true;
  std::int64_t margin_ = 0;
  std::vector<double> scale_;
};

template <class T>
void filter_line(const LineFilter& filter, std::int64_t n, T* line, std::vector<double>& extended) {
  const std::int64_t r = filter.reach();
  extended.resize(static_cast<std::size_t>(n + 2 * r));
  for (std::int64_t i = -r; i < n + r; ++i) {
    const std::int64_t source = filter.source(i);
    extended[static_cast<std::size_t>(i + r)] = source < 0 ? 0.0 : line[source];
  }
  for (std::int64_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::int64_t w = -r; w <= r; ++w)
      sum += filter.weight(w) * extended[static_cast<std::size_t>(i + w + r)];
    line[i] = static_cast<T>(filter.scale(i) * sum);
  }
}

/// Along y, whole rows at a time: much faster than line by line.
template <class T>
void filter_rows(const LineFilter& filter, std::int64_t rows, std::int64_t row_length, T* plane) {
  const std::int64_t r = filter.reach();
  const std::vector<T> original(plane, plane + rows * row_length);
  std::vector<double> sum(static_cast<std::size_t>(row_length));
  for (std::int64_t j = 0; j < rows; ++j) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (std::int64_t w = -r; w <= r; ++w) {
      const std::int64_t source = filter.source(j + w);
      if (source < 0) continue;
      const double weight = filter.weight(w);
      const T* row = original.data() + source * row_length;
      for (std::int64_t i = 0; i < row_length; ++i)
        sum[static_cast<std::size_t>(i)] += weight * row[i];
    }
    const double scale = filter.scale(j);
    std::transform(sum.begin(), sum.end(), plane + j * row_length,
                   [=](double s) { return static_cast<T>(scale * s); });
  }
}

/// Along z: the planes within reach come from the ranks that hold them.
template <class T>
void filter_planes(const base::Communicator& communicator, voxels::Volume<T>& volume,
                   const LineFilter& filter) {
  const std::int64_t r = filter.reach();
  const std::int64_t planes = volume.size[2];
  // A mirrored plane may lie anywhere when the reach exceeds the volume; the range below covers
  // that too.
  std::int64_t first = planes, last = -1;
  for (std::int64_t k = volume.first_plane - r;
       k < volume.first_plane + volume.planes + r && volume.planes > 0; ++k) {
    const std::int64_t source = filter.source(k);
    if (source < 0) continue;
    first = std::min(first, source);
    last = std::max(last, source);
  }
  voxels::Box reach{{0, 0, first}, {volume.size[0], volume.size[1], last - first + 1}};
  if (volume.planes == 0) reach = voxels::Box{};
  const std::vector<T> around = voxels::extract(communicator, volume, reach);
  const auto plane_voxels = static_cast<std::size_t>(volume.plane_voxels());
  std::vector<double> sum(plane_voxels);
  for (std::int64_t k = 0; k < volume.planes; ++k) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (std::int64_t w = -r; w <= r; ++w) {
      const std::int64_t source = filter.source(volume.first_plane + k + w);
      if (source < 0) continue;
      const double weight = filter.weight(w);
      const T* plane = around.data() + (source - first) * volume.plane_voxels();
      for (std::size_t i = 0; i < plane_voxels; ++i) sum[i] += weight * plane[i];
    }
    const double scale = filter.scale(volume.first_plane + k);
    std::transform(sum.begin(), sum.end(), volume.plane(k),
                   [=](double s) { return static_cast<T>(scale * s); });
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

/// Where there is no filter, the mean.
template <class T>
void apply(const base::Communicator& communicator, voxels::Volume<T>& volume,
           const std::array<std::optional<LineFilter>, 3>& filter) {
  const auto& [along_x, along_y, along_z] = filter;
  const auto changes = [](const LineFilter& f) { return f.reach() > 0 || f.weight(0) != 1.0; };
  std::vector<double> line;
  for (std::int64_t k = 0; k < volume.planes; ++k) {
    T* plane = volume.plane(k);
    for (std::int64_t j = 0; j < volume.size[1]; ++j) {
      T* row = plane + j * volume.size[0];
      if (!along_x)
        average_line(volume.size[0], row);
      else if (changes(*along_x))
        filter_line(*along_x, volume.size[0], row, line);
    }
    if (!along_y)
      average_rows(volume.size[1], volume.size[0], plane);
    else if (changes(*along_y))
      filter_rows(*along_y, volume.size[1], volume.size[0], plane);
  }
  if (!along_z)
    average_planes(communicator, volume);
  else if (changes(*along_z))
    filter_planes(communicator, volume, *along_z);
}

/// Those of a Gaussian no wider than where it leaves the mean alone.
std::vector<double> weights_within(double sigma, std::int64_t n) {
  return gaussian_weights(std::min(sigma, mean_from * static_cast<double>(n)));
}

/// Of a Gaussian's weights: in proportion to place, such that a line that rises by 1 from value to
/// value has the derivative 1.
std::vector<double> derivative_of(std::vector<double> weights) {
  if (weights.size() == 1) weights = {1.0, 1.0, 1.0};  // central differences
  const auto r = static_cast<double>(weights.size() / 2);
  double sum = 0.0;
  for (std::size_t w = 0; w < weights.size(); ++w) {
    const double place = static_cast<double>(w) - r;
    weights[w] *= place;
    sum += weights[w] * place;
  }
  for (double& weight : weights) weight /= sum;
  return weights;
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
  std::array<std::optional<LineFilter>, 3> filter;  // none along an axis: the mean is taken there
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!smooths_to_mean(sigma[axis], volume.size[axis]))
      filter[axis].emplace(gaussian_weights(sigma[axis]), volume.size[axis]);
  apply(communicator, volume, filter);
}

template <class T>
void differentiate(const base::Communicator& communicator, voxels::Volume<T>& volume, int axis,
                   const std::array<double, 3>& sigma) {
  std::array<std::optional<LineFilter>, 3> filter;
  for (std::size_t d = 0; d < 3; ++d) {
    std::vector<double> weights = weights_within(sigma[d], volume.size[d]);
    if (d == static_cast<std::size_t>(axis)) weights = derivative_of(weights);
    filter[d].emplace(std::move(weights), volume.size[d]);
  }
  apply(communicator, volume, filter);
}

template <class T>
void average_inside(const base::Communicator& communicator, voxels::Volume<T>& volume,
                    const std::array<double, 3>& sigma, const std::array<std::int64_t, 3>& margin) {
  std::array<std::optional<LineFilter>, 3> filter;
  for (std::size_t d = 0; d < 3; ++d)
    filter[d].emplace(weights_within(sigma[d], volume.size[d]), volume.size[d], margin[d]);
  apply(communicator, volume, filter);
}

#define STROMA_FILTERS_OF(T)                                                      \
  template void smooth(const base::Communicator&, voxels::Volume<T>&,             \
                       const std::array<double, 3>&);                             \
  template void differentiate(const base::Communicator&, voxels::Volume<T>&, int, \
                              const std::array<double, 3>&);                      \
  template void average_inside(const base::Communicator&, voxels::Volume<T>&,     \
                               const std::array<double, 3>&, const std::array<std::int64_t, 3>&)
STROMA_FILTERS_OF(float);
STROMA_FILTERS_OF(double);
#undef STROMA_FILTERS_OF

}  // namespace stroma::image
