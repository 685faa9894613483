// SPDX-License-Identifier: BSD-3-Clause

#include "run/Specimen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "run/LoadNotes.hpp"
#include "run/MeasuredFields.hpp"
#include "run/MemoryEstimate.hpp"
#include "run/OwnNumbers.hpp"
#include "run/ResolutionNotes.hpp"
#include "run/WithoutEffect.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/labels/Fragments.hpp"
#include "stroma/mechanics/conditions/FacesReached.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/particles/Migration.hpp"
#include "stroma/solver/CurveNotes.hpp"

namespace stroma {

namespace {

/// The grid over an image, or over the region of it that is read.
grid::Grid body_of(const DeckParameters& p, const std::array<std::int64_t, 3>& voxels,
                   const std::array<double, 3>& voxel_size) {
  std::array<double, 3> length;
  for (std::size_t d = 0; d < 3; ++d) length[d] = static_cast<double>(voxels[d]) * voxel_size[d];
  grid::Grid grid = mechanics::make_grid(p.grid, length);
  if (p.image.region)  // positions are those in the whole image
    for (std::size_t d = 0; d < 3; ++d)
      grid.origin[d] = static_cast<double>((*p.image.region)[d]) * voxel_size[d];
  return grid;
}

/// Of the voxels, over all ranks.
double filled_fraction(const base::Communicator& communicator, const voxels::LabelVolume& labels) {
  const auto filled = static_cast<std::int64_t>(
      std::count_if(labels.values.begin(), labels.values.end(), [](auto l) { return l >= 0; }));
  return static_cast<double>(communicator.sum(filled)) / static_cast<double>(labels.voxels());
}

/// How far the conditions and tractions on the body's faces reach into the image, in whole elements
/// whose particles have shape functions there.
image::FaceReach reach_of_conditions(const DeckParameters& p, const grid::Grid& body,
                                     const voxels::LabelVolume& labels) {
  std::vector<mechanics::Face> faces;
  for (const auto& [name, condition] : p.boundary_conditions.conditions)
    if (condition.face) faces.push_back(*condition.face);
  for (const auto& [name, force] : p.external_forces.forces)
    if (force.face) faces.push_back(*force.face);
  if (asks_for_stiffness(p)) faces.push_back(mechanics::Face::all);
  const int elements = grid::grid_for(p.grid.shape_functions, body).width - 1;
  image::FaceReach reach{};
  for (const mechanics::Face face : faces)
    for (int d = 0; d < 3; ++d) {
      if (face != mechanics::Face::all && mechanics::axis_of(face) != d) continue;
      const auto voxels = static_cast<std::int64_t>(
          std::ceil(elements * body.spacing[d] / labels.voxel_size[static_cast<std::size_t>(d)]));
      for (const bool is_upper : {false, true})
        if (face == mechanics::Face::all || mechanics::is_upper(face) == is_upper)
          reach[static_cast<std::size_t>(d)][is_upper ? 1 : 0] = voxels;
    }
  return reach;
}

/// Whether forces act on all of the body, wherever it is.
bool has_volume_forces(const mechanics::NamedForces& forces) {
  return std::any_of(forces.begin(), forces.end(),
                     [](const auto& named) { return !named.second.traction; });
}

/// Hats have kinks at the faces of elements, which particles cross.
std::string crossing_note(const mechanics::GridParameters& p) {
  if (!p.reset || p.shape_functions != shape::ShapeFunctions::linear) return "";
  return "Shape Functions = Linear on a grid that is reset: where particles cross the faces of "
         "elements, forces fall by some per cent and stresses scatter; GIMP and CPDI do without";
}

/// Materials that no particle is of, as where a threshold is too high or a label another one.
std::vector<std::string> unused_materials_notes(const base::Communicator& communicator,
                                                const material::NamedMaterials& materials,
                                                const particles::Particles<grid::Device>& seeded) {
  std::vector<std::int64_t> particles(materials.size(), 0);
  const auto material = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), seeded.material);
  for (std::size_t p = 0; p < material.extent(0); ++p)
    ++particles[static_cast<std::size_t>(material(p))];
  communicator.sum_all(particles.data(), particles.size());
  std::vector<std::string> notes;
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (particles[m] == 0)
      notes.push_back(base::format("Materials|%s: no particle is of this material (label %d)",
                                   materials[m].first.c_str(), materials[m].second.label));
  return notes;
}

}  // namespace

SpecimenImage read_image(const base::Communicator& communicator, const Deck& deck) {
  const base::Stage stage("image");
  const DeckParameters& p = deck.parameters;
  SpecimenImage image;
  voxels::LabelVolume& labels = image.labels;
  labels = image::read_labels(
      communicator, p.image, deck.document.folder(), &image.summary,
      [&](const image::ImageSummary& found) {  // how much of it is empty, nobody knows yet
        const grid::Grid body = body_of(p, found.size, found.voxel_size.um);
        require_memory(communicator, p, found.size, body, 0.0);
      },
      material::read_the_specimens_image(p.materials.materials) ? &image.intensities : nullptr);
  std::optional<image::FaceReach> reach;
  if (!has_volume_forces(p.external_forces.forces))  // a fragment that they load is an error
    reach = reach_of_conditions(p, body_of(p, labels.size, labels.voxel_size), labels);
  const image::Bodies bodies = image::leave_out_fragments(communicator, labels, reach);
  image.bodies = bodies.count;
  if (!bodies.note.empty()) image.summary.notes.push_back(bodies.note);
  return image;
}

namespace {

/// Where a traction acts on a part of its face only: the body has gaps there.
std::vector<std::string> traction_notes(const base::Communicator& communicator,
                                        const mechanics::NamedForces& forces,
                                        const Specimen& specimen) {
  std::vector<std::string> notes;
  const auto acts_on_a_face = [](const auto& named) { return named.second.traction.has_value(); };
  if (std::none_of(forces.begin(), forces.end(), acts_on_a_face)) return notes;
  const auto shares = mechanics::filled_shares_of_faces(
      communicator, specimen.body, specimen.layout.outer_thickness, specimen.particles);
  for (const auto& [name, force] : forces) {
    if (!force.traction) continue;
    const double share = shares[static_cast<std::size_t>(*force.face)];
    if (share > 0.0 && share < 1.0 - 1e-9)
      notes.push_back(base::format(
          "External Forces|%s: the body fills %.3g %% of its face; the traction acts on that part",
          name.c_str(), 100.0 * share));
  }
  return notes;
}

}  // namespace

namespace {

std::vector<image::Widths> widths_of(const base::Communicator& communicator,
                                     const material::NamedMaterials& materials,
                                     const voxels::LabelVolume& labels) {
  std::vector<std::int32_t> wanted;
  for (const auto& [name, material] : materials) wanted.push_back(material.label);
  return image::widths(communicator, labels, wanted);
}

}  // namespace

Specimen make_specimen(const base::Communicator& communicator, const Deck& deck,
                       const SpecimenImage& image) {
  const base::Stage stage("particles");
  const DeckParameters& p = deck.parameters;
  const voxels::LabelVolume& labels = image.labels;
  const material::NamedMaterials& materials = p.materials.materials;
  const grid::Grid grid = body_of(p, labels.size, labels.voxel_size);
  require_memory(communicator, p, labels.size, grid, filled_fraction(communicator, labels));

  const auto lattice = grid::Partition::balanced(
      grid, communicator.size(), particles::layer_weights(communicator, grid, labels));
  const bool vary = material::vary(materials);
  particles::ParticleVoxels where;
  auto particles = particles::seed(communicator, p.particles, lattice, labels,
                                   material::material_of_label(materials), vary ? &where : nullptr);
  OwnNumbers own;
  ReadImages seen{image.summary.files, {}};
  if (vary) {
    FieldImages images(communicator, deck, image, where, seen);
    own = give_own_numbers(communicator, images, materials, particles);
  }
  const auto partition = grid::partition_for(p.grid.shape_functions, lattice);
  auto displacements = measured_displacements(communicator, deck, grid, partition, seen);
  auto velocities = measured_velocities(communicator, deck, grid, partition, seen);
  if (partition.grid().centered) particles = particles::migrate(communicator, partition, particles);
  Specimen specimen{image.summary,
                    grid,
                    partition,
                    particles,
                    particles::layout_sizes(p.particles, grid, labels.size, labels.voxel_size),
                    particles::layout_notes(p.particles, grid, labels.size),
                    widths_of(communicator, materials, labels),
                    image.bodies,
                    0,
                    "",
                    {},
                    {},
                    {},
                    std::move(displacements),
                    std::move(velocities),
                    std::move(seen.files)};
  const material::Compressibility of_volume = material::compressibility(materials);
  specimen.dilatation = mechanics::describe_dilatation(p.grid, of_volume);
  const std::string locking = mechanics::locking_note(p.grid, of_volume);
  if (!locking.empty()) specimen.notes.push_back(locking);
  const std::string crossing = crossing_note(p.grid);
  if (!crossing.empty()) specimen.notes.push_back(crossing);
  for (std::string& note : resolution_notes(p, specimen)) specimen.notes.push_back(std::move(note));
  for (std::string& note : unused_materials_notes(communicator, materials, specimen.particles))
    specimen.notes.push_back(std::move(note));
  for (std::string& note : seen.notes) specimen.notes.push_back(std::move(note));
  for (std::string& note : load_notes(p, specimen.body.lengths(), labels.size[2]))
    specimen.notes.push_back(std::move(note));
  for (std::string& note : notes_without_effect(p)) specimen.notes.push_back(std::move(note));
  for (const auto& [name, curve] : p.load_curves.curves)
    if (is_followed(p, name))
      for (std::string& note : solver::curve_notes(name, curve, p.loading))
        specimen.notes.push_back(std::move(note));
  specimen.fields = std::move(own.ranges);
  for (std::string& note : own.notes) specimen.notes.push_back(std::move(note));
  specimen.own_numbers = std::move(own.which);
  specimen.extremes = std::move(own.extremes);
  for (std::string& note : traction_notes(communicator, p.external_forces.forces, specimen))
    specimen.notes.push_back(std::move(note));
  specimen.particle_count = communicator.sum<std::int64_t>(specimen.particles.count());
  if (specimen.particle_count == 0)
    throw base::InputError("Image: every voxel is empty (label -1): there is nothing to compute");
  return specimen;
}

namespace {

/// The curves by which materials are driven; none if no material is.
std::vector<mechanics::MaterialDrives> drives_of(const DeckParameters& p) {
  const auto curve_of = [&](const auto& drive) {
    return drive ? curve_named(p, drive->load_curve) : mechanics::LoadCurve{};
  };
  std::vector<mechanics::MaterialDrives> drives;
  bool are_any = false;
  for (const auto& named : p.materials.materials) {
    const material::MaterialParameters& m = named.second;
    const bool is_pressure = material::is_pressure(m);
    are_any = are_any || is_pressure || m.active_stress || m.growth;
    drives.push_back({is_pressure ? curve_named(p, m.load_curve) : curve_of(m.active_stress),
                      curve_of(m.growth)});
  }
  if (!are_any) drives.clear();
  return drives;
}

}  // namespace

mechanics::Problem problem_of(const Deck& deck, const Specimen& specimen) {
  const DeckParameters& p = deck.parameters;
  mechanics::Problem problem;
  problem.body = specimen.body;
  material::MaterialLaws made = material::laws_of(p.materials.materials);
  for (std::size_t m = 0; m < specimen.own_numbers.size(); ++m)
    made.laws[m].let_vary(specimen.own_numbers[m]);
  problem.laws = mechanics::LawList{made.laws, made.directions};
  problem.laws.extremes = specimen.extremes;
  problem.duration = p.loading.seconds();
  problem.drives = drives_of(p);
  problem.conditions = p.boundary_conditions.conditions;
  for (std::size_t m = 0; m < problem.conditions.size(); ++m)
    problem.conditions[m].second.field = specimen.displacements[m];
  problem.forces = p.external_forces.forces;
  for (const auto& named : p.materials.materials)
    if (named.second.density) problem.density.push_back(*named.second.density);
  if (problem.density.size() != problem.laws.size()) problem.density.clear();
  problem.outer_thickness = specimen.layout.outer_thickness;
  problem.particle_half_edge = specimen.layout.half_edge;
  problem.dynamics = p.loading.dynamics();
  if (problem.dynamics) {
    mechanics::InitialConditionsParameters initial = p.initial_conditions;
    for (std::size_t m = 0; m < initial.conditions.size(); ++m)
      initial.conditions[m].second.field = specimen.velocities[m];
    problem.dynamics->initial_velocity = mechanics::initial_velocity(initial, specimen.body);
  }
  problem.method = mechanics::method_of(p.grid, material::compressibility(p.materials.materials));
  return problem;
}

solver::Circumstances circumstances(const Deck& deck, const mechanics::MomentumBalance& balance) {
  const DeckParameters& p = deck.parameters;
  return solver::circumstances(p.solver, p.grid, material::compressibility(p.materials.materials),
                               balance);
}

}  // namespace stroma
