// SPDX-License-Identifier: BSD-3-Clause

#include "fit/Sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "run/Specimen.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma {
namespace {

using base::format;

mechanics::LawList laws_with(const Deck& deck, const std::string& path, double value) {
  std::vector<std::string> overrides{path + format("=%.17g", value)};
  for (const std::string& one : deck.overrides)
    if (one.rfind(path + "=", 0) != 0) overrides.push_back(one);
  material::MaterialLaws made =
      material::laws_of(read_deck(deck.document.path(), overrides).parameters.materials.materials);
  return {std::move(made.laws), std::move(made.directions)};
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::string adjoint_obstacle(const Deck& deck, const std::string& path) {
  const DeckParameters& p = deck.parameters;
  const material::NamedMaterials& materials = p.materials.materials;
  if (path.rfind("Materials|", 0) != 0 || ends_with(path, "|Label") ||
      path.find("|Density [") != std::string::npos)
    return path + " is no number of a law";
  if (p.grid.reset) return "with Grid|Reset, a step rests on those before it";
  if (p.loading.inertia) return "with Loading|Inertia, a step rests on those before it";
  for (const auto& [name, m] : materials) {
    const std::string of = "Materials|" + name + "|";
    if (m.viscosity) return of + "Viscosity remembers";
    if (m.active_stress) return of + "Active Stress is no law";
    if (material::is_pressure(m)) return of + "Pressure is no law";
    if (m.growth) return of + "Growth is no law";
  }
  if (material::vary(materials)) return "numbers of the laws vary from particle to particle";
  for (const auto& [name, condition] : p.boundary_conditions.conditions)
    if (condition.imposed_by.value_or(mechanics::ImposedBy::nodes) == mechanics::ImposedBy::penalty)
      return "Boundary Conditions|" + name + " is imposed by springs";
  return "";
}

Sensitivity::Sensitivity(const base::Communicator& communicator, const Deck& deck,
                         const std::vector<std::string>& paths, const std::vector<double>& values,
                         std::vector<Reaction> reactions, std::string path)
    : communicator_(communicator),
      reactions_(std::move(reactions)),
      path_(std::move(path)),
      header_("step,load") {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double h = values[i] == 0.0 ? 1e-5 : 1e-5 * std::abs(values[i]);
    pairs_.push_back({laws_with(deck, paths[i], values[i] + h),
                      laws_with(deck, paths[i], values[i] - h), 2.0 * h});
  }
  for (const Reaction& reaction : reactions_)
    for (const std::string& one : paths) header_ += "," + output::csv_field(column(reaction, one));
}

void Sensitivity::operator()(const AcceptedStep& step) {
  const base::Stage stage("sensitivity");
  mechanics::MomentumBalance& balance = step.balance;
  const auto& map = balance.owned_map();
  const auto kernels = [&](const mechanics::LawList& laws) {
    return mechanics::stress_kernels(laws, balance.problem().method.shape_functions,
                                     balance.halo().partition().grid().flat);
  };
  std::vector<grid::Vector> by_parameter;  // df/dp [pN per unit of p]
  grid::Vector below(map);
  for (const Pair& pair : pairs_) {
    grid::Vector& derivative = by_parameter.emplace_back(map);
    balance.internal_force(kernels(pair.above), step.u, derivative);
    balance.internal_force(kernels(pair.below), step.u, below);
    derivative.update(-1.0 / pair.distance, below, 1.0 / pair.distance);
  }

  std::string row = format("%lld,%.17g", static_cast<long long>(step.row.step), step.row.load);
  grid::Vector weight(map), rhs(map), adjoint(map);
  for (const Reaction& reaction : reactions_) {
    balance.supports().mark_reaction(reaction.index, reaction.component, weight);
    balance.tangent_times(step.u, weight, rhs);
    rhs.scale(-1.0);
    try {
      step.newton.solve_tangent(step.u, rhs, adjoint, 1e-10);
    } catch (const base::StepRejected& failure) {
      throw base::RunError(format("step %lld: the force's derivatives cannot be had: %s",
                                  static_cast<long long>(step.row.step), failure.what()));
    }
    adjoint.update(1.0, weight, 1.0);
    for (const grid::Vector& derivative : by_parameter)
      row += format(",%.17g", adjoint.dot(derivative));
  }
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    output::write_file(path_, (is_begun_ ? "" : header_ + "\n") + row + "\n",
                       is_begun_ ? output::WriteMode::append : output::WriteMode::replace);
  });
  is_begun_ = true;
}

}  // namespace stroma
