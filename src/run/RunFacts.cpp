// SPDX-License-Identifier: BSD-3-Clause

#include "run/RunFacts.hpp"

#include <mpi.h>

#include <array>
#include <set>

#include "stroma/base/Log.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/deck/PlainText.hpp"

namespace stroma {
namespace {

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
                        const std::vector<KnownFile>& files) {
  output::Facts facts{{"ranks", std::to_string(communicator.size())},
                      {"threads", base::format("%d a rank", base::threads())},
                      {"hosts", hosts(communicator)},
                      {"start", in_utc(start)}};
  for (const KnownFile& file : files) {
    facts.emplace_back();
    facts.emplace_back("file", deck::printable(file.path));
    facts.emplace_back("bytes", std::to_string(file.bytes));
    facts.emplace_back("SHA-256", file.sha256);
  }
  return facts;
}

}  // namespace stroma
