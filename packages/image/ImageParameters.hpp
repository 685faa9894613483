#pragma once

/// \file
/// What the deck's section "Image" says: where the specimen comes from and how it is segmented. The
/// section itself is declared in ImageSection.cpp.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/Phantom.hpp"

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

/// The specimen: a file or a phantom, never both.
struct ImageParameters {
  std::optional<std::string> file;                  ///< relative to the deck's folder
  std::optional<std::string> dataset;               ///< HDF5 only; absent: the only one of the file
  int channel = 0;                                  ///< from 0
  int frame = 0;                                    ///< of a time series, from 0
  std::optional<std::array<double, 3>> voxel_size;  ///< x, y, z [um]; absent: the file's own
  std::optional<std::array<int, 6>> region;  ///< first voxel x, y, z, then counts; absent: all
  SegmentationParameters segmentation;
  std::optional<PhantomParameters> phantom;
};

}  // namespace stroma::image
