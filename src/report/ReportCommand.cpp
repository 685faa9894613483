// SPDX-License-Identifier: BSD-3-Clause

#include "report/ReportCommand.hpp"

#include <filesystem>

#include "fit/FitReport.hpp"
#include "run/RunReport.hpp"
#include "stiffness/StiffnessReport.hpp"
#include "stiffness/StiffnessRun.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "study/StudyReport.hpp"

namespace stroma {

void report_command(const base::Communicator& communicator, const std::string& folder,
                    base::Log& log) {
  const output::RunFiles files(folder);
  decltype(&run_report) make_report = nullptr;
  base::collectively(communicator, [&] {
    if (!std::filesystem::is_directory(folder))
      throw base::InputError("'" + folder + "' is no folder");
    if (std::filesystem::is_regular_file(files.file("study.csv"))) {
      make_report = study_report;
    } else if (std::filesystem::is_regular_file(files.file("fit.csv"))) {
      make_report = fit_report;
    } else if (std::filesystem::is_regular_file(files.deck())) {
      make_report = holds_stiffness(folder) ? stiffness_report : run_report;
    } else {
      throw base::InputError("'" + folder +
                             "' is no folder of results: it has neither deck.xml, which a run "
                             "leaves, nor study.csv, which a study leaves, nor fit.csv, which a "
                             "fit leaves");
    }
  });
  make_report(communicator, folder, log);
}

}  // namespace stroma
