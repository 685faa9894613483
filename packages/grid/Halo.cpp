#include "grid/Halo.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

namespace stroma::grid {
namespace {

RCP<const Map> map_of(const base::Communicator& communicator, const Partition& partition,
                      const Box& nodes, bool contiguous) {
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  if (contiguous) {
    return Teuchos::rcp(new Map(invalid, static_cast<std::size_t>(3 * nodes.count()), 0,
                                teuchos(communicator)));
  }
  Teuchos::Array<GlobalOrdinal> unknowns;
  unknowns.reserve(3 * nodes.count());
  for_each_index(nodes, [&](const Index3& node) {
    for (int c = 0; c < 3; ++c) unknowns.push_back(3 * partition.node_number(node) + c);
  });
  return Teuchos::rcp(new Map(invalid, unknowns(), 0, teuchos(communicator)));
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
      owned_(map_of(communicator, partition, partition.owned_nodes(communicator.rank()), true)),
      touched_(communicator.size() == 1
                   ? owned_
                   : map_of(communicator, partition, partition.touched_nodes(communicator.rank()),
                            false)),
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

}  // namespace stroma::grid
