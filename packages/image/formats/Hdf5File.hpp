// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What readers of HDF5 images share: attributes, names.

#include <optional>
#include <string>
#include <vector>

#include "stroma/hdf/Handle.hpp"

namespace stroma::image {

/// Opens a group or a dataset by its path within the file, which may lead over hard and soft links
/// but not into another file; a handle that is not good() if it cannot.
hdf::Handle open_object(hid_t file, const std::string& path);

/// Paths of all datasets of a file, in alphabetical order, without a slash in front. Nothing when
/// the file is too broken to be walked through.
std::optional<std::vector<std::string>> datasets_of(hid_t file);

/// Texts of an attribute: strings of fixed or variable length, one or a list; or one text written
/// as a list of single characters, as Imaris does. Nothing when it is absent or no text.
std::vector<std::string> text_attribute(hid_t object, const char* name);

/// Numbers of an attribute (integers or floats), at most `most` of them. Nothing when it is absent
/// or anything else.
std::vector<double> number_attribute(hid_t object, const char* name, std::size_t most = 16);

/// The first filter of a dataset that this HDF5 does not have: "lzf (filter 32000)"; nothing if it
/// has them all.
std::optional<std::string> missing_filter(hid_t creation_properties);

}  // namespace stroma::image
