// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How a section names an image beside the specimen's.

#include "stroma/deck/Section.hpp"
#include "stroma/material/MaterialFields.hpp"

namespace stroma::sections {

/// The parameters of the FieldImage that Params derives from.
template <class Params>
void declare_field_image(deck::Section<Params>& section) {
  using deck::inherited;
  section.optional("Image", inherited<Params>(&Params::file), deck::not_empty(),
                   "An image file of the same voxels, relative to the deck; read over the same "
                   "Region. Absent: the specimen's own.");
  section.optional("Dataset", inherited<Params>(&Params::dataset), deck::not_empty(),
                   "Of an HDF5 file.");
  section.optional("Channel", inherited<Params>(&Params::channel), deck::not_negative(),
                   "Counted from 0; absent: of the specimen's file its Channel, of another the "
                   "first.");
  section.optional("Frame", inherited<Params>(&Params::frame), deck::not_negative(),
                   "Of a time series, from 0; absent: of the specimen's file its Frame, of another "
                   "the first.");
}

}  // namespace stroma::sections
