// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What was read of the images beside the specimen's: of fields, directions, displacements, velocities.

#include <string>
#include <vector>

#include "stroma/image/formats/ImageSummary.hpp"

namespace stroma {

/// Images that were read beside the specimen's.
struct ReadImages {
  std::vector<std::string> files;
  std::vector<std::string> notes;  ///< each with the deck's section that names the image

  /// Adds the files and notes of an image.
  /// \param where  the deck's section
  /// \param found  the image
  void add(const std::string& where, const image::ImageSummary& found);
};

}  // namespace stroma
