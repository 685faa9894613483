// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One case of tests/data/reference: its description, and how to put it to the program.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/Program.hpp"

namespace stroma::test {

/// A boundary condition of the deck, and whose summed force in the reference it must equal.
struct CaseCondition {
  std::string name;
  std::string face;
  std::string components;
  std::string load;            ///< a Parameter line of the deck, or nothing
  std::string reference_face;  ///< "F_y0", "F_y1", or nothing
};

/// A reference solution: grid, points, labels of the points, conditions, results.
class ReferenceCase {
 public:
  /// \param file  name without folder and ending
  explicit ReferenceCase(const std::string& file);

  /// Writes the label image (one voxel for each point, two per element and direction) and the deck.
  /// \return the deck
  fs::path write_deck(const TemporaryFolder& folder) const;

  /// Whether its elements have one dilatation each (Q1/P0).
  bool has_mean_dilatation() const { return name_.find("q1p0") != std::string::npos; }
  const std::vector<CaseCondition>& conditions() const { return conditions_; }
  const nlohmann::json& results() const { return json_.at("results"); }
  std::array<std::int64_t, 3> elements() const { return elements_; }
  /// Number of point p of element e (both of the reference) in the layout's order, which is
  /// Stroma's id.
  std::int64_t particle_id(std::int64_t element, std::int64_t point) const;

 private:
  bool is_vessel(std::int64_t element, int point) const;
  void write_labels(const fs::path& path) const;
  std::string loading() const;

  nlohmann::json json_;
  std::string name_;
  std::array<std::int64_t, 3> elements_;
  std::array<double, 3> element_size_;
  std::vector<CaseCondition> conditions_;
};

/// The case's file.
fs::path reference_file(const std::string& name);

}  // namespace stroma::test
