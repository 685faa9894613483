// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Records that ranks send to each other, and the home to which a particle's results return.

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::particles {

/// The records that the other ranks (and this one) have for this rank, in rank order. Collective.
/// \param communicator  of the ranks that exchange
/// \param for_rank      (rank) what to send to it
template <class Record>
std::vector<Record> exchange(const base::Communicator& communicator,
                             const std::vector<std::vector<Record>>& for_rank) {
  static_assert(std::is_trivially_copyable_v<Record>);
  const auto ranks = static_cast<std::size_t>(communicator.size());
  std::vector<int> send(ranks), send_begin(ranks + 1, 0), receive(ranks), receive_begin(ranks + 1);
  std::vector<Record> outgoing;
  for (std::size_t r = 0; r < ranks; ++r) {
    send[r] = static_cast<int>(for_rank[r].size());
    send_begin[r + 1] = send_begin[r] + send[r];
    outgoing.insert(outgoing.end(), for_rank[r].begin(), for_rank[r].end());
  }
  MPI_Alltoall(send.data(), 1, MPI_INT, receive.data(), 1, MPI_INT, communicator.raw());
  receive_begin[0] = 0;
  for (std::size_t r = 0; r < ranks; ++r) receive_begin[r + 1] = receive_begin[r] + receive[r];
  std::vector<Record> incoming(static_cast<std::size_t>(receive_begin[ranks]));
  MPI_Datatype type;  // whole records, so that counts stay far below 2^31
  MPI_Type_contiguous(sizeof(Record), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(outgoing.data(), send.data(), send_begin.data(), type, incoming.data(),
                receive.data(), receive_begin.data(), type, communicator.raw());
  MPI_Type_free(&type);
  return incoming;
}

/// A field's values of the particles that the other ranks send, in rank order. Collective.
/// \param communicator  of the ranks that exchange
/// \param leave         (rank) the particles that go there
/// \param values        (particle, number) on the host
/// \param numbers       of a particle; the same on all ranks
template <class T>
std::vector<T> exchange_values(const base::Communicator& communicator,
                               const std::vector<std::vector<int>>& leave, const T* values,
                               std::size_t numbers) {
  std::vector<std::vector<T>> for_rank(leave.size());
  for (std::size_t r = 0; r < leave.size(); ++r) {
    for_rank[r].reserve(numbers * leave[r].size());
    for (const int p : leave[r]) {
      const T* const first = values + numbers * static_cast<std::size_t>(p);
      for_rank[r].insert(for_rank[r].end(), first, first + numbers);
    }
  }
  return particles::exchange(communicator, for_rank);
}

/// The place to which the results of a particle return, however far it has moved: the rank that
/// seeded it, and its number there. Files keep one order of particles from the first step to the
/// last.
inline std::int64_t home_of(int rank, int number) {
  return (static_cast<std::int64_t>(rank) << 32) + number;
}
inline int home_rank(std::int64_t home) { return static_cast<int>(home >> 32); }
inline int home_number(std::int64_t home) { return static_cast<int>(home & 0x7fffffff); }

}  // namespace stroma::particles
