// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Small bodies for tests: a grid, an image made by a function, particles, and the balance of
/// momentum.

#include <functional>
#include <memory>
#include <vector>

#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/mechanics/MovingBody.hpp"
#include "stroma/particles/Migration.hpp"
#include "stroma/particles/Seeding.hpp"

namespace stroma::test {

/// What a small body is made of. The defaults are the block A of the reference solutions.
struct Specimen {
  grid::Index3 elements{4, 4, 4};
  std::array<double, 3> spacing{2.1, 2.1, 2.0};  ///< [um]
  std::array<double, 3> origin{0.0, 0.0, 0.0};   ///< [um]
  std::array<std::int64_t, 3> voxels_per_element{2, 2, 2};
  std::array<std::int64_t, 3> image_size{};  ///< voxels in all, instead of voxels_per_element
  std::function<std::int32_t(const grid::Index3&)> label;  ///< of a voxel; none: all 0
  particles::ParticleParameters layout{particles::Layout::gauss, 1, 2};
  std::vector<material::NeoHookean> laws{{520.8, 2430.4}, {1041.6, 4860.8}};  ///< of labels 0 and 1
  std::optional<mechanics::Laws> other_laws;  ///< in place of `laws`, for as many labels
  mechanics::NamedConditions conditions;
  bool plane_strain = false;
  bool reset = false;
  bool springs_pull_on = false;
  mechanics::NamedForces forces;
  decltype(mechanics::Problem::body_force) body_force;  ///< [pN/um^3], at X
  std::vector<double> density;                          ///< of each law [kg/m^3]
  std::vector<mechanics::MaterialDrives> drives;        ///< of each law
  std::optional<mechanics::Dynamics> dynamics;
  double duration = 1.0;  ///< [s]
  double stabilization = 0.0;
  shape::ShapeFunctions shape_functions = shape::ShapeFunctions::linear;
  mechanics::ParticleDomain particle_domain = mechanics::ParticleDomain::stretched;
  mechanics::Dilatation dilatation = mechanics::Dilatation::pointwise;
  mechanics::DeformationGradient deformation_gradient = mechanics::DeformationGradient::incremental;

  grid::Grid grid() const {
    grid::Grid grid;
    grid.elements = elements;
    grid.spacing = spacing;
    grid.origin = origin;
    grid.flat = plane_strain;
    return grid;
  }

  std::array<std::int64_t, 3> voxels() const {
    if (image_size[0] > 0) return image_size;
    std::array<std::int64_t, 3> size;
    for (std::size_t d = 0; d < 3; ++d) size[d] = elements[d] * voxels_per_element[d];
    return size;
  }
  std::array<double, 3> voxel_size() const {
    std::array<double, 3> edge;
    for (std::size_t d = 0; d < 3; ++d)
      edge[d] = image_size[d] > 0
                    ? grid().length(static_cast<int>(d)) / static_cast<double>(image_size[d])
                    : spacing[d] / static_cast<double>(voxels_per_element[d]);
    return edge;
  }

  voxels::LabelVolume labels(const base::Communicator& communicator) const {
    const std::array<std::int64_t, 3> size = voxels();
    voxels::LabelVolume volume(communicator, size, voxel_size());
    if (!label) return volume;
    std::size_t n = 0;
    for (std::int64_t k = 0; k < volume.planes; ++k)
      for (std::int64_t j = 0; j < size[1]; ++j)
        for (std::int64_t i = 0; i < size[0]; ++i)
          volume.values[n++] = label({i, j, volume.first_plane + k});
    return volume;
  }

  /// Of the lattice of elements that fills the body.
  grid::Partition lattice(const base::Communicator& communicator) const {
    return grid::Partition::balanced(
        grid(), communicator.size(),
        particles::layer_weights(communicator, grid(), labels(communicator)));
  }

  /// Of the grid that the shape functions need.
  grid::Partition partition(const base::Communicator& communicator) const {
    return grid::partition_for(shape_functions, lattice(communicator));
  }

  particles::Particles<grid::Device> particles(const base::Communicator& communicator) const {
    std::map<std::int32_t, int> material_of_label;
    for (std::size_t m = 0; m < laws.size(); ++m)
      material_of_label[static_cast<std::int32_t>(m)] = static_cast<int>(m);
    const auto seeded = particles::seed(communicator, layout, lattice(communicator),
                                        labels(communicator), material_of_label);
    const grid::Partition cells = partition(communicator);
    return cells.grid().centered ? particles::migrate(communicator, cells, seeded) : seeded;
  }

  mechanics::Problem problem() const {
    mechanics::Problem problem;
    problem.body = grid();
    problem.laws = other_laws ? *other_laws : mechanics::Laws(laws);
    problem.conditions = conditions;
    problem.forces = forces;
    problem.body_force = body_force;
    problem.density = density;
    problem.drives = drives;
    problem.dynamics = dynamics;
    problem.duration = duration;
    const auto sizes = particles::layout_sizes(layout, problem.body, voxels(), voxel_size());
    problem.outer_thickness = sizes.outer_thickness;
    problem.particle_half_edge = sizes.half_edge;
    problem.method.reset = reset;
    problem.method.springs_pull_on = springs_pull_on;
    problem.method.shape_functions = shape_functions;
    problem.method.particle_domain = particle_domain;
    problem.method.dilatation = dilatation;
    problem.method.deformation_gradient = deformation_gradient;
    problem.method.stabilization = stabilization;
    return problem;
  }

  mechanics::MovingBody moving_body(const base::Communicator& communicator) const {
    return {communicator, partition(communicator), particles(communicator), problem()};
  }

  std::unique_ptr<mechanics::MomentumBalance> balance(
      const base::Communicator& communicator) const {
    return std::make_unique<mechanics::MomentumBalance>(communicator, partition(communicator),
                                                        particles(communicator), problem());
  }
};

/// Label 1 in two crossing bars, 0 elsewhere; for images of 8 voxels and more per direction.
inline std::int32_t crossing_bars(const grid::Index3& voxel) {
  const bool along_y = voxel[0] >= 2 && voxel[0] < 5 && voxel[2] >= 3 && voxel[2] < 6;
  const bool along_x = voxel[1] >= 3 && voxel[1] < 5 && voxel[2] >= 2 && voxel[2] < 5;
  return along_y || along_x ? 1 : 0;
}

using mechanics::hold;

/// A condition on a face that moves components by a strain.
inline mechanics::BoundaryCondition stretch(mechanics::Face face, const std::string& components,
                                            double strain) {
  mechanics::BoundaryCondition condition = hold(face, components);
  condition.strain = strain;
  return condition;
}

/// Clamped at y-, pulled at the clamped y+.
inline mechanics::NamedConditions clamped(double strain) {
  return {{"bottom", hold(mechanics::Face::y_lower, "xyz")},
          {"top", stretch(mechanics::Face::y_upper, "xyz", strain)}};
}

/// Sets a vector of unknowns from a function value(node, component).
template <class Function>
void fill(const grid::Halo& halo, grid::Vector& vector, const Function& value) {
  const grid::Box owned = halo.partition().owned_nodes(halo.communicator().rank());
  const auto values = vector.getLocalViewHost(Tpetra::Access::OverwriteAll);
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    for (int c = 0; c < 3; ++c) values(3 * owned.local(node) + c, 0) = value(node, c);
  });
}

/// Calls visit(node, component, value) for each unknown that this rank owns.
template <class Function>
void for_each_unknown(const grid::Halo& halo, const grid::Vector& vector, const Function& visit) {
  const grid::Box owned = halo.partition().owned_nodes(halo.communicator().rank());
  const auto values = vector.getLocalViewHost(Tpetra::Access::ReadOnly);
  grid::for_each_index(owned, [&](const grid::Index3& node) {
    for (int c = 0; c < 3; ++c) visit(node, c, values(3 * owned.local(node) + c, 0));
  });
}

/// A number between -1 and 1 that depends on node and component alone, without pattern.
inline double scatter(const grid::Index3& node, int component, int seed = 0) {
  const auto n = static_cast<double>(node[0] + 31 * node[1] + 977 * node[2] + 7919 * component);
  const double x = std::sin(12.9898 * n + 78.233 * (seed + 1)) * 43758.5453;
  return 2.0 * (x - std::floor(x)) - 1.0;
}

/// u = G (X - origin), at a node.
inline double linear_field(const grid::Grid& grid, const std::array<double, 9>& G,
                           const grid::Index3& node, int component) {
  const auto x = grid.node_position(node);
  double sum = 0.0;
  for (std::size_t d = 0; d < 3; ++d)
    sum += G[static_cast<std::size_t>(3 * component) + d] * (x[d] - grid.origin[d]);
  return sum;
}

}  // namespace stroma::test
