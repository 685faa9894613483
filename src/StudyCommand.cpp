#include "StudyCommand.hpp"

#include <mpi.h>

#include <Teuchos_TimeMonitor.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "Simulation.hpp"
#include "StudyPlan.hpp"
#include "base/Error.hpp"
#include "output/RunFolder.hpp"
#include "output/StudyPictures.hpp"

namespace stroma {
namespace {

using base::format;

/// Newton stops at this share of the largest force; differences below it tell nothing.
double noise_of(const Deck& deck) { return 10.0 * deck.parameters.solver.newton_tolerance; }

/// The support whose force is drawn, or null.
const output::MovingSupport* drawn_support(const StudyPlan& plan, std::size_t member) {
  const std::string& wanted = plan.study.parameters.plot.support;
  for (const auto& support : plan.facts[member].moving)
    if (wanted.empty() || support.name == wanted) return &support;
  return nullptr;
}

/// The labels that all these members share.
std::string common_name(const StudyPlan& plan, const std::vector<std::size_t>& members) {
  std::string name;
  const auto& labels = plan.members[members.front()].labels;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    const bool is_common = std::all_of(members.begin(), members.end(), [&](std::size_t m) {
      return plan.members[m].labels[v] == labels[v];
    });
    if (is_common) name += (name.empty() ? "" : ", ") + labels[v];
  }
  return name;
}

/// The axis along which the members' elements differ first, -1 if they are alike, -2 if they differ
/// in shape: along the other axes a size may stay or change in the same ratio.
int size_axis(const StudyPlan& plan, const std::vector<std::size_t>& members) {
  const auto& first = plan.facts[members.front()].element_size;
  const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-6 * b; };
  int axis = -1;
  for (int d = 2; d >= 0; --d)
    for (const std::size_t m : members)
      if (differs(plan.facts[m].element_size[static_cast<std::size_t>(d)],
                  first[static_cast<std::size_t>(d)]))
        axis = d;
  if (axis < 0) return axis;
  for (std::size_t d = 0; d < 3; ++d) {
    bool stays = true, follows = true;
    for (const std::size_t m : members) {
      const auto& size = plan.facts[m].element_size;
      const auto a = static_cast<std::size_t>(axis);
      stays = stays && !differs(size[d], first[d]);
      follows = follows && !differs(size[d] / first[d], size[a] / first[a]);
    }
    if (!stays && !follows) return -2;
  }
  return axis;
}

/// Force against element size of every family of members that has at least two sizes. For one rank.
std::vector<SizeGroup> size_groups(const StudyPlan& plan,
                                   const std::vector<MemberResult>& results) {
  std::map<std::size_t, std::vector<std::size_t>> families;
  for (std::size_t m = 0; m < plan.members.size(); ++m)
    if (results[m].status == MemberStatus::done && drawn_support(plan, m) != nullptr)
      families[plan.family[m]].push_back(m);

  std::vector<SizeGroup> groups;
  for (const auto& [family, members] : families) {
    const int axis = size_axis(plan, members);
    if (axis == -1) continue;
    SizeGroup group;
    group.name = common_name(plan, members);
    for (const std::size_t m : members) {
      const double size = plan.facts[m].element_size[static_cast<std::size_t>(std::max(axis, 0))];
      group.forces.push_back(
          {size, force_along(*drawn_support(plan, m), results[m].history).back()});
    }
    group.limit = axis == -2 ? RichardsonResult{std::nullopt, "the elements differ in shape"}
                             : richardson(group.forces, noise_of(plan.decks[members.front()]));
    std::sort(group.forces.begin(), group.forces.end(),
              [](const SizedFigure& a, const SizedFigure& b) { return a.size > b.size; });
    groups.push_back(std::move(group));
  }
  return groups;
}

void write_file(const std::string& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << content;
  file.close();
  if (file.fail()) throw base::RunError("cannot write '" + path + "'");
}

void write_table(const base::Communicator& communicator, const StudyPlan& plan,
                 const std::vector<MemberResult>& results, const std::string& folder) {
  base::collectively(communicator, [&] {
    if (communicator.is_root())
      write_file(folder + "/study.csv", study_table(plan.study.variations, plan.members, plan.facts,
                                                    results, plan.study.parameters.also_tabulate));
  });
}

/// Reads a member's history on rank 0; done only if it came to full load. Collective.
void read_back(const base::Communicator& communicator, const std::string& folder,
               MemberResult& result) {
  int is_whole = 0;
  if (communicator.is_root()) {
    try {
      result.history = output::HistoryTable(folder + "/history.csv");
      is_whole = result.history.reached_full_load() ? 1 : 0;
    } catch (const base::RunError&) {
      result.history = {};
    }
  }
  communicator.broadcast(is_whole);
  if (is_whole == 0) result.status = MemberStatus::failed;
}

/// Runs one member. Collective. \return why it failed; empty when it did not
std::string run_member(const base::Communicator& communicator, const Deck& deck,
                       const std::string& folder) {
  Teuchos::TimeMonitor::zeroOutTimers();  // the member's log tells the times of the member
  base::Log log(communicator, true);
  try {
    run_simulation(communicator, deck, folder, log);
    return "";
  } catch (const base::RunError& error) {
    log.line(std::string("stroma: ") + error.what());
    return error.what();
  } catch (const base::InputError& error) {
    log.line(std::string("stroma: ") + error.what());
    return located(deck, error).what();
  }
}

std::string figures_of(const StudyPlan& plan, std::size_t m, const MemberResult& result) {
  const output::MovingSupport* support = drawn_support(plan, m);
  if (support == nullptr || result.status != MemberStatus::done || result.history.rows() == 0)
    return "";
  return format("   force of %s %.8g pN", support->name.c_str(),
                force_along(*support, result.history).back());
}

void draw(const base::Communicator& communicator, const StudyPlan& plan,
          const std::vector<MemberResult>& results, const std::vector<SizeGroup>& groups,
          const std::string& folder, base::Log& log) {
  const StudyPlotParameters& plot = plan.study.parameters.plot;
  bool by_strain = true, any_support = false;
  std::string support_name;
  std::vector<output::ForceCurve> curves;
  for (std::size_t m = 0; m < plan.members.size(); ++m) {
    const output::MovingSupport* support = drawn_support(plan, m);
    if (support == nullptr) continue;
    any_support = true;
    by_strain = by_strain && support->strain != 0.0;
    if (support_name.empty()) support_name = support->name;
  }
  for (std::size_t m = 0; m < plan.members.size(); ++m) {
    const output::MovingSupport* support = drawn_support(plan, m);
    if (support == nullptr || results[m].history.rows() == 0) continue;
    const auto& way = support->displacement;
    const double scale = by_strain ? support->strain : std::hypot(way[0], way[1], way[2]);
    output::ForceCurve curve{plan.members[m].name, {}, force_along(*support, results[m].history)};
    if (results[m].status == MemberStatus::failed) curve.name += " (failed)";
    for (const double load : results[m].history.column("load"))
      curve.stretch.push_back(load * scale);
    curves.push_back(std::move(curve));
  }
  std::vector<output::SizeSeries> series;
  for (const SizeGroup& group : groups) {
    output::SizeSeries one;
    one.name = group.name;
    one.undefined_because = group.limit.undefined_because;
    for (const SizedFigure& point : group.forces) {
      one.size.push_back(point.size);
      one.force.push_back(point.figure);
    }
    if (const auto& limit = group.limit.extrapolation) {
      const SizedFigure& finest = group.forces.back();
      one.fit = output::SizeFit{
          limit->value, (finest.figure - limit->value) / std::pow(finest.size, limit->order),
          limit->order};
    }
    series.push_back(std::move(one));
  }

  const auto note = [&](const std::string& text) {
    if (!text.empty()) log.note(text);
  };
  if (!any_support) return note("no picture was drawn: no boundary condition moves");
  if (plot.force_against_strain)
    note(output::draw_force_strain(communicator, folder, plan.title, support_name, curves,
                                   by_strain));
  int has_series = series.empty() ? 0 : 1;
  communicator.broadcast(has_series);
  if (plot.force_against_element_size && has_series == 1)
    note(output::draw_force_element_size(communicator, folder, plan.title, support_name, series));
}

void report_sizes(const std::vector<SizeGroup>& groups, base::Log& log) {
  for (const SizeGroup& group : groups) {
    const std::string name = group.name.empty() ? "force" : "force, " + group.name;
    if (const auto& limit = group.limit.extrapolation)
      log.line(format("%s: %.8g pN at element size 0, observed order %.3f (from %g, %g and %g um)",
                      name.c_str(), limit->value, limit->order, limit->sizes[0], limit->sizes[1],
                      limit->sizes[2]));
    else
      log.line(name + ": no extrapolation to element size 0: " + group.limit.undefined_because);
  }
}

}  // namespace

void study_command(const base::Communicator& communicator, const std::string& study_deck,
                   const std::string& output_folder, base::Log& log) {
  const double start = MPI_Wtime();
  const StudyPlan plan = plan_study(communicator, study_deck, output_folder);
  const output::RunFolder folder(communicator, output_folder);
  base::collectively(communicator, [&] { log.open_file(folder.log()); });
  const std::size_t count = plan.members.size();
  const auto kept =
      static_cast<std::size_t>(std::count(plan.finished.begin(), plan.finished.end(), true));
  log.line(format("study       %s: %zu members, %zu of them finished before", study_deck.c_str(),
                  count, kept));

  std::vector<MemberResult> results(count);
  for (std::size_t m = 0; m < count; ++m) {
    if (!plan.finished[m]) continue;
    results[m].status = MemberStatus::done;
    read_back(communicator, plan.folders[m], results[m]);
  }
  std::vector<std::string> failures;
  std::size_t ran = 0;
  for (std::size_t m = 0; m < count; ++m) {
    const std::string head = format("[%zu/%zu] %s", m + 1, count, plan.members[m].name.c_str());
    if (plan.finished[m]) {
      log.line(head + ": finished before" + figures_of(plan, m, results[m]));
      continue;
    }
    const double before = MPI_Wtime();
    log.line(head + ": running, its log is " + plan.folders[m] + "/log.txt");
    const std::string failure = run_member(communicator, plan.decks[m], plan.folders[m]);
    results[m].status = failure.empty() ? MemberStatus::done : MemberStatus::failed;
    read_back(communicator, plan.folders[m], results[m]);
    ++ran;
    const double now = MPI_Wtime();
    const double left =
        (now - start) / static_cast<double>(ran) * static_cast<double>(count - kept - ran);
    if (!failure.empty()) {
      log.line(head + ": failed\n  " + failure.substr(0, failure.find('\n')));
      failures.push_back("\"" + plan.members[m].name +
                         "\": " + failure.substr(0, failure.find('\n')));
    } else {
      log.line(head + format(": done in %.1f s, about %.0f s left", now - before, left) +
               figures_of(plan, m, results[m]));
    }
    write_table(communicator, plan, results, folder.folder());
  }
  write_table(communicator, plan, results, folder.folder());

  std::vector<SizeGroup> groups;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    groups = size_groups(plan, results);
    if (!groups.empty()) write_file(folder.file("convergence.csv"), convergence_table(groups));
  });
  report_sizes(groups, log);
  draw(communicator, plan, results, groups, folder.folder(), log);
  log.line(format("%.1f s on %d rank%s; %s", MPI_Wtime() - start, communicator.size(),
                  communicator.size() == 1 ? "" : "s", folder.file("study.csv").c_str()));
  if (failures.empty()) return;
  std::string text = format("%zu of %zu members failed; the others' results are in %s",
                            failures.size(), count, folder.folder().c_str());
  for (const std::string& failure : failures) text += "\nmember " + failure;
  throw base::RunError(text +
                       "\nto go on: see the members' log.txt; change the study or its base deck; "
                       "what is finished is not run again");
}

}  // namespace stroma
