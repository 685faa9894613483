// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/ImageJDescription.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/WholeNumber.hpp"

namespace stroma::image {
namespace {

using Settings = std::map<std::string, std::string>;

Settings settings_of(const std::string& description) {
  Settings settings;
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
      settings.emplace(line.substr(0, equals), line.substr(equals + 1));
  }
  return settings;
}

const std::string* text_of(const Settings& settings, const char* key) {
  const auto found = settings.find(key);
  return found == settings.end() ? nullptr : &found->second;
}

/// A count of at least 1; `otherwise` where the key is absent, 0 where it is no such number.
std::int64_t count_of(const Settings& settings, const char* key, std::int64_t otherwise) {
  const std::string* text = text_of(settings, key);
  return text ? whole_number(*text).value_or(0) : otherwise;
}

std::string counts_text(const ImageJDescription& read) {
  return base::format("%lld images, but of %lld channels x %lld slices x %lld frames",
                      static_cast<long long>(read.images), static_cast<long long>(read.channels),
                      static_cast<long long>(read.slices), static_cast<long long>(read.frames));
}

/// The slices follow from the other counts where they are not given, as in old stacks.
bool read_counts(const Settings& settings, std::int64_t pages, ImageJDescription& read,
                 std::string& problem) {
  read.images = count_of(settings, "images", pages);
  read.channels = count_of(settings, "channels", 1);
  read.frames = count_of(settings, "frames", 1);
  for (const char* key : {"images", "channels", "slices", "frames"}) {
    if (count_of(settings, key, 1) >= 1) continue;
    problem = std::string(key) + "=" + *text_of(settings, key) + "; admissible: 1 to 10^9";
    return false;
  }
  const double per_slice = static_cast<double>(read.channels) * static_cast<double>(read.frames);
  const bool divisible = per_slice <= static_cast<double>(read.images) &&
                         read.images % static_cast<std::int64_t>(per_slice) == 0;
  read.slices = count_of(settings, "slices",
                         divisible ? read.images / static_cast<std::int64_t>(per_slice) : 1);
  if (per_slice * static_cast<double>(read.slices) == static_cast<double>(read.images)) return true;
  problem = counts_text(read);
  return false;
}

/// Codes of ImageJ's calibration functions; all others bend.
constexpr int straight_line = 0, no_function = 20;

void read_values(const Settings& settings, ImageJDescription& read) {
  const std::string* function = text_of(settings, "cf");
  if (!function) return;
  const int code = std::atoi(function->c_str());
  if (code == no_function) return;
  if (code != straight_line) {
    read.notes.push_back("ImageJ's calibration of values is no straight line (cf=" + *function +
                         "); not used: the values are those stored");
    return;
  }
  const auto coefficient = [&](const char* key, double otherwise) {
    const std::string* text = text_of(settings, key);
    return text ? to_real(trimmed(*text)).value_or(std::nan("")) : otherwise;
  };
  const double c0 = coefficient("c0", 0.0), c1 = coefficient("c1", 1.0);
  if (!std::isfinite(c0) || !std::isfinite(c1) || c1 == 0.0) {
    read.notes.push_back(base::format(
        "ImageJ's calibration of values, %g + %g x stored, says nothing; not used", c0, c1));
    return;
  }
  read.intercept = c0;
  read.slope = c1;
}

void read_lengths(const Settings& settings, ImageJDescription& read) {
  const auto unit = [&](const char* key, const std::string& otherwise) {
    const std::string* text = text_of(settings, key);
    return text ? *text : otherwise;
  };
  read.unit = unit("unit", "");
  read.y_unit = unit("yunit", read.unit);
  read.z_unit = unit("zunit", read.unit);
  const std::string* const spacing = text_of(settings, "spacing");
  if (spacing == nullptr) return;
  const std::optional<double> number = to_real(trimmed(*spacing));
  read.spacing = number.value_or(0.0);  // 0: none, and that is told
  if (*read.spacing == 0.0)
    read.notes.push_back("ImageJ's spacing, \"" + printable(*spacing) + "\", is no " +
                         (number ? "length above 0" : "number") + "; not used");
}

}  // namespace

bool is_imagej(const std::string& description) { return description.compare(0, 7, "ImageJ=") == 0; }

std::optional<ImageJDescription> read_imagej(const std::string& description, std::int64_t pages,
                                             std::string& problem) {
  const Settings settings = settings_of(description);
  ImageJDescription read;
  if (!read_counts(settings, pages, read, problem)) return std::nullopt;
  read_values(settings, read);
  read_lengths(settings, read);
  return read;
}

}  // namespace stroma::image
