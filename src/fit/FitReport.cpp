// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitReport.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "run/ReportFile.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {
namespace {

using nlohmann::json;

constexpr std::size_t most_rows = 2000;

json data_of(const output::RunFiles& files) {
  const std::string log = base::file_content(files.log());
  json data{{"kind", "fit"},
            {"title", said_in(log, "title")},
            {"folder", std::filesystem::absolute(files.folder()).filename().string()},
            {"made_by", output::program_version()},
            {"log", log}};
  for (const char* table : {"fit", "estimates", "fitted"})
    data[table] = output::table_excerpt(base::file_content(files.file(std::string(table) + ".csv")),
                                        most_rows, false);
  return data;
}

}  // namespace

void fit_report(const base::Communicator& communicator, const std::string& folder, base::Log& log) {
  report_of_tables(communicator, folder, "a fit", "fit.csv", data_of, log);
}

}  // namespace stroma
