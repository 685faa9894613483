// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The ranks that share a machine.

#include <mpi.h>

#include "stroma/base/Communicator.hpp"

namespace stroma::base {

/// A communicator of the ranks on this rank's machine, while it lives. Collective.
class Machine {
 public:
  explicit Machine(const Communicator& all) {
    MPI_Comm_split_type(all.raw(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &own_);
  }
  ~Machine() { MPI_Comm_free(&own_); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  Communicator ranks() const { return Communicator(own_); }

 private:
  MPI_Comm own_;
};

}  // namespace stroma::base
