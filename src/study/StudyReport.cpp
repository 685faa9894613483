// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyReport.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "run/ReportFile.hpp"
#include "run/RunReport.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {
namespace {

using nlohmann::json;

constexpr std::size_t most_shown = 2000, most_rows = 200;

/// A member that has left a deck and a history.
json member_of(const std::string& folder, const output::RunFiles& files) {
  const Deck deck = read_deck(files.deck(), {});
  return {{"folder", folder},
          {"title", deck.parameters.title},
          {"grid", said_in(base::file_content(files.log()), "grid")},
          {"has_time", deck.parameters.loading.has_time()},
          {"has_report", std::filesystem::exists(files.file("report.html"))},
          {"supports", described_supports(deck.parameters, {1.0, 1.0, 1.0})},
          {"history", output::table_excerpt(base::file_content(files.history()), most_rows, true)}};
}

/// The first field of a row of study.csv: names of folders need no quotes.
std::string first_field(const std::string& row) { return row.substr(0, row.find(',')); }

/// What the members' titles begin with: the study's own, for to it they add ": " and their name.
std::string common_title(const json& members) {
  std::string title;
  for (const json& member : members) {
    const auto one = member["title"].get<std::string>();
    if (title.empty()) title = one;
    const auto differ = std::mismatch(title.begin(), title.end(), one.begin(), one.end());
    title.erase(differ.first, title.end());
  }
  return title.substr(0, title.rfind(": "));
}

json data_of(const output::RunFiles& files) {
  const std::string table = base::file_content(files.file("study.csv"));
  json data{
      {"kind", "study"},
      {"folder", std::filesystem::absolute(files.folder()).filename().string()},
      {"made_by", output::program_version()},
      {"log", base::file_content(files.log())},
      {"study", output::table_excerpt(table, most_shown, false)},
      {"convergence",
       output::table_excerpt(base::file_content(files.file("convergence.csv")), most_shown, false)},
      {"bands",
       output::table_excerpt(base::file_content(files.file("bands.csv")), most_rows, true)},
      {"correlations", output::table_excerpt(base::file_content(files.file("correlations.csv")),
                                             most_shown, false)},
      {"members", json::array()}};
  std::istringstream rows(table);
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row) && data["members"].size() < most_shown) {
    const output::RunFiles member(files.file(first_field(row)));
    if (std::filesystem::is_regular_file(member.deck()) &&
        std::filesystem::is_regular_file(member.history()))
      data["members"].push_back(member_of(first_field(row), member));
  }
  const std::string title = said_in(data["log"].get<std::string>(), "title");
  data["title"] = title.empty() ? common_title(data["members"]) : title;
  return data;
}

}  // namespace

void study_report(const base::Communicator& communicator, const std::string& folder,
                  base::Log& log) {
  report_of_tables(communicator, folder, "a study", "study.csv", data_of, log);
}

}  // namespace stroma
