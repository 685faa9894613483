// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A picture with its numbers and its script, and what pictures of forces share.

#include <cstddef>
#include <string>

#include "stroma/base/Communicator.hpp"

namespace stroma::output {

/// Writes FOLDER/pictures/NAME.ENDING and NAME.gp from rank 0 and lets gnuplot draw
/// FOLDER/NAME.png. Collective.
///
/// \param communicator  rank 0 of it draws
/// \param folder        exists
/// \param name          of the picture, without its ending
/// \param data          numbers, as the script reads them; what counts is rank 0's
/// \param data_ending   dat or raw
/// \param script        gnuplot's; rank 0's counts
/// \return  a note for the log, the same on all ranks: empty when the picture was made, else why
///          gnuplot did not
/// \throws RunError on all ranks when data, script or picture could not be written, as on a full
///         disk
std::string draw_picture(const base::Communicator& communicator, const std::string& folder,
                         const std::string& name, const std::string& data,
                         const std::string& data_ending, const std::string& script);

/// The unit in which a force is easily read.
struct ForceUnit {
  const char* name;
  double size;  ///< [pN]
};
ForceUnit force_unit(double largest);

/// Colour of the n-th line of a plot; they repeat after six.
const char* line_colour(std::size_t n);

}  // namespace stroma::output
