// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Which program this is: what a result must be traced back to, whoever runs it on whatever.

#include <string>
#include <utility>
#include <vector>

namespace stroma::output {

/// Names and what there is to say of them, in the order in which they are read.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Version and commit of Stroma, its compiler and options, the libraries that decide a result
/// (Trilinos, Kokkos with its back end, MPI, HDF5, Exodus). The commit is that of the sources when
/// they were built, with "-dirty" if they differed from it; "unknown" outside git.
Facts program_facts();

/// Version and commit: "0.1.0 (7b35d4e01234)".
std::string program_version();

/// A line "NAME: FACT" for each, the facts below one another; an empty name makes an empty line.
/// \param facts   to be listed
/// \param indent  in front of each line
std::string aligned(const Facts& facts, const std::string& indent = "");

}  // namespace stroma::output
