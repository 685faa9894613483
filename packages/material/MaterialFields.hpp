// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Numbers of a material that vary within it, as the deck gives them.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stroma::material {

/// An image beside the specimen's, or the specimen's own.
struct FieldImage {
  std::optional<std::string> file;     ///< relative to the deck's folder; absent: the specimen's
  std::optional<std::string> dataset;  ///< HDF5 only
  std::optional<int> channel;          ///< absent: the specimen's in its file, 0 in another
  std::optional<int> frame;            ///< absent: likewise

  bool is_the_specimens() const { return !file && !dataset && !channel && !frame; }
};

/// A number as a function of the intensity of an image.
struct FieldParameters : FieldImage {
  std::string parameter;            ///< the name of one of numbers_that_may_vary()
  double smoothing = 0.0;           ///< standard deviation of a Gaussian [um]
  std::vector<double> intensities;  ///< ascending, in the image's unit
  std::vector<double> values;       ///< one each, in the number's unit

  /// Piecewise linear between the points (intensity, value), constant beyond the first and last.
  double at(double intensity) const;
  /// Whether it is constant there for no reason but that the points end.
  bool is_clipped(double intensity) const {
    return intensity < intensities.front() || intensity > intensities.back();
  }
};

struct MaterialFields {
  std::vector<std::pair<std::string, FieldParameters>> fields;  ///< by the user's names
};

/// Where directions of fibres are that an image gives, if one does.
struct DirectionsFromImage : FieldImage {
  enum class Kind {
    structure_tensor,  ///< of one image: the direction in which it varies least
    images             ///< three: components along x, y, z
  };

  std::optional<Kind> direction_from;    ///< absent: from no image
  std::optional<double> gradient_scale;  ///< standard deviation of the derivative's Gaussian [um]
  std::optional<double> window_scale;    ///< of the mean of its products [um]
  bool weigh_by_coherence = false;       ///< fibres are as many as their direction is clear
  std::vector<std::string> images;       ///< of Kind::images: three files
};

}  // namespace stroma::material
