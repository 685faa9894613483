// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A deck that runs in a second: a ball of 8 x 8 x 8 voxels, stretched between clamps.

#include <regex>
#include <string>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {

inline std::string small_deck() {
  return content_of(clone_folder() / "tests" / "data" / "cases" / "title_control" / "base.yaml");
}

/// The same of an image file that holds its labels.
inline std::string small_deck_of_labels(const std::string& file) {
  std::string text = small_deck();
  const std::size_t begin = text.find("    Phantom:"), end = text.find("  Materials:");
  return text.replace(begin, end - begin,
                      "    File: " + file + "\n    Segmentation: {Method: Labels}\n");
}

/// The same as a run of an hour.
inline const std::string endless =
    " --set 'Loading|Steps=900000' --set 'Loading|Smallest Step=1e-9' ";

/// Makes an output folder's list of files that of a run that was killed in its last step.
inline void leave_as_killed(const fs::path& out) {
  const std::string files = content_of(out / ".stroma_files");
  std::ofstream(out / ".stroma_files")
      << std::regex_replace(files, std::regex("\t[0-9]+ bytes.*"), "\tbeing written");
}

/// Runs a script of bash in a folder, in which $stroma is the program, $mpirun starts ranks, and
/// `wait_for_steps FILE` waits until a history.csv has three steps.
inline Outcome run_script(const TemporaryFolder& folder, const std::string& script) {
  const std::string head =
      "stroma=" + quoted(stroma_program()) +
      "\nmpirun='env -u OMPI_MCA_btl -u OMPI_MCA_pml -u OMPI_MCA_ess_singleton_isolated "
      "-u OMPI_MCA_orte_create_session_dirs OMPI_MCA_odls_base_sigkill_timeout=5 "
      "PRTE_MCA_odls_base_sigkill_timeout=5 mpirun --oversubscribe'\n"
      "wait_for_steps() {\n"
      "  for ((n = 0; n < 600; ++n)); do\n"
      "    [[ -f $1 && $(wc -l <\"$1\") -ge 4 ]] && break\n"
      "    sleep 0.1\n"
      "  done\n"
      "}\n";
  folder.write("script.sh", head + script);
  return run_program("/bin/bash", folder.path(), "script.sh", 1, 1);
}

}  // namespace stroma::test
