// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How the many curves of a study are told apart: one thing that varies by colours, one by dashes,
/// one by points, and a legend with a column for each thing.

#include <cstddef>
#include <string>
#include <vector>

namespace stroma::output {

/// A thing in which curves differ.
struct CurveThing {
  std::string name;
  std::vector<std::string> alternatives;
};

/// A curve as far as its style goes.
struct CurveName {
  std::string name;                      ///< of the whole curve
  std::vector<std::size_t> alternative;  ///< which one of each thing
};

struct CurveStyles {
  std::vector<std::string> style;  ///< of each curve: "lw 2 lc rgb '#31688e' dt 1 pt 7 ps 1"
  std::vector<std::string> title;  ///< of each curve: "notitle" or "title '...'"
  std::string legend;              ///< continues the plot command after the curves; may be empty
  std::string key;                 ///< gnuplot's `set key`, below the plot
  int key_lines = 0;               ///< height of the legend
  int width = 0;                   ///< of the picture, for the legend to fit [pixels]
};

/// Things with one alternative tell nothing apart and are left out. Of the others, the one with
/// most alternatives gets colours, the next dashes (at most 5 of them), the third points (at most
/// 7). Of more than three, the smallest are taken together as one. Where one thing alone varies, or
/// dashes or points do not suffice, every curve has a line of its own in the legend.
CurveStyles curve_styles(std::vector<CurveThing> things, std::vector<CurveName> curves);

}  // namespace stroma::output
