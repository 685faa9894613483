// SPDX-License-Identifier: BSD-3-Clause

#include "study/ReportCommand.hpp"

#include <filesystem>

#include "run/RunReport.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "study/StudyReport.hpp"

namespace stroma {

void report_command(const base::Communicator& communicator, const std::string& folder,
                    base::Log& log) {
  const output::RunFiles files(folder);
  bool is_study = false;
  base::collectively(communicator, [&] {
    if (!std::filesystem::is_directory(folder))
      throw base::InputError("'" + folder + "' is no folder");
    is_study = std::filesystem::is_regular_file(files.file("study.csv"));
    if (!is_study && !std::filesystem::is_regular_file(files.deck()))
      throw base::InputError("'" + folder +
                             "' is no folder of results: it has neither deck.xml, which a run "
                             "leaves, nor study.csv, which a study leaves");
  });
  is_study ? study_report(communicator, folder, log) : run_report(communicator, folder, log);
}

}  // namespace stroma
