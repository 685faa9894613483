// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Segmentation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/labels/Smoothing.hpp"

namespace stroma::image {
namespace {

/// Labels with the shape of another volume.
template <class T>
voxels::LabelVolume labels_like(const voxels::Volume<T>& volume) {
  voxels::LabelVolume labels;
  labels.size = volume.size;
  labels.voxel_size = volume.voxel_size;
  labels.first_plane = volume.first_plane;
  labels.planes = volume.planes;
  labels.values.resize(volume.values.size());
  return labels;
}

}  // namespace

voxels::LabelVolume threshold_labels(const voxels::IntensityVolume& volume, double threshold) {
  voxels::LabelVolume labels = labels_like(volume);
  std::transform(volume.values.begin(), volume.values.end(), labels.values.begin(),
                 [&](double value) { return value > threshold ? 1 : 0; });
  return labels;
}

voxels::LabelVolume value_labels(const base::Communicator& communicator,
                                 const voxels::IntensityVolume& volume) {
  voxels::LabelVolume labels = labels_like(volume);
  base::collectively(communicator, [&] {
    for (std::size_t i = 0; i < volume.values.size(); ++i) {
      const double value = volume.values[i];
      const bool admissible = value == std::floor(value) && value >= -1.0 &&
                              value <= std::numeric_limits<std::int32_t>::max();
      if (!admissible) {
        const auto voxel =
            static_cast<std::int64_t>(i) + volume.first_plane * volume.plane_voxels();
        throw base::InputError(base::format(
            "Image|Segmentation|Method = Labels: the value at %s is %.9g; admissible: integers "
            "from -1 (empty space) to 2147483647",
            voxels::name_of_voxel(volume, voxel).c_str(), value));
      }
      labels.values[i] = static_cast<std::int32_t>(value);
    }
  });
  return labels;
}

namespace {

void smooth_intensities(const base::Communicator& communicator, double deviation,
                        voxels::IntensityVolume& volume, ImageSummary& summary) {
  std::array<double, 3> sigma{};
  std::string axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sigma[axis] = deviation / volume.voxel_size[axis];
    if (smooths_to_mean(sigma[axis], volume.size[axis]))
      axes += std::string(axes.empty() ? "" : ", ") + "xyz"[axis];
  }
  smooth(communicator, volume, sigma);
  if (!axes.empty()) {
    summary.notes.push_back(base::format(
        "Smoothing [um] = %g is more than twice the image along %s: the mean along it is taken",
        deviation, axes.c_str()));
  }
}

/// Labels 0 and 1 by a threshold, the user's or Otsu's.
voxels::LabelVolume labels_by_threshold(const base::Communicator& communicator,
                                        const voxels::IntensityVolume& volume,
                                        const SegmentationParameters& parameters,
                                        ImageSummary& summary) {
  double threshold = 0.0;
  if (parameters.method == SegmentationParameters::Method::threshold) {
    threshold = parameters.threshold.value();
  } else {
    ValueType type = summary.type;
    if (parameters.smoothing > 0.0)
      type.kind = ValueType::Kind::floating;  // means of integers are none
    threshold = otsu_threshold(histogram(communicator, volume, type));
    summary.notes.push_back(base::format("Otsu's threshold: %.9g", threshold));
  }
  return threshold_labels(volume, threshold);
}

/// Turns labels into empty space, and says of how many voxels.
void empty_out(const base::Communicator& communicator, const SegmentationParameters& parameters,
               voxels::LabelVolume& labels, ImageSummary& summary) {
  std::vector<int> empty;
  if (const std::string* word = std::get_if<std::string>(&*parameters.empty_labels)) {
    empty = {*word == "Bright" ? 1 : 0};
  } else {
    empty = std::get<std::vector<int>>(*parameters.empty_labels);
  }
  std::vector<std::int64_t> voxels(empty.size(), 0);
  for (std::int32_t& label : labels.values) {
    const auto found = std::find(empty.begin(), empty.end(), label);
    if (found == empty.end()) continue;
    label = -1;
    ++voxels[static_cast<std::size_t>(found - empty.begin())];
  }
  communicator.sum_all(voxels.data(), voxels.size());
  for (std::size_t i = 0; i < empty.size(); ++i) {
    summary.notes.push_back(
        base::format("Empty Labels: label %d, %lld of %lld voxels, is empty space", empty[i],
                     static_cast<long long>(voxels[i]), static_cast<long long>(labels.voxels())));
  }
}

}  // namespace

voxels::LabelVolume segment(const base::Communicator& communicator, voxels::IntensityVolume volume,
                            const SegmentationParameters& parameters, ImageSummary& summary) {
  require_finite(communicator, volume);
  if (parameters.smoothing > 0.0)
    smooth_intensities(communicator, parameters.smoothing, volume, summary);
  voxels::LabelVolume labels = parameters.method == SegmentationParameters::Method::labels
                                   ? value_labels(communicator, volume)
                                   : labels_by_threshold(communicator, volume, parameters, summary);
  volume = voxels::IntensityVolume();
  if (parameters.empty_labels) empty_out(communicator, parameters, labels, summary);
  if (parameters.smallest_object > 1) {
    const std::int64_t removed =
        remove_small_objects(communicator, labels, parameters.smallest_object);
    summary.notes.push_back(base::format("objects of fewer than %d voxels removed: %lld",
                                         parameters.smallest_object,
                                         static_cast<long long>(removed)));
  }
  return labels;
}

std::map<std::int32_t, double> volume_fractions(const base::Communicator& communicator,
                                                const voxels::LabelVolume& labels) {
  std::map<std::int32_t, std::int64_t> here;
  for (const std::int32_t label : labels.values) ++here[label];
  // Labels one after another, in rising order: each round, the smallest that is left on any rank.
  std::map<std::int32_t, double> fractions;
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  auto next = here.begin();
  for (;;) {
    const std::int64_t label =
        communicator.min(next == here.end() ? none : std::int64_t{next->first});
    if (label == none) return fractions;
    const bool mine = next != here.end() && next->first == label;
    const std::int64_t count = communicator.sum(mine ? next->second : std::int64_t{0});
    fractions[static_cast<std::int32_t>(label)] =
        static_cast<double>(count) / static_cast<double>(labels.voxels());
    if (mine) ++next;
  }
}

std::vector<double> plane_fractions(const base::Communicator& communicator,
                                    const voxels::LabelVolume& labels, std::int32_t label) {
  std::vector<double> fractions(static_cast<std::size_t>(labels.size[2]), 0.0);
  for (std::int64_t k = 0; k < labels.planes; ++k) {
    const auto count = std::count(labels.plane(k), labels.plane(k) + labels.plane_voxels(), label);
    fractions[static_cast<std::size_t>(labels.first_plane + k)] =
        static_cast<double>(count) / static_cast<double>(labels.plane_voxels());
  }
  communicator.sum_all(fractions.data(), fractions.size());
  return fractions;
}

}  // namespace stroma::image
