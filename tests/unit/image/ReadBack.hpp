// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Reads the files of WriteFiles.hpp as a deck would, and compares them value by value. Collective.

#include <string>

#include "WriteFiles.hpp"
#include "stroma/image/ReadVolume.hpp"

namespace stroma::test {

using Size = std::array<std::int64_t, 3>;

/// Reads what `parameters` ask for; a file's name is relative to folder().
voxels::IntensityVolume read_back(const image::ImageParameters& parameters,
                                  image::ImageSummary& summary);

/// Every value of this rank's slab is the pattern's, and the slabs make up `size`.
/// \param first  the voxel of the pattern at the volume's corner
void expect_pattern(const voxels::IntensityVolume& volume, const Size& size, const Pattern& pattern,
                    std::int64_t channel = 0, const Size& first = {0, 0, 0});

/// A note holds these words.
bool has_note(const image::ImageSummary& summary, const std::string& words);

/// Reading fails on all ranks with a message that names the file and holds these words; no library
/// says a word beside it.
void expect_refused(const image::ImageParameters& parameters, const std::string& words);
void expect_refused(const std::string& file, const std::string& words);
/// The same of a file that holds these bytes.
void expect_refused(const std::string& file, const std::string& bytes, const std::string& words);

}  // namespace stroma::test
