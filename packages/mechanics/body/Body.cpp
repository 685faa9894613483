// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/body/Body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/grid/ToDevice.hpp"
#include "stroma/mechanics/body/Filling.hpp"
#include "stroma/mechanics/problem/Scales.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/particles/Migration.hpp"

namespace stroma::mechanics {
namespace {

/// Refuses a grid or particles that the shape functions cannot work with.
void check_shape_functions(const Problem& problem, const grid::Grid& grid) {
  const grid::Grid needed = grid::grid_for(problem.method.shape_functions, problem.body);
  if (grid.width != needed.width || grid.centered != needed.centered)
    throw base::InputError(
        "the partition's grid is not the one for the problem's shape functions; admissible: one "
        "made by grid::partition_for()");
  for (const auto& half_edge : problem.particle_half_edge)
    if (grid.centered && half_edge.empty())
      throw base::InputError(
          "these shape functions average over the particles' domains; admissible: "
          "Problem::particle_half_edge of each layer of particles along each axis");
}

/// Elements that particles fill by a smaller share get fictitious points. Where a body ends a little
/// below a knot, elements on it are half full, and the functions beyond have next to no consistent
/// mass: they need more help than lumped masses do.
double stabilized_share(const Problem& problem) {
  const bool is_consistent = problem.dynamics && !problem.dynamics->lumped;
  return is_consistent && problem.method.reset ? 0.75 : 0.5;
}

/// Refuses numbers that no law would take, or too few of them. Collective: ranks without particles
/// have none.
void check_fields(const base::Communicator& communicator,
                  const particles::Particles<grid::Device>& particles,
                  const StressKernels& kernels) {
  const auto wanted = static_cast<std::size_t>(kernels.own_numbers());
  if (communicator.any(particles.count() > 0 && particles.own_numbers.extent(1) != wanted))
    throw base::InputError(base::format(
        "the particles have %zu numbers of their own, and the laws take %zu; admissible: "
        "Particles::own_numbers as material::AnyLaw::let_vary() says",
        particles.own_numbers.extent(1), wanted));
}

/// The domains as kernels want them: one box if all are alike.
transfer::ParticleDomains<grid::Device> domains_of(const Problem& problem) {
  transfer::ParticleDomains<grid::Device> domains;
  std::vector<double> of_layer;
  bool are_alike = true;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto& half_edge = problem.particle_half_edge[d];
    if (half_edge.empty()) return {};
    domains.half_edge[d] = half_edge.front();
    domains.layers[d] = static_cast<std::int64_t>(half_edge.size());
    of_layer.insert(of_layer.end(), half_edge.begin(), half_edge.end());
    are_alike = are_alike && std::all_of(half_edge.begin(), half_edge.end(),
                                         [&](double edge) { return edge == half_edge.front(); });
  }
  if (!are_alike) domains.of_layer = grid::to_device("domains", of_layer);
  return domains;
}

}  // namespace

Body::Body(const base::Communicator& communicator, const grid::Partition& partition,
           const particles::Particles<Device>& particles, const Problem& problem)
    : problem_(problem),
      kernels_(kernels_for(problem.method.shape_functions, partition.grid().flat)),
      stress_(problem.laws.kernels(problem.method.shape_functions, partition.grid().flat)),
      halo_(communicator, partition),
      particles_(particles),
      box_(element_box(partition, communicator.rank())),
      density_(grid::to_device("density", problem.density.empty()
                                              ? std::vector<double>(problem.laws.size(), 1.0)
                                              : problem.density)),
      domains_(domains_of(problem)) {
  check_shape_functions(problem, partition.grid());
  check_scales(problem);
  check_fields(communicator, particles_, *stress_);
  if (problem.method.dilatation == Dilatation::element_mean && !stress_->may_be_averaged())
    throw base::InputError(
        "a mean dilatation averages the laws' energies of volume, and one of them has none; "
        "admissible: Dilatation::pointwise");
  particles::begin_history(particles_, stress_->states());
  if (particles_carry_motion())
    begins_motion_ =
        communicator.any(particles::begin_motion(particles_, particles_carry_gradients()));
  typical_diagonal_ = problem.laws.stiffest_modulus() *
                      std::min({box_.spacing[0], box_.spacing[1], box_.spacing[2]});
  find_fictitious_points();
}

Body::Points Body::points(const grid::Vector& u) const {
  return {box_,
          particles_,
          halo_.gather(u),
          fictitious_volume_,
          domains_,
          problem_.method.particle_domain == ParticleDomain::stretched,
          problem_.method.dilatation == Dilatation::element_mean,
          time_step_,
          factors_};
}

void Body::set_load(double load, double time_step) {
  time_step_ = time_step;
  if (problem_.drives.empty()) return;
  std::vector<material::MaterialFactors> factors;
  for (const MaterialDrives& drives : problem_.drives)
    factors.push_back({drives.active.at(load), drives.growth.at(load)});
  factors_ = grid::to_device("factors", factors);
}

Body::NodeCounts Body::elements_around(const Kokkos::View<const std::uint8_t*, Device>& chosen,
                                       bool with_fictitious_points,
                                       const transfer::TouchedNodes<Device>& by_particles) const {
  const grid::Vector at_rest(halo_.owned_map());
  kernels_->touch(points(at_rest), chosen, with_fictitious_points, halo_.contributions(),
                  by_particles);
  grid::Vector owned(halo_.owned_map());
  halo_.sum_to_owner(owned);
  const grid::ConstNodeView everywhere = halo_.gather(owned);
  const NodeCounts counts("elements around", everywhere.extent(0));
  Kokkos::parallel_for(
      "elements around",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(counts.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        counts(n) = static_cast<std::uint8_t>(everywhere(n, 0) + 0.5);
      });
  return counts;
}

void Body::stabilize(double stabilization) {
  problem_.method.stabilization = stabilization;
  find_fictitious_points();
}

void Body::find_fictitious_points() {
  fictitious_volume_ = {};
  const double stabilization = problem_.method.stabilization;
  if (stabilization == 0.0) return;
  const auto missing = missing_volume(stabilized_share(problem_));
  const Kokkos::View<float*, Device> volume("fictitious volume", missing.extent(0));
  const double count_of_element = kernels_->fictitious_points();
  std::int64_t found = 0;
  Kokkos::parallel_reduce(
      "fictitious points",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(missing.extent(0))),
      KOKKOS_LAMBDA(const int e, std::int64_t& sum) {
        volume(e) = static_cast<float>(stabilization * missing(e) / count_of_element);
        if (missing(e) > 0.0) ++sum;
      },
      found);
  if (found > 0) fictitious_volume_ = volume;
}

Kokkos::View<double*, grid::Device> Body::missing_volume(double share) const {
  return mechanics::missing_volume(halo_, box_, particles_, domains_, share);
}

particles::Particles<grid::Device> Body::particles_on(const grid::Partition& partition) const {
  const bool is_own = partition.grid().centered == halo_.partition().grid().centered;
  return is_own ? particles_ : particles::migrate(communicator(), partition, particles_);
}

Kokkos::View<std::uint8_t*, grid::Device> Body::filled_elements(
    const grid::Partition& partition) const {
  const auto begin = particles_on(partition).element_begin;
  const std::size_t count = begin.extent(0) - 1;
  Kokkos::View<std::uint8_t*, Device> filled("filled", count);
  Kokkos::parallel_for(
      "filled elements", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) { filled(e) = begin(e + 1) > begin(e) ? 1 : 0; });
  return filled;
}

void Body::project_displacement(const grid::Vector& u, grid::Vector& projected) const {
  find_nodal_means(u, particle_fields(u).displacement, projected);
}

void Body::find_nodal_means(const grid::Vector& u, const grid::ConstNodeView& field,
                            grid::Vector& means) const {
  const Points at_u = points(u);
  const std::size_t nodes = at_u.displacement.extent(0);
  const grid::NodeView mass_of_nodes("mass", nodes), momentum("momentum", nodes);
  kernels_->project_to_nodes(at_u, field, density_, mass_of_nodes, momentum);
  grid::Vector mass(halo_.owned_map());
  Kokkos::deep_copy(halo_.contributions(), mass_of_nodes);
  halo_.sum_to_owner(mass);
  Kokkos::deep_copy(halo_.contributions(), momentum);
  halo_.sum_to_owner(means);
  const auto m = grid::node_view(static_cast<const grid::Vector&>(mass));
  const auto value = grid::node_view(means);
  Kokkos::parallel_for(
      "divide by mass",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(value.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        for (int c = 0; c < 3; ++c) value(n, c) = m(n, 0) > 0.0 ? value(n, c) / m(n, 0) : 0.0;
      });
}

void Body::set_base_gradient(const grid::Vector& projected) {
  const std::int64_t bad = kernels_->gradient_from_displacement(points(projected));
  if (communicator().sum(bad) > 0)
    throw base::RunError("the projected displacement turns particles inside out");
}

void Body::replace_displacement(const grid::Vector& old, const grid::Vector& now) {
  grid::Vector difference(old, Teuchos::Copy);
  difference.update(-1.0, now, 1.0);
  kernels_->add_at_particles(points(difference), particles_.base_displacement);
}

void Body::take_history(const Body& other) {
  time_step_ = other.time_step_;
  factors_ = other.factors_;
  if (stress_->states() > 0) particles_.history = other.particles_on(halo_.partition()).history;
}

particles::Particles<grid::Device> Body::moved_particles(const grid::Vector& u) const {
  const auto moved = particles::with_room_to_move(particles_);
  kernels_->advance(points(u), moved);
  return moved;
}

transfer::ParticleFields<grid::Device> Body::particle_fields(const grid::Vector& u) const {
  const base::Stage stage("grid to particles");
  transfer::ParticleFields<Device> fields(particles_.count());
  stress_->particle_fields(points(u), fields);
  return fields;
}

FieldLayers Body::field_layers(const grid::Vector& u) const { return {stress_, points(u)}; }

void FieldLayers::operator()(const Visitor& use) const {
  const base::Stage stage("grid to particles");
  for (int layer = 0; layer < count(); ++layer) visit(layer, use);
}

int FieldLayers::first_particle(int layer) const {
  const auto element_begin =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), at_u_.particles.element_begin);
  return element_begin(at_u_.box.element(0, 0, layer));
}

void FieldLayers::visit(int layer, const Visitor& use) const {
  const int first = first_particle(layer), count = first_particle(layer + 1) - first;
  if (count == 0) return;
  const Fields fields(count);
  stress_->layer_fields(at_u_, layer, first, fields);
  use(first, fields);
}

double Body::largest_strain(const grid::Vector& u) const {
  const particles::HostParticles particles = particles::on_host(particles_);
  double largest = 0.0;
  field_layers(u)([&](int first, const transfer::ParticleFields<Device>& fields) {
    const auto stress = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fields.stress);
    for (std::size_t p = 0; p < stress.extent(0); ++p) {
      const auto moduli = stress_->moduli_of(particles, first + static_cast<int>(p));
      const double mean = (stress(p, 0) + stress(p, 1) + stress(p, 2)) / 3.0;
      largest = std::max(largest, std::abs(mean) / moduli.bulk);
      for (int c = 0; c < 6; ++c)
        largest = std::max(largest, std::abs(stress(p, c) - (c < 3 ? mean : 0.0)) / moduli.shear);
    }
  });
  return communicator().max(largest);
}

WorstParticle Body::worst_particle(const grid::Vector& u) const {
  return worst_by(particle_fields(u).jacobian);
}

Localization Body::localization(const grid::Vector& u, int share) const {
  material::DistributionParameters everywhere;
  everywhere.distribution = material::Distribution::spherical;
  everywhere.quadrature = 4;
  const auto directions = grid::to_device("directions", material::directions(everywhere));
  const auto count = static_cast<std::size_t>(particles_.count());
  const Kokkos::View<double*, Device> moduli("wave moduli", count);  // zero: not looked at
  stress_->wave_moduli(points(u), directions, share, moduli, {});
  Localization found;
  const auto on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), moduli);
  for (std::size_t p = 0; p < count; ++p)
    if (on_host(p) < 0.0) ++found.particles;
  found.particles = communicator().sum(found.particles);
  if (found.particles == 0) return found;
  found.worst = worst_by(moduli);

  const Kokkos::View<double* [3], Device> across("across", count);
  stress_->wave_moduli(points(u), directions, share, moduli, across);
  const auto n = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), across);
  const auto id = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles_.id);
  for (std::size_t p = 0; p < count; ++p)
    if (id(p) == found.worst.id)
      for (std::size_t d = 0; d < 3; ++d) found.direction[d] = n(p, d);
  communicator().sum_all(found.direction.data(), 3);
  return found;
}

WorstParticle Body::worst_by(const Kokkos::View<const double*, Device>& figure) const {
  const auto on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), figure);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity;
  int worst = -1;
  for (int p = 0; p < particles_.count(); ++p)
    if (!(on_host(p) >= least)) {
      least = std::isnan(on_host(p)) ? -infinity : on_host(p);
      worst = p;
    }
  const double least_of_all = communicator().min(least);
  const int owner = communicator().min(worst >= 0 && least == least_of_all ? communicator().rank()
                                                                           : communicator().size());
  WorstParticle result;
  if (owner == communicator().size()) return result;
  if (owner == communicator().rank()) {
    const auto one = [&](const auto& view) {
      return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
    };
    result.id = one(particles_.id)(worst);
    result.material = one(particles_.material)(worst);
    result.figure = on_host(worst);
    const auto position = one(particles_.position);
    for (std::size_t d = 0; d < 3; ++d) result.position[d] = position(worst, static_cast<int>(d));
  }
  communicator().broadcast(result.id, owner);
  communicator().broadcast(result.material, owner);
  communicator().broadcast(result.figure, owner);
  communicator().broadcast(result.position.data(), 3, owner);
  return result;
}

}  // namespace stroma::mechanics
