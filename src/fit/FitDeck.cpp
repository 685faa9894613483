// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitDeck.hpp"

#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

void check_start(const FittedParameters& p, deck::Findings& findings) {
  if (p.lower && p.upper && !(*p.lower < *p.upper))
    findings.add("Upper", base::format("%g; admissible: above Lower, %g", *p.upper, *p.lower));
  else if ((p.lower && p.start < *p.lower) || (p.upper && p.start > *p.upper))
    findings.add("Start", base::format("%g; admissible: from Lower to Upper", p.start));
  if (p.logarithmic && !(p.start > 0.0 && p.lower.value_or(1.0) > 0.0))
    findings.add("Logarithmic", "Start and Lower have no logarithm; admissible: both > 0");
}

void check_errors(const MeasurementParameters& p, deck::Findings& findings) {
  if (!p.error_column && !p.error && !p.relative_error)
    findings.add("Error",
                 "how sure is the measurement? admissible: Error Column, Error, Relative "
                 "Error, or several of them, which add up as squares");
}

deck::Section<FittedParameters> fitted_section() {
  deck::Section<FittedParameters> section(
      "NAME", "A number that is looked for; NAME is the user's, and stands in the results.");
  section.required("Path", &FittedParameters::path, deck::not_empty(),
                   "The parameter of the base deck, such as Materials|vessel|Shear Modulus [Pa].");
  section.required("Start", &FittedParameters::start, deck::any(), "Where the search begins.");
  section.optional("Lower", &FittedParameters::lower, deck::any(), "It is no less than this.");
  section.optional("Upper", &FittedParameters::upper, deck::any(), "It is no more than this.");
  section.optional("Logarithmic", &FittedParameters::logarithmic, deck::any(),
                   "Its logarithm is looked for: for positive numbers of unknown magnitude.");
  section.check(check_start);
  return section;
}

deck::Section<MeasurementParameters> measurement_section() {
  deck::Section<MeasurementParameters> section(
      "NAME", "A table of forces; NAME is the user's, and stands in the results.");
  section.required("File", &MeasurementParameters::file, deck::not_empty(),
                   "A CSV file: a line of names, then rows of numbers. Relative to this file.");
  section.choice("Against", &MeasurementParameters::against,
                 {{"Strain", Against::strain}, {"Time", Against::time}},
                 "What the force was measured at. Strain: that of the condition, as a fraction. "
                 "Time: in seconds; the load factor, where the deck gives no duration.");
  section.required("Abscissa Column", &MeasurementParameters::abscissa_column, deck::not_empty(),
                   "The column of strain or time.");
  section.required("Force Column", &MeasurementParameters::force_column, deck::not_empty(),
                   "The column of the force of the support on the body.");
  section.optional("Force Unit [pN]", &MeasurementParameters::force_unit, deck::any(),
                   "What 1 in the columns of force and error is; 1e6 for micronewton. Negative, "
                   "where the table has the other sign.");
  section.required("Condition", &MeasurementParameters::condition, deck::not_empty(),
                   "The boundary condition of the base deck whose support was measured.");
  section.required_choice("Component", &MeasurementParameters::component,
                          {{"x", 0}, {"y", 1}, {"z", 2}}, "Of the force.");
  section.optional("Error Column", &MeasurementParameters::error_column, deck::any(),
                   "The column of the force's standard deviation.");
  section.optional("Error", &MeasurementParameters::error, deck::positive(),
                   "Standard deviation of all forces, in the unit of the column.");
  section.optional("Relative Error", &MeasurementParameters::relative_error, deck::positive(),
                   "Standard deviation of each force, as a fraction of it.");
  section.check(check_errors);
  return section;
}

}  // namespace

deck::Section<FitParameters> fit_section() {
  deck::Section<FittedList> parameters("Parameters",
                                       "The numbers that are looked for, one sublist each.");
  parameters.named_sections(fitted_section(), &FittedList::all);
  deck::Section<MeasurementList> measurements("Measurements",
                                              "What was measured, one sublist for each table.");
  measurements.named_sections(measurement_section(), &MeasurementList::all);

  deck::Section<FitParameters> section(
      "Fit", "Numbers of a deck for which its forces are those that were measured.");
  section.optional("Title", &FitParameters::title, deck::any(),
                   "One line about the fit; it stands on its picture. Else the base deck's.");
  section.required("Base Deck", &FitParameters::base_deck, deck::not_empty(),
                   "The deck of the experiment; relative to this file.");
  section.required_section(parameters, &FitParameters::parameters);
  section.required_section(measurements, &FitParameters::measurements);
  section.choice("Gradient", &FitParameters::gradient,
                 {{"Automatic", Gradient::automatic},
                  {"Adjoint", Gradient::adjoint},
                  {"Differences", Gradient::differences}},
                 "How the forces' derivatives are had. Adjoint: with each run, by one more linear "
                 "solve for each load step and measured force; for numbers of laws that remember "
                 "nothing. Differences: by one more run for each number. Automatic: Adjoint where "
                 "it can be.");
  section.optional("Tolerance", &FitParameters::tolerance, deck::strictly_between(0.0, 0.1),
                   "The search ends when the numbers change by less than this share of them, or by "
                   "less than some 1e-4 of their standard deviations.");
  section.optional("Most Steps", &FitParameters::most_steps, deck::at_least(1),
                   "It ends after so many steps in any case.");
  return section;
}

}  // namespace stroma
