// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/StudyPictures.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Log.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"
#include "stroma/output/pictures/PictureFile.hpp"

namespace stroma::output {
namespace {

using base::format;

/// Height that the plot itself and a legend of so many lines below it need.
int height_with_key(std::size_t lines) { return 724 + 24 * static_cast<int>(lines); }

const char* const grid_lines = "set grid lc rgb '#dddddd' lt 1 lw 1\n";
const char* const key_below = "set key below left Left reverse maxcols 1 width 2 title ' '\n";

double largest_of(double largest, const std::vector<double>& values) {
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// A block of a gnuplot data file; blocks are told apart by two empty lines.
std::string block(const std::string& name, const std::vector<double>& x,
                  const std::vector<double>& y) {
  std::string text = "# " + name + "\n";
  for (std::size_t i = 0; i < x.size(); ++i) text += format("%.10g\t%.10g\n", x[i], y[i]);
  return text + "\n\n";
}

/// Colours repeat after six lines, shapes of points after seven.
int point_type(std::size_t n) {
  static const int types[] = {7, 5, 9, 11, 13, 6, 4};
  return types[n % 7];
}

}  // namespace

std::string draw_force_strain(const base::Communicator& communicator, const std::string& folder,
                              const std::string& title, const std::string& support,
                              const std::vector<CurveThing>& things,
                              const std::vector<ForceCurve>& curves, bool by_strain,
                              const std::string& remark) {
  const char* const name = "force_strain";
  std::string data = by_strain ? "# strain [-]\tforce [pN]\n" : "# displacement [um]\tforce [pN]\n";
  double largest = 0.0;
  std::vector<CurveName> names;
  for (const ForceCurve& curve : curves) {
    data += block(curve.name.name, curve.stretch, curve.force);
    largest = largest_of(largest, curve.force);
    names.push_back(curve.name);
  }
  const ForceUnit unit = force_unit(largest);
  const CurveStyles styles = curve_styles(things, names);
  std::string script =
      gnuplot_head(name, styles.width, height_with_key(static_cast<std::size_t>(styles.key_lines)),
                   title + "\nforce of \"" + support + "\" along its displacement" + remark);
  script += format("set xlabel '%s'\nset ylabel 'force (%s)'\n",
                   by_strain ? "strain (%)" : "displacement (µm)", unit.name);
  script += styles.key + grid_lines;
  script += "set offsets 0, 0, graph 0.05, 0\nplot ";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    script += format("%s'%s.dat' index %zu using ($1*%g):($2/%g) with linespoints %s %s",
                     i == 0 ? "" : ", \\\n     ", name, i, by_strain ? 100.0 : 1.0, unit.size,
                     styles.style[i].c_str(), styles.title[i].c_str());
  }
  return draw_picture(communicator, folder, name, data, "dat", script + styles.legend + "\n");
}

std::string draw_force_element_size(const base::Communicator& communicator,
                                    const std::string& folder, const std::string& title,
                                    const std::string& support,
                                    const std::vector<SizeSeries>& series) {
  const char* const name = "force_element_size";
  std::string data = "# element size [um]\tforce [pN]; an extrapolated value stands at size 0\n";
  double largest = 0.0, widest = 0.0;
  std::size_t key_lines = 0;
  for (const SizeSeries& one : series) {
    data += block(one.name, one.size, one.force);
    data += block(one.name + (one.fit ? ", extrapolated" : ", not extrapolated"), {0.0},
                  {one.fit ? one.fit->value : std::nan("")});
    largest = largest_of(largest, one.force);
    widest = largest_of(widest, one.size);
    key_lines += 1;
  }
  const ForceUnit unit = force_unit(largest);
  std::string script = gnuplot_head(
      name, 1000, height_with_key(key_lines),
      title + "\nforce of \"" + support + "\" at full load; dashed: f + c h^p to size 0");
  script += format("set xlabel 'element size h (µm)'\nset ylabel 'force (%s)'\n", unit.name);
  script += std::string(key_below) + grid_lines;
  script +=
      format("set xrange [0:%.8g]\nset offsets 0, 0, graph 0.05, graph 0.05\nset samples 200\n",
             1.08 * widest);
  script += "plot ";
  for (std::size_t i = 0; i < series.size(); ++i) {
    const SizeSeries& one = series[i];
    const char* const colour = line_colour(i);
    std::string label = one.name + (one.name.empty() ? "" : ": ");
    label += one.fit ? format("%.6g %s at h = 0, order %.2f", one.fit->value / unit.size, unit.name,
                              one.fit->order)
                     : "no extrapolation";  // why: convergence.csv
    script += format(
        "%s'%s.dat' index %zu using 1:($2/%g) with %s lw 2 pt %d ps 1.3 lc rgb '%s' "
        "title %s",
        i == 0 ? "" : ", \\\n     ", name, 2 * i, unit.size, one.fit ? "points" : "linespoints",
        point_type(i), colour, gnuplot_quoted(label).c_str());
    if (!one.fit) continue;
    script +=
        format(", \\\n     (%.12g + %.12g*x**%.12g)/%g with lines lw 1.5 dt 2 lc rgb '%s' notitle",
               one.fit->value, one.fit->coefficient, one.fit->order, unit.size, colour);
    script += format(
        ", \\\n     '%s.dat' index %zu using 1:($2/%g) with points pt 6 ps 1.8 lw 2 lc rgb "
        "'%s' notitle",
        name, 2 * i + 1, unit.size, colour);
  }
  return draw_picture(communicator, folder, name, data, "dat", script + "\n");
}

std::string draw_force_band(const base::Communicator& communicator, const std::string& folder,
                            const std::string& title, const std::string& support,
                            const ForceBand& band) {
  std::string data = "# " + band.abscissa + "\t5 %\tmedian\t95 %\tmiddle\tfiner [pN]\n";
  const auto at = [](const std::vector<double>& values, std::size_t s) {
    return s < values.size() ? values[s] : std::nan("");
  };
  for (std::size_t s = 0; s < band.stretch.size(); ++s)
    data += format("%.10g\t%.10g\t%.10g\t%.10g\t%.10g\t%.10g\n", band.stretch[s], band.low[s],
                   band.median[s], band.high[s], at(band.middle, s), at(band.finer, s));
  const ForceUnit unit = force_unit(largest_of(0.0, band.high));
  std::string script = gnuplot_head(
      "force_band", 1000, height_with_key(4),
      title + "\nforce of \"" + support + "\": 5 to 95 % of the draws, and their median");
  script += format("set xlabel '%s'\nset ylabel 'force (%s)'\n", band.abscissa.c_str(), unit.name);
  script += std::string(key_below) + grid_lines + "set offsets 0, 0, graph 0.05, 0\n";
  const char* const file = "'force_band.dat'";
  script += format(
      "plot %s using 1:($2/%g):($4/%g) with filledcurves fc rgb '%s' fs transparent "
      "solid 0.3 noborder title '5 to 95 %%'",
      file, unit.size, unit.size, line_colour(0));
  script += format(", \\\n     %s using 1:($3/%g) with lines lw 2 lc rgb '%s' title 'median'", file,
                   unit.size, line_colour(0));
  if (!band.middle.empty())
    script += format(
        ", \\\n     %s using 1:($5/%g) with lines lw 2 dt 2 lc rgb '%s' title "
        "'all inputs at their medians'",
        file, unit.size, line_colour(1));
  if (!band.finer.empty())
    script += format(
        ", \\\n     %s using 1:($6/%g) with lines lw 2 dt 3 lc rgb '%s' title "
        "'the same on finer elements'",
        file, unit.size, line_colour(2));
  return draw_picture(communicator, folder, "force_band", data, "dat", script + "\n");
}

}  // namespace stroma::output
