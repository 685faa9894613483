// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Counts what this rank really sends: MPI's own names for the calls stand in CountedMpi.cpp, which
/// hands them on through MPI's profiling interface.

#include <functional>

#include "stroma/grid/Traffic.hpp"

namespace stroma::test {

/// What some work sends from this rank.
grid::Traffic counted(const std::function<void()>& work);

}  // namespace stroma::test
