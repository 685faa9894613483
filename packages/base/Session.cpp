// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Session.hpp"

#include <mpi.h>
#include <sched.h>
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include <Kokkos_Core.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Machine.hpp"

namespace stroma::base {
namespace {

#ifdef KOKKOS_ENABLE_OPENMP
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

// Kokkos' word for it changed.
#if KOKKOS_VERSION >= 30700
constexpr const char* threads_word = "--kokkos-num-threads=";
#else
constexpr const char* threads_word = "--kokkos-threads=";
#endif

/// The processors of this machine, as its ranks may use them.
struct Processors {
  int mine;   ///< that this rank may use (mpirun may bind it to few)
  int all;    ///< that any of the machine's ranks may use
  int ranks;  ///< on this machine
};

Processors processors(const Communicator& communicator) {
  cpu_set_t mine;
  CPU_ZERO(&mine);
  sched_getaffinity(0, sizeof mine, &mine);
  const Machine machine(communicator);
  cpu_set_t all;
  MPI_Allreduce(&mine, &all, sizeof mine, MPI_BYTE, MPI_BOR, machine.ranks().raw());
  return {std::max(1, CPU_COUNT(&mine)), std::max(1, CPU_COUNT(&all)), machine.ranks().size()};
}

/// N of --kokkos-num-threads=N or --kokkos-threads=N; 0 if the word is another one.
int threads_asked_for(const std::string& word) {
  for (const char* name : {"--kokkos-num-threads", "--kokkos-threads"}) {
    if (word.rfind(name, 0) != 0) continue;
    const std::size_t length = std::strlen(name);
    char* end = nullptr;
    const long number = word.size() > length + 1 && word[length] == '='
                            ? std::strtol(&word[length + 1], &end, 10)
                            : 0;
    if (end == nullptr || *end != '\0' || number < 1 || number > 4096)
      throw InputError(word + ": admissible: " + name + "=N, N threads from 1 to 4096");
    return static_cast<int>(number);
  }
  return 0;
}

bool is_set(const char* name) { return std::getenv(name) != nullptr; }

}  // namespace

MpiSession::MpiSession(int* argc, char*** argv) {
  int provided = 0;
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
}

MpiSession::~MpiSession() {
#ifdef __SANITIZE_ADDRESS__
  // Leaks are looked for here, and not when the process ends: MPI_Finalize unloads Open MPI's modules
  // without freeing what they hold, and tests/leaks.supp could not tell whose it was.
  __lsan_do_leak_check();
#endif
  MPI_Finalize();
}

std::vector<std::string> take_kokkos_words(std::vector<char*>& command_line) {
  std::vector<std::string> words;
  if (!command_line.empty()) words.emplace_back(command_line.front());
  const auto is_for_kokkos = [](const char* word) {
    return std::strncmp(word, "--kokkos", 8) == 0;
  };
  for (const char* word : command_line)
    if (is_for_kokkos(word)) words.emplace_back(word);
  command_line.erase(std::remove_if(command_line.begin(), command_line.end(), is_for_kokkos),
                     command_line.end());
  return words;
}

KokkosSession::KokkosSession(const Communicator& communicator,
                             const std::vector<std::string>& words) {
  int count = 0;
  for (const std::string& word : words) {
    const int asked_for = threads_asked_for(word);
    if (asked_for == 0) words_.push_back(word);
    if (asked_for != 0) count = asked_for;
  }
  if (has_threads) {
    if (count == 0 && !is_set("OMP_NUM_THREADS") && !is_set("KOKKOS_NUM_THREADS")) {
      const Processors found = processors(communicator);
      count = std::max(1, std::min(found.mine, found.all / found.ranks));
    }
    if (count != 0) words_.push_back(threads_word + std::to_string(count));
    // Kokkos would advise each rank on OMP_PROC_BIND; what matters is said by oversubscription().
    if (!is_set("KOKKOS_DISABLE_WARNINGS")) words_.emplace_back("--kokkos-disable-warnings");
  }
  for (std::string& word : words_) pointers_.push_back(word.data());
  int number = static_cast<int>(pointers_.size());
  pointers_.push_back(nullptr);
  char** first = pointers_.data();
  tpetra_ = std::make_unique<Tpetra::ScopeGuard>(&number, &first);
}

KokkosSession::~KokkosSession() = default;

int threads() { return Kokkos::DefaultExecutionSpace().concurrency(); }

std::string ranks_and_threads(const Communicator& communicator) {
  std::string text = format("%d rank%s", communicator.size(), communicator.size() == 1 ? "" : "s");
  if (threads() > 1) text += format(" of %d threads", threads());
  return text;
}

std::string oversubscription(const Communicator& communicator) {
  if (!has_threads) return "";  // ranks alone: mpirun has an option for that, and asks for it
  const Processors found = processors(communicator);
  const bool too_many = threads() > found.mine || threads() * found.ranks > found.all;
  if (!communicator.any(threads() > 1 && too_many)) return "";
  return format(
      "%d threads a rank, %d ranks on a machine, share %d processors, of which a rank may use %d: "
      "fewer threads (OMP_NUM_THREADS), or, where mpirun binds ranks to single cores, "
      "mpirun --bind-to none",
      threads(), found.ranks, found.all, found.mine);
}

}  // namespace stroma::base
