// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Numbers of a material that vary within it.

#include <string>
#include <utility>
#include <vector>

namespace stroma::material {

/// Which number of its material a field gives to each particle.
enum class VaryingNumber { shear_modulus };

/// "Shear Modulus [Pa]".
const char* name_of(VaryingNumber number);

/// A number as a function of the intensity of the specimen's image.
struct FieldParameters {
  VaryingNumber number = VaryingNumber::shear_modulus;
  std::vector<double> intensities;  ///< ascending, in the image's unit
  std::vector<double> values;       ///< one each, in the number's unit

  /// Piecewise linear between the points (intensity, value), constant beyond the first and last.
  double at(double intensity) const;
};

struct MaterialFields {
  std::vector<std::pair<std::string, FieldParameters>> fields;  ///< by the user's names

  /// The field of a number; null: the number is the material's own everywhere.
  const FieldParameters* of(VaryingNumber number) const;
};

}  // namespace stroma::material
