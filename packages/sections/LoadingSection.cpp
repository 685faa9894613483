// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/LoadingSection.hpp"

#include <cmath>

#include "stroma/base/Log.hpp"
#include "stroma/sections/Ascending.hpp"

namespace stroma::sections {

using namespace solver;

namespace {

/// Refuses a parameter that something else than what is chosen would read.
void refuse_unread(const char* name, bool is_given, const char* read_with,
                   deck::Findings& findings) {
  if (is_given) findings.add(name, std::string("is used with ") + read_with + " only");
}

void declare_inertia(deck::Section<LoadingParameters>& section) {
  section.optional(
      "Inertia", &LoadingParameters::inertia, deck::any(),
      "Whether the body has inertia, and moves through time (implicit dynamics); every "
      "material needs a Density [kg/m^3], and Loading a Duration [s].");
  section.choice(
      "Scheme", &LoadingParameters::scheme,
      {{"Newmark", TimeIntegration::newmark},
       {"Generalised Alpha", TimeIntegration::generalised_alpha}},
      "Of a step through time, with Inertia. Newmark: momentum is in balance at its end. "
      "Generalised Alpha (Chung and Hulbert): within it, with dissipation of high "
      "frequencies by choice.");
  section.optional("Spectral Radius", &LoadingParameters::spectral_radius, deck::between(0.0, 1.0),
                   "What a step of Generalised Alpha leaves of the highest frequencies: 1 all (the "
                   "midpoint rule), 0 nothing. Without it: 0.9.");
  section.optional(
      "Beta", &LoadingParameters::beta, deck::positive(),
      "Newmark's share of the new acceleration in the displacement. Without it: 0.25.");
  section.optional(
      "Gamma", &LoadingParameters::gamma, deck::positive(),
      "Newmark's share of the new acceleration in the velocity; more than 0.5 damps, at "
      "order 1. Without it: 0.5.");
  section.choice(
      "Mass", &LoadingParameters::mass,
      {{"Lumped", MassMatrix::lumped}, {"Consistent", MassMatrix::consistent}},
      "Lumped: masses at the nodes of the grid. Consistent: of the particles, by which the "
      "midpoint rule keeps angular momentum.");
  section.optional("Mass Damping [1/s]", &LoadingParameters::mass_damping, deck::not_negative(),
                   "Rayleigh's: a force of this * mass * velocity against the motion.");
  section.optional("Stiffness Damping [s]", &LoadingParameters::stiffness_damping,
                   deck::not_negative(),
                   "Rayleigh's: a force of this * the tangent of stress * velocity.");
  section.optional(
      "Step Error [um]", &LoadingParameters::step_error, deck::positive(),
      "Error in time of a step, the mass-weighted root of mean squares of dt^2 (beta - "
      "1/6) times the change of acceleration, above which it is halved; steps grow back "
      "where it is less than an eighth of this. Without it steps are what they are.");
  section.check([](const LoadingParameters& p, deck::Findings& findings) {
    const bool is_newmark = p.scheme == TimeIntegration::newmark;
    const char* with = p.inertia ? "Scheme = Generalised Alpha" : "Inertia = true";
    refuse_unread("Spectral Radius", p.spectral_radius && (!p.inertia || is_newmark), with,
                  findings);
    with = p.inertia ? "Scheme = Newmark" : "Inertia = true";
    refuse_unread("Beta", p.beta && (!p.inertia || !is_newmark), with, findings);
    refuse_unread("Gamma", p.gamma && (!p.inertia || !is_newmark), with, findings);
    with = "Inertia = true";
    refuse_unread("Scheme", !p.inertia && !is_newmark, with, findings);
    refuse_unread("Mass", !p.inertia && p.mass != MassMatrix::lumped, with, findings);
    refuse_unread("Mass Damping [1/s]", !p.inertia && p.mass_damping != 0.0, with, findings);
    refuse_unread("Stiffness Damping [s]", !p.inertia && p.stiffness_damping != 0.0, with,
                  findings);
    refuse_unread("Step Error [um]", !p.inertia && p.step_error, with, findings);
    const double beta = p.beta.value_or(0.25), gamma = p.gamma.value_or(0.5);
    if (gamma < 0.5)
      findings.add("Gamma",
                   base::format("%g lets vibrations grow; admissible: 0.5 or more", gamma));
    else if (2.0 * beta < gamma)
      findings.add("Beta", base::format("%g is not stable with Gamma = %g at steps of any length; "
                                        "admissible: %g or more",
                                        beta, gamma, 0.5 * gamma));
    if (p.inertia && !p.has_time())
      findings.add("Duration [s]", "missing; Inertia asks for times in seconds");
  });
}

}  // namespace

deck::Section<LoadingParameters> loading_section() {
  deck::Section<LoadingParameters> section("Loading", "How the load grows from nothing to full.");
  section.optional("Duration [s]", &LoadingParameters::duration, deck::positive(),
                   "Time at full load. Without it, and without Times [s], time is the load factor: "
                   "1 at full load.");
  section.optional(
      "Steps", &LoadingParameters::steps, deck::at_least(1),
      "Equal load steps; without it 10, or Times [s]. A step that fails is halved and grows back "
      "afterwards; multiples of 1 / Steps are always met.");
  section.optional("Times [s]", &LoadingParameters::times, deck::positive(),
                   "Ends of the steps, ascending, in the place of Steps; the last is the Duration "
                   "[s]. All are met, whatever steps are halved.");
  section.optional(
      "Smallest Step", &LoadingParameters::smallest_step, deck::strictly_between(0.0, 1.0),
      "Fraction of the full load below which steps are not halved; the run ends there.");
  declare_inertia(section);
  section.check([](const LoadingParameters& p, deck::Findings& findings) {
    if (p.times && p.steps)
      findings.add("Times [s]", "given beside \"Steps\"; give one of the two");
    if (p.times && p.times->empty())
      findings.add("Times [s]", "an empty list; admissible: at least one time");
    if (!p.times && p.smallest_step > 1.0 / p.equal_steps())
      findings.add("Smallest Step", "is larger than a step, 1 / Steps");
    if (!p.times || p.times->empty()) return;
    const std::vector<double>& times = *p.times;
    refuse_descending("Times [s]", times, findings);
    if (p.duration && std::abs(*p.duration - times.back()) > 1e-9 * times.back())
      findings.add("Times [s]", base::format("end at %g s; admissible: at Duration [s], %g s",
                                             times.back(), *p.duration));
    double before = 0.0;
    for (const double time : times) {
      if (time > before && (time - before) / p.seconds() < p.smallest_step)
        findings.add("Smallest Step",
                     base::format("is larger than the step from %g to %g s", before, time));
      before = time;
    }
  });
  return section;
}

}  // namespace stroma::sections
