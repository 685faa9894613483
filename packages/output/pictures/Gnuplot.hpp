// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// gnuplot as a child process, and the parts of a script that all pictures share.

#include <chrono>
#include <string>

namespace stroma::output {

/// Terminal, fonts and title of a script that writes ../NAME.png, seen from the scripts' folder.
/// \param name    of the picture, without its ending
/// \param width   [pixels]
/// \param height  [pixels]
/// \param title   a line break separates the first, bold line from the rest
std::string gnuplot_head(const std::string& name, int width, int height, const std::string& title);

/// Viridis, a perceptually uniform colour map that the colour-blind can read (van der Walt & Smith,
/// matplotlib, public domain), by 20 of its colours.
std::string viridis_palette();

/// One of its colours, "#rrggbb": 0 the darkest, 1 the lightest.
std::string viridis_colour(double place);

/// A text as a gnuplot string.
std::string gnuplot_quoted(const std::string& text);

/// How long gnuplot is waited for: a minute; a few seconds once it has been given up.
std::chrono::milliseconds gnuplot_patience();

/// Runs `gnuplot SCRIPT` in a folder, without the user's own settings, and waits for it; after so
/// long it is ended, with the processes that it started. Nothing reaches this process's output.
/// \return  empty when it succeeded; else what went wrong, in one line
std::string run_gnuplot(const std::string& folder, const std::string& script,
                        std::chrono::milliseconds patience = gnuplot_patience());

}  // namespace stroma::output
