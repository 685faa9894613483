// SPDX-License-Identifier: BSD-3-Clause

#include "run/MemoryEstimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma {
namespace {

using base::format;
using base::readable_bytes;
using particles::bytes_of_particle;
using particles::Presence;

constexpr double largest_count = std::numeric_limits<int>::max();

/// Particles along an axis of the body. So many elements that counting would take long have two
/// each, at least.
double particles_along(const particles::ParticleParameters& parameters, const grid::Grid& body,
                       int d, std::int64_t voxels) {
  if (body.elements[d] > 10'000'000) return 2.0 * static_cast<double>(body.elements[d]);
  return static_cast<double>(particles::axis_layout(parameters, body, d, 0, 0, voxels, 1.0).total);
}

/// What there is most of, as a mistake of the section that can change it.
std::string blame(const DeckParameters& parameters, const MemoryEstimate& estimate) {
  if (estimate.image >= std::max(estimate.seeding, estimate.solving())) return "Image: ";
  if (std::max(estimate.seeding, estimate.particles + estimate.results) > 0.5 * estimate.bytes())
    return "Particles: ";
  return parameters.grid.elements ? "Grid|Elements: " : "Grid|Element Size [um]: ";
}

}  // namespace

double MemoryEstimate::bytes() const {
  return std::max({image, seeding, solving(), particles + measured + results + vectors + tables});
}

double measured_numbers(const DeckParameters& parameters, const std::array<std::int64_t, 3>& voxels,
                        const grid::Grid& body, int ranks) {
  const int elements = grid::grid_for(parameters.grid.shape_functions, body).width - 1;
  std::array<double, 3> beside{};  // voxels of a face's layer
  double all = 1.0;
  for (std::size_t d = 0; d < 3; ++d) all *= static_cast<double>(voxels[d]);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto along = static_cast<double>(voxels[d]);
    const double deep = elements * along / static_cast<double>(body.elements[d]) + 1.0;
    beside[d] = all / along * std::min(deep, along);
  }
  double numbers = 0.0;
  for (const auto& [name, condition] : parameters.boundary_conditions.conditions) {
    if (!condition.images) continue;
    int components = 0;
    for (int component = 0; component < 3; ++component)
      components += condition.prescribes(component) ? 1 : 0;
    for (int face = 0; face < 6; ++face)
      if (condition.applies_to(static_cast<mechanics::Face>(face)))
        numbers += components * beside[static_cast<std::size_t>(face / 2)];
  }
  if (!parameters.grid.reset) numbers /= ranks;  // else each rank keeps all of the faces
  for (const auto& [name, condition] : parameters.initial_conditions.conditions)
    if (condition.images) numbers += 3.0 * all / ranks;
  return numbers;
}

Counts even_counts(const DeckParameters& parameters, const std::array<std::int64_t, 3>& voxels,
                   const grid::Grid& body, double filled, int ranks) {
  const grid::Grid grid = grid::grid_for(parameters.grid.shape_functions, body);
  Counts counts{1.0, filled, 1.0, 0.0, measured_numbers(parameters, voxels, body, ranks)};
  for (int d = 0; d < 3; ++d) {
    const std::int64_t along = voxels[static_cast<std::size_t>(d)];
    counts.voxels *= static_cast<double>(along);
    counts.particles *= particles_along(parameters.particles, body, d, along);
    counts.nodes *= static_cast<double>(grid.elements[d] + grid.beyond(d));
  }
  for (double* count : {&counts.voxels, &counts.particles, &counts.nodes}) *count /= ranks;
  counts.layers = static_cast<double>(grid.elements[2]);
  return counts;
}

MemoryEstimate estimate_memory(const DeckParameters& parameters, const Counts& counts) {
  const double nodes = counts.nodes;
  const bool resets = parameters.grid.reset;
  MemoryEstimate estimate{};
  const material::NamedMaterials& materials = parameters.materials.materials;
  const double intensities =  // of a voxel, kept beside its label
      material::read_the_specimens_image(materials) ? 8.0 : 0.0;
  estimate.image = (parameters.image.phantom ? 4.0 : 12.0 + intensities) * counts.voxels;
  const bool is_sorted = parameters.grid.shape_functions != shape::ShapeFunctions::linear;
  double seeded = bytes_of_particle({Presence::always});
  seeded += sizeof(double) * material::numbers_of_particles(materials);
  const double remembered = sizeof(double) * material::states_of_materials(materials);
  const bool carry_motion = parameters.loading.inertia &&
                            (resets || parameters.loading.mass == solver::MassMatrix::consistent);
  const bool carry_gradients =
      carry_motion && parameters.loading.mass == solver::MassMatrix::lumped;
  const double kept =
      remembered +
      (carry_motion ? bytes_of_particle({Presence::where_particles_carry_motion}) : 0.0) +
      (carry_gradients ? bytes_of_particle({Presence::where_motion_changes_grids}) : 0.0);
  const double moving = seeded + bytes_of_particle({Presence::where_particles_move}) + kept;
  constexpr double order = 24.0;  // of a particle, while particles are sorted
  // What fields are made of: an image with its copy, or the gradients of one and their product; and
  // what particles take from them.
  const double of_fields = material::vary(materials) ? 28.0 : 0.0;
  const double taken = material::vary(materials) ? 16.0 + 2.0 * seeded : 0.0;
  estimate.measured = sizeof(double) * counts.measured;
  // An image of displacements is read beside the labels; it may have other voxels than they.
  const double measured = counts.measured > 0.0 ? 4.0 : 0.0;
  estimate.seeding =
      (8.0 + intensities + of_fields + measured) * counts.voxels + estimate.measured +
      (is_sorted ? 2.0 * seeded + order : seeded) * counts.particles + taken * counts.particles;
  estimate.particles = (resets ? 2.0 * moving + seeded : seeded + kept) * counts.particles;
  // Results are evaluated a layer of elements at a time; with reset they must go home all together.
  // Then the modulus of a plane wave may be looked for, of all layers.
  estimate.results = resets ? (160.0 + 72.0) * counts.particles
                            : std::max(160.0 / counts.layers, 8.0) * counts.particles;
  // Velocities by components, and all together where nodes have them.
  if (parameters.loading.inertia)
    estimate.results += (carry_motion ? 24.0 : 48.0) * counts.particles;

  const grid::Grid grid = grid::grid_for(parameters.grid.shape_functions, {});
  const bool flat = parameters.grid.plane_strain;
  const auto kind = parameters.solver.preconditioner;
  const bool is_geometric = kind == solver::PreconditionerKind::geometric_multigrid;
  const bool is_stencil = solver::takes_stencil(kind, grid);
  const double stencil = 504.0 * nodes;
  const double blocks = std::pow(2.0 * grid.width - 1.0, flat ? 2.0 : 3.0);  // of a row
  estimate.tangent = is_stencil ? stencil + 48.0 * nodes : (9.0 * 12.0 + 2.0) * blocks * nodes;
  estimate.vectors = (parameters.loading.inertia ? 30.0 : 20.0) * 24.0 * nodes;
  if (is_geometric) estimate.preconditioner = stencil / 7.0 + 8.0 / 7.0 * 72.0 * nodes;
  if (is_geometric && !is_stencil)
    estimate.preconditioner += stencil + 48.0 * nodes + 6.0 * 24.0 * nodes;
  if (kind == solver::PreconditionerKind::multigrid)
    estimate.preconditioner = 1.6 * estimate.tangent;
  if (parameters.output.tables) {
    estimate.particles += 6.0 * counts.particles;  // object and distance to a wall
    estimate.seeding =
        std::max(estimate.seeding, (20.0 * counts.voxels) + (seeded + 14.0) * counts.particles);
    const double numbers = room_for_tables(nodes) / (8.0 * std::max(counts.particles, 1.0));
    estimate.tables = (16.0 + 8.0 * std::clamp(numbers - 2.0, 2.0, 8.0)) * counts.particles;
  }
  return estimate;
}

void require_memory(const base::Communicator& communicator, const DeckParameters& parameters,
                    const std::array<std::int64_t, 3>& voxels, const grid::Grid& body,
                    double filled) {
  const Counts counts = even_counts(parameters, voxels, body, filled, communicator.size());
  const MemoryEstimate estimate = estimate_memory(parameters, counts);
  std::string reason = base::shortage(communicator, estimate.bytes());
  if (reason.empty() && std::max(counts.particles, 3.0 * counts.nodes) > largest_count)
    reason = "a rank holds up to 2^31 particles and unknowns";
  if (reason.empty()) return;
  const double ranks = communicator.size();
  std::string counted = format("%.3g voxels (%s a rank), ", ranks * counts.voxels,
                               readable_bytes(estimate.image).c_str());
  if (filled > 0.0)
    counted +=
        format("%.3g particles (%s), ", ranks * counts.particles,
               readable_bytes(std::max(estimate.seeding,
                                       estimate.particles + estimate.results + estimate.tables))
                   .c_str());
  if (counts.measured > 0.0)
    counted += format("images of displacements or velocities (%s), ",
                      readable_bytes(estimate.measured).c_str());
  counted +=
      format("%.3g unknowns (%s)", 3.0 * ranks * counts.nodes,
             readable_bytes(estimate.tangent + estimate.vectors + estimate.preconditioner).c_str());
  throw base::InputError(blame(parameters, estimate) + reason + ": " + counted +
                         "; take coarser elements, fewer particles, a smaller Image|Region, or "
                         "more memory or machines");
}

}  // namespace stroma
