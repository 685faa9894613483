// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyDrawing.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "stroma/output/pictures/RasterPlot.hpp"
#include "stroma/output/pictures/StressPanels.hpp"
#include "stroma/output/pictures/StudyPictures.hpp"

namespace stroma {
namespace {

using base::format;
namespace fs = std::filesystem;

/// The things that vary, as the legend shows them: "Steps" for the parameter Loading|Steps.
std::vector<output::CurveThing> things_of(const std::vector<Variation>& variations) {
  std::vector<output::CurveThing> things;
  for (const Variation& variation : variations) {
    const std::size_t bar = variation.name.rfind('|');
    const bool is_path = bar != std::string::npos;
    output::CurveThing& thing =
        things.emplace_back(output::CurveThing{variation.name.substr(is_path ? bar + 1 : 0), {}});
    for (const Choice& choice : variation.choices)
      thing.alternatives.push_back(is_path ? choice.value : choice.label);
  }
  return things;
}

output::CurveName curve_name(const std::vector<Variation>& variations, const Member& member) {
  output::CurveName name{member.name, {}};
  for (std::size_t v = 0; v < variations.size(); ++v) {
    const auto& choices = variations[v].choices;
    const auto choice = std::find_if(choices.begin(), choices.end(), [&](const Choice& one) {
      return one.label == member.labels[v];
    });
    name.alternative.push_back(static_cast<std::size_t>(choice - choices.begin()));
  }
  return name;
}

std::string draw_forces(const base::Communicator& communicator, const StudyPlan& plan,
                        const std::vector<MemberResult>& results, const std::string& folder,
                        const std::string& support_name, bool by_strain) {
  std::vector<output::ForceCurve> curves;
  int failed = 0;
  for (std::size_t m = 0; m < plan.members.size(); ++m) {
    const output::MovingSupport* support = drawn_support(plan, m);
    if (support == nullptr || results[m].history.rows() == 0) continue;
    const double scale = by_strain ? support->strain : moved_along(*support);
    output::ForceCurve curve{curve_name(plan.study.variations, plan.members[m]),
                             {},
                             force_along(*support, results[m].history)};
    if (results[m].status == MemberStatus::failed) {
      curve.name.name += " (failed)";
      ++failed;
    }
    for (const double load : results[m].history.column("load"))
      curve.stretch.push_back(load * scale);
    curves.push_back(std::move(curve));
  }
  const std::string remark =
      failed == 0 ? "" : format("; %d of %zu runs failed on the way", failed, plan.members.size());
  return output::draw_force_strain(communicator, folder, plan.title, support_name,
                                   things_of(plan.study.variations), curves, by_strain, remark);
}

output::SizeSeries series_of(const SizeGroup& group) {
  output::SizeSeries series;
  series.name = group.name;
  series.undefined_because = group.limit.undefined_because;
  for (const SizedFigure& point : group.forces) {
    series.size.push_back(point.size);
    series.force.push_back(point.figure);
  }
  if (const auto& limit = group.limit.extrapolation) {
    const SizedFigure& finest = group.forces.back();
    series.fit = output::SizeFit{
        limit->value, (finest.figure - limit->value) / std::pow(finest.size, limit->order),
        limit->order};
  }
  return series;
}

/// The von Mises raster that a finished member's run left. For one rank.
output::StoredRaster raster_of(const std::string& folder) {
  std::error_code failure;
  const auto begun = fs::last_write_time(folder + "/deck.xml", failure);
  const auto drawn = fs::last_write_time(folder + "/pictures/von_mises.raw", failure);
  if (!failure && drawn < begun)
    return {std::nullopt, "its pictures are older than its run (Output|Pictures: false?)"};
  return output::read_raster(folder + "/pictures", "von_mises");
}

/// The labels in which members of a picture differ, or which they share.
std::string labels_of(const StudyPlan& plan, const std::vector<std::size_t>& members,
                      std::size_t member, bool shared) {
  std::string text;
  for (std::size_t v = 0; v < plan.study.variations.size(); ++v) {
    const std::string& label = plan.members[member].labels[v];
    const bool is_shared = std::all_of(members.begin(), members.end(), [&](std::size_t m) {
      return plan.members[m].labels[v] == label;
    });
    if (is_shared == shared) text += (text.empty() ? "" : ", ") + label;
  }
  return text;
}

void draw_stresses(const base::Communicator& communicator, const StudyPlan& plan,
                   const std::vector<MemberResult>& results, const std::string& folder,
                   base::Log& log) {
  const std::vector<std::size_t>& members = plan.study.von_mises_members;
  std::vector<output::StressPanel> panels;
  for (const std::size_t m : members) {
    std::string missing;
    if (communicator.is_root()) {
      output::StoredRaster stored;
      if (results[m].status == MemberStatus::done)
        stored = raster_of(plan.folders[m]);
      else
        stored.missing_because = "it did not reach full load";
      missing = stored.missing_because;
      if (stored.raster)
        panels.push_back({labels_of(plan, members, m, false), std::move(*stored.raster)});
    }
    communicator.broadcast(missing);
    if (!missing.empty())
      log.note("von_mises.png is without \"" + plan.members[m].name + "\": " + missing);
  }
  int count = static_cast<int>(panels.size());
  communicator.broadcast(count);
  if (count == 0) return log.note("von_mises.png was not drawn: no member has a map to show");
  const std::string failure = output::draw_stress_panels(
      communicator, folder, plan.title, labels_of(plan, members, members.front(), true), panels,
      plan.decks[members.front()].parameters.output.origin);
  if (!failure.empty()) log.note(failure);
}

}  // namespace

void draw_study(const base::Communicator& communicator, const StudyPlan& plan,
                const std::vector<MemberResult>& results, const std::vector<SizeGroup>& groups,
                const std::string& folder, base::Log& log) {
  const StudyPlotParameters& plot = plan.study.parameters.plot;
  if (!plan.study.von_mises_members.empty())
    draw_stresses(communicator, plan, results, folder, log);

  bool by_strain = true, follows_load = true;
  std::string support_name;
  for (std::size_t m = 0; m < plan.members.size(); ++m) {
    const output::MovingSupport* support = drawn_support(plan, m);
    if (support == nullptr) continue;
    by_strain = by_strain && support->strain != 0.0;
    follows_load = follows_load && support->follows_load;
    if (support_name.empty()) support_name = support->name;
  }
  const auto note = [&](const std::string& text) {
    if (!text.empty()) log.note(text);
  };
  if (support_name.empty()) return note("no forces were drawn: no boundary condition moves");
  if (plot.force_against_strain && !follows_load)
    note("force_strain.png was not drawn: a load curve moves \"" + support_name + "\"");
  else if (plot.force_against_strain)
    note(draw_forces(communicator, plan, results, folder, support_name, by_strain));
  std::vector<output::SizeSeries> series;
  for (const SizeGroup& group : groups) series.push_back(series_of(group));
  int has_series = series.empty() ? 0 : 1;
  communicator.broadcast(has_series);
  if (plot.force_against_element_size && has_series == 1)
    note(output::draw_force_element_size(communicator, folder, plan.title, support_name, series));
}

}  // namespace stroma
