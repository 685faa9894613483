// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The pictures of a study: its members' forces, against strain and against the size of the
/// elements.

#include <optional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/pictures/CurveStyles.hpp"

namespace stroma::output {

/// The force of one support of one member over its steps.
struct ForceCurve {
  CurveName name;
  std::vector<double> stretch;  ///< strain [-], or displacement [um] where there is none
  std::vector<double> force;    ///< along the displacement [pN]
};

/// f = value + coefficient h^order [pN], h in um.
struct SizeFit {
  double value = 0;
  double coefficient = 0;
  double order = 0;
};

/// The force at full load of members that differ in nothing but the size of their elements.
struct SizeSeries {
  std::string name;               ///< stands in the legend; may be empty
  std::vector<double> size;       ///< of the elements [um]
  std::vector<double> force;      ///< [pN]
  std::optional<SizeFit> fit;     ///< to size 0
  std::string undefined_because;  ///< why there is no fit
};

/// What 5, 50 and 95 % of a study's draws stay below, at each of some loads.
struct ForceBand {
  std::string abscissa;                   ///< "strain (%)"
  std::vector<double> stretch;            ///< in its unit
  std::vector<double> low, median, high;  ///< [pN]
  std::vector<double> middle,
      finer;  ///< of the runs with all inputs at their medians; may be empty
};

/// force_band.png: the band of the draws, and the runs in the middle of the inputs on both grids.
/// Collective; what is drawn is rank 0's.
std::string draw_force_band(const base::Communicator& communicator, const std::string& folder,
                            const std::string& title, const std::string& support,
                            const ForceBand& band);

/// force_strain.png: all members in one picture, told apart by curve_styles(), with the legend
/// below. Collective; what is drawn is rank 0's.
/// \param communicator  rank 0 of it draws
/// \param folder        exists
/// \param title         the first, bold line
/// \param support       the condition whose force is drawn
/// \param things        what the curves differ in
/// \param curves        one for each member
/// \param by_strain     the curves' abscissa is strain, else displacement
/// \param remark        follows the picture's second line; may be empty
/// \return  as draw_picture of PictureFile.hpp
std::string draw_force_strain(const base::Communicator& communicator, const std::string& folder,
                              const std::string& title, const std::string& support,
                              const std::vector<CurveThing>& things,
                              const std::vector<ForceCurve>& curves, bool by_strain,
                              const std::string& remark);

/// force_element_size.png: force against element size, with each series' value at size 0 and its
/// observed order, or why they are undefined. Collective; what is drawn is rank 0's.
std::string draw_force_element_size(const base::Communicator& communicator,
                                    const std::string& folder, const std::string& title,
                                    const std::string& support,
                                    const std::vector<SizeSeries>& series);

}  // namespace stroma::output
