// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/grid/Halo.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

namespace stroma::grid {
namespace {

RCP<const Map> make_owned_map(const base::Communicator& communicator, const Partition& partition) {
  const Box nodes = partition.owned_nodes(communicator.rank());
  return Teuchos::rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                              static_cast<std::size_t>(3 * nodes.count()), 0,
                              teuchos(communicator)));
}

RCP<const Map> make_touched_map(const RCP<const Map>& owned, const Partition& partition, int rank) {
  if (partition.ranks() == 1) return owned;
  const Box nodes = partition.touched_nodes(rank);
  Teuchos::Array<GlobalOrdinal> unknowns;
  unknowns.reserve(3 * nodes.count());
  for_each_index(nodes, [&](const Index3& node) {
    for (int c = 0; c < 3; ++c) unknowns.push_back(3 * partition.node_number(node) + c);
  });
  return Teuchos::rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), unknowns(),
                              0, owned->getComm()));
}

}  // namespace

RCP<const Teuchos::Comm<int>> teuchos(const base::Communicator& communicator) {
  return Teuchos::rcp(new Teuchos::MpiComm<int>(communicator.raw()));
}

NodeView node_view(Vector& vector) {
  const auto values = vector.getLocalViewDevice(Tpetra::Access::ReadWrite);
  return NodeView(values.data(), values.extent(0) / 3);
}

ConstNodeView node_view(const Vector& vector) {
  const auto values = vector.getLocalViewDevice(Tpetra::Access::ReadOnly);
  return ConstNodeView(values.data(), values.extent(0) / 3);
}

Halo::Halo(const base::Communicator& communicator, const Partition& partition)
    : communicator_(communicator),
      partition_(partition),
      owned_(make_owned_map(communicator, partition)),
      touched_(make_touched_map(owned_, partition, communicator.rank())),
      import_(Teuchos::rcp(new Tpetra::Import<>(owned_, touched_))),
      gathered_(touched_),
      contributed_(touched_) {}

ConstNodeView Halo::gather(const Vector& owned) const {
  gathered_.doImport(owned, *import_, Tpetra::REPLACE);
  return node_view(static_cast<const Vector&>(gathered_));
}

NodeView Halo::contributions() const {
  contributed_.putScalar(0.0);
  return node_view(contributed_);
}

void Halo::sum_to_owner(Vector& owned) const {
  owned.putScalar(0.0);
  owned.doExport(contributed_, *import_, Tpetra::ADD);
}

void Halo::largest_to_owner(Vector& owned) const {
  owned.putScalar(0.0);
  owned.doExport(contributed_, *import_, Tpetra::ABSMAX);
}

}  // namespace stroma::grid
