// SPDX-License-Identifier: BSD-3-Clause

#include "fit/FitReport.hpp"

#include <mpi.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "run/RunReport.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/files/RunFolder.hpp"
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
  const double start = MPI_Wtime();
  const output::RunFiles files(folder);
  std::string page;
  base::collectively(communicator, [&] {
    if (!std::filesystem::is_regular_file(files.file("fit.csv")))
      throw base::InputError("'" + folder + "' is no folder of a fit: it has no fit.csv");
    if (!communicator.is_root()) return;
    const json data = data_of(files);
    page = output::report_page(data["title"].get<std::string>(), data, {});
  });
  write_report(communicator, folder, page, start, log);
}

}  // namespace stroma
