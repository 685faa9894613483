// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// MPI and Kokkos from the start of a program to its end, and how many threads a rank gets.

#include <memory>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace Tpetra {
class ScopeGuard;
}

namespace stroma::base {

/// Starts MPI, and ends it. Only the thread that made it calls MPI (MPI_THREAD_FUNNELED): threads
/// work inside kernels alone.
class MpiSession {
 public:
  MpiSession(int* argc, char*** argv);
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

/// Starts Kokkos and Tpetra after MPI, and ends them.
///
/// Threads per rank, where Trilinos has OpenMP: --kokkos-num-threads=N (or --kokkos-threads=N);
/// else OMP_NUM_THREADS; else an equal share of the processors that the ranks of a machine may use,
/// so that several ranks do not each take all of them. Collective.
class KokkosSession {
 public:
  /// \param communicator  the ranks that share the machines
  /// \param words         program name, then words for Kokkos (--kokkos-...)
  /// \throws InputError when a number of threads is none
  KokkosSession(const Communicator& communicator, const std::vector<std::string>& words);
  ~KokkosSession();
  KokkosSession(const KokkosSession&) = delete;
  KokkosSession& operator=(const KokkosSession&) = delete;

 private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
  std::unique_ptr<Tpetra::ScopeGuard> tpetra_;
};

/// The words that begin with --kokkos, taken out of a command line, behind its first word.
std::vector<std::string> take_kokkos_words(std::vector<char*>& command_line);

/// Threads of a rank in kernels; 1 where Trilinos has no OpenMP.
int threads();

/// "2 ranks", or "2 ranks of 4 threads".
std::string ranks_and_threads(const Communicator& communicator);

/// What is wrong when ranks and threads outnumber the processors that they may use on some machine,
/// and what to do; empty if they do not. Collective.
std::string oversubscription(const Communicator& communicator);

}  // namespace stroma::base
