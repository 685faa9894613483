#include "mechanics/MomentumBalance.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "base/Stage.hpp"
#include "transfer/InternalForce.hpp"

namespace stroma::mechanics {
namespace {

transfer::ElementBox element_box(const grid::Partition& partition, int rank) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(rank);
  transfer::ElementBox box;
  const auto corner = grid.node_position(elements.begin);
  box.flat = grid.flat;
  for (int d = 0; d < 3; ++d) {
    box.elements[d] = static_cast<int>(elements.extent(d));
    box.corner[d] = corner[d];
    box.spacing[d] = grid.spacing[d];
    box.inverse_spacing[d] = 1.0 / grid.spacing[d];
  }
  return box;
}

/// (touched node) whether an element with particles, of any rank, has it as a corner.
Kokkos::View<std::uint8_t*, grid::Device> active_nodes(
    const grid::Halo& halo, const transfer::ElementBox& box,
    const particles::Particles<grid::Device>& particles) {
  const auto element_begin =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), particles.element_begin);
  const grid::NodeView touches = halo.contributions();
  const auto touch = Kokkos::create_mirror_view(touches);
  Kokkos::deep_copy(touch, 0.0);
  for (int k = 0; k < box.elements[2]; ++k)
    for (int j = 0; j < box.elements[1]; ++j)
      for (int i = 0; i < box.elements[0]; ++i) {
        const int e = box.element(i, j, k);
        if (element_begin(e) == element_begin(e + 1)) continue;
        for (int a = 0; a < 8; ++a)
          touch(box.node(i + (a & 1), j + (a >> 1 & 1), k + (a >> 2)), 0) += 1.0;
      }
  Kokkos::deep_copy(touches, touch);
  grid::Vector owned(halo.owned_map());
  halo.sum_to_owner(owned);
  const auto everywhere =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), halo.gather(owned));
  Kokkos::View<std::uint8_t*, grid::Device> active("active", everywhere.extent(0));
  const auto is_active = Kokkos::create_mirror_view(active);
  for (std::size_t n = 0; n < everywhere.extent(0); ++n) is_active(n) = everywhere(n, 0) > 0.0;
  Kokkos::deep_copy(active, is_active);
  return active;
}

}  // namespace

MomentumBalance::MomentumBalance(const base::Communicator& communicator,
                                 const grid::Partition& partition,
                                 const particles::Particles<Device>& particles,
                                 const std::vector<Law>& laws, const NamedConditions& conditions)
    : communicator_(communicator),
      halo_(communicator, partition),
      particles_(particles),
      box_(element_box(partition, communicator.rank())) {
  Kokkos::View<Law*, Device> law("law", laws.size());
  const auto host_law = Kokkos::create_mirror_view(law);
  double stiffest = 0.0;
  for (std::size_t m = 0; m < laws.size(); ++m) {
    host_law(m) = laws[m];
    stiffest = std::max(stiffest, laws[m].bulk_modulus + 4.0 / 3.0 * laws[m].shear_modulus);
  }
  Kokkos::deep_copy(law, host_law);
  law_ = law;
  typical_diagonal_ = stiffest * std::min({box_.spacing[0], box_.spacing[1], box_.spacing[2]});
  supports_ = std::make_unique<Supports>(halo_, conditions, active_nodes(halo_, box_, particles_));
}

Kokkos::View<std::uint8_t*, grid::Device> MomentumBalance::filled_elements() const {
  const std::size_t count = particles_.element_begin.extent(0) - 1;
  Kokkos::View<std::uint8_t*, Device> filled("filled", count);
  const auto begin = particles_.element_begin;
  Kokkos::parallel_for(
      "filled elements", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) { filled(e) = begin(e + 1) > begin(e) ? 1 : 0; });
  return filled;
}

MomentumBalance::Elements MomentumBalance::elements(const grid::Vector& u) const {
  return {box_, particles_, halo_.gather(u)};
}

std::int64_t MomentumBalance::internal_force(const grid::Vector& u, grid::Vector& force) const {
  const base::Stage stage("internal force");
  const transfer::InternalForce<Shape, Law, Device> kernel{elements(u), law_,
                                                           halo_.contributions()};
  const std::int64_t bad = transfer::for_each_element<Shape::width, grid::ExecutionSpace>(
      "internal force", box_, kernel);
  halo_.sum_to_owner(force);
  return communicator_.sum(bad);
}

std::int64_t MomentumBalance::residual(const grid::Vector& u, grid::Vector& r) const {
  const std::int64_t bad = internal_force(u, r);
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
    stencil_ = Teuchos::rcp(new StencilMatrix(halo_, supports_->held(), typical_diagonal_));
  return stencil_;
}

grid::RCP<Matrix> MomentumBalance::tangent_matrix() {
  if (form_ != TangentForm::compressed_rows)
    throw std::logic_error("the tangent is stored as a stencil, not as compressed rows");
  if (!rows_) {
    const base::Stage stage("graph");
    rows_ = std::make_unique<TangentMatrix>(halo_, supports_->held(), typical_diagonal_);
  }
  return rows_->matrix();
}

std::int64_t MomentumBalance::assemble_tangent(const grid::Vector& u) {
  tangent();
  const base::Stage stage("tangent");
  const auto add_elements = [&](const auto& rows) {
    const transfer::Tangent<Shape, Law, Device, std::decay_t<decltype(rows)>> kernel{elements(u),
                                                                                     law_, rows};
    return transfer::for_each_element<Shape::width, grid::ExecutionSpace>("tangent", box_, kernel);
  };
  std::int64_t bad = 0;
  if (form_ == TangentForm::stencil) {
    bad = add_elements(stencil_->begin());
    stencil_->finish();
  } else {
    bad = add_elements(rows_->begin());
    rows_->finish();
  }
  return communicator_.sum(bad);
}

void MomentumBalance::tangent_times(const grid::Vector& u, const grid::Vector& v,
                                    grid::Vector& product) const {
  const Elements at_u = elements(u);
  // The halo has one buffer for gathered values: keep u's while v is gathered.
  grid::NodeView displacement("u", at_u.displacement.extent(0));
  Kokkos::deep_copy(displacement, at_u.displacement);
  const transfer::TangentTimes<Shape, Law, Device> kernel{
      {box_, particles_, displacement}, law_, halo_.gather(v), halo_.contributions()};
  transfer::for_each_element<Shape::width, grid::ExecutionSpace>("tangent times", box_, kernel);
  halo_.sum_to_owner(product);
}

transfer::ParticleFields<grid::Device> MomentumBalance::particle_fields(
    const grid::Vector& u) const {
  const base::Stage stage("grid to particles");
  transfer::ParticleFields<Device> fields(particles_.count());
  const transfer::GridToParticles<Shape, Law, Device> kernel{elements(u), law_, fields};
  transfer::for_each_element<Shape::width, grid::ExecutionSpace>("grid to particles", box_, kernel);
  return fields;
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
