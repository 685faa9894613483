#include "Specimen.hpp"

#include "base/Error.hpp"
#include "base/Stage.hpp"
#include "grid/ShapeGrid.hpp"
#include "image/ReadVolume.hpp"
#include "particles/Migration.hpp"

namespace stroma {

image::LabelVolume read_labels(const base::Communicator& communicator, const Deck& deck,
                               image::ImageSummary& summary) {
  const base::Stage stage("image");
  return image::read_labels(communicator, deck.parameters.image, deck.document.folder(), &summary);
}

Specimen make_specimen(const base::Communicator& communicator, const Deck& deck,
                       const image::LabelVolume& labels, const image::ImageSummary& summary) {
  const base::Stage stage("particles");
  const DeckParameters& p = deck.parameters;
  std::array<double, 3> length;
  for (int d = 0; d < 3; ++d)
    length[d] = static_cast<double>(labels.size[d]) * labels.voxel_size[d];
  grid::Grid grid = grid::make_grid(p.grid, length);
  if (p.image.region)  // positions are those in the whole image
    for (std::size_t d = 0; d < 3; ++d)
      grid.origin[d] = static_cast<double>((*p.image.region)[d]) * labels.voxel_size[d];

  const auto lattice = grid::Partition::balanced(
      grid, communicator.size(), particles::layer_weights(communicator, grid, labels));
  auto particles = particles::seed(communicator, p.particles, lattice, labels,
                                   material::material_of_label(p.materials.materials));
  const auto partition = grid::partition_for(p.grid.shape_functions, lattice);
  if (partition.grid().centered) particles = particles::migrate(communicator, partition, particles);
  Specimen specimen{summary, grid, partition, particles, {}, {}, 0};
  for (int d = 0; d < 3; ++d) {
    const double voxel = labels.voxel_size[static_cast<std::size_t>(d)];
    specimen.particle_spacing[static_cast<std::size_t>(d)] =
        particles::particle_spacing(p.particles, grid, d, voxel);
    specimen.particle_half_edge[static_cast<std::size_t>(d)] =
        particles::domain_half_edge(p.particles, grid, d, voxel);
  }
  specimen.particle_count = communicator.sum<std::int64_t>(specimen.particles.count());
  if (specimen.particle_count == 0)
    throw base::InputError("Image: every voxel is empty (label -1): there is nothing to compute");
  return specimen;
}

mechanics::Problem problem_of(const Deck& deck, const Specimen& specimen) {
  const DeckParameters& p = deck.parameters;
  mechanics::Problem problem;
  problem.body = specimen.body;
  problem.laws = material::laws(p.materials.materials);
  problem.conditions = p.boundary_conditions.conditions;
  problem.forces = p.external_forces.forces;
  for (const auto& named : p.materials.materials)
    if (named.second.density) problem.density.push_back(*named.second.density);
  if (problem.density.size() != problem.laws.size()) problem.density.clear();
  problem.particle_spacing = specimen.particle_spacing;
  problem.particle_half_edge = specimen.particle_half_edge;
  problem.shape_functions = p.grid.shape_functions;
  problem.particle_domain = p.grid.particle_domain;
  problem.dilatation = p.grid.dilatation;
  problem.reset = p.grid.reset;
  problem.deformation_gradient = p.grid.deformation_gradient;
  problem.stabilization = grid::stabilization(p.grid);
  return problem;
}

}  // namespace stroma
