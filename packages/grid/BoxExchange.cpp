// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/BoxExchange.hpp"

#include "stroma/base/Error.hpp"

namespace stroma::grid {
namespace {

constexpr int message_tag = 24007;  // unlike any of Tpetra's

/// Calls visit(value) for each value of the face of nodes `layer` along direction d.
template <class T, class Visit>
void for_each_on_face(const NodeField<T>& field, int d, int layer, const Visit& visit) {
  int begin[3] = {0, 0, 0}, end[3] = {field.nodes[0], field.nodes[1], field.nodes[2]};
  begin[d] = layer;
  end[d] = layer + 1;
  for (int k = begin[2]; k < end[2]; ++k)
    for (int j = begin[1]; j < end[1]; ++j)
      for (int c = 0; c < 3; ++c) {
        T* const line = field.line(c, j + field.nodes[1] * k);
        for (int i = begin[0]; i < end[0]; ++i) visit(line[i]);
      }
}

void expect_success(int code) {
  if (code != MPI_SUCCESS) throw base::RunError("MPI could not exchange nodes between neighbours");
}

}  // namespace

BoxExchange::BoxExchange(const base::Communicator& communicator, const LevelGrid& grid)
    : communicator_(communicator), grid_(grid) {}

template <class T>
void BoxExchange::sum_of(const NodeField<T>& field) const {
  for (int d = 0; d < 3; ++d) {
    const int neighbour[2] = {grid_.lower_neighbour(d), grid_.upper_neighbour(d)};
    const int layer[2] = {0, grid_.nodes(d) - 1};
    if (neighbour[0] < 0 && neighbour[1] < 0) continue;
    const int count = 3 * field.nodes[0] * field.nodes[1] * field.nodes[2] / field.nodes[d];
    std::vector<T> sent[2], received[2];
    MPI_Request request[4];
    int requests = 0;
    for (int side = 0; side < 2; ++side) {
      if (neighbour[side] < 0) continue;
      received[side].resize(static_cast<std::size_t>(count));
      sent[side].reserve(static_cast<std::size_t>(count));
      for_each_on_face(field, d, layer[side], [&](const T& value) { sent[side].push_back(value); });
      expect_success(MPI_Irecv(received[side].data(), count, base::mpi_type<T>(), neighbour[side],
                               message_tag + d, communicator_.raw(), &request[requests++]));
      expect_success(MPI_Isend(sent[side].data(), count, base::mpi_type<T>(), neighbour[side],
                               message_tag + d, communicator_.raw(), &request[requests++]));
    }
    expect_success(MPI_Waitall(requests, request, MPI_STATUSES_IGNORE));
    for (int side = 0; side < 2; ++side) {
      if (neighbour[side] < 0) continue;
      std::size_t n = 0;
      for_each_on_face(field, d, layer[side], [&](T& value) { value += received[side][n++]; });
    }
  }
}

template void BoxExchange::sum_of(const NodeField<float>&) const;
template void BoxExchange::sum_of(const NodeField<double>&) const;

}  // namespace stroma::grid
