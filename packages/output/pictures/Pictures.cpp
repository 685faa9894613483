// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/Pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"
#include "stroma/output/pictures/PictureFile.hpp"
#include "stroma/output/pictures/RasterPlot.hpp"
#include "stroma/output/pictures/SliceRaster.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::output {
namespace {

using base::format;

/// Width and height of the layer at load 0, over all ranks.
std::array<double, 2> extent_of(const base::Communicator& communicator,
                                const ParticleSet& particles,
                                const std::vector<std::int64_t>& layer) {
  std::array<double, 2> extent{};
  for (int d = 0; d < 2; ++d) {
    double low = 1e300, high = -1e300;
    for (const std::int64_t p : layer) {
      low = std::min(low, particles.position[3 * p + d]);
      high = std::max(high, particles.position[3 * p + d]);
    }
    extent[static_cast<std::size_t>(d)] =
        std::max(0.0, communicator.max(high) - communicator.min(low));
  }
  return extent;
}

/// Where things stand on a raster's picture, in pixels from its lower left corner: the plot, true
/// in aspect and 900 pixels long, and the colour bar to the right of it.
struct PictureLayout {
  double width, height;  ///< of the picture
  double left, bottom;   ///< of the plot
  double plot_width, plot_height;
  double bar_bottom, bar_height;
};

PictureLayout layout_of(const Raster& raster) {
  const double width = raster.pixel[0] * raster.columns, height = raster.pixel[1] * raster.rows;
  const double scale = 900.0 / std::max(width, height);
  PictureLayout layout{};
  layout.plot_width = width * scale;
  layout.plot_height = height * scale;
  layout.bar_height = std::max(layout.plot_height, 160.0);
  const double room = std::max(layout.plot_width, 300.0);
  layout.left = 110.0 + 0.5 * (room - layout.plot_width);
  layout.bottom = 80.0 + 0.5 * (layout.bar_height - layout.plot_height);
  layout.bar_bottom = 80.0;
  layout.width = std::round(110.0 + room + 220.0);
  layout.height = std::round(80.0 + layout.bar_height + 110.0);
  return layout;
}

/// The part of a script that a raster's pictures share: size, title, axes, aspect.
std::string raster_script(const Raster& raster, const PictureLayout& layout,
                          const std::string& name, const std::string& title, Origin origin) {
  std::string script =
      gnuplot_head(name, static_cast<int>(layout.width), static_cast<int>(layout.height), title);
  script += format("set lmargin at screen %.5f\nset rmargin at screen %.5f\n",
                   layout.left / layout.width, (layout.left + layout.plot_width) / layout.width);
  script +=
      format("set bmargin at screen %.5f\nset tmargin at screen %.5f\n",
             layout.bottom / layout.height, (layout.bottom + layout.plot_height) / layout.height);
  script +=
      format("set colorbox user origin graph %.5f, screen %.5f size screen %.5f, screen %.5f\n",
             1.0 + 24.0 / layout.plot_width, layout.bar_bottom / layout.height, 34.0 / layout.width,
             layout.bar_height / layout.height);
  script += format("set xlabel 'x (%s)'\nset ylabel 'y (%s)'\nset size ratio -1\n", micrometre,
                   micrometre);
  const double width = raster.pixel[0] * raster.columns, height = raster.pixel[1] * raster.rows;
  const double left = raster.first[0] - 0.5 * raster.pixel[0];
  const double low = raster.first[1] - 0.5 * raster.pixel[1];
  script += format("set xrange [%.8g:%.8g]\nset yrange ", left, left + width) +
            y_range(low, low + height, origin) + "\n";
  script += format("set xtics %g\nset ytics %g\n",
                   round_step(width, std::max(layout.plot_width / 80.0, 2.0)),
                   round_step(height, std::max(layout.plot_height / 60.0, 2.0)));
  return script;
}

/// The plot command of a raster in NAME.raw.
std::string raster_plot(const Raster& raster, const std::string& name) {
  return format(
             "# %s.raw: %d x %d pixels, 32-bit floats of this machine's byte order, x fastest, "
             "from the\n# smallest y on; NaN where there is no particle.\nplot ",
             name.c_str(), raster.columns, raster.rows) +
         raster_clause(raster, name) + "\n";
}

/// Material colours: a pale first one for what surrounds, then ones that the colour-blind can tell.
const std::vector<std::string> material_colours = {"#f2e6d0", "#b2182b", "#2166ac", "#e69f00",
                                                   "#009e73", "#7b3294", "#56b4e9", "#4d4d4d"};

}  // namespace

Pictures::Pictures(const base::Communicator& communicator, std::string folder, std::string title,
                   std::array<double, 3> spacing, Origin origin)
    : communicator_(communicator),
      folder_(std::move(folder)),
      title_(std::move(title)),
      spacing_(spacing),
      origin_(origin) {}

std::string Pictures::draw_materials(const ParticleSet& particles,
                                     const std::vector<std::string>& materials) const {
  double z = 0.0;
  const auto layer = middle_layer(communicator_, particles, spacing_[2], &z);
  std::vector<SlicePoint> points;
  for (const std::int64_t p : layer) {
    points.push_back({{particles.position[3 * p], particles.position[3 * p + 1]},
                      static_cast<double>(particles.material[p])});
  }
  const Raster raster = rasterise(communicator_, points, extent_of(communicator_, particles, layer),
                                  {spacing_[0], spacing_[1]}, Merge::Majority);
  if (raster.columns == 0) return "vessels.png was not drawn: there are no particles";
  if (!communicator_.is_root()) return draw("vessels", "", "raw", "");

  const std::size_t count = materials.size();
  std::string script =
      raster_script(raster, layout_of(raster), "vessels",
                    title_ + format("\nmaterials at z = %.4g ", z) + micrometre, origin_);
  script += "set palette defined (";
  std::string names;
  for (std::size_t m = 0; m < count; ++m) {
    const std::string& colour = material_colours[m % material_colours.size()];
    script += format("%s%zu '%s', %zu '%s'", m == 0 ? "" : ", ", m, colour.c_str(), m + 1,
                     colour.c_str());
    names += format("%s%s %zu", m == 0 ? "" : ", ", gnuplot_quoted(materials[m]).c_str(), m);
  }
  script += format(")\nset palette maxcolors %zu\nset cbrange [-0.5:%zu-0.5]\n", count, count);
  script += "set cbtics scale 0 (" + names + ")\n";
  script += raster_plot(raster, "vessels");
  return draw("vessels", raster_bytes(raster), "raw", script);
}

std::string Pictures::draw_von_mises(const ParticleSet& particles, const StatePieces& states,
                                     double load) const {
  double z = 0.0;
  const auto layer = middle_layer(communicator_, particles, spacing_[2], &z);
  std::vector<SlicePoint> points;
  auto next = layer.begin();  // members of the layer come in ascending order
  states([&](std::int64_t first, std::int64_t count, const ParticleState& state) {
    for (; next != layer.end() && *next < first + count; ++next) {
      const std::int64_t p = *next;
      const double* s = state.stress + 6 * (p - first);
      const double* u = state.displacement + 3 * (p - first);
      const tensor::Tensor3 stress{{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
      points.push_back({{particles.position[3 * p] + u[0], particles.position[3 * p + 1] + u[1]},
                        tensor::von_mises(stress)});
    }
  });
  const Raster raster = rasterise(communicator_, points, extent_of(communicator_, particles, layer),
                                  {spacing_[0], spacing_[1]}, Merge::Mean);
  if (raster.columns == 0) return "von_mises.png was not drawn: there are no particles";
  if (!communicator_.is_root()) return draw("von_mises", "", "raw", "");

  const ColourScale scale = colour_scale(raster.value);
  std::string subtitle =
      format("\nvon Mises stress, load factor %.4g, layer z = %.4g ", load, z) + micrometre;
  if (scale.largest > scale.end) subtitle += format(", largest %.3g Pa", scale.largest);
  const PictureLayout layout = layout_of(raster);
  std::string script = raster_script(raster, layout, "von_mises", title_ + subtitle, origin_);
  script += viridis_palette();
  script += "set cblabel 'von Mises stress (Pa)' offset 1\n";
  script += format("set cbrange [0:%.4g]\nset cbtics %g\n", scale.end,
                   round_step(scale.end, layout.bar_height / 60.0));
  script += raster_plot(raster, "von_mises");
  return draw("von_mises", raster_bytes(raster), "raw", script);
}

std::string Pictures::draw_force(const std::vector<MovingSupport>& supports,
                                 const std::vector<HistoryRow>& history) const {
  if (supports.empty()) return "force.png was not drawn: no boundary condition moves";
  const bool by_strain =
      std::all_of(supports.begin(), supports.end(),
                  [](const MovingSupport& support) { return support.strain != 0.0; });
  const bool over_time = std::any_of(supports.begin(), supports.end(),
                                     [](const MovingSupport& s) { return !s.follows_load; });
  const auto size = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };

  std::string data = "# load";
  for (const MovingSupport& support : supports) {
    data += format("\t%s: %s\t%s: force [pN]", support.name.c_str(),
                   over_time   ? "time"
                   : by_strain ? "strain"
                               : "displacement [um]",
                   support.name.c_str());
  }
  data += "\n";
  double largest = 0.0;
  for (const HistoryRow& row : history) {
    data += format("%.10g", row.load);
    for (const MovingSupport& support : supports) {
      const auto& reaction = row.reactions.at(support.index);
      double force = 0.0;
      for (std::size_t d = 0; d < 3; ++d) {
        force += reaction[d] * support.displacement[d] / size(support.displacement);
      }
      largest = std::max(largest, std::abs(force));
      data +=
          format("\t%.10g\t%.10g",
                 over_time ? row.time
                           : row.load * (by_strain ? support.strain : size(support.displacement)),
                 force);
    }
    data += "\n";
  }

  const ForceUnit unit = force_unit(largest);
  std::string script =
      gnuplot_head("force", 1000, 700, title_ + "\nreaction along the displacement");
  script += format("set xlabel '%s'\nset ylabel 'force (%s)'\n",
                   over_time   ? "time (s)"
                   : by_strain ? "strain (%)"
                               : ("displacement (" + std::string(micrometre) + ")").c_str(),
                   unit.name);
  script += "set grid lc rgb '#dddddd' lt 1 lw 1\nset key top left reverse Left\n";
  script += "set offsets 0, 0, graph 0.05, 0\nplot ";
  for (std::size_t i = 0; i < supports.size(); ++i) {
    script += format(
        "%s'force.dat' using ($%zu*%g):($%zu/%g) with linespoints lw 2.5 pt 7 ps 1.1 lc rgb '%s' "
        "title %s",
        i == 0 ? "" : ", \\\n     ", 2 * i + 2, by_strain && !over_time ? 100.0 : 1.0, 2 * i + 3,
        unit.size, line_colour(i), gnuplot_quoted(supports[i].name).c_str());
  }
  return draw("force", data, "dat", script + "\n");
}

std::string Pictures::draw(const std::string& name, const std::string& data,
                           const std::string& data_ending, const std::string& script) const {
  return draw_picture(communicator_, folder_, name, data, data_ending, script);
}

}  // namespace stroma::output
