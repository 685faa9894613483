// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Counts in the text headers of image files.

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

namespace stroma::image {

/// No count in an image file is larger: products of a few such stay below 2^63 as doubles do below
/// infinity, and are compared as doubles.
inline constexpr std::int64_t largest_count = 1000000000;

/// The text's whole number, which may stand between spaces. Nothing where it is none, or beyond
/// +-10^9.
inline std::optional<std::int64_t> whole_number(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  if (first == std::string::npos) return std::nullopt;
  std::int64_t value = 0;
  const char* const end = text.data() + last + 1;
  const auto read = std::from_chars(text.data() + first, end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  if (value < -largest_count || value > largest_count) return std::nullopt;
  return value;
}

}  // namespace stroma::image
