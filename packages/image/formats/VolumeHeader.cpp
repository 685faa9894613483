// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/VolumeHeader.hpp"

#include <cmath>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace stroma::image {

void set_strides(VolumeHeader& header,
                 const std::vector<std::pair<std::int64_t, std::int64_t*>>& axes) {
  header.values = 1;
  for (const auto& [size, stride] : axes) {
    *stride = header.values;
    // What follows multiplies by the bytes of a value at most.
    if (__builtin_mul_overflow(header.values, size, &header.values) || header.values > 1LL << 56)
      refuse(header.path, "is broken: the sizes in its " + header.format +
                              " header multiply to more than any file holds");
  }
}

void set_spacing(VolumeHeader& header, int axis, double spacing, double micrometres) {
  const char name = "xyz"[axis];
  const double um = std::abs(spacing) * micrometres;
  if (!std::isfinite(um) || !(um > 0.0)) {
    header.notes.push_back(
        base::format("the header's spacing along %c, %g, is no length; not used", name, spacing));
    return;
  }
  if (spacing < 0.0)
    header.notes.push_back(base::format(
        "the header's spacing along %c is negative, %g; its size is taken", name, spacing));
  header.voxel_size.set(axis, um, header.format + " header");
}

void note_no_unit(VolumeHeader& header, const std::vector<double>& spacing) {
  std::string numbers;
  for (const double s : spacing) numbers += (numbers.empty() ? "" : ", ") + base::format("%g", s);
  header.notes.push_back("the header's spacing (" + numbers + ") has no unit of length; not used");
}

void note_orientation(VolumeHeader& header, const std::vector<std::array<double, 3>>& axes) {
  constexpr double tolerance = 1e-3;  // of a cosine
  const auto product = [&](std::size_t i, std::size_t j) {
    double sum = 0.0;
    for (std::size_t d = 0; d < 3; ++d) sum += axes[i][d] * axes[j][d];
    return sum;
  };
  bool proper = true, right_angles = true, as_stored = true;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double length = std::sqrt(product(i, i));
    proper = proper && std::isfinite(length) && length > 0.0;
    as_stored = as_stored && axes[i][i] > (1.0 - tolerance) * length;
    for (std::size_t j = 0; j < i; ++j)
      right_angles =
          right_angles && std::abs(product(i, j)) <= tolerance * length * std::sqrt(product(j, j));
  }
  if (!proper) {
    header.notes.push_back("the header's directions of the axes are none; not used");
  } else if (!right_angles) {
    header.notes.push_back(
        "the header's axes are not at right angles (a sheared stack); the array is taken as a box");
  } else if (!as_stored) {
    header.notes.push_back(
        "the header turns or mirrors the axes; x, y and z are those of the array, as stored");
  }
}

void note_range(VolumeHeader& header, double stated_max) {
  if (header.type.kind != ValueType::Kind::signed_integer) return;
  const double type_max = std::ldexp(1.0, 8 * header.type.bytes - 1) - 1.0;
  if (!(stated_max > type_max)) return;
  header.notes.push_back(
      base::format("the header states a largest value of %g, beyond the %g of its %s: values that "
                   "were meant unsigned are read as negative",
                   stated_max, type_max, header.type.name().c_str()));
}

}  // namespace stroma::image
