// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/MomentumBalance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/grid/ToDevice.hpp"
#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/mechanics/BoundaryPoints.hpp"
#include "stroma/mechanics/Scales.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/particles/Migration.hpp"
#include "stroma/particles/Seeding.hpp"
#include "stroma/particles/UndeformedPositions.hpp"

namespace stroma::mechanics {
namespace {

/// Refuses a grid or particles that the shape functions cannot work with.
void check_shape_functions(const Problem& problem, const grid::Grid& grid) {
  const grid::Grid needed = grid::grid_for(problem.shape_functions, problem.body);
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

/// A force per reference volume at each particle [pN/um^3]; empty without one.
transfer::ForceAtParticles<grid::Device> body_force_at(
    const decltype(Problem::body_force)& body_force,
    const particles::Particles<grid::Device>& particles) {
  if (!body_force) return {};
  const auto X = particles::undeformed_positions(particles);
  const Kokkos::View<double* [3], Kokkos::LayoutRight, grid::Device> force("body force", X.size());
  const auto on_host = Kokkos::create_mirror_view(force);
  for (int p = 0; p < particles.count(); ++p) {
    const auto b = body_force(X[static_cast<std::size_t>(p)]);
    for (int c = 0; c < 3; ++c) on_host(p, c) = b[static_cast<std::size_t>(c)];
  }
  Kokkos::deep_copy(force, on_host);
  return force;
}

}  // namespace

MomentumBalance::MomentumBalance(const base::Communicator& communicator,
                                 const grid::Partition& partition,
                                 const particles::Particles<Device>& particles,
                                 const Problem& problem, double base_load, bool is_refused_if_loose)
    : communicator_(communicator),
      problem_(problem),
      kernels_(kernels_for(problem.shape_functions, partition.grid().flat)),
      stress_(problem.laws.kernels(problem.shape_functions, partition.grid().flat)),
      halo_(communicator, partition),
      particles_(particles),
      box_(element_box(partition, communicator.rank())),
      density_(grid::to_device("density", problem.density.empty()
                                              ? std::vector<double>(problem.laws.size(), 1.0)
                                              : problem.density)),
      domains_(domains_of(problem)),
      stretches_domains_(problem.particle_domain == grid::ParticleDomain::stretched),
      base_load_(base_load),
      load_(base_load) {
  check_shape_functions(problem, partition.grid());
  check_scales(problem);
  particles::begin_history(particles_, stress_->states());
  typical_diagonal_ =
      stiffest_modulus(problem) * std::min({box_.spacing[0], box_.spacing[1], box_.spacing[2]});
  if (problem.stabilization > 0.0) find_fictitious_points(problem.stabilization);

  boundary_ = boundary_points(communicator, problem, particles_);
  stiffest_diagonal_ = std::max(typical_diagonal_, stiffest_springs(problem));
  if (!problem.forces.empty() || problem.body_force) find_external_force(problem);
  find_supports(problem, base_load, is_refused_if_loose);
}

MomentumBalance::MomentumBalance(const base::Communicator& communicator,
                                 const grid::Partition& partition,
                                 const particles::Particles<Device>& particles, const Laws& laws,
                                 const NamedConditions& conditions)
    : MomentumBalance(communicator, partition, particles,
                      Problem{partition.grid(), laws, conditions, {}, {}, {}}) {}

void MomentumBalance::find_supports(const Problem& problem, double base_load,
                                    bool is_refused_if_loose) {
  std::vector<Supports::NodeCounts> grips(problem.conditions.size());
  for (std::size_t m = 0; m < grips.size(); ++m) {
    const BoundaryCondition& condition = problem.conditions[m].second;
    if (problem.imposed_by(condition) == ImposedBy::grip)
      grips[m] = elements_around(grip(particles_, problem.body, *condition.face), false);
  }
  const int width = halo_.partition().grid().width;
  const transfer::TouchedNodes<Device> touched(
      "touched nodes", particles_.element_begin.extent(0) - 1, (width * width * width + 63) / 64);
  const auto filled_around = elements_around({}, true, touched);
  const Pieces pieces(halo_, box_, touched);
  BodyStatics statics(halo_, pieces, problem.body);
  sum_up(pieces, statics);
  supports_ = std::make_unique<Supports>(
      halo_, problem, base_load,
      SupportedBody{filled_around, grips, pieces, held_components(boundary_, particles_, pieces),
                    is_refused_if_loose},
      statics);
}

/// Elements, loads and stresses of the pieces.
void MomentumBalance::sum_up(const Pieces& pieces, BodyStatics& statics) const {
  const auto begin =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles_.element_begin);
  for (int k = 0; k < box_.elements[2]; ++k)
    for (int j = 0; j < box_.elements[1]; ++j)
      for (int i = 0; i < box_.elements[0]; ++i) {
        const int e = box_.element(i, j, k);
        if (pieces.of_element(e) == Pieces::none) continue;
        const int index[3] = {i, j, k};
        std::array<double, 3> lower, upper;
        for (int d = 0; d < 3; ++d) {
          const auto c = static_cast<std::size_t>(d);
          box_.within_ends(d, index[d], lower[c], upper[c]);
          for (double* end : {&lower[c], &upper[c]})
            *end = box_.corner[d] + (index[d] + *end) * box_.spacing[d];
        }
        statics.add_element(pieces.of_element(e), begin(e + 1) - begin(e), lower, upper);
      }

  const grid::Box owned = halo_.partition().owned_nodes(communicator_.rank());
  const grid::Box touched = halo_.partition().touched_nodes(communicator_.rank());
  const auto for_each_force = [&](const grid::Vector& force, const auto& use) {
    const auto value = force.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::int64_t n = 0; n < owned.count(); ++n) {
      const grid::Index3 node = owned.index(n);
      const int piece = pieces.of_node(touched.local(node));
      if (piece == Pieces::none) continue;
      use(piece, halo_.partition().grid().node_position(node),
          std::array<double, 3>{value(3 * n, 0), value(3 * n + 1, 0), value(3 * n + 2, 0)});
    }
  };
  if (external_force_ != Teuchos::null)
    for_each_force(*external_force_, [&](int piece, const auto& position, const auto& force) {
      statics.add_load(piece, position, force);
    });
  if (particles_.base_gradient.extent(0) == 0) return;
  grid::Vector stress(halo_.owned_map());
  internal_force(grid::Vector(halo_.owned_map()), stress);
  // Rounding strains a piece that was carried along, too.
  const double negligible =
      1e-12 * typical_diagonal_ * std::min({box_.spacing[0], box_.spacing[1], box_.spacing[2]});
  for_each_force(stress, [&](int piece, const auto&, const auto& force) {
    const double size = std::hypot(force[0], force[1], force[2]);
    if (size > negligible) statics.add_stress(piece, size);
  });
}

Supports::NodeCounts MomentumBalance::elements_around(
    const Kokkos::View<const std::uint8_t*, Device>& chosen, bool with_fictitious_points,
    const transfer::TouchedNodes<Device>& by_particles) const {
  const grid::Vector at_rest(halo_.owned_map());
  kernels_->touch(points(at_rest), chosen, with_fictitious_points, halo_.contributions(),
                  by_particles);
  grid::Vector owned(halo_.owned_map());
  halo_.sum_to_owner(owned);
  const grid::ConstNodeView everywhere = halo_.gather(owned);
  const Supports::NodeCounts counts("elements around", everywhere.extent(0));
  Kokkos::parallel_for(
      "elements around",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(counts.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        counts(n) = static_cast<std::uint8_t>(everywhere(n, 0) + 0.5);
      });
  return counts;
}

void MomentumBalance::find_fictitious_points(double stabilization) {
  const auto missing = missing_volume(box_, particles_);
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

void MomentumBalance::find_external_force(const Problem& problem) {
  const grid::Vector at_rest(halo_.owned_map());
  const auto forces = grid::to_device(
      "forces", volume_forces(problem.forces, problem.body, problem.outer_thickness));
  const auto at_particles = body_force_at(problem.body_force, particles_);
  kernels_->external_force(points(at_rest), forces, density_, at_particles, halo_.contributions());
  const auto force = Teuchos::rcp(new grid::Vector(halo_.owned_map()));
  halo_.sum_to_owner(*force);
  external_force_ = force;
}

Kokkos::View<std::uint8_t*, grid::Device> MomentumBalance::filled_elements(
    const grid::Partition& partition) const {
  const bool is_own = partition.grid().centered == halo_.partition().grid().centered;
  const auto begin = is_own
                         ? particles_.element_begin
                         : particles::migrate(communicator_, partition, particles_).element_begin;
  const std::size_t count = begin.extent(0) - 1;
  Kokkos::View<std::uint8_t*, Device> filled("filled", count);
  Kokkos::parallel_for(
      "filled elements", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) { filled(e) = begin(e + 1) > begin(e) ? 1 : 0; });
  return filled;
}

MomentumBalance::Points MomentumBalance::points(const grid::Vector& u) const {
  return {box_,
          particles_,
          halo_.gather(u),
          fictitious_volume_,
          domains_,
          stretches_domains_,
          problem_.dilatation == grid::Dilatation::element_mean};
}

std::int64_t MomentumBalance::internal_force(const grid::Vector& u, grid::Vector& force) const {
  const base::Stage stage("internal force");
  const std::int64_t bad = stress_->internal_force(points(u), halo_.contributions());
  halo_.sum_to_owner(force);
  return communicator_.sum(bad);
}

std::int64_t MomentumBalance::unbalanced_force(const grid::Vector& u, grid::Vector& force) const {
  const base::Stage stage("internal force");
  const Points at_u = points(u);
  const grid::NodeView sum = halo_.contributions();
  const std::int64_t bad = stress_->internal_force(at_u, sum);
  if (!boundary_.empty()) kernels_->spring_force(at_u, boundary_, load_, sum);
  halo_.sum_to_owner(force);
  if (external_force_ != Teuchos::null) force.update(-load_, *external_force_, 1.0);
  return communicator_.sum(bad);
}

std::int64_t MomentumBalance::residual(const grid::Vector& u, grid::Vector& r) const {
  const std::int64_t bad = unbalanced_force(u, r);
  supports_->clear(r);
  return bad;
}

void MomentumBalance::choose_tangent(TangentForm form) {
  if (form == form_) return;
  form_ = form;
  rows_.reset();
  stencil_ = Teuchos::null;
}

grid::RCP<Tpetra::Operator<double>> MomentumBalance::tangent() {
  if (form_ == TangentForm::compressed_rows) return tangent_matrix();
  if (stencil_ == Teuchos::null)
    stencil_ =
        Teuchos::rcp(new tangent::StencilMatrix(halo_, supports_->held(), typical_diagonal_));
  return stencil_;
}

grid::RCP<tangent::Matrix> MomentumBalance::tangent_matrix() {
  if (form_ != TangentForm::compressed_rows)
    throw std::logic_error("the tangent is stored as a stencil, not as compressed rows");
  if (!rows_) {
    const base::Stage stage("graph");
    rows_ = std::make_unique<tangent::TangentMatrix>(halo_, supports_->held(), typical_diagonal_);
  }
  return rows_->matrix();
}

std::int64_t MomentumBalance::assemble_tangent(const grid::Vector& u) {
  tangent();
  linearized_at_ = Teuchos::rcp(new grid::Vector(u, Teuchos::Copy));
  const base::Stage stage("tangent");
  std::int64_t bad = 0;
  const auto assemble = [&](auto& matrix) {
    const Points at_u = points(u);
    const auto rows = matrix.begin();
    bad = stress_->tangent(at_u, rows);
    if (!boundary_.empty()) kernels_->spring_tangent(at_u, boundary_, rows);
    matrix.finish();
  };
  if (form_ == TangentForm::stencil)
    assemble(*stencil_);
  else
    assemble(*rows_);
  return communicator_.sum(bad);
}

std::unique_ptr<MomentumBalance> MomentumBalance::with_hats(const grid::Partition& lattice) const {
  Problem problem = problem_;
  problem.shape_functions = grid::ShapeFunctions::linear;
  const bool has_other_elements = halo_.partition().grid().centered;
  auto hats = std::make_unique<MomentumBalance>(
      communicator_, lattice,
      has_other_elements ? particles::migrate(communicator_, lattice, particles_) : particles_,
      problem, base_load_, false);
  hats->boundary_.lumped = true;
  return hats;
}

void MomentumBalance::tangent_times(const grid::Vector& u, const grid::Vector& v,
                                    grid::Vector& product) const {
  Points at_u = points(u);
  // The halo has one buffer for gathered values: keep u's while v is gathered.
  const grid::NodeView displacement("u", at_u.displacement.extent(0));
  Kokkos::deep_copy(displacement, at_u.displacement);
  at_u.displacement = displacement;
  const grid::ConstNodeView direction = halo_.gather(v);
  const grid::NodeView sum = halo_.contributions();
  stress_->tangent_times(at_u, direction, sum);
  if (!boundary_.empty()) kernels_->spring_tangent_times(at_u, boundary_, direction, sum);
  halo_.sum_to_owner(product);
}

template <class Use>
void MomentumBalance::for_each_gap(const grid::Vector& u, const Use& use) const {
  if (boundary_.empty()) return;
  const grid::NodeView gaps("gaps", boundary_.point.extent(0));
  kernels_->boundary_gaps(points(u), boundary_, load_, gaps);
  const auto gap = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gaps);
  const auto point = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), boundary_.point);
  for (std::size_t n = 0; n < point.extent(0); ++n)
    use(point(n), std::array<double, 3>{gap(n, 0), gap(n, 1), gap(n, 2)});
}

std::vector<std::array<double, 3>> MomentumBalance::reactions(
    const grid::Vector& u, const grid::Vector& unbalanced_force) const {
  auto of_springs = std::vector<std::array<double, 3>>(problem_.conditions.size());
  for_each_gap(u, [&](const transfer::BoundaryPoint& b, const std::array<double, 3>& gap) {
    for (std::size_t c = 0; c < 3; ++c)
      of_springs[static_cast<std::size_t>(b.condition)][c] -= b.spring * gap[c];
  });
  if (!of_springs.empty()) communicator_.sum_all(of_springs.front().data(), 3 * of_springs.size());
  auto reactions = supports_->reactions(unbalanced_force);
  for (std::size_t m = 0; m < reactions.size(); ++m)
    for (std::size_t c = 0; c < 3; ++c) reactions[m][c] += of_springs[m][c];
  return reactions;
}

double MomentumBalance::spring_energy(const grid::Vector& u) const {
  std::vector<double> sums(6 * problem_.conditions.size());  // stiffness; force; per component
  for_each_gap(u, [&](const transfer::BoundaryPoint& b, const std::array<double, 3>& gap) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = 6 * static_cast<std::size_t>(b.condition) + c;
      if (!(b.components >> c & 1)) continue;
      sums[at] += b.spring;
      sums[at + 3] += b.spring * gap[c];
    }
  });
  communicator_.sum_all(sums.data(), sums.size());
  double energy = 0.0;
  for (std::size_t at = 0; at < sums.size(); at += 6)
    for (std::size_t c = at; c < at + 3; ++c)
      if (sums[c] > 0.0) energy += 0.5 * sums[c + 3] * sums[c + 3] / sums[c];
  return energy;
}

double MomentumBalance::force_scale(const grid::Vector& u,
                                    const grid::Vector& unbalanced_force) const {
  double scale = supports_->reaction_norm(unbalanced_force);
  if (!boundary_.empty()) {
    kernels_->spring_force(points(u), boundary_, load_, halo_.contributions());
    grid::Vector springs(halo_.owned_map());
    halo_.sum_to_owner(springs);
    scale = std::max(scale, springs.norm2());
  }
  if (external_force_ != Teuchos::null)
    scale = std::max(scale, std::abs(load_) * external_force_->norm2());
  return scale;
}

double MomentumBalance::rounding(const grid::Vector& u) const {
  return 16.0 * std::numeric_limits<double>::epsilon() * stiffest_diagonal_ * u.norm2();
}

void MomentumBalance::project_displacement(const grid::Vector& u, grid::Vector& projected) const {
  const auto fields = particle_fields(u);
  const Points at_u = points(u);
  const std::size_t nodes = at_u.displacement.extent(0);
  const grid::NodeView mass_of_nodes("mass", nodes), momentum("momentum", nodes);
  kernels_->project_displacement(at_u, fields.displacement, density_, mass_of_nodes, momentum);
  grid::Vector mass(halo_.owned_map());
  Kokkos::deep_copy(halo_.contributions(), mass_of_nodes);
  halo_.sum_to_owner(mass);
  Kokkos::deep_copy(halo_.contributions(), momentum);
  halo_.sum_to_owner(projected);
  const auto m = grid::node_view(static_cast<const grid::Vector&>(mass));
  const auto value = grid::node_view(projected);
  Kokkos::parallel_for(
      "divide by mass",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(value.extent(0))),
      KOKKOS_LAMBDA(const int n) {
        for (int c = 0; c < 3; ++c) value(n, c) = m(n, 0) > 0.0 ? value(n, c) / m(n, 0) : 0.0;
      });
}

void MomentumBalance::set_base_gradient(const grid::Vector& projected) {
  const std::int64_t bad = kernels_->gradient_from_displacement(points(projected));
  if (communicator_.sum(bad) > 0)
    throw base::RunError("the projected displacement turns particles inside out");
}

void MomentumBalance::replace_displacement(const grid::Vector& old, const grid::Vector& now) {
  grid::Vector difference(old, Teuchos::Copy);
  difference.update(-1.0, now, 1.0);
  kernels_->add_to_displacement(points(difference));
}

void MomentumBalance::commit_history(const grid::Vector& u) {
  if (stress_->states() > 0) stress_->update_history(points(u));
}

void MomentumBalance::take_history(const MomentumBalance& other) {
  if (stress_->states() == 0) return;
  const bool has_other_elements = other.halo_.partition().grid().centered;
  particles_.history =
      has_other_elements
          ? particles::migrate(communicator_, halo_.partition(), other.particles_).history
          : other.particles_.history;
}

particles::Particles<grid::Device> MomentumBalance::moved_particles(const grid::Vector& u) const {
  const auto moved = particles::with_room_to_move(particles_);
  kernels_->advance(points(u), moved);
  return moved;
}

transfer::ParticleFields<grid::Device> MomentumBalance::particle_fields(
    const grid::Vector& u) const {
  const base::Stage stage("grid to particles");
  transfer::ParticleFields<Device> fields(particles_.count());
  stress_->particle_fields(points(u), fields);
  return fields;
}

std::function<void(const MomentumBalance::FieldVisitor&)> MomentumBalance::field_layers(
    const grid::Vector& u) const {
  return [stress = stress_, at_u = points(u)](const FieldVisitor& visit) {
    const base::Stage stage("grid to particles");
    const transfer::ElementBox& box = at_u.box;
    const auto element_begin =
        Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), at_u.particles.element_begin);
    for (int k = 0; k < box.elements[2]; ++k) {
      const int first = element_begin(box.element(0, 0, k));
      const int count = element_begin(box.element(0, 0, k + 1)) - first;
      if (count == 0) continue;
      const transfer::ParticleFields<Device> fields(count);
      stress->layer_fields(at_u, k, first, fields);
      visit(first, fields);
    }
  };
}

double MomentumBalance::largest_strain(const grid::Vector& u) const {
  const auto material =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles_.material);
  const auto own =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles_.shear_modulus);
  double largest = 0.0;
  field_layers(u)([&](int first, const transfer::ParticleFields<Device>& fields) {
    const auto stress = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fields.stress);
    for (std::size_t p = 0; p < stress.extent(0); ++p) {
      const std::size_t n = static_cast<std::size_t>(first) + p;
      material::SmallStrainModuli moduli = problem_.laws.moduli[material(n)];
      if (own.extent(0) > 0) moduli = moduli.with_shear_modulus(own(n));
      const double modulus = moduli.uniaxial_strain();
      for (int c = 0; c < 6; ++c) largest = std::max(largest, std::abs(stress(p, c)) / modulus);
    }
  });
  return communicator_.max(largest);
}

WorstParticle MomentumBalance::worst_particle(const grid::Vector& u) const {
  const auto jacobian =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particle_fields(u).jacobian);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity;
  int worst = -1;
  for (int p = 0; p < particles_.count(); ++p)
    if (!(jacobian(p) >= least)) {
      least = std::isnan(jacobian(p)) ? -infinity : jacobian(p);
      worst = p;
    }
  const double least_of_all = communicator_.min(least);
  const int owner = communicator_.min(worst >= 0 && least == least_of_all ? communicator_.rank()
                                                                          : communicator_.size());
  WorstParticle result;
  if (owner == communicator_.size()) return result;
  if (owner == communicator_.rank()) {
    const auto one = [&](const auto& view) {
      return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
    };
    result.id = one(particles_.id)(worst);
    result.material = one(particles_.material)(worst);
    result.jacobian = jacobian(worst);
    const auto position = one(particles_.position);
    for (std::size_t d = 0; d < 3; ++d) result.position[d] = position(worst, static_cast<int>(d));
  }
  communicator_.broadcast(result.id, owner);
  communicator_.broadcast(result.material, owner);
  communicator_.broadcast(result.jacobian, owner);
  communicator_.broadcast(result.position.data(), 3, owner);
  return result;
}

}  // namespace stroma::mechanics
