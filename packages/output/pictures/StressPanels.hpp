// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Maps of the von Mises stress of several runs, side by side on one scale.

#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/pictures/RasterPlot.hpp"
#include "stroma/output/pictures/SliceRaster.hpp"

namespace stroma::output {

struct StressPanel {
  std::string title;  ///< stands above the map
  Raster raster;      ///< von Mises stress [Pa]
};

/// von_mises.png: the panels in rows, as (a), (b), ..., all with the same range of x and y, at the
/// same length on paper, and with one colour bar. The colour scale is that of colour_scale() over
/// all pixels together. Its numbers, one raster after the other, are pictures/von_mises.raw.
/// Collective; the panels are rank 0's, and at least one.
/// \param communicator  rank 0 of it draws
/// \param folder        exists
/// \param title         the first, bold line
/// \param common        what the panels have in common, for the picture's second line; may be empty
/// \param panels        from left to right, row by row
/// \param origin        of y, in all panels
/// \return  as draw_picture of PictureFile.hpp
std::string draw_stress_panels(const base::Communicator& communicator, const std::string& folder,
                               const std::string& title, const std::string& common,
                               const std::vector<StressPanel>& panels, Origin origin);

}  // namespace stroma::output
