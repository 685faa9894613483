// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/RasterPlot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "stroma/base/FileContent.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {
namespace {

using base::format;

}  // namespace

double round_step(double length, double parts) {
  const double step = length / std::max(parts, 1.0);
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::string y_range(double low, double high, Origin origin) {
  return origin == Origin::Top ? format("[%.8g:%.8g]", high, low)
                               : format("[%.8g:%.8g]", low, high);
}

ColourScale colour_scale(std::vector<float> values) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }),
      values.end());
  if (values.empty()) return {};
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.995 * (values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  const double common = *place;
  const double largest = *std::max_element(place, values.end());
  if (largest <= 0.0) return {};
  return {(common > 0.0 && largest > 1.5 * common) ? common : largest, largest};
}

std::string raster_bytes(const Raster& raster) {
  return {reinterpret_cast<const char*>(raster.value.data()), raster.value.size() * sizeof(float)};
}

std::string raster_clause(const Raster& raster, const std::string& name, std::size_t skip) {
  const std::string offset = skip == 0 ? "" : format(" skip=%zu", skip);
  return format(
      "'%s.raw' binary%s array=(%d,%d) format='%%float' origin=(%.10g,%.10g) dx=%.10g dy=%.10g "
      "with image notitle",
      name.c_str(), offset.c_str(), raster.columns, raster.rows, raster.first[0], raster.first[1],
      raster.pixel[0], raster.pixel[1]);
}

StoredRaster read_raster(const std::string& folder, const std::string& name) {
  const std::string script = base::file_content(folder + "/" + name + ".gp");
  const std::string bytes = base::file_content(folder + "/" + name + ".raw");
  if (script.empty() || bytes.empty())
    return {std::nullopt, "there is no " + folder + "/" + name + ".raw with its script"};
  const std::string head = "'" + name + ".raw' binary array=";
  const std::size_t at = script.find(head);
  Raster raster;
  const bool is_told = at != std::string::npos &&
                       std::sscanf(script.c_str() + at + head.size(),
                                   "(%d,%d) format='%%float' origin=(%lf,%lf) dx=%lf dy=%lf",
                                   &raster.columns, &raster.rows, &raster.first[0],
                                   &raster.first[1], &raster.pixel[0], &raster.pixel[1]) == 6 &&
                       raster.columns > 0 && raster.rows > 0;
  if (!is_told)
    return {std::nullopt, folder + "/" + name + ".gp does not tell the pixels of " + name + ".raw"};
  const std::size_t pixels =
      static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows);
  if (bytes.size() != pixels * sizeof(float))
    return {std::nullopt, folder + "/" + name + ".raw and its script do not go together"};
  raster.value.resize(pixels);
  std::memcpy(raster.value.data(), bytes.data(), bytes.size());
  return {std::move(raster), ""};
}

}  // namespace stroma::output
