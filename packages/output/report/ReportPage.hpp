// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A page with results that shows itself in any browser, without a network.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "stroma/output/report/ParticleMaps.hpp"

namespace stroma::output {

/// An array of the page: its name, and packed().
using PageArray = std::pair<std::string, std::string>;

/// The page: our own style and script, Chart.js, the data, and the arrays, each an element of its
/// own that is unpacked when it is looked at.
/// \param title   of the page, any text
/// \param data    what the page shows
/// \param arrays  that the data name
std::string report_page(const std::string& title, const nlohmann::json& data,
                        const std::vector<PageArray>& arrays);

/// What the page has to know of maps; their values are added to the arrays.
nlohmann::json describe(const ParticleMaps& maps, const std::vector<double>& loads,
                        const std::vector<double>& step_numbers, const std::vector<double>& times,
                        std::vector<PageArray>& arrays);

/// Rows of a CSV file for the page: {"text": header and rows, "rows": how many, "of": how many the
/// file has}.
/// \param text    of the file
/// \param most    rows
/// \param evenly  whether more are thinned out, the last one kept, or the first ones taken
nlohmann::json table_excerpt(const std::string& text, std::size_t most, bool evenly);

}  // namespace stroma::output
