// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The files that a report is made of, built into the program by cmake/embed.cmake.

#include <string_view>

namespace stroma::output::embedded {

std::string_view page();            ///< report.html, with places for the others
std::string_view style();           ///< report.css
std::string_view script();          ///< the files of script/
std::string_view charts();          ///< Chart.js
std::string_view charts_licence();  ///< of Chart.js

}  // namespace stroma::output::embedded
