// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Unknowns at nodes: the maps that say which rank owns them, and the exchange between neighbours.

#include <Tpetra_Import.hpp>

#include "stroma/base/Communicator.hpp"
#include "stroma/grid/Partition.hpp"
#include "stroma/grid/Types.hpp"

namespace stroma::grid {

/// Three unknowns per node of the grid: 3 n + c for node number n (Partition::node_number),
/// component c. A rank computes with the nodes that its elements touch; the solvers see the nodes
/// that it owns.
class Halo {
 public:
  Halo(const base::Communicator& communicator, const Partition& partition);

  /// Unknowns that this rank owns; one-to-one, contiguous, in the order of
  /// Partition::owned_nodes().
  const RCP<const Map>& owned_map() const { return owned_; }
  /// Unknowns of the nodes that this rank's elements touch, in the order of
  /// Partition::touched_nodes().
  const RCP<const Map>& touched_map() const { return touched_; }
  const Partition& partition() const { return partition_; }
  const base::Communicator& communicator() const { return communicator_; }

  /// Values at the touched nodes, taken from their owners. Collective. The view stays valid until
  /// the next call.
  ConstNodeView gather(const Vector& owned) const;

  /// Space for contributions at the touched nodes, zeroed; hand it back with sum_to_owner().
  NodeView contributions() const;

  /// owned = sum over ranks of the contributions at touched nodes. Collective.
  void sum_to_owner(Vector& owned) const;
  /// owned = the largest of the ranks' contributions, which must not be negative. Collective.
  void largest_to_owner(Vector& owned) const;

 private:
  base::Communicator communicator_;
  Partition partition_;
  RCP<const Map> owned_;
  RCP<const Map> touched_;
  RCP<const Tpetra::Import<>> import_;
  mutable Vector gathered_;
  mutable Vector contributed_;
};

/// View of a vector's values as (node, component).
NodeView node_view(Vector& vector);
ConstNodeView node_view(const Vector& vector);

/// A new Teuchos communicator over the same ranks. Objects that exchange messages share one (that
/// of the owned map): each counts its own message tags.
RCP<const Teuchos::Comm<int>> teuchos(const base::Communicator& communicator);

}  // namespace stroma::grid
