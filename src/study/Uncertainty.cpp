// SPDX-License-Identifier: BSD-3-Clause

#include "study/Uncertainty.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/pictures/StudyPictures.hpp"
#include "study/Bands.hpp"
#include "study/StressBands.hpp"
#include "study/StudySummary.hpp"

namespace stroma {
namespace {

using base::format;
using output::csv_field;
using output::csv_number;

constexpr std::size_t fewest_draws = 5;

Choice choice_of(const std::string& name, const InputList& inputs,
                 const std::vector<double>& values) {
  Choice choice{name, name, {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    choice.settings.push_back({inputs.all[i].second.path, format("%.10g", values[i])});
  return choice;
}

/// Where the members of a study with draws are, and what their forces are. For one rank.
struct Draws {
  std::vector<std::size_t> done;     ///< members that are draws and reached full load
  std::vector<ForceRecord> records;  ///< of these, where a support moves
  std::optional<ForceRecord> middle, finer;
  std::vector<std::string> names;                   ///< of inputs
  std::vector<std::vector<double>> inputs;          ///< (input) (draw that is done)
  std::vector<std::optional<double>> correlations;  ///< of ranks, of an input and the force
};

Draws draws_in(const StudyPlan& plan, const std::vector<MemberResult>& results) {
  const UncertaintyParameters& uncertainty = *plan.study.parameters.uncertainty;
  const auto records = force_records(plan, results);
  const std::size_t first = uncertainty.finer ? 2 : 1;
  Draws draws;
  draws.middle = records[0];
  if (uncertainty.finer) draws.finer = records[1];
  for (const auto& named : uncertainty.inputs.all) draws.names.push_back(named.first);
  draws.inputs.resize(draws.names.size());
  for (std::size_t m = first; m < records.size(); ++m) {
    if (results[m].status != MemberStatus::done) continue;
    draws.done.push_back(m);
    if (records[m]) draws.records.push_back(*records[m]);
    const Choice& choice = plan.study.variations.front().choices[m];
    for (std::size_t i = 0; i < draws.inputs.size(); ++i)
      draws.inputs[i].push_back(std::stod(choice.settings[i].value));
  }
  if (draws.records.empty()) return draws;
  std::vector<double> at_end;
  for (const ForceRecord& record : draws.records) at_end.push_back(record.force.back());
  for (const std::vector<double>& input : draws.inputs)
    draws.correlations.push_back(rank_correlation(input, at_end));
  return draws;
}

std::string draws_table(const StudyPlan& plan, const Draws& draws) {
  std::string table = "member";
  for (const std::string& name : draws.names) table += "," + csv_field(name);
  table += ",force\n";
  for (std::size_t n = 0; n < draws.done.size(); ++n) {
    table += plan.members[draws.done[n]].folder;
    for (const std::vector<double>& input : draws.inputs) table += "," + csv_number(input[n]);
    table += "," + csv_number(draws.records[n].force.back()) + "\n";
  }
  return table;
}

std::string bands_table(const Draws& draws, const std::vector<double>& loads,
                        const std::vector<Band>& bands) {
  std::string table = "load,low,median,high,middle,finer\n";
  const auto at = [](const std::optional<ForceRecord>& record, double load) {
    return record ? csv_number(force_at(*record, load)) : "";
  };
  for (std::size_t s = 0; s < loads.size(); ++s)
    table += csv_number(loads[s]) + "," + csv_number(bands[s].low) + "," +
             csv_number(bands[s].median) + "," + csv_number(bands[s].high) + "," +
             at(draws.middle, loads[s]) + "," + at(draws.finer, loads[s]) + "\n";
  return table;
}

std::vector<std::string> summary(const Draws& draws, const Band& end) {
  std::vector<std::string> lines{
      format("force of %zu draws at full load: median %.6g pN, 5 to 95 %%: %.6g to %.6g pN",
             draws.done.size(), end.median, end.low, end.high)};
  if (end.low * end.high > 0.0)
    lines.front() += format(" (%+.2f to %+.2f %%)", 100.0 * (end.low / end.median - 1.0),
                            100.0 * (end.high / end.median - 1.0));
  for (std::size_t i = 0; i < draws.names.size(); ++i) {
    const std::optional<double>& correlation = draws.correlations[i];
    lines.push_back(format("  rank correlation with %s: %s", draws.names[i].c_str(),
                           correlation ? format("%.3f", *correlation).c_str() : "undefined"));
  }
  if (draws.middle && draws.finer)
    lines.push_back(format("discretisation: the force of the middle is %+.2f %% on finer elements",
                           100.0 * (draws.finer->force.back() / draws.middle->force.back() - 1.0)));
  return lines;
}

std::string correlations_table(const Draws& draws) {
  std::string table = "input,force\n";
  for (std::size_t i = 0; i < draws.names.size(); ++i) {
    const std::optional<double>& correlation = draws.correlations[i];
    table += csv_field(draws.names[i]) + "," + (correlation ? csv_number(*correlation) : "") + "\n";
  }
  return table;
}

/// Whether the drawn support has the same displacement in all members.
bool moves_alike(const StudyPlan& plan) {
  for (std::size_t m = 1; m < plan.members.size(); ++m)
    if (drawn_support(plan, m)->displacement != drawn_support(plan, 0)->displacement) return false;
  return true;
}

std::string draw_band(const base::Communicator& communicator, const StudyPlan& plan,
                      const Draws& draws, const std::vector<double>& loads,
                      const std::vector<Band>& bands, const std::string& folder) {
  const output::MovingSupport& support = *drawn_support(plan, 0);
  output::ForceBand band;
  double scale = moved_along(support);
  band.abscissa = "displacement (µm)";
  if (support.strain != 0.0) {
    scale = 100.0 * support.strain;
    band.abscissa = "strain (%)";
  }
  if (!support.follows_load || !moves_alike(plan)) {
    scale = 1.0;
    band.abscissa = "load factor";
  }
  for (std::size_t s = 0; s < loads.size(); ++s) {
    band.stretch.push_back(loads[s] * scale);
    band.low.push_back(bands[s].low);
    band.median.push_back(bands[s].median);
    band.high.push_back(bands[s].high);
    if (draws.finer) band.finer.push_back(force_at(*draws.finer, loads[s]));
    if (draws.middle) band.middle.push_back(force_at(*draws.middle, loads[s]));
  }
  return output::draw_force_band(communicator, folder, plan.title, support.name, band);
}

void tell_forces(const base::Communicator& communicator, const StudyPlan& plan, const Draws& draws,
                 const std::string& folder, base::Log& log) {
  std::vector<double> loads;
  std::vector<Band> bands;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    loads = draws.records.front().load;
    bands = force_bands(draws.records, loads);
    output::write_file(folder + "/draws.csv", draws_table(plan, draws));
    output::write_file(folder + "/bands.csv", bands_table(draws, loads, bands));
    output::write_file(folder + "/correlations.csv", correlations_table(draws));
  });
  if (communicator.is_root())
    for (const std::string& line : summary(draws, bands.back())) log.line(line);
  const std::string failure = draw_band(communicator, plan, draws, loads, bands, folder);
  if (!failure.empty()) log.note(failure);
}

}  // namespace

Variation draws_of(const UncertaintyParameters& uncertainty) {
  Variation variation{"draw", {}};
  std::vector<double> medians;
  for (const auto& named : uncertainty.inputs.all) medians.push_back(quantile(named.second, 0.5));
  variation.choices.push_back(choice_of("middle", uncertainty.inputs, medians));
  if (uncertainty.finer) {
    Choice finer = choice_of("middle on finer elements", uncertainty.inputs, medians);
    const auto& size = *uncertainty.finer;
    finer.settings.push_back(
        {"Grid|Element Size [um]", format("{%.10g, %.10g, %.10g}", size[0], size[1], size[2])});
    variation.choices.push_back(std::move(finer));
  }
  const auto draws = latin_hypercube(uncertainty);
  for (std::size_t n = 0; n < draws.size(); ++n)
    variation.choices.push_back(
        choice_of(format("draw %03zu", n + 1), uncertainty.inputs, draws[n]));
  return variation;
}

std::vector<std::string> uncertainty_notes(const StudyPlan& plan) {
  const UncertaintyParameters& uncertainty = *plan.study.parameters.uncertainty;
  std::vector<std::string> notes = draw_notes(uncertainty);
  if (drawn_support(plan, 0) == nullptr)
    notes.push_back("no boundary condition moves, so that there will be no bands of force" +
                    std::string(uncertainty.stress_bands ? ", only of stress" : ""));
  return notes;
}

void tell_uncertainty(const base::Communicator& communicator, const StudyPlan& plan,
                      const std::vector<MemberResult>& results, const std::string& folder,
                      base::Log& log) {
  const Draws draws = communicator.is_root() ? draws_in(plan, results) : Draws();
  std::size_t count = draws.done.size();
  communicator.broadcast(count);
  if (count < fewest_draws) return log.note("too few draws reached full load for bands");
  if (drawn_support(plan, 0) != nullptr) tell_forces(communicator, plan, draws, folder, log);
  if (!plan.study.parameters.uncertainty->stress_bands) return;
  std::vector<std::string> folders(count);
  for (std::size_t n = 0; n < count; ++n) {
    std::size_t member = communicator.is_root() ? draws.done[n] : 0;
    communicator.broadcast(member);
    folders[n] = plan.folders[member];
  }
  const double start = MPI_Wtime();
  write_stress_bands(communicator, folders, plan.facts.front().image, folder);
  log.line(format("bands of von Mises stress in %.1f s: %s/von_mises_05.tif, _50, _95",
                  MPI_Wtime() - start, folder.c_str()));
}

}  // namespace stroma
