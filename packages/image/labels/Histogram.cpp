// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::image {
namespace {

/// Smallest and largest value of all ranks. \throws base::InputError when one is not finite, or
/// their difference is too large for a double
std::array<double, 2> range(const base::Communicator& communicator,
                            const voxels::IntensityVolume& volume) {
  require_finite(communicator, volume);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : volume.values) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  low = communicator.min(low);
  high = communicator.max(high);
  if (!std::isfinite(high - low))
    throw base::InputError(base::format(
        "the intensities range from %.9g to %.9g, too far for their statistics", low, high));
  return {low, high};
}

/// The bin of a value in the range.
std::size_t bin_of(const Histogram& histogram, double value) {
  return static_cast<std::size_t>(std::clamp((value - histogram.first_edge) / histogram.width, 0.0,
                                             static_cast<double>(histogram.counts.size() - 1)));
}

Histogram counted(const base::Communicator& communicator, const voxels::IntensityVolume& volume,
                  double first_edge, double width, std::int64_t bins, bool levels) {
  Histogram histogram{first_edge, width, levels,
                      std::vector<std::int64_t>(static_cast<std::size_t>(bins), 0)};
  for (const double value : volume.values) ++histogram.counts[bin_of(histogram, value)];
  communicator.sum_all(histogram.counts.data(), histogram.counts.size());
  return histogram;
}

Histogram in_equal_bins(const base::Communicator& communicator,
                        const voxels::IntensityVolume& volume, double low, double high, int bins) {
  const double width =
      high > low ? std::max((high - low) / bins, std::numeric_limits<double>::min()) : 1.0;
  return counted(communicator, volume, low, width, bins, false);
}

}  // namespace

NotFinite not_finite(const base::Communicator& communicator,
                     const voxels::IntensityVolume& volume) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::int64_t count = 0, first = none;
  for (std::size_t i = 0; i < volume.values.size(); ++i) {
    if (std::isfinite(volume.values[i])) continue;
    if (count == 0)
      first = static_cast<std::int64_t>(i) + volume.first_plane * volume.plane_voxels();
    ++count;
  }
  NotFinite found;
  found.count = communicator.sum(count);
  if (found.count > 0) found.first = voxels::name_of_voxel(volume, communicator.min(first));
  return found;
}

void require_finite(const base::Communicator& communicator, const voxels::IntensityVolume& volume) {
  const NotFinite found = not_finite(communicator, volume);
  if (found.count == 0) return;
  throw base::InputError(base::format(
      "%lld of %lld voxels are not finite (NaN or infinity), the first of them %s; admissible: "
      "finite intensities",
      static_cast<long long>(found.count), static_cast<long long>(volume.voxels()),
      found.first.c_str()));
}

std::int64_t Histogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

Statistics statistics(const base::Communicator& communicator,
                      const voxels::IntensityVolume& volume) {
  const auto [low, high] = range(communicator, volume);
  const double count = static_cast<double>(volume.voxels());
  const double mean =
      communicator.sum(std::accumulate(volume.values.begin(), volume.values.end(), 0.0)) / count;
  double squares = 0.0;
  for (const double value : volume.values) squares += (value - mean) * (value - mean);
  return {low, high, mean, std::sqrt(communicator.sum(squares) / count)};
}

Histogram histogram(const base::Communicator& communicator, const voxels::IntensityVolume& volume,
                    const ValueType& type, int bins) {
  const auto [low, high] = range(communicator, volume);
  if (type.is_integer() && high - low < static_cast<double>(most_levels))
    return counted(communicator, volume, low - 0.5, 1.0, static_cast<std::int64_t>(high - low) + 1,
                   true);
  return in_equal_bins(communicator, volume, low, high, bins);
}

Histogram histogram_with_extremes(const base::Communicator& communicator,
                                  const voxels::IntensityVolume& volume, int bins) {
  const auto [low, high] = range(communicator, volume);
  Histogram histogram = in_equal_bins(communicator, volume, low, high, bins);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  histogram.lowest.assign(histogram.counts.size(), infinity);
  histogram.highest.assign(histogram.counts.size(), -infinity);
  for (const double value : volume.values) {
    const std::size_t bin = bin_of(histogram, value);
    histogram.lowest[bin] = std::min(histogram.lowest[bin], value);
    histogram.highest[bin] = std::max(histogram.highest[bin], value);
  }
  MPI_Allreduce(MPI_IN_PLACE, histogram.lowest.data(), bins, MPI_DOUBLE, MPI_MIN,
                communicator.raw());
  MPI_Allreduce(MPI_IN_PLACE, histogram.highest.data(), bins, MPI_DOUBLE, MPI_MAX,
                communicator.raw());
  return histogram;
}

double otsu_threshold(const Histogram& histogram) {
  const auto occupied = std::count_if(histogram.counts.begin(), histogram.counts.end(),
                                      [](std::int64_t n) { return n > 0; });
  if (occupied < 2)
    throw base::InputError(
        "Otsu's method needs at least two different intensities; the image holds a single one");
  // Means are formed from bin numbers, whose sums are exact, so that equal maxima compare equal.
  const std::size_t bins = histogram.counts.size();
  double all = 0.0, all_sum = 0.0;
  for (std::size_t b = 0; b < bins; ++b) {
    all += static_cast<double>(histogram.counts[b]);
    all_sum += static_cast<double>(b) * static_cast<double>(histogram.counts[b]);
  }
  double below = 0.0, below_sum = 0.0, best = -1.0;
  std::size_t best_bin = 0;
  for (std::size_t b = 0; b + 1 < bins; ++b) {
    below += static_cast<double>(histogram.counts[b]);
    below_sum += static_cast<double>(b) * static_cast<double>(histogram.counts[b]);
    const double above = all - below;
    if (below == 0.0 || above == 0.0) continue;
    const double difference = below_sum / below - (all_sum - below_sum) / above;
    const double between = below * above * difference * difference;
    if (between > best) {
      best = between;
      best_bin = b;
    }
  }
  return histogram.center(best_bin);
}

double percentile(const Histogram& histogram, double percent) {
  const std::int64_t total = histogram.total();
  // The value of the voxel at a place of the sorted order; those of a bin of a float image are taken
  // to be evenly spread.
  const auto value_at = [&](std::int64_t place) {
    std::int64_t before = 0;
    for (std::size_t b = 0; b < histogram.counts.size(); ++b) {
      const std::int64_t here = histogram.counts[b];
      if (place < before + here) {
        if (histogram.levels) return histogram.center(b);
        const double within = static_cast<double>(place - before) /
                              static_cast<double>(std::max<std::int64_t>(here - 1, 1));
        return histogram.lowest[b] + within * (histogram.highest[b] - histogram.lowest[b]);
      }
      before += here;
    }
    return histogram.center(histogram.counts.size() - 1);
  };
  const double place = percent / 100.0 * static_cast<double>(total - 1);
  const auto lower = static_cast<std::int64_t>(std::floor(place));
  const double between = place - static_cast<double>(lower);
  const double low = value_at(lower);
  return between == 0.0 ? low : low + between * (value_at(lower + 1) - low);
}

double fraction_above(const base::Communicator& communicator, const voxels::IntensityVolume& volume,
                      double threshold) {
  const auto above = std::count_if(volume.values.begin(), volume.values.end(),
                                   [&](double value) { return value > threshold; });
  return static_cast<double>(communicator.sum(static_cast<std::int64_t>(above))) /
         static_cast<double>(volume.voxels());
}

}  // namespace stroma::image
