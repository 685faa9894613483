// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/ImageSummary.hpp"

#include <vector>

namespace stroma::image {

std::string VoxelSize::source() const {
  static const char* const axis_names[] = {"x", "y", "z"};
  std::vector<std::pair<std::string, std::string>> places;  // place, axes
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string place = um[axis] > 0.0 ? found_in[axis] : "nowhere";
    if (!places.empty() && places.back().first == place) {
      places.back().second += std::string(", ") + axis_names[axis];
    } else {
      places.emplace_back(place, axis_names[axis]);
    }
  }
  if (places.size() == 1) return places.front().first;
  std::string text;
  for (const auto& [place, axes] : places)
    text += (text.empty() ? "" : ", ") + place + " (" + axes + ")";
  return text;
}

std::string ValueType::name() const {
  const std::string bits = std::to_string(8 * bytes) + "-bit ";
  switch (kind) {
    case Kind::unsigned_integer:
      return bits + "unsigned integer";
    case Kind::signed_integer:
      return bits + "signed integer";
    default:
      return bits + "float";
  }
}

}  // namespace stroma::image
