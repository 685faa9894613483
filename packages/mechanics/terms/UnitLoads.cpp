// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/UnitLoads.hpp"

#include <cmath>

#include "stroma/mechanics/terms/ElasticForce.hpp"

namespace stroma::mechanics {
namespace {

/// Calls visit(n, index, position) for each owned node, n its number on this rank.
template <class Visit>
void for_each_owned_node(const Body& body, const Visit& visit) {
  const grid::Partition& partition = body.halo().partition();
  const grid::Box owned = partition.owned_nodes(body.communicator().rank());
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    visit(owned.local(node), node, partition.grid().node_position(node));
  });
}

}  // namespace

grid::Vector unit_displacement(const Body& body, int unit) {
  const grid::Grid& box = body.problem().body;
  const auto [i, j] = axes_of_unit(unit);
  const auto from_middle = [&](const std::array<double, 3>& x, int axis) {
    const auto d = static_cast<std::size_t>(axis);
    return x[d] - box.origin[d] - 0.5 * box.length(axis);
  };
  grid::Vector v(body.halo().owned_map());
  {
    const auto values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
    for_each_owned_node(body, [&, i = i, j = j](std::int64_t n, const grid::Index3&,
                                                const std::array<double, 3>& x) {
      const auto first = static_cast<std::size_t>(3 * n);
      values(first + static_cast<std::size_t>(i), 0) += 0.5 * from_middle(x, j);
      values(first + static_cast<std::size_t>(j), 0) += 0.5 * from_middle(x, i);
    });
  }
  return v;
}

grid::Vector unit_traction(const Body& body, int unit) {
  const grid::Grid& box = body.problem().body;
  const auto [i, j] = axes_of_unit(unit);
  // -1 and 1 on the two faces across an axis, 0 between them.
  const auto normal = [&](const grid::Index3& node, std::size_t d) {
    return node[d] == 0 ? -1.0 : (node[d] == box.elements[d] ? 1.0 : 0.0);
  };
  const auto length = [&](const grid::Index3& node, std::size_t d) {
    return box.spacing[d] * (normal(node, d) == 0.0 ? 1.0 : 0.5);
  };
  grid::Vector f(body.halo().owned_map());
  {
    const auto values = f.getLocalViewHost(Tpetra::Access::ReadWrite);
    for_each_owned_node(body, [&, i = i, j = j](std::int64_t n, const grid::Index3& node,
                                                const std::array<double, 3>&) {
      const auto add = [&](int component, int across) {
        const auto d = static_cast<std::size_t>(across);
        const double area = length(node, (d + 1) % 3) * length(node, (d + 2) % 3);
        values(static_cast<std::size_t>(3 * n + component), 0) += normal(node, d) * area;
      };
      add(i, j);
      if (i != j) add(j, i);
    });
  }
  return f;
}

void elastic_force(const Body& body, const grid::Vector& v, grid::Vector& force) {
  const grid::Vector at_rest(body.halo().owned_map());
  auto points = body.points(at_rest);
  // The halo has one buffer for gathered values: keep those of rest while v is gathered.
  const grid::NodeView displacement("u", points.displacement.extent(0));
  points.displacement = displacement;
  const ElasticForce stress(body.halo(), body.stress());
  const grid::ConstNodeView direction = body.halo().gather(v);
  const grid::NodeView sum = body.halo().contributions();
  stress.add_tangent_times({at_rest, points}, direction, sum);
  body.halo().sum_to_owner(force);
}

grid::Vector unit_load(const Body& body, UniformBoundary boundary, int unit) {
  if (boundary == UniformBoundary::traction) return unit_traction(body, unit);
  grid::Vector load(body.halo().owned_map());
  elastic_force(body, unit_displacement(body, unit), load);
  load.scale(-1.0);
  return load;
}

TermForce UnitLoads::force(const TrialState&, grid::Vector& force) const {
  force.putScalar(0.0);
  return {};
}

std::vector<grid::RCP<const grid::Vector>> UnitLoads::dead_loads() const {
  std::vector<grid::RCP<const grid::Vector>> loads;
  for (const int unit : units_)
    loads.push_back(Teuchos::rcp(new grid::Vector(unit_load(body_, boundary_, unit))));
  return loads;
}

}  // namespace stroma::mechanics
