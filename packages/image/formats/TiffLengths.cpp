// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/TiffLengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/LengthUnit.hpp"

namespace stroma::image {
namespace {

using base::format;

/// 1 / resolution. Where a decimal of at most 6 digits gives the same tag, up to the rounding of
/// its writer, it is that decimal: 952381 / 1000000 pixels per micron is 1.05 um, not 1.0499999475.
double length_of_pixel(double resolution, double rounding) {
  const double length = 1.0 / resolution;
  for (int digits = 1; digits <= 6; ++digits) {
    const double candidate = std::strtod(format("%.*g", digits, length).c_str(), nullptr);
    if (std::abs(1.0 / candidate - resolution) <= rounding) return candidate;
  }
  return length;
}

/// Units of the resolutions along x and y, by name.
using Units = std::array<std::string, 2>;

/// Resolutions of printers and screens are no calibration; one of both axes is told once.
void take_resolutions(ImageSummary& summary, const TiffTags& tags, const Units& units,
                      const std::string& place) {
  const std::array<std::optional<double>, 2> resolutions{tags.pixels_per_unit_x,
                                                         tags.pixels_per_unit_y};
  const std::array<double, 2> roundings{tags.rounding_x, tags.rounding_y};
  std::string told;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::optional<double> scale = micrometres_per(units[axis]);
    if (!resolutions[axis] || !scale) continue;
    const double resolution = *resolutions[axis];
    const bool is_printers =
        (place != "ImageJ tags" || units[axis] == "inch") && resolution * 25400.0 / *scale < 1300.0;
    if (!is_printers) {
      summary.voxel_size.set(static_cast<int>(axis),
                             length_of_pixel(resolution, roundings[axis]) * *scale, place);
      continue;
    }
    const std::string note =
        format("%g pixels per %s is a printer's or a screen's resolution; not used", resolution,
               units[axis].c_str());
    if (note != told) summary.notes.push_back(note);
    told = note;
  }
}

}  // namespace

void take_resolution_lengths(ImageSummary& summary, const TiffTags& tags) {
  if (tags.resolution_unit == RESUNIT_NONE) return;
  const std::string unit = tags.resolution_unit == RESUNIT_INCH ? "inch" : "cm";
  take_resolutions(summary, tags, {unit, unit}, "TIFF resolution tags");
}

void take_imagej_lengths(ImageSummary& summary, const TiffTags& tags,
                         const ImageJDescription& imagej) {
  if (!micrometres_per(imagej.unit)) {
    if (!imagej.unit.empty() && imagej.unit != "pixel" && imagej.unit != "pixels")
      summary.notes.push_back("ImageJ's unit \"" + imagej.unit +
                              "\" is no unit of length known here; not used");
    take_resolution_lengths(summary, tags);
    return;
  }
  take_resolutions(summary, tags, {imagej.unit, imagej.y_unit}, "ImageJ tags");
  if (!micrometres_per(imagej.y_unit))
    summary.notes.push_back("ImageJ's unit along y, \"" + imagej.y_unit +
                            "\", is no unit of length known here; not used");
  // ImageJ leaves the spacing out where it is 1.
  const auto z_scale = micrometres_per(imagej.z_unit);
  const double spacing = imagej.spacing.value_or(1.0);
  if (spacing > 0.0 && std::isfinite(spacing) && z_scale) {
    summary.voxel_size.set(2, spacing * *z_scale, "ImageJ tags");
    if (!imagej.spacing)
      summary.notes.push_back("ImageJ states no spacing of the slices, which means 1 " +
                              imagej.z_unit);
  } else if (spacing != 0.0) {
    summary.notes.push_back(format("ImageJ's spacing, %g \"%s\", is no length above 0; not used",
                                   spacing, imagej.z_unit.c_str()));
  }
}

void take_ome_lengths(ImageSummary& summary, const OmePixels& ome) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::optional<double>& size = ome.physical_size[axis];
    const auto scale = micrometres_per(ome.physical_unit[axis]);
    if (!size) continue;
    if (*size > 0.0 && std::isfinite(*size) && scale) {
      summary.voxel_size.set(static_cast<int>(axis), *size * *scale, "OME attributes");
    } else if (!scale) {
      summary.notes.push_back("the OME attributes give the voxel size in \"" +
                              ome.physical_unit[axis] +
                              "\", which is no unit of length known here; not used");
    } else {
      summary.notes.push_back(
          format("the OME attribute PhysicalSize%c is no number above 0; not used", "XYZ"[axis]));
    }
  }
}

void take_stk_lengths(ImageSummary& summary, const StkTags& stk) {
  const auto scale = micrometres_per(stk.unit);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::optional<double>& size = stk.pixel_size[axis];
    if (size && *size > 0.0 && scale) {
      summary.voxel_size.set(static_cast<int>(axis), *size * *scale, "MetaMorph tags");
    } else if (size && axis == 0) {
      summary.notes.push_back(
          format("MetaMorph's calibration, %g \"%s\", is no known length; not used", *size,
                 stk.unit.c_str()));
    }
  }
  // The first distance is from a plane that is not there, unless it is the only one.
  const auto& distances = stk.z_distances;
  if (distances.empty()) return;
  const auto first = distances.begin() + (distances.size() > 1 ? 1 : 0);
  if (*first > 0.0 && std::all_of(first, distances.end(), [&](double d) { return d == *first; })) {
    summary.voxel_size.set(2, *first, "MetaMorph tags");
  } else if (distances.size() > 1) {
    summary.notes.push_back(
        "MetaMorph's distances between the planes are 0 or differ; not used. All planes are "
        "stacked along z, even those of a time series");
  }
}

void take_lsm_lengths(ImageSummary& summary, const LsmTags& lsm) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double metres = lsm.voxel_size[axis];
    if (metres > 0.0 && metres < 1.0)
      summary.voxel_size.set(static_cast<int>(axis), 1e6 * metres, "Zeiss tags");
  }
}

}  // namespace stroma::image
