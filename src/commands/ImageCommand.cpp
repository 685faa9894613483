// SPDX-License-Identifier: BSD-3-Clause

#include "commands/ImageCommand.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>

#include "stroma/base/Error.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/labels/Histogram.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/labels/Segmentation.hpp"

namespace stroma {
namespace {

using base::format;

long long printable(std::int64_t number) { return static_cast<long long>(number); }

void print_summary(const image::ImageSummary& summary, base::Log& log) {
  log.line("file         " + summary.path);
  log.line("format       " + summary.format);
  if (!summary.dataset.empty()) log.line("dataset      " + summary.dataset);
  log.line(format("size         %lld x %lld x %lld voxels (x, y, z)", printable(summary.size[0]),
                  printable(summary.size[1]), printable(summary.size[2])));
  const image::VoxelSize& voxel = summary.voxel_size;
  std::string sizes, extent;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool known = voxel.um[axis] > 0.0;
    const std::string by = axis == 0 ? "" : " x ";
    sizes += by + (known ? format("%.9g", voxel.um[axis]) : "?");
    extent += by + (known ? format("%.6g", voxel.um[axis] * static_cast<double>(summary.size[axis]))
                          : "?");
  }
  if (voxel.complete()) {
    log.line("voxel size   " + sizes + " um, found in: " + voxel.source());
    log.line("extent       " + extent + " um");
  } else {
    log.line("voxel size   " + sizes + " um, found in: " + voxel.source() +
             "; a run needs Image|Voxel Size [um] in its deck");
  }
  log.line("type         " + summary.type.name());
  log.line(format("channels     %lld; channel %lld is shown", printable(summary.channels),
                  printable(summary.channel)));
  if (summary.frames > 1)
    log.line(format("frames       %lld; frame %lld is shown", printable(summary.frames),
                    printable(summary.frame)));
  for (const std::string& note : summary.notes) log.note(note);
}

/// A message in the words of a deck, in those of the command line.
std::string with_options(std::string message) {
  for (const auto& [deck, option] :
       {std::pair("Image|Dataset", "--dataset"), std::pair("Image|Channel", "--channel"),
        std::pair("Image|Frame", "--frame"),
        std::pair("from the deck is used", "by --voxel is used")})
    for (std::size_t at = 0; (at = message.find(deck, at)) != std::string::npos;)
      message.replace(at, std::strlen(deck), option);
  return message;
}

/// At most 16 bars over the range; the longest stands for the fullest, on a scale of logarithms,
/// since tissue is mostly dark.
void print_histogram(const image::Histogram& histogram, base::Log& log) {
  const std::size_t bars = std::min<std::size_t>(16, histogram.counts.size());
  std::vector<std::int64_t> counts(bars, 0);
  for (std::size_t b = 0; b < histogram.counts.size(); ++b)
    counts[b * bars / histogram.counts.size()] += histogram.counts[b];
  const double most =
      std::log1p(static_cast<double>(*std::max_element(counts.begin(), counts.end())));
  log.line("histogram    (bars on a logarithmic scale)");
  for (std::size_t bar = 0; bar < bars; ++bar) {
    const std::size_t bin = (bar * histogram.counts.size() + bars - 1) / bars;
    const double from = histogram.levels
                            ? histogram.center(bin)
                            : histogram.first_edge + static_cast<double>(bin) * histogram.width;
    const auto length = static_cast<std::size_t>(
        std::lround(40.0 * std::log1p(static_cast<double>(counts[bar])) / most));
    log.line(format("  from %-12.6g %12lld  ", from, printable(counts[bar])) +
             std::string(length, '#'));
  }
}

void print_objects(const base::Communicator& communicator, const voxels::LabelVolume& labels,
                   image::Connectivity connectivity, base::Log& log) {
  const image::Objects objects(communicator, labels, connectivity);
  const std::int64_t count = objects.count(), large = objects.count(27),
                     largest = objects.largest();
  log.line(format(
      "objects      %lld with %d neighbours (of at least 27 voxels: %lld; the largest: %lld "
      "voxels)",
      printable(count), static_cast<int>(connectivity), printable(large), printable(largest)));
}

/// The finite values of a volume, one behind the other, as their statistics want them.
voxels::IntensityVolume finite_values(const voxels::IntensityVolume& volume, std::int64_t count) {
  voxels::IntensityVolume finite;
  finite.size = {count, 1, 1};
  std::copy_if(volume.values.begin(), volume.values.end(), std::back_inserter(finite.values),
               [](double value) { return std::isfinite(value); });
  return finite;
}

struct Otsu {
  double threshold;
  const char* bins;
};

/// Extremes, percentiles, histogram. \return  Otsu's threshold, if there is one
std::optional<Otsu> print_statistics(const base::Communicator& communicator,
                                     const voxels::IntensityVolume& volume,
                                     const image::ValueType& type, base::Log& log) {
  const image::Statistics statistics = image::statistics(communicator, volume);
  const image::Histogram histogram = image::histogram(communicator, volume, type);
  log.line(format("intensity    min %.9g, max %.9g, mean %.6g, standard deviation %.6g",
                  statistics.min, statistics.max, statistics.mean, statistics.deviation));
  const image::Histogram fine =
      histogram.levels ? histogram : image::histogram_with_extremes(communicator, volume, 65536);
  std::string percentiles;
  for (const double percent : {1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 99.9}) {
    percentiles += percentiles.empty() ? "percentiles  " : ", ";
    percentiles += format("%g %%: %.6g", percent, image::percentile(fine, percent));
  }
  log.line(percentiles);
  print_histogram(histogram, log);
  if (!(statistics.max > statistics.min)) {
    log.line("Otsu         none: all voxels have the same value");
    return std::nullopt;
  }
  return Otsu{image::otsu_threshold(histogram),
              histogram.levels ? "one bin per level" : "equal bins"};
}

/// What the values are, and the objects above Otsu's threshold.
void print_intensities(const base::Communicator& communicator, voxels::IntensityVolume volume,
                       const image::ValueType& type, base::Log& log) {
  const image::NotFinite gaps = image::not_finite(communicator, volume);
  const std::int64_t finite = volume.voxels() - gaps.count;
  const bool has_gaps = finite > 0 && gaps.count > 0;  // as results have, off the body
  if (has_gaps)
    log.line(
        format("not finite   %lld of %lld voxels (NaN or infinity), the first of them %s, left "
               "out of statistics; as the image of a specimen they are refused",
               printable(gaps.count), printable(volume.voxels()), gaps.first.c_str()));
  const std::optional<Otsu> otsu =
      has_gaps ? print_statistics(communicator, finite_values(volume, finite), type, log)
               : print_statistics(communicator, volume, type, log);
  if (!otsu) return;
  const double fraction = image::fraction_above(communicator, volume, otsu->threshold);
  log.line(format("Otsu         threshold %.9g (%s); above it: %.6f of the volume, %lld voxels",
                  otsu->threshold, otsu->bins, fraction,
                  printable(std::llround(fraction * static_cast<double>(volume.voxels())))));
  const voxels::LabelVolume labels = image::threshold_labels(volume, otsu->threshold);
  volume = voxels::IntensityVolume();
  print_objects(communicator, labels, image::Connectivity::faces, log);
  print_objects(communicator, labels, image::Connectivity::corners, log);
}

}  // namespace

int image_command(const base::Communicator& communicator, const ImageOptions& options,
                  base::Log& log) {
  if (options.voxel_size) {
    for (const double um : *options.voxel_size)
      if (!(um > 0.0) || !std::isfinite(um))
        throw base::InputError("--voxel: admissible: three lengths in um, each above 0");
  }
  image::ImageParameters parameters;
  parameters.file = options.file;
  if (!options.dataset.empty()) parameters.dataset = options.dataset;
  parameters.channel = options.channel;
  parameters.frame = options.frame;
  parameters.voxel_size = options.voxel_size;
  image::ImageSummary summary;
  voxels::IntensityVolume volume;
  try {
    volume = image::read_volume(communicator, parameters, "", summary);
  } catch (const base::InputError& error) {  // thrown on all ranks alike
    throw base::InputError(with_options(error.what()));
  }
  for (std::string& note : summary.notes) note = with_options(note);
  for (std::string& place : summary.voxel_size.found_in)
    if (place == "deck") place = "--voxel";
  print_summary(summary, log);

  try {
    print_intensities(communicator, std::move(volume), summary.type, log);
  } catch (const base::InputError& error) {  // thrown on all ranks alike
    throw base::InputError(summary.path + ": " + error.what());
  }
  return 0;
}

}  // namespace stroma
