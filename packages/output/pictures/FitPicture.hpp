// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The picture of a fit: measured forces with their errors, and those of the fitted deck.

#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::output {

/// One table of measurements, and what the fitted deck makes of it.
struct FittedCurve {
  std::string name;
  bool by_strain = true;                ///< the abscissa is a strain, else a time [s]
  std::vector<double> abscissa;         ///< strain [-] or time [s]
  std::vector<double> measured, error;  ///< [pN]
  std::vector<double> fitted;           ///< [pN]
};

/// fit.png: a panel for tables against strain and one for those against time. Collective; what is
/// drawn is rank 0's.
/// \return  as draw_picture of PictureFile.hpp
std::string draw_fit(const base::Communicator& communicator, const std::string& folder,
                     const std::string& title, const std::vector<FittedCurve>& curves);

}  // namespace stroma::output
