// SPDX-License-Identifier: BSD-3-Clause

#include "run/RunFacts.hpp"

#include <mpi.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/base/Sha256.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/deck/PlainText.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;

/// The names of the machines, on rank 0: "2 (node07, node08)". Collective.
std::string hosts(const base::Communicator& communicator) {
  using Name = std::array<char, MPI_MAX_PROCESSOR_NAME>;
  Name own{};
  int length = 0;
  MPI_Get_processor_name(own.data(), &length);
  std::vector<Name> all(communicator.is_root() ? static_cast<std::size_t>(communicator.size()) : 0);
  MPI_Gather(own.data(), sizeof own, MPI_CHAR, all.data(), sizeof own, MPI_CHAR, 0,
             communicator.raw());
  std::set<std::string> names;
  for (const Name& name : all) names.insert(name.data());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return std::to_string(names.size()) + " (" + text + ")";
}

std::string in_utc(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

}  // namespace

output::Facts run_facts(const base::Communicator& communicator, std::time_t start,
                        const std::vector<std::string>& files) {
  const base::Stage stage("checksums");
  output::Facts facts{{"ranks", std::to_string(communicator.size())},
                      {"threads", base::format("%d a rank", base::threads())},
                      {"hosts", hosts(communicator)},
                      {"start", in_utc(start)}};
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::set<fs::path> listed;
    for (const std::string& file : files) {
      const fs::path path = fs::absolute(file).lexically_normal();
      if (!listed.insert(path).second) continue;
      std::error_code ignored;  // sha256_of_file() tells what is wrong
      const std::uintmax_t bytes = fs::file_size(path, ignored);
      facts.emplace_back();
      facts.emplace_back("file", deck::printable(path.string()));
      facts.emplace_back("bytes", std::to_string(bytes));
      facts.emplace_back("SHA-256", base::sha256_of_file(path.string()));
    }
  });
  return facts;
}

}  // namespace stroma
