// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A material whose numbers and directions differ from particle to particle.

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stroma/material/LawParameters.hpp"
#include "stroma/material/Material.hpp"

namespace stroma::material {

/// A number of a material that a field may give.
struct VaryingNumber {
  std::string name;  ///< "C1 [Pa]", "C [Pa]|1" of a list, "Fibers|collagen|Xi [Pa]"
  Range admissible;
  std::function<double&(MaterialParameters&)> in;
};

/// Those that a material has: its model's, of which it gives the value that a field replaces, its
/// families', its viscosity's, its drives'.
std::vector<VaryingNumber> numbers_that_may_vary(const MaterialParameters& material);

/// The numbers of a law in the order of AnyLaw::for_each_number().
std::vector<double> numbers_of(AnyLaw law);

/// The law of a material at a particle.
class VaryingMaterial {
 public:
  /// \pre each of its fields is one of its numbers
  explicit VaryingMaterial(const MaterialParameters& material);
  VaryingMaterial(const VaryingMaterial&) = delete;
  VaryingMaterial& operator=(const VaryingMaterial&) = delete;

  /// \param field  by its place in the material's list
  /// \param value  of the number that it gives
  void set(std::size_t field, double value) { *number_[field] = value; }
  /// \param family  of fibres, by its place
  /// \param n       unit vector
  /// \param share   of the fibres that there are in full, >= 0
  void point(std::size_t family, const std::array<double, 3>& n, double share);
  /// The law with the numbers and directions set last; without the directions of distributions.
  AnyLaw law() const { return law_at_rest(own_); }

 private:
  MaterialParameters own_;
  std::vector<double*> number_;  // (field) within own_
};

/// Whether a material has fields, or directions from images.
bool varies(const MaterialParameters& material);
/// Those that its fields and structure tensors are of, one each.
std::vector<const FieldImage*> images_of(const MaterialParameters& material);

}  // namespace stroma::material
