// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What an iteration of conjugate gradients sends from rank to rank.

#include <optional>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Traffic.hpp"
#include "stroma/solver/SolverParameters.hpp"

namespace stroma::solver {

/// Of one rank, in one iteration.
struct IterationTraffic {
  grid::Traffic product;  ///< K v
  std::optional<grid::Traffic>
      preconditioner;  ///< M^-1 r, where it is known: not for MueLu, Direct
  grid::Traffic dots;  ///< Belos' sums over all unknowns

  /// Of all that is known.
  grid::Traffic total() const;
};

/// By arithmetic, for any rank of any partition. The deck's own lists for Trilinos' packages are
/// not looked at.
IterationTraffic iteration_traffic(const grid::Partition& partition, int rank,
                                   PreconditionerKind kind);

/// The same in words, of the rank that sends most bytes; empty on one rank. Collective.
std::string describe_traffic(const base::Communicator& communicator,
                             const grid::Partition& partition, PreconditionerKind kind);

}  // namespace stroma::solver
