// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// How much memory the ranks of a machine may take.

#include <exception>
#include <string>

#include "stroma/base/Communicator.hpp"

namespace stroma::base {

/// An upper bound of memory, and what sets it.
struct MemoryLimit {
  double bytes;
  std::string set_by;  ///< e.g. "physical memory"
};

/// What all processes of this machine may take together: its physical memory, or less where a
/// control group (a container, a batch job) has a limit.
MemoryLimit machine_memory();

/// What this process may still take: the limit of its address space (ulimit -v) less what is mapped
/// already; infinite without one.
MemoryLimit process_memory();

/// What a rank holds besides its data: the program, its libraries, and what MPI shares [bytes].
constexpr double program_memory = 95e6;

/// The most that this process has held so far [bytes].
double peak_memory();

/// Why ranks that each need so many bytes besides program_memory cannot have them: "each of 2 ranks
/// needs about 31.2 GiB, and physical memory is 23.4 GiB on a machine with 2 of them"; empty where
/// they can. Collective; the same text on all ranks.
std::string shortage(const Communicator& communicator, double bytes);

/// "1.50 GiB", or in MiB below one.
std::string readable_bytes(double bytes);

/// What to say, and to do, where memory could not be had.
constexpr const char* out_of_memory =
    "out of memory; take more machines, or a smaller Image|Region";

/// Whether an exception says that memory could not be had.
bool is_out_of_memory(const std::exception& error);

}  // namespace stroma::base
