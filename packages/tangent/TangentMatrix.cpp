// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/tangent/TangentMatrix.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace stroma::tangent {
namespace {

constexpr std::uint16_t no_neighbour = 65535;

grid::Index3 neighbour(const grid::Index3& node, int reach, int s) {
  const int side = 2 * reach + 1;
  return {node[0] + s % side - reach, node[1] + s / side % side - reach,
          node[2] + s / (side * side) - reach};
}

/// Map of whole nodes (not unknowns).
grid::RCP<const grid::Map> node_map(const grid::Halo& halo,
                                    const std::vector<grid::Index3>& nodes) {
  Teuchos::Array<grid::GlobalOrdinal> numbers;
  for (const auto& node : nodes) numbers.push_back(halo.partition().node_number(node));
  return Teuchos::rcp(new grid::Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                                    numbers(), 0, halo.owned_map()->getComm()));
}

}  // namespace

TangentMatrix::TangentMatrix(const grid::Halo& halo,
                             const Kokkos::View<std::uint8_t*, Device>& held, double diagonal)
    : halo_(&halo), diagonal_(diagonal), reach_(halo.partition().grid().width - 1) {
  const int side = 2 * reach_ + 1;
  stencil_ = side * side * side;
  rows_.held = held;
  build_graph();
  build_exchange();
}

void TangentMatrix::build_graph() {
  const grid::Partition& partition = halo_->partition();
  const int rank = halo_->communicator().rank();
  const grid::Box all = partition.grid().all_nodes();
  const grid::Box owned = partition.owned_nodes(rank);
  grid::Box columns = owned;
  for (int d = 0; d < 3; ++d) {
    columns.begin[d] = std::max(columns.begin[d] - reach_, all.begin[d]);
    columns.end[d] = std::min(columns.end[d] + reach_, all.end[d]);
  }

  // Columns: owned nodes first, then the others by their number, so that those of one rank stand
  // together. Packages of Trilinos (aggregation in MueLu) count on that order.
  std::vector<int> column_of(static_cast<std::size_t>(columns.count()));
  std::vector<std::pair<std::int64_t, std::int64_t>> ghosts;  // node number, place in the box
  grid::for_each_index(columns, [&](const grid::Index3& node) {
    if (owned.contains(node)) {
      column_of[static_cast<std::size_t>(columns.local(node))] =
          static_cast<int>(owned.local(node));
    } else {
      ghosts.emplace_back(partition.node_number(node), columns.local(node));
    }
  });
  std::sort(ghosts.begin(), ghosts.end());
  Teuchos::Array<grid::GlobalOrdinal> column_unknowns;
  column_unknowns.reserve(3 * columns.count());
  for (std::int64_t unknown = 0; unknown < 3 * owned.count(); ++unknown)
    column_unknowns.push_back(3 * partition.first_node(rank) + unknown);
  for (std::size_t g = 0; g < ghosts.size(); ++g) {
    column_of[static_cast<std::size_t>(ghosts[g].second)] =
        static_cast<int>(owned.count()) + static_cast<int>(g);
    for (int c = 0; c < 3; ++c) column_unknowns.push_back(3 * ghosts[g].first + c);
  }

  // Rows: the columns of a row must be sorted, or Tpetra's products are silently wrong.
  slot_ = decltype(slot_)("slot", static_cast<std::size_t>(owned.count()),
                          static_cast<std::size_t>(stencil_));
  row_begin_ = decltype(row_begin_)("row_begin", static_cast<std::size_t>(3 * owned.count() + 1));
  const auto slot = Kokkos::create_mirror_view(slot_);
  const auto row_begin = Kokkos::create_mirror_view(row_begin_);
  std::vector<int> sorted;
  std::vector<int> blocks_of_node;
  blocks_of_node.reserve(static_cast<std::size_t>(stencil_ * owned.count()));
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    const std::int64_t n = owned.local(node);
    sorted.clear();
    for (int s = 0; s < stencil_; ++s) {
      const grid::Index3 other = neighbour(node, reach_, s);
      if (all.contains(other))
        sorted.push_back(column_of[static_cast<std::size_t>(columns.local(other))]);
    }
    std::sort(sorted.begin(), sorted.end());
    for (int s = 0; s < stencil_; ++s) {
      slot(n, s) = no_neighbour;
      const grid::Index3 other = neighbour(node, reach_, s);
      if (!all.contains(other)) continue;
      const int column = column_of[static_cast<std::size_t>(columns.local(other))];
      slot(n, s) = static_cast<std::uint16_t>(
          std::lower_bound(sorted.begin(), sorted.end(), column) - sorted.begin());
    }
    for (int i = 0; i < 3; ++i) row_begin(3 * n + i + 1) = row_begin(3 * n + i) + 3 * sorted.size();
    blocks_of_node.insert(blocks_of_node.end(), sorted.begin(), sorted.end());
  });
  using Graph = Matrix::crs_graph_type;
  using LocalGraph = Graph::local_graph_device_type;
  LocalGraph::entries_type::non_const_type entries(
      Kokkos::view_alloc("entries", Kokkos::WithoutInitializing), row_begin(3 * owned.count()));
  const auto entry = Kokkos::create_mirror_view(entries);
  std::size_t first_block = 0;
  for (std::int64_t n = 0; n < owned.count(); ++n) {
    const std::size_t blocks = (row_begin(3 * n + 1) - row_begin(3 * n)) / 3;
    for (int i = 0; i < 3; ++i)
      for (std::size_t b = 0; b < blocks; ++b)
        for (int k = 0; k < 3; ++k)
          entry(row_begin(3 * n + i) + 3 * b + static_cast<std::size_t>(k)) =
              3 * blocks_of_node[first_block + b] + k;
    first_block += blocks;
  }
  Kokkos::deep_copy(entries, entry);
  Kokkos::deep_copy(slot_, slot);
  Kokkos::deep_copy(row_begin_, row_begin);

  const auto column_map =
      Teuchos::rcp(new grid::Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                                 column_unknowns(), 0, halo_->owned_map()->getComm()));
  const auto graph = Teuchos::rcp(
      new Graph(halo_->owned_map(), column_map, LocalGraph::row_map_type(row_begin_), entries));
  graph->fillComplete(halo_->owned_map(), halo_->owned_map());
  matrix_ = Teuchos::rcp(new Matrix(graph));
  matrix_->fillComplete();

  rows_.slot = slot_;
  rows_.row_begin = row_begin_;
  rows_.values = matrix_->getLocalMatrixDevice().values;
}

void TangentMatrix::build_exchange() {
  const grid::Partition& partition = halo_->partition();
  const int rank = halo_->communicator().rank();
  const grid::Box owned = partition.owned_nodes(rank);
  const grid::Box touched = partition.touched_nodes(rank);
  row_ = decltype(row_)("row", static_cast<std::size_t>(touched.count()));
  const auto row = Kokkos::create_mirror_view(row_);
  std::vector<grid::Index3> shared;
  grid::for_each_index(touched, [&](const grid::Index3& node) {
    if (owned.contains(node)) {
      row(touched.local(node)) = static_cast<int>(owned.local(node));
    } else {
      row(touched.local(node)) = ~static_cast<int>(shared.size());
      shared.push_back(node);
    }
  });
  Kokkos::deep_copy(row_, row);
  rows_.row = row_;
  if (halo_->communicator().size() == 1) return;

  std::vector<grid::Index3> received;  // owned nodes near the lower faces, which neighbours touch
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    for (int d = 0; d < 3; ++d)
      if (node[d] < owned.begin[d] + reach_ && owned.begin[d] > 0) {
        received.push_back(node);
        break;
      }
  });
  shared_ = Teuchos::rcp(new grid::MultiVector(node_map(*halo_, shared), 9 * stencil_));
  received_ = Teuchos::rcp(new grid::MultiVector(node_map(*halo_, received), 9 * stencil_));
  export_ = Teuchos::rcp(new Tpetra::Export<>(shared_->getMap(), received_->getMap()));
  received_node_ = decltype(received_node_)("received_node", received.size());
  const auto received_node = Kokkos::create_mirror_view(received_node_);
  for (std::size_t r = 0; r < received.size(); ++r)
    received_node(r) = static_cast<int>(owned.local(received[r]));
  Kokkos::deep_copy(received_node_, received_node);
}

transfer::BlockRows<grid::Device> TangentMatrix::begin() {
  Kokkos::deep_copy(rows_.values, 0.0);
  if (shared_ != Teuchos::null) {
    shared_->putScalar(0.0);
    rows_.shared = shared_->getLocalViewDevice(Tpetra::Access::ReadWrite);
  }
  return rows_;
}

void TangentMatrix::finish() {
  using Policy = Kokkos::RangePolicy<grid::ExecutionSpace>;
  const auto rows = rows_;
  const int stencil = stencil_, own = stencil_ / 2;
  rows_.shared = {};
  if (shared_ != Teuchos::null) {
    received_->putScalar(0.0);
    received_->doExport(*shared_, *export_, Tpetra::ADD);
    const auto blocks = received_->getLocalViewDevice(Tpetra::Access::ReadOnly);
    const auto node_of = received_node_;
    Kokkos::parallel_for(
        "add received rows", Policy(0, static_cast<int>(node_of.extent(0))),
        KOKKOS_LAMBDA(const int r) {
          const int n = node_of(r);
          for (int s = 0; s < stencil; ++s) {
            if (rows.slot(n, s) == no_neighbour) continue;
            for (int i = 0; i < 3; ++i)
              for (int k = 0; k < 3; ++k)
                rows.values(rows.row_begin(3 * n + i) + 3 * rows.slot(n, s) + k) +=
                    blocks(r, 9 * s + 3 * i + k);
          }
        });
  }
  const double diagonal = diagonal_;
  Kokkos::parallel_for(
      "prescribed diagonal", Policy(0, static_cast<int>(rows.row.extent(0))),
      KOKKOS_LAMBDA(const int touched) {
        const int n = rows.row(touched);
        if (n < 0) return;
        for (int c = 0; c < 3; ++c)
          if (rows.held(touched) >> c & 1)
            rows.values(rows.row_begin(3 * n + c) + 3 * rows.slot(n, own) + c) = diagonal;
      });
}

}  // namespace stroma::tangent
