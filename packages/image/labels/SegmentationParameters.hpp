// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How an image is segmented.

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stroma::image {

/// How intensities become labels.
struct SegmentationParameters {
  enum class Method { threshold, otsu, labels };
  Method method = Method::otsu;
  std::optional<double>
      threshold;           ///< label 1 where intensity > threshold (Method::threshold only)
  double smoothing = 0.0;  ///< standard deviation of a Gaussian [um]; 0: none
  /// What becomes empty space: labels, or (not with Method::labels) the word Dark or Bright.
  std::optional<std::variant<std::vector<int>, std::string>> empty_labels;
  int smallest_object = 0;  ///< voxels, 26-connected; smaller objects become background
};

}  // namespace stroma::image
