#pragma once

/// \file
/// What NRRD and MetaImage headers say about the unit of their spacing, which ITK does not pass on.

#include <optional>
#include <string>

namespace stroma::image {

/// Neither format has a unit by convention that one could trust in microscopy: without a unit a
/// spacing is no length.
struct HeaderUnits {
  bool has_spacing = false;
  std::optional<double>
      micrometres;  ///< in one unit of the spacing; nothing: no unit, or not a known one
};

/// From the fields `spacings` or `space directions`, and `space units` or `units`.
HeaderUnits nrrd_units(const std::string& path);
/// From ElementSpacing (or ElementSize) and DistanceUnits.
HeaderUnits metaimage_units(const std::string& path);

}  // namespace stroma::image
