// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitPlan.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "commands/CheckCommand.hpp"
#include "run/MovingSupports.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/deck/Findings.hpp"
#include "stroma/deck/Nearest.hpp"
#include "study/MemberRun.hpp"
#include "study/StudyMembers.hpp"

namespace stroma {

std::vector<double> starts(const FitPlan& plan) {
  std::vector<double> values;
  for (const auto& [name, one] : plan.parameters.parameters.all) values.push_back(one.start);
  return values;
}

namespace {

using base::format;

void refuse_twins(const FitPlan& plan, deck::Findings& findings) {
  const auto& all = plan.parameters.parameters.all;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all[i].second.path == all[j].second.path)
        findings.add("Parameters|" + all[i].first + "|Path",
                     "\"" + all[j].first + "\" is the same parameter; admissible: each once");
}

/// The load factor at which a run has a force that was measured at a strain or time.
std::optional<double> load_at(const MeasurementParameters& p, const Deck& deck,
                              const mechanics::BoundaryCondition& condition, double abscissa) {
  const double full = p.against == Against::time ? deck.parameters.loading.seconds()
                                                 : strain_between_faces(deck.parameters, condition);
  const double load = abscissa / full, rounding = 1e-9;
  if (!(load >= -rounding && load <= 1.0 + rounding)) return std::nullopt;
  return std::min(1.0, std::max(0.0, load));
}

void read_points(FitPlan& plan, const Deck& start, deck::Findings& findings) {
  const auto& conditions = start.parameters.boundary_conditions.conditions;
  const auto& measurements = plan.parameters.measurements.all;
  for (std::size_t m = 0; m < measurements.size(); ++m) {
    const std::string& name = measurements[m].first;
    const MeasurementParameters& p = measurements[m].second;
    const std::string where = "Measurements|" + name + "|";
    const auto condition = std::find_if(conditions.begin(), conditions.end(),
                                        [&](const auto& one) { return one.first == p.condition; });
    if (condition == conditions.end()) {
      findings.add(where + "Condition", "\"" + p.condition +
                                            "\" is no boundary condition of the base deck; " +
                                            deck::suggestion(p.condition, names(conditions)));
      continue;
    }
    if (!condition->second.prescribes(p.component)) {
      findings.add(where + "Component", std::string("the support bears no force along ") +
                                            "xyz"[p.component] + "; admissible: its Components, " +
                                            condition->second.components);
      continue;
    }
    if (p.against == Against::strain &&
        (strain_between_faces(start.parameters, condition->second) == 0.0 ||
         !condition->second.curve.is_load())) {
      findings.add(where + "Against",
                   "\"" + p.condition +
                       "\" has no Strain that grows with the load, or the opposite face moves by "
                       "other values; admissible: Time");
      continue;
    }
    Reaction reaction{p.condition, static_cast<std::size_t>(condition - conditions.begin()),
                      p.component};
    const auto known =
        std::find_if(plan.reactions.begin(), plan.reactions.end(),
                     [&](const Reaction& r) { return r.column() == reaction.column(); });
    const auto index = static_cast<std::size_t>(known - plan.reactions.begin());
    if (known == plan.reactions.end()) plan.reactions.push_back(reaction);
    const std::string path = plan.document.resolve(p.file);
    plan.files.push_back(path);
    try {
      for (const MeasuredForce& one : read_measurement(path, p)) {
        const auto load = load_at(p, start, condition->second, one.abscissa);
        if (load)
          plan.points.push_back({m, index, *load, one});
        else
          findings.add(where + "File",
                       format("the run does not come to %s %g",
                              p.against == Against::time ? "time" : "strain", one.abscissa));
      }
    } catch (const base::InputError& error) {
      findings.add(where + "File", error.what());
    }
  }
  const std::size_t wanted = plan.parameters.parameters.all.size();
  if (findings.empty() && plan.points.size() < wanted)
    findings.add("Measurements", format("%zu forces for %zu numbers; admissible: as many at least",
                                        plan.points.size(), wanted));
}

void choose_gradient(FitPlan& plan, const Deck& start, deck::Findings& findings) {
  if (plan.parameters.gradient == Gradient::differences) {
    plan.no_adjoint_because = "the deck asks for differences";
    return;
  }
  for (const auto& [name, one] : plan.parameters.parameters.all)
    if (plan.no_adjoint_because.empty())
      plan.no_adjoint_because = adjoint_obstacle(start, one.path);
  if (plan.parameters.gradient == Gradient::adjoint && !plan.has_adjoint())
    findings.add("Gradient",
                 "no adjoint: " + plan.no_adjoint_because + "; admissible: Differences, Automatic");
}

/// What the base deck says of each number at its start and bounds, in terms of the fit.
void check_values(const FitPlan& plan, deck::Findings& findings) {
  const auto& all = plan.parameters.parameters.all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const FittedParameters& one = all[i].second;
    for (const auto& [word, value] :
         {std::pair<const char*, std::optional<double>>{"Start", one.start},
          {"Lower", one.lower},
          {"Upper", one.upper}}) {
      if (!value) continue;
      try {
        std::vector<double> values = starts(plan);
        values[i] = *value;
        deck_with(plan, values);
      } catch (const base::InputError& error) {
        findings.add("Parameters|" + all[i].first + "|" + word,
                     "the base deck does not take it: " + in_terms_of("the fit", error.what()));
        break;
      }
    }
  }
}

}  // namespace

std::string name_of(const FitPlan& plan, const std::vector<double>& values) {
  std::string name;
  for (std::size_t i = 0; i < values.size(); ++i)
    name += (i == 0 ? "" : ", ") + plan.parameters.parameters.all[i].first +
            format(" %.10g", values[i]);
  return name;
}

std::string folder_of(const FitPlan& plan, const std::vector<double>& values) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < values.size(); ++i)
    labels.push_back(plan.parameters.parameters.all[i].first + format(" %.10g", values[i]));
  return folder_name(labels);
}

Deck deck_with(const FitPlan& plan, const std::vector<double>& values) {
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < values.size(); ++i)
    overrides.push_back(plan.parameters.parameters.all[i].second.path +
                        format("=%.10g", values[i]));
  overrides.push_back("Title=" + plan.base_title + (plan.base_title.empty() ? "" : ": ") +
                      name_of(plan, values));
  return read_deck(plan.base_deck, overrides);
}

FitPlan plan_fit(const base::Communicator& communicator, const std::string& fit_deck) {
  std::optional<FitPlan> plan;
  std::optional<Deck> start;
  base::collectively(communicator, [&] {
    deck::Document document = deck::load(fit_deck);
    FitParameters parameters = deck::read(document, fit_section());
    plan.emplace(FitPlan{std::move(document), std::move(parameters), "", "", "", {}, {}, {}, ""});
    plan->base_deck = plan->document.resolve(plan->parameters.base_deck);
    deck::Findings findings(plan->document);
    if (!std::filesystem::exists(plan->base_deck))
      findings.add("Base Deck", "there is no file '" + plan->base_deck + "'");
    refuse_twins(*plan, findings);
    findings.throw_if_any();
    const deck::Document base = deck::load(plan->base_deck);
    const deck::tree::Parameter* title = base.root().parameter("Title");
    plan->base_title = title != nullptr ? title->text : "";
    plan->title = plan->parameters.title.empty() ? plan->base_title : plan->parameters.title;
    check_values(*plan, findings);
    findings.throw_if_any();
    start = deck_with(*plan, starts(*plan));
    if (asks_for_stiffness(start->parameters)) {
      findings.add("Base Deck", "Rig|Kind = Stiffness has no measured forces to fit");
      findings.throw_if_any();
    }
    plan->files = input_files(*start);
    plan->files.push_back(fit_deck);
    read_points(*plan, *start, findings);
    choose_gradient(*plan, *start, findings);
    findings.throw_if_any();
  });
  try {
    base::Log silent(communicator, true);
    check_command(communicator, *start, silent);
  } catch (const base::InputError& error) {
    throw base::InputError("the base deck of " + fit_deck + " cannot be run as it is\n" +
                           in_terms_of("the fit", located(*start, error).what()));
  }
  return std::move(*plan);
}

}  // namespace stroma
