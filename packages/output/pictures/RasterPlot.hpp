// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A raster as gnuplot draws it, and read back from the files of a picture.

#include <optional>
#include <string>
#include <vector>

#include "stroma/output/pictures/SliceRaster.hpp"

namespace stroma::output {

constexpr const char* micrometre = "µm";

/// Where a picture has the origin of y, the image's first row: at the top, as image viewers draw
/// images, or at the bottom, as plots are drawn.
enum class Origin { Top, Bottom };

/// The range of y from low to high as gnuplot is told it; for Top, y grows downwards.
std::string y_range(double low, double high, Origin origin);

/// A round step (1, 2 or 5 times a power of 10) that divides a length into at most so many parts.
double round_step(double length, double parts);

struct ColourScale {
  double end = 1.0;      ///< its upper end
  double largest = 0.0;  ///< of the values; above the end when rare peaks are cut off
};

/// The scale ends at the largest value, unless less than 0.5 % of the pixels lie above two thirds
/// of it: then at the 99.5th percentile. Values that are not finite do not count.
ColourScale colour_scale(std::vector<float> values);

/// The bytes of NAME.raw: 32-bit floats of this machine's byte order, x fastest, from the row of
/// the smallest y on; NaN: no particle.
std::string raster_bytes(const Raster& raster);

/// What gnuplot's `plot` draws a raster with.
/// \param raster  what is drawn
/// \param name    of the file with its numbers, without the ending
/// \param skip    bytes in the file before the raster
std::string raster_clause(const Raster& raster, const std::string& name, std::size_t skip = 0);

/// A raster read back, or why it is not there.
struct StoredRaster {
  std::optional<Raster> raster;
  std::string missing_because;
};

/// Reads FOLDER/NAME.raw with the pixels that raster_clause() wrote into FOLDER/NAME.gp. For one
/// rank.
StoredRaster read_raster(const std::string& folder, const std::string& name);

}  // namespace stroma::output
