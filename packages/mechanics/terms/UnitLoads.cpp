// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/UnitLoads.hpp"

#include <cmath>

#include "stroma/mechanics/terms/ElasticForce.hpp"

namespace stroma::mechanics {
namespace {

/// Calls visit(n, position) for each owned node, n its number on this rank.
template <class Visit>
void for_each_owned_node(const grid::Halo& halo, const Visit& visit) {
  const grid::Partition& partition = halo.partition();
  const grid::Box owned = partition.owned_nodes(halo.communicator().rank());
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    visit(owned.local(node), partition.grid().node_position(node));
  });
}

/// The forces of a unit stress on the nodes of hats, which may lie beyond the box as well.
grid::Vector traction_of_hats(const grid::Halo& halo, const grid::Grid& box, int unit) {
  const auto [i, j] = axes_of_unit(unit);
  using Position = std::array<double, 3>;
  // -1 and 1 on the two faces across an axis, 0 between them, 2 and -2 beyond.
  const auto side = [&](const Position& x, std::size_t d) {
    const double from_middle = x[d] - box.origin[d] - 0.5 * box.length(static_cast<int>(d));
    const double to_face =
        (std::abs(from_middle) - 0.5 * box.length(static_cast<int>(d))) / box.spacing[d];
    const double which = std::abs(to_face) < 1e-6 ? 1.0 : to_face < 0.0 ? 0.0 : 2.0;
    return std::copysign(which, from_middle);
  };
  const auto length = [&](const Position& x, std::size_t d) {
    const double at = std::abs(side(x, d));
    return at > 1.0 ? 0.0 : box.spacing[d] * (at == 1.0 ? 0.5 : 1.0);
  };
  grid::Vector f(halo.owned_map());
  {
    const auto values = f.getLocalViewHost(Tpetra::Access::ReadWrite);
    for_each_owned_node(halo, [&, i = i, j = j](std::int64_t n, const Position& x) {
      const auto add = [&](int component, int across) {
        const auto d = static_cast<std::size_t>(across);
        if (std::abs(side(x, d)) != 1.0) return;
        const double area = length(x, (d + 1) % 3) * length(x, (d + 2) % 3);
        values(static_cast<std::size_t>(3 * n + component), 0) += side(x, d) * area;
      };
      add(i, j);
      if (i != j) add(j, i);
    });
  }
  return f;
}

}  // namespace

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

UnitFields::UnitFields(const Body& body) : body_(body) {
  if (body.halo().partition().grid().width > 2) lattice_.emplace(body.halo());
}

grid::Vector UnitFields::displacement(int unit) const {
  const grid::Grid& box = body_.problem().body;
  const auto [i, j] = axes_of_unit(unit);
  const auto from_middle = [&](const std::array<double, 3>& x, int axis) {
    const auto d = static_cast<std::size_t>(axis);
    return x[d] - box.origin[d] - 0.5 * box.length(axis);
  };
  grid::Vector v(body_.halo().owned_map());
  {
    const auto values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
    for_each_owned_node(body_.halo(),
                        [&, i = i, j = j](std::int64_t n, const std::array<double, 3>& x) {
                          const auto first = static_cast<std::size_t>(3 * n);
                          values(first + static_cast<std::size_t>(i), 0) += 0.5 * from_middle(x, j);
                          values(first + static_cast<std::size_t>(j), 0) += 0.5 * from_middle(x, i);
                        });
  }
  return v;
}

grid::Vector UnitFields::traction(int unit) const {
  const grid::Grid& box = body_.problem().body;
  if (!lattice_) return traction_of_hats(body_.halo(), box, unit);
  grid::Vector forces(body_.halo().owned_map());
  lattice_->to_functions(traction_of_hats(lattice_->halo(), box, unit), forces);
  return forces;
}

grid::Vector UnitFields::load(UniformBoundary boundary, int unit) const {
  if (boundary == UniformBoundary::traction) return traction(unit);
  grid::Vector load(body_.halo().owned_map());
  elastic_force(body_, displacement(unit), load);
  load.scale(-1.0);
  return load;
}

TermForce UnitLoads::force(const TrialState&, grid::Vector& force) const {
  force.putScalar(0.0);
  return {};
}

std::vector<grid::RCP<const grid::Vector>> UnitLoads::dead_loads() const {
  const UnitFields fields(body_);
  std::vector<grid::RCP<const grid::Vector>> loads;
  for (const int unit : units_)
    loads.push_back(Teuchos::rcp(new grid::Vector(fields.load(boundary_, unit))));
  return loads;
}

}  // namespace stroma::mechanics
