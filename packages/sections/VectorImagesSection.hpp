// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Sublists that name images of a vector's components.

#include <string>

#include "stroma/deck/Section.hpp"
#include "stroma/mechanics/problem/VectorField.hpp"

namespace stroma::sections {

/// \param name     of the sublist
/// \param meaning  what the images hold, and in which unit
/// \param unread   a sentence on images that are not read; "" without any
deck::Section<mechanics::VectorImages> vector_images_section(const std::string& name,
                                                             const std::string& meaning,
                                                             const std::string& unread = "");

}  // namespace stroma::sections
