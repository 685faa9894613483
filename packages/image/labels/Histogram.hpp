// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Histogram of a distributed volume, what can be read off it, and Otsu's threshold.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Counts of equally wide bins. Bin b covers [first_edge + b width, first_edge + (b + 1) width);
/// the last one includes its upper end.
struct Histogram {
  double first_edge = 0.0;
  double width = 1.0;
  bool levels = false;               ///< one bin per integer level, the level at the bin's centre
  std::vector<std::int64_t> counts;  ///< of all ranks
  std::vector<double> lowest = {}, highest = {};  ///< (bin) of its values, or empty

  double center(std::size_t bin) const {
    return first_edge + (static_cast<double>(bin) + 0.5) * width;
  }
  std::int64_t total() const;
};

/// Extremes, mean and (population) standard deviation of a volume.
struct Statistics {
  double min = 0.0, max = 0.0, mean = 0.0, deviation = 0.0;
};

/// The widest range of integers that gets one bin per level (2^20 levels); a wider one gets equal
/// bins.
inline constexpr std::int64_t most_levels = std::int64_t{1} << 20;

/// What of a volume is NaN or infinite.
struct NotFinite {
  std::int64_t count = 0;
  std::string first;  ///< voxel (i, j, k) of the file
};

/// Collective.
NotFinite not_finite(const base::Communicator& communicator, const voxels::IntensityVolume& volume);

/// Collective.
/// \throws base::InputError when a value is not finite: how many, and where the first is
void require_finite(const base::Communicator& communicator, const voxels::IntensityVolume& volume);

/// Collective.
/// \throws base::InputError when a value is not finite
Statistics statistics(const base::Communicator& communicator,
                      const voxels::IntensityVolume& volume);

/// One bin per integer level from the smallest to the largest value when the type is an integer and
/// its range is at most most_levels; else `bins` equal bins between the smallest and the largest
/// value. Collective.
/// \throws base::InputError when a value is not finite
Histogram histogram(const base::Communicator& communicator, const voxels::IntensityVolume& volume,
                    const ValueType& type, int bins = 256);

/// Equal bins between the smallest and the largest value, whatever the type, and the extremes of
/// each bin. Collective.
/// \throws base::InputError when a value is not finite
Histogram histogram_with_extremes(const base::Communicator& communicator,
                                  const voxels::IntensityVolume& volume, int bins);

/// Otsu's threshold: the bin centre t that maximises the variance between the classes I <= t
/// and I > t,
///
///     n1 n2 (m1 - m2)^2,   n: counts, m: means of the bin centres,
///
/// the first of equal maxima. Foreground is I > t. Source: Otsu (1979), IEEE Trans. Syst. Man
/// Cybern. 9, 62.
/// \throws base::InputError when all values are equal
double otsu_threshold(const Histogram& histogram);

/// The value below which the given percentage of the voxels lies, linear between neighbouring order
/// statistics (the convention of most numerical libraries). Exact for levels, else between the values
/// of a bin.
/// \param histogram  of levels, or with extremes
/// \param percent    from 0 to 100
double percentile(const Histogram& histogram, double percent);

/// Fraction of the voxels with a value > threshold. Collective.
double fraction_above(const base::Communicator& communicator, const voxels::IntensityVolume& volume,
                      double threshold);

}  // namespace stroma::image
