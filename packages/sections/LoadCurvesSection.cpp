// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/LoadCurvesSection.hpp"

#include "stroma/base/Log.hpp"
#include "stroma/sections/Ascending.hpp"

namespace stroma::sections {

using namespace mechanics;

deck::Section<LoadCurvesParameters> load_curves_section() {
  deck::Section<LoadCurveParameters> curve(
      "NAME", "One curve: the factor of what names it as its Load Curve; NAME is the user's.");
  curve.required("Times [s]", &LoadCurveParameters::times, deck::not_empty(),
                 "Times of its points, ascending; load factors, where Loading gives no duration.");
  curve.required("Values", &LoadCurveParameters::values, deck::any(),
                 "The factor at each of them.");
  curve.choice("Interpolation", &LoadCurveParameters::interpolation,
               {{"Linear", Interpolation::linear},
                {"Smooth", Interpolation::smooth},
                {"Step", Interpolation::step}},
               "Between two points. Linear: straight. Smooth: with no slope at the points. Step: "
               "the value of the point before.");
  curve.choice("Beyond", &LoadCurveParameters::beyond,
               {{"Hold", Beyond::hold}, {"Repeat", Beyond::repeat}},
               "Beyond the last point. Hold: its value. Repeat: the curve from its first point on, "
               "again and again. Before the first point: its value.");
  curve.check([](const LoadCurveParameters& p, deck::Findings& findings) {
    if (p.values.size() != p.times.size())
      findings.add("Values", base::format("%zu numbers for %zu Times [s]; admissible: one each",
                                          p.values.size(), p.times.size()));
    refuse_descending("Times [s]", p.times, findings);
    if (p.beyond == Beyond::repeat && p.times.size() < 2)
      findings.add("Beyond", "one point cannot repeat; admissible: two points or more");
  });

  deck::Section<LoadCurvesParameters> section(
      "Load Curves",
      "How conditions and forces follow time, one sublist each, named by the user; without a Load "
      "Curve they grow in proportion to the load, to their full values at the end. The body begins "
      "undeformed: faces that a curve moves from its start on get there with the first step.");
  section.named_sections(curve, &LoadCurvesParameters::curves, 0);
  return section;
}

}  // namespace stroma::sections
