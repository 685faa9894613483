// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyCommand.hpp"

#include <mpi.h>

#include <algorithm>

#include "run/ReportFile.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "study/MemberRun.hpp"
#include "study/StudyDrawing.hpp"
#include "study/StudyPlan.hpp"
#include "study/StudyReport.hpp"
#include "study/StudySizes.hpp"
#include "study/StudySummary.hpp"
#include "study/Uncertainty.hpp"

namespace stroma {
namespace {

using base::format;

void write_table(const base::Communicator& communicator, const StudyPlan& plan,
                 const std::vector<MemberResult>& results, const std::string& folder) {
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    const ComparisonTable comparison =
        compare(plan.study, plan.members, force_records(plan, results));
    output::write_file(folder + "/study.csv",
                       study_table(plan.study.variations, plan.members, plan.facts, results,
                                   comparison, plan.study.parameters.also_tabulate));
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

std::string figures_of(const StudyPlan& plan, std::size_t m, const MemberResult& result) {
  const output::MovingSupport* support = drawn_support(plan, m);
  if (support == nullptr || result.status != MemberStatus::done || result.history.rows() == 0)
    return "";
  return format("   force of %s %.8g pN", support->name.c_str(),
                force_along(*support, result.history).back());
}

}  // namespace

void study_command(const base::Communicator& communicator, const std::string& study_deck,
                   const std::string& output_folder, base::Log& log) {
  const double start = MPI_Wtime();
  const output::RunFolder folder(communicator, output_folder, output::study_files());
  const StudyPlan plan = plan_study(communicator, study_deck, output_folder);
  folder.refuse_foreign_files(input_files(plan));
  folder.remove_old_results(log);
  base::collectively(communicator, [&] { log.open_file(folder.log()); });
  if (!plan.title.empty()) log.line("title       " + plan.title);
  const std::size_t count = plan.members.size();
  const auto kept =
      static_cast<std::size_t>(std::count(plan.finished.begin(), plan.finished.end(), true));
  log.line(format("study       %s: %zu members, %zu of them finished before", study_deck.c_str(),
                  count, kept));
  if (plan.study.parameters.uncertainty)
    for (const std::string& note : uncertainty_notes(plan)) log.note(note);

  std::vector<MemberResult> results(count);
  for (std::size_t m = 0; m < count; ++m) {
    if (!plan.finished[m]) continue;
    results[m].status = MemberStatus::done;
    read_back(communicator, plan.folders[m], results[m]);
  }
  const base::StopRequests signals;
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
    RunOptions options;
    options.folder = plan.folders[m];
    const std::string failure =
        run_member(communicator, plan.members[m].name, plan.decks[m], options, signals);
    log.require_written();
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
    if (!groups.empty())
      output::write_file(folder.file("convergence.csv"), convergence_table(groups));
  });
  const auto records = force_records(plan, results);
  const ComparisonTable comparison = compare(plan.study, plan.members, records);
  log.line("");
  if (plan.study.parameters.uncertainty)
    tell_uncertainty(communicator, plan, results, folder.folder(), log);
  else
    for (const std::string& line : study_summary(plan, records, comparison)) log.line(line);
  log.line("");
  for (const std::string& line : size_summary(groups)) log.line(line);
  draw_study(communicator, plan, results, groups, folder.folder(), log);
  report_at_end(log, [&] { study_report(communicator, folder.folder(), log); });
  folder.finish();
  log.line(format("%.1f s on %d rank%s; %s", MPI_Wtime() - start, communicator.size(),
                  communicator.size() == 1 ? "" : "s", folder.file("study.csv").c_str()));
  folder.finish("log.txt");
  if (failures.empty()) return;
  std::string text = format("%zu of %zu members failed; the others' results are in %s",
                            failures.size(), count, folder.folder().c_str());
  for (const std::string& failure : failures) text += "\nmember " + failure;
  throw base::RunError(text +
                       "\nto go on: see the members' log.txt; change the study or its base deck; "
                       "what is finished is not run again");
}

}  // namespace stroma
