// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/FindSupports.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/mechanics/conditions/FacesReached.hpp"
#include "stroma/particles/AxisLayout.hpp"
#include "stroma/particles/UndeformedPositions.hpp"

namespace stroma::mechanics {
namespace {

/// Marks the particles of the grip of a condition: those that lay in the outermost layer of
/// elements along its face (along all faces, for Face::all) when the body was undeformed.
Kokkos::View<std::uint8_t*, grid::Device> grip(const particles::Particles<grid::Device>& particles,
                                               const grid::Grid& body, Face face) {
  const auto X = particles::undeformed_positions(particles);
  const Kokkos::View<std::uint8_t*, grid::Device> gripped("gripped", particles.count());
  const auto mark = Kokkos::create_mirror_view(gripped);
  for (int p = 0; p < particles.count(); ++p)
    for (int d = 0; d < 3; ++d) {
      if (face != Face::all && axis_of(face) != d) continue;
      const double layer = std::floor(
          (X[static_cast<std::size_t>(p)][static_cast<std::size_t>(d)] - body.origin[d]) /
              body.spacing[d] +
          particles::face_tolerance);
      const bool lower = layer <= 0.0;
      const bool upper = layer >= static_cast<double>(body.elements[d] - 1);
      if (face == Face::all ? (lower || upper) : (is_upper(face) ? upper : lower)) mark(p) = 1;
    }
  Kokkos::deep_copy(gripped, mark);
  return gripped;
}

void add_elements(const Body& body, const Pieces& pieces, BodyStatics& statics) {
  const transfer::ElementBox& box = body.box();
  const auto begin =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body.particles().element_begin);
  for (int k = 0; k < box.elements[2]; ++k)
    for (int j = 0; j < box.elements[1]; ++j)
      for (int i = 0; i < box.elements[0]; ++i) {
        const int e = box.element(i, j, k);
        if (pieces.of_element(e) == Pieces::none) continue;
        const int index[3] = {i, j, k};
        std::array<double, 3> lower, upper;
        for (int d = 0; d < 3; ++d) {
          const auto c = static_cast<std::size_t>(d);
          box.within_ends(d, index[d], lower[c], upper[c]);
          for (double* end : {&lower[c], &upper[c]})
            *end = box.corner[d] + (index[d] + *end) * box.spacing[d];
        }
        statics.add_element(pieces.of_element(e), begin(e + 1) - begin(e), lower, upper);
      }
}

/// Calls use(piece, position, force) for each owned node of a piece.
template <class Use>
void for_each_force(const Body& body, const Pieces& pieces, const grid::Vector& force,
                    const Use& use) {
  const grid::Partition& partition = body.halo().partition();
  const int rank = body.communicator().rank();
  const grid::Box owned = partition.owned_nodes(rank), touched = partition.touched_nodes(rank);
  const auto value = force.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::int64_t n = 0; n < owned.count(); ++n) {
    const grid::Index3 node = owned.index(n);
    const int piece = pieces.of_node(touched.local(node));
    if (piece == Pieces::none) continue;
    use(piece, partition.grid().node_position(node),
        std::array<double, 3>{value(3 * n, 0), value(3 * n + 1, 0), value(3 * n + 2, 0)});
  }
}

}  // namespace

std::unique_ptr<Supports> find_supports(const Body& body, const OtherActions& others,
                                        double base_load, bool is_refused_if_loose) {
  const Problem& problem = body.problem();
  if (base_load == 0.0) refuse_faces_out_of_reach(body.communicator(), problem, body.particles());
  std::vector<Supports::NodeCounts> grips(problem.conditions.size());
  for (std::size_t m = 0; m < grips.size(); ++m) {
    const BoundaryCondition& condition = problem.conditions[m].second;
    if (problem.imposed_by(condition) == ImposedBy::grip)
      grips[m] = body.elements_around(grip(body.particles(), problem.body, *condition.face), false);
  }
  const int width = body.halo().partition().grid().width;
  const transfer::TouchedNodes<grid::Device> touched("touched nodes",
                                                     body.particles().element_begin.extent(0) - 1,
                                                     (width * width * width + 63) / 64);
  const auto filled_around = body.elements_around({}, true, touched);
  const Pieces pieces(body.halo(), body.box(), touched);

  BodyStatics statics(body.halo(), pieces, problem.body, others.loads.size());
  add_elements(body, pieces, statics);
  for (const auto& load : others.loads)
    for_each_force(body, pieces, *load, [&](int piece, const auto& position, const auto& force) {
      statics.add_load(piece, position, force);
    });
  if (others.stress != Teuchos::null) {
    // Rounding strains a piece that was carried along, too.
    const auto& h = body.box().spacing;
    const double negligible = 1e-12 * body.typical_diagonal() * std::min({h[0], h[1], h[2]});
    for_each_force(body, pieces, *others.stress, [&](int piece, const auto&, const auto& force) {
      const double size = std::hypot(force[0], force[1], force[2]);
      if (size > negligible) statics.add_stress(piece, size);
    });
  }
  return std::make_unique<Supports>(
      body.halo(), problem, base_load,
      SupportedBody{filled_around, grips, pieces,
                    [&](const HeldVisitor& visit) { others.visit_held(pieces, visit); },
                    is_refused_if_loose},
      statics);
}

}  // namespace stroma::mechanics
