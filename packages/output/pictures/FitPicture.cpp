// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/FitPicture.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stroma/base/Log.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"
#include "stroma/output/pictures/PictureFile.hpp"

namespace stroma::output {
namespace {

using base::format;

/// A block of the data file, by ascending abscissa.
std::string block(const FittedCurve& curve) {
  std::vector<std::size_t> order(curve.abscissa.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return curve.abscissa[a] < curve.abscissa[b];
  });
  std::string text = "# " + curve.name + "\n";
  for (const std::size_t i : order)
    text += format("%.10g\t%.10g\t%.10g\t%.10g\n", curve.abscissa[i], curve.measured[i],
                   curve.error[i], curve.fitted[i]);
  return text + "\n\n";
}

/// The plot of the tables whose abscissa is of one kind; empty if there are none.
std::string panel(const std::vector<FittedCurve>& curves, bool by_strain, const ForceUnit& unit) {
  std::string plot;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].by_strain != by_strain) continue;
    const double scale = by_strain ? 100.0 : 1.0;
    plot += format(
        "%s'fit.dat' index %zu using ($1*%g):($2/%g):($3/%g) with yerrorbars pt 7 ps 1 lw 1.5 lc "
        "rgb '%s' title %s, \\\n     '' index %zu using ($1*%g):($4/%g) with lines lw 2 lc rgb "
        "'%s' title %s",
        plot.empty() ? "plot " : ", \\\n     ", i, scale, unit.size, unit.size, line_colour(i),
        gnuplot_quoted(curves[i].name + ": measured").c_str(), i, scale, unit.size, line_colour(i),
        gnuplot_quoted(curves[i].name + ": fitted").c_str());
  }
  if (plot.empty()) return "";
  return format("set xlabel '%s'\n", by_strain ? "strain (%)" : "time (s)") + plot + "\n";
}

}  // namespace

std::string draw_fit(const base::Communicator& communicator, const std::string& folder,
                     const std::string& title, const std::vector<FittedCurve>& curves) {
  std::string data = "# strain [-] or time [s]\tmeasured\terror\tfitted force [pN]\n";
  double largest = 0.0;
  for (const FittedCurve& curve : curves) {
    data += block(curve);
    for (const double force : curve.measured) largest = std::max(largest, std::abs(force));
  }
  const ForceUnit unit = force_unit(largest);
  const std::string strains = panel(curves, true, unit), times = panel(curves, false, unit);
  const int panels = strains.empty() || times.empty() ? 1 : 2;
  std::string script = gnuplot_head("fit", 1000, 100 + 650 * panels,
                                    title + "\nmeasured force with standard deviation, and fitted");
  script += format("set ylabel 'force (%s)'\n", unit.name);
  script += "set key top left Left reverse\nset grid lc rgb '#dddddd' lt 1 lw 1\n";
  script += "set offsets graph 0.02, graph 0.02, graph 0.05, 0\n";
  if (panels == 2) script += "set multiplot layout 2, 1\n";
  script += strains;
  if (panels == 2) script += "unset title\n";
  script += times;
  return draw_picture(communicator, folder, "fit", data, "dat", script);
}

}  // namespace stroma::output
