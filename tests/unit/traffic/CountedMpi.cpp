// SPDX-License-Identifier: BSD-3-Clause

#include "unit/traffic/CountedMpi.hpp"

#include <mpi.h>

#include <set>

namespace {

stroma::grid::Traffic traffic;
std::set<int> receivers;

std::int64_t bytes_of(int count, MPI_Datatype type) {
  int size = 0;
  MPI_Type_size(type, &size);
  return std::int64_t{count} * size;
}

void count_message(int count, MPI_Datatype type, int receiver) {
  ++traffic.messages;
  traffic.bytes += bytes_of(count, type);
  receivers.insert(receiver);
}

}  // namespace

extern "C" {

int MPI_Send(const void* data, int count, MPI_Datatype type, int receiver, int tag, MPI_Comm comm) {
  count_message(count, type, receiver);
  return PMPI_Send(data, count, type, receiver, tag, comm);
}
int MPI_Ssend(const void* data, int count, MPI_Datatype type, int receiver, int tag,
              MPI_Comm comm) {
  count_message(count, type, receiver);
  return PMPI_Ssend(data, count, type, receiver, tag, comm);
}
int MPI_Rsend(const void* data, int count, MPI_Datatype type, int receiver, int tag,
              MPI_Comm comm) {
  count_message(count, type, receiver);
  return PMPI_Rsend(data, count, type, receiver, tag, comm);
}
int MPI_Isend(const void* data, int count, MPI_Datatype type, int receiver, int tag, MPI_Comm comm,
              MPI_Request* request) {
  count_message(count, type, receiver);
  return PMPI_Isend(data, count, type, receiver, tag, comm, request);
}
int MPI_Allreduce(const void* sent, void* received, int count, MPI_Datatype type, MPI_Op operation,
                  MPI_Comm comm) {
  ++traffic.reductions;
  traffic.reduced_bytes += bytes_of(count, type);
  return PMPI_Allreduce(sent, received, count, type, operation, comm);
}

}  // extern "C"

namespace stroma::test {

grid::Traffic counted(const std::function<void()>& work) {
  traffic = {};
  receivers.clear();
  work();
  traffic.neighbours = static_cast<int>(receivers.size());
  return traffic;
}

}  // namespace stroma::test
