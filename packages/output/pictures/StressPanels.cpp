// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/StressPanels.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"
#include "stroma/output/pictures/PictureFile.hpp"
#include "stroma/output/pictures/RasterPlot.hpp"

namespace stroma::output {
namespace {

using base::format;

/// x and y that all panels show [um].
struct Window {
  double low[2], high[2];
  double width() const { return high[0] - low[0]; }
  double height() const { return high[1] - low[1]; }
};

Window window_of(const std::vector<StressPanel>& panels) {
  Window window{{1e300, 1e300}, {-1e300, -1e300}};
  for (const StressPanel& panel : panels) {
    const Raster& raster = panel.raster;
    const int pixels[2] = {raster.columns, raster.rows};
    for (std::size_t d = 0; d < 2; ++d) {
      const double low = raster.first[d] - 0.5 * raster.pixel[d];
      window.low[d] = std::min(window.low[d], low);
      window.high[d] = std::max(window.high[d], low + pixels[d] * raster.pixel[d]);
    }
  }
  const double margin = 0.015 * std::max(window.width(), window.height());
  for (std::size_t d = 0; d < 2; ++d) {
    window.low[d] -= margin;
    window.high[d] += margin;
  }
  return window;
}

/// Where the panels stand, in pixels from the picture's lower left corner.
struct Layout {
  static constexpr double left = 100.0, right = 190.0, bottom = 80.0, top = 112.0;
  static constexpr double column_gap = 30.0, row_gap = 16.0, line = 21.0;
  std::size_t columns = 1, rows = 1;
  double panel_width = 0, panel_height = 0;
  double title_height = 0;  ///< above each panel
  double indent = 0;        ///< of all panels, where the picture is wider than they need

  double width() const {
    return left + static_cast<double>(columns) * (panel_width + column_gap) - column_gap + right +
           2.0 * indent;
  }
  double height() const {
    return bottom + static_cast<double>(rows) * (panel_height + title_height + row_gap) - row_gap +
           top;
  }
  double panel_left(std::size_t column) const {
    return left + indent + static_cast<double>(column) * (panel_width + column_gap);
  }
  double panel_bottom(std::size_t row) const {
    return bottom + static_cast<double>(rows - 1 - row) * (panel_height + title_height + row_gap);
  }
};

/// A title cut into lines of at most so many letters, between words.
std::vector<std::string> wrapped(const std::string& title, std::size_t letters) {
  std::vector<std::string> lines;
  std::istringstream words(title);
  for (std::string word; words >> word;) {
    if (!lines.empty() && lines.back().size() + 1 + word.size() <= letters)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

/// As many columns as make the maps largest on a sheet of 1500 x 1000 pixels.
Layout layout_of(const Window& window, std::size_t panels) {
  Layout best;
  double best_scale = 0.0;
  for (std::size_t columns = 1; columns <= panels; ++columns) {
    const std::size_t rows = (panels + columns - 1) / columns;
    const double scale = std::min({1500.0 / static_cast<double>(columns) / window.width(),
                                   1000.0 / static_cast<double>(rows) / window.height(),
                                   520.0 / std::max(window.width(), window.height())});
    if (scale <= best_scale * 1.0001) continue;
    best_scale = scale;
    best.columns = columns;
    best.rows = rows;
    best.panel_width = window.width() * scale;
    best.panel_height = window.height() * scale;
  }
  best.indent = std::max(0.0, 0.5 * (760.0 - best.width()));
  return best;
}

/// (a), (b), ... (z), (27), ...; nothing where there is one panel.
std::string mark_of(std::size_t panel, std::size_t panels) {
  if (panels == 1) return "";
  return panel < 26 ? format("(%c) ", static_cast<char>('a' + panel)) : format("(%zu) ", panel + 1);
}

}  // namespace

std::string draw_stress_panels(const base::Communicator& communicator, const std::string& folder,
                               const std::string& title, const std::string& common,
                               const std::vector<StressPanel>& panels, Origin origin) {
  const char* const name = "von_mises";
  if (!communicator.is_root()) return draw_picture(communicator, folder, name, "", "raw", "");

  const Window window = window_of(panels);
  Layout layout = layout_of(window, panels.size());
  std::vector<std::vector<std::string>> titles;
  std::size_t title_lines = 1;
  std::vector<float> all;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const auto letters = static_cast<std::size_t>(layout.panel_width / 8.6);
    titles.push_back(wrapped(mark_of(p, panels.size()) + panels[p].title, letters));
    title_lines = std::max(title_lines, titles.back().size());
    all.insert(all.end(), panels[p].raster.value.begin(), panels[p].raster.value.end());
  }
  layout.title_height = 14.0 + Layout::line * static_cast<double>(title_lines);
  const ColourScale scale = colour_scale(all);

  const double width = std::round(layout.width()), height = std::round(layout.height());
  std::string heading = title + "\nvon Mises stress at full load";
  if (!common.empty()) heading += "; " + common;
  if (scale.largest > scale.end) heading += format("; largest value %.3g Pa", scale.largest);
  std::string script =
      gnuplot_head(name, static_cast<int>(width), static_cast<int>(height), heading);
  script += viridis_palette();
  script += format("set cbrange [0:%.6g]\nset size ratio -1\n", scale.end);
  script += format("set xrange [%.8g:%.8g]\nset yrange ", window.low[0], window.high[0]) +
            y_range(window.low[1], window.high[1], origin) + "\n";
  script += format("set xtics %g\nset ytics %g\nset tics scale 0.6\n",
                   round_step(window.width(), std::max(layout.panel_width / 72.0, 2.0)),
                   round_step(window.height(), std::max(layout.panel_height / 70.0, 2.0)));
  script +=
      "# von_mises.raw: the panels' rasters one after the other, 32-bit floats of this "
      "machine's byte order, x\n# fastest, from the smallest y on; NaN where there is no "
      "particle.\nset multiplot\n";

  std::string data;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const std::size_t column = p % layout.columns, row = p / layout.columns;
    const double left = layout.panel_left(column), bottom = layout.panel_bottom(row);
    const bool is_lowest = p + layout.columns >= panels.size(), is_last = p + 1 == panels.size();
    script += format("\nset lmargin at screen %.5f\nset rmargin at screen %.5f\n", left / width,
                     (left + layout.panel_width) / width);
    script += format("set bmargin at screen %.5f\nset tmargin at screen %.5f\n", bottom / height,
                     (bottom + layout.panel_height) / height);
    for (std::size_t line = 0; line < titles[p].size(); ++line) {
      const double up = 16.0 + Layout::line * static_cast<double>(titles[p].size() - 1 - line);
      script += format("set label %zu %s at screen %.5f, screen %.5f left font 'Sans,13'\n",
                       10 + line, gnuplot_quoted(titles[p][line]).c_str(), left / width,
                       (bottom + layout.panel_height + up) / height);
    }
    script += is_lowest ? format("set xlabel 'x (%s)'\nset format x '%%g'\n", micrometre)
                        : std::string("unset xlabel\nset format x ''\n");
    script += column == 0 ? format("set ylabel 'y (%s)'\nset format y '%%g'\n", micrometre)
                          : std::string("unset ylabel\nset format y ''\n");
    if (is_last) {
      const double low = layout.panel_bottom(layout.rows - 1);
      const double bar = layout.panel_bottom(0) + layout.panel_height - low;
      const double right = layout.panel_left(layout.columns - 1) + layout.panel_width;
      script += format(
          "set colorbox user origin screen %.5f, screen %.5f size screen %.5f, screen %.5f\n",
          (right + 26.0) / width, low / height, 28.0 / width, bar / height);
      script += format("set cblabel 'von Mises stress (Pa)' offset 1\nset cbtics %g\n",
                       round_step(scale.end, std::max(bar / 60.0, 2.0)));
    } else {
      script += "unset colorbox\n";
    }
    script += "plot " + raster_clause(panels[p].raster, name, data.size()) + "\nunset label\n";
    data += raster_bytes(panels[p].raster);
  }
  script += "unset multiplot\n";
  return draw_picture(communicator, folder, name, data, "raw", script);
}

}  // namespace stroma::output
