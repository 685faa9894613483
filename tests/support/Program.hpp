// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Runs the program as a user does, and reads the table it leaves.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/Places.hpp"
#include "support/TemporaryFolder.hpp"

namespace stroma::test {

struct Outcome {
  int status;
  std::string standard_output;
  std::string standard_error;
};

inline std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// How many threads this test was given, and gives to the programs that it runs.
inline int threads_of_test() {
  const char* number = std::getenv("OMP_NUM_THREADS");
  return number == nullptr ? 1 : std::atoi(number);
}

/// What a program is given of this test's environment, in the words of env: where libraries are, and
/// what cmake/asan.sh tells the sanitizers.
inline std::string kept_environment() {
  std::string words;
  for (const char* name :
       {"PATH", "LD_LIBRARY_PATH", "ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS"})
    words += std::string(name) + "=\"$" + name + "\" ";
  return words;
}

/// Runs a program of this build, `stroma` unless another one is named, with arguments in a folder:
/// alone, or under mpirun on several ranks; never as a rank of the MPI job that runs the test,
/// whose environment it must not see. With threads = 0 nothing says how many threads to take.
inline Outcome run_program(const fs::path& program, const fs::path& folder,
                           const std::string& arguments, int ranks, int threads) {
  const TemporaryFolder capture;
  const fs::path output = capture / "output", error = capture / "error";
  std::string line =
      "cd " + quoted(folder) + " && env -i " + kept_environment() +
      "HOME=" + quoted(capture.path()) +
      " OMP_WAIT_POLICY=passive OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      "OMPI_MCA_mpi_yield_when_idle=1 ";
  if (threads > 0) line += "OMP_NUM_THREADS=" + std::to_string(threads) + " ";
  if (ranks > 1) {  // on one machine, so no network either: Open MPI 5 complains of some of them
    line += "OMPI_MCA_btl=^tcp,ofi mpirun --oversubscribe --bind-to none -np " +
            std::to_string(ranks) + " ";
  } else {  // one rank needs no daemon and no network
    line +=
        "OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_orte_create_session_dirs=0 OMPI_MCA_pml=ob1 "
        "OMPI_MCA_btl=self ";
  }
  line += quoted(program) + " " + arguments + " > " + quoted(output) + " 2> " + quoted(error);
  const int result = std::system(line.c_str());
  return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, content_of(output), content_of(error)};
}

/// Runs `stroma ARGUMENTS` with the test's own number of threads.
inline Outcome run_stroma(const fs::path& folder, const std::string& arguments, int ranks = 1) {
  return run_program(stroma_program(), folder, arguments, ranks, threads_of_test());
}

/// The columns of a history.csv by name; element s is the row of step s.
class History {
 public:
  explicit History(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    std::stringstream header(line);
    for (std::string name; std::getline(header, name, ',');) names_.push_back(name);
    while (std::getline(file, line)) {
      std::stringstream row(line);
      std::size_t column = 0;
      for (std::string value; std::getline(row, value, ','); ++column)
        columns_[names_.at(column)].push_back(std::stod(value));
    }
  }

  const std::vector<double>& operator[](const std::string& name) const {
    const auto found = columns_.find(name);
    if (found == columns_.end()) throw std::runtime_error("history.csv has no column " + name);
    return found->second;
  }
  bool has(const std::string& name) const { return columns_.count(name) > 0; }
  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_.begin()->second.size(); }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> columns_;
};

/// Writes a deck NAME.yaml, runs it into the folder NAME beside it, and reads its history.
inline History run_deck(const TemporaryFolder& folder, const std::string& name,
                        const std::string& deck, int ranks = 1) {
  folder.write(name + ".yaml", deck);
  const Outcome outcome =
      run_stroma(folder.path(), "run " + name + ".yaml -o " + name + " --quiet", ranks);
  EXPECT_EQ(outcome.status, 0) << deck << outcome.standard_error;
  return History(folder.path() / name / "history.csv");
}

}  // namespace stroma::test
