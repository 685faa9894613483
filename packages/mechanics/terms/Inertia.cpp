// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/Inertia.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/grid/ToDevice.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/particles/UndeformedPositions.hpp"

namespace stroma::mechanics {
namespace {

using grid::ConstNodeView;
using grid::NodeView;

constexpr double force_of_mass = 1e-12;  // [pN] of 1 kg/m^3 um^3 um/s^2

/// Calls use(n, c) for each number of an array of vectors.
template <class Use>
void for_each_number(const char* name, std::size_t count, const Use& use) {
  Kokkos::parallel_for(
      name, Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int n) {
        for (int c = 0; c < 3; ++c) use(n, c);
      });
}

/// The motion at the end of a step from that at its begin.
struct AtEnd {
  TimeScheme scheme;
  double dt;

  /// \param d  displacement over the step
  KOKKOS_INLINE_FUNCTION void operator()(double d, double& v, double& a) const {
    const double a_1 = scheme.acceleration(dt, d, v, a);
    v = scheme.velocity(dt, v, a, a_1);
    a = a_1;
  }
};

/// The motion with which nodes or particles enter the balance, from that at the begin of the step; the
/// same where no step is tried.
struct AtBalance {
  TimeScheme scheme;
  double dt;

  /// \param d  displacement over the way to the balance
  KOKKOS_INLINE_FUNCTION void operator()(double d, double& v, double& a) const {
    if (dt == 0.0) return;
    double v_1 = v, a_1 = a;
    AtEnd{scheme, dt}(d / (1.0 - scheme.alpha_f), v_1, a_1);
    v = scheme.velocity_at_balance(v, v_1);
    a = scheme.acceleration_at_balance(a, a_1);
  }
};

}  // namespace

Inertia::Inertia(const Body& body, double load)
    : body_(body),
      mass_(body.halo().owned_map()),
      load_(load),
      from_(body.halo().owned_map()),
      velocity_(body.halo().owned_map()),
      acceleration_(body.halo().owned_map()),
      prescribed_(body.halo().owned_map()),
      arriving_(body.halo().owned_map()),
      balancing_(body.halo().owned_map()) {
  const std::vector<double>& density = body.problem().density;
  if (density.size() != body.problem().laws.size())
    throw base::InputError(
        "inertia asks for the density of every material; admissible: Problem::density");
  std::vector<double> scaled = density;
  for (double& rho : scaled) rho *= force_of_mass;
  density_ = grid::to_device("mass density", scaled);
  begins_ = body.begins_motion();
  weigh();
  if (begins_) begin_particles();
  if (body.particles_carry_motion() && !begins_) find_nodal_motion();
}

/// Masses of the nodes.
void Inertia::weigh() {
  const base::Stage stage("inertia");
  const auto points = body_.points(from_);
  const std::size_t nodes = points.displacement.extent(0);
  mass_here_ = NodeView("mass", nodes);
  const NodeView nothing("nothing", nodes), field("nothing", body_.particles().volume.extent(0));
  body_.kernels().project_to_nodes(points, field, density_, mass_here_, nothing);
  const NodeView sum = body_.halo().contributions();
  const NodeView here = mass_here_;
  for_each_number(
      "mass", nodes, KOKKOS_LAMBDA(const int n, const int c) { sum(n, c) = here(n, 0); });
  body_.halo().sum_to_owner(mass_);
  largest_mass_ = mass_.normInf();
  const auto m = grid::node_view(mass_);
  int negative = 0;
  Kokkos::parallel_reduce(
      "negative masses",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(m.extent(0))),
      KOKKOS_LAMBDA(const int n, int& count) { count += m(n, 0) < 0.0 ? 1 : 0; }, negative);
  if (is_lumped() && body_.communicator().any(negative > 0))
    throw base::InputError(
        "the body's outermost particles give nodes negative masses; admissible: the consistent "
        "mass, or another grid");
}

/// The velocities of a body that begins, at nodes and at particles that carry theirs.
void Inertia::begin_particles() {
  const auto& initial = dynamics().initial_velocity;
  if (!initial) return;
  const auto& halo = body_.halo();
  const grid::Partition& partition = halo.partition();
  const int rank = halo.communicator().rank();
  const grid::Box owned = partition.owned_nodes(rank), touched = partition.touched_nodes(rank);
  const auto filled =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body_.elements_around({}, true));
  base::collectively(halo.communicator(), [&] {
    const auto v = velocity_.getLocalViewHost(Tpetra::Access::ReadWrite);
    grid::for_each_index(owned, [&](const grid::Index3& node) {
      if (filled(touched.local(node)) == 0) return;  // nothing moves there, and nobody may know how
      const auto at = initial(partition.grid().node_position(node));
      for (int c = 0; c < 3; ++c)
        v(static_cast<std::size_t>(3 * owned.local(node) + c), 0) = at[static_cast<std::size_t>(c)];
    });
  });
  if (!body_.particles_carry_motion()) return;
  const auto X = particles::undeformed_positions(body_.particles());
  const auto v = Kokkos::create_mirror_view(body_.particles().velocity);
  base::collectively(halo.communicator(), [&] {
    for (int p = 0; p < body_.particles().count(); ++p) {
      const auto at = initial(X[static_cast<std::size_t>(p)]);
      for (int c = 0; c < 3; ++c) v(p, c) = at[static_cast<std::size_t>(c)];
    }
  });
  Kokkos::deep_copy(body_.particles().velocity, v);
  if (body_.particles_carry_gradients()) carry_gradient(from_);
}

/// The motion of the nodes as the mass-weighted mean of that of the particles.
void Inertia::find_nodal_motion() {
  find_nodal_velocities();
  body_.find_nodal_means(from_, body_.particles().acceleration, acceleration_);
}

/// With gradients, v_I = sum_p m_p N_I (v_p + G_p (x_I - x_p)) / m_I: from the means of v_p - G_p x_p
/// and of the columns of G_p.
void Inertia::find_nodal_velocities() {
  const auto& particles = body_.particles();
  if (!body_.particles_carry_gradients()) {
    body_.find_nodal_means(from_, particles.velocity, velocity_);
    return;
  }
  const grid::Partition& partition = body_.halo().partition();
  const grid::Box owned = partition.owned_nodes(body_.communicator().rank());
  const NodeView field("velocity", particles.volume.extent(0));
  const auto x = particles.position, v = particles.velocity;
  const auto G = particles.velocity_gradient;
  const auto [o_x, o_y, o_z] = partition.grid().origin;
  const Kokkos::Array<double, 3> origin{o_x, o_y, o_z};
  for_each_number(
      "velocity at the origin", field.extent(0), KOKKOS_LAMBDA(const int p, const int c) {
        field(p, c) = v(p, c);
        for (int d = 0; d < 3; ++d) field(p, c) -= G(p, c, d) * (x(p, d) - origin[d]);
      });
  body_.find_nodal_means(from_, field, velocity_);
  grid::Vector column(velocity_.getMap());
  for (int d = 0; d < 3; ++d) {
    for_each_number(
        "column of gradients", field.extent(0),
        KOKKOS_LAMBDA(const int p, const int c) { field(p, c) = G(p, c, d); });
    body_.find_nodal_means(from_, field, column);
    const auto rate = column.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto sum = velocity_.getLocalViewHost(Tpetra::Access::ReadWrite);
    grid::for_each_index(owned, [&](const grid::Index3& node) {
      const double distance = partition.grid().node_position(node)[d] - origin[d];
      for (int c = 0; c < 3; ++c) {
        const auto n = static_cast<std::size_t>(3 * owned.local(node) + c);
        sum(n, 0) += rate(n, 0) * distance;
      }
    });
  }
}

/// Adds to a vector of the particles what nodal values carry.
void Inertia::carry(const grid::Vector& nodal, const NodeView& field) const {
  body_.kernels().add_at_particles(body_.points(nodal), field);
}

void Inertia::carry_difference(const grid::Vector& from, const grid::Vector& to,
                               const NodeView& field) const {
  grid::Vector difference(to, Teuchos::Copy);
  difference.update(-1.0, from, 1.0);
  carry(difference, field);
}

grid::NodeView Inertia::carried_by(const grid::Vector& nodal) const {
  const NodeView field("carried", body_.particles().volume.extent(0));
  carry(nodal, field);
  return field;
}

/// Sets the particles' velocity gradients to those of the nodes at a displacement.
void Inertia::carry_gradient(const grid::Vector& u) const {
  auto points = body_.points(u);
  const NodeView displacement("u", points.displacement.extent(0));
  Kokkos::deep_copy(displacement, points.displacement);
  points.displacement = displacement;
  body_.kernels().gradient_at_particles(points, body_.halo().gather(velocity_),
                                        body_.particles().velocity_gradient);
}

void Inertia::go_from(const grid::Vector& u) {
  from_.assign(u);
  if (!is_lumped()) carried_from_ = carried_by(from_);
}

void Inertia::follow(const Supports& supports) {
  if (supports_ == nullptr) {
    grid::Vector idle(velocity_.getMap());
    const auto one = grid::node_view(idle), m = grid::node_view(mass_);
    for_each_number(
        "idle", one.extent(0),
        KOKKOS_LAMBDA(const int n, const int c) { one(n, c) = m(n, c) == 0.0 ? 1.0 : 0.0; });
    supports.clear(idle);
    has_idle_nodes_ = idle.normInf() > 0.0;
  }
  const bool is_first = supports_ == nullptr;
  supports_ = &supports;
  const grid::Vector before(velocity_, Teuchos::Copy);
  grid::Vector rate(velocity_.getMap());
  supports.rate(load_, rate);
  supports.clear(velocity_);
  velocity_.update(1.0 / body_.problem().duration, rate, 1.0);
  if (is_first && begins_ && !is_lumped())
    carry_difference(before, velocity_, body_.particles().velocity);
}

/// Nodes without a mass have no memory: their velocity is the mean over the step.
void Inertia::carry_idle_nodes(double dt, const grid::Vector& change) {
  const auto m = grid::node_view(static_cast<const grid::Vector&>(mass_)),
             d = grid::node_view(change);
  const auto v = grid::node_view(velocity_), a = grid::node_view(acceleration_);
  for_each_number(
      "idle nodes", v.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
        if (m(n, c) != 0.0) return;
        v(n, c) = d(n, c) / dt;
        a(n, c) = 0.0;
      });
}

void Inertia::begin(const grid::Vector& unbalanced) {
  acceleration_.update(-1.0, unbalanced, 0.0);
  supports_->clear(acceleration_);
  const auto m = grid::node_view(static_cast<const grid::Vector&>(mass_));
  const auto a = grid::node_view(acceleration_);
  for_each_number(
      "divide by mass", a.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
        a(n, c) = m(n, c) > 0.0 ? a(n, c) / m(n, c) : 0.0;
      });
  if (!body_.particles_carry_motion()) return;
  Kokkos::deep_copy(body_.particles().acceleration, 0.0);
  carry(acceleration_, body_.particles().acceleration);
}

void Inertia::resume(double load, const grid::Vector& u, const grid::Vector& velocity,
                     const grid::Vector& acceleration) {
  begins_ = false;
  load_ = load;
  step_ = 0.0;
  go_from(u);
  velocity_.assign(velocity);
  acceleration_.assign(acceleration);
}

double Inertia::balance_load(double end) const {
  return end - dynamics().scheme.alpha_f * (end - load_);
}

void Inertia::set_load(double load) {
  const double way = (load - load_) / (1.0 - dynamics().scheme.alpha_f);
  step_ = std::max(way * body_.problem().duration, 0.0);
  if (step_ == 0.0 || supports_ == nullptr) return;
  prescribe(load_ + way);
  supports_->rate(load, balancing_);
  balancing_.scale(1.0 / body_.problem().duration);
}

/// The accelerations and velocities of prescribed components at the end of a step, from within it:
/// load curves may have a corner there.
void Inertia::prescribe(double end) {
  const double bit = 1e-3 * (end - load_), time = body_.problem().duration;
  grid::Vector earlier(prescribed_.getMap());
  supports_->rate(end - bit, prescribed_);
  supports_->rate(end - 2.0 * bit, earlier);
  arriving_.update(2.0 / time, prescribed_, -1.0 / time, earlier, 0.0);
  prescribed_.update(-1.0 / (bit * time * time), earlier, 1.0 / (bit * time * time));
}

grid::Vector Inertia::arriving_velocity() const {
  grid::Vector v(velocity_, Teuchos::Copy);
  supports_->clear(v);
  v.update(1.0, arriving_, 1.0);
  return v;
}

grid::Vector Inertia::predicted(double load) const {
  const double dt = (load - load_) * body_.problem().duration;
  grid::Vector u(from_, Teuchos::Copy);
  u.update(dt, velocity_, 0.5 * dt * dt, acceleration_, 1.0);
  return u;
}

void Inertia::go_to_end(grid::Vector& u) const {
  const double factor = 1.0 / (1.0 - dynamics().scheme.alpha_f);
  if (factor != 1.0) u.update(1.0 - factor, from_, factor);
}

double Inertia::step_error(double load, const grid::Vector& u) const {
  const TimeScheme& scheme = dynamics().scheme;
  const double dt = (load - load_) * body_.problem().duration;
  grid::Vector error(u.getMap());
  const auto e = grid::node_view(error);
  const auto d = grid::node_view(u), from = grid::node_view(from_);
  const auto v = grid::node_view(velocity_), a = grid::node_view(acceleration_);
  for_each_number(
      "error of step", e.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
        const double a_1 = scheme.acceleration(dt, d(n, c) - from(n, c), v(n, c), a(n, c));
        e(n, c) = dt * dt * (scheme.beta - 1.0 / 6.0) * (a_1 - a(n, c));
      });
  supports_->clear(error);
  grid::Vector weighted(u.getMap());
  weighted.elementWiseMultiply(1.0, mass_, error, 0.0);
  return std::sqrt(std::max(weighted.dot(error), 0.0) * 3.0 / mass_.norm1());
}

void Inertia::arrive(double load, const grid::Vector& u) {
  const double dt = (load - load_) * body_.problem().duration;
  const AtEnd at_end{dynamics().scheme, dt};
  grid::Vector change(u, Teuchos::Copy);
  change.update(-1.0, from_, 1.0);
  const grid::Vector before(velocity_, Teuchos::Copy);
  const auto of = [&](const auto& d, const auto& v, const auto& a) {
    for_each_number(
        "end of step", v.extent(0),
        KOKKOS_LAMBDA(const int n, const int c) { at_end(d(n, c), v(n, c), a(n, c)); });
  };
  const auto& particles = body_.particles();
  if (!is_lumped()) of(carried_by(change), particles.velocity, particles.acceleration);
  of(grid::node_view(static_cast<const grid::Vector&>(change)), grid::node_view(velocity_),
     grid::node_view(acceleration_));
  if (has_idle_nodes_) carry_idle_nodes(dt, change);
  const grid::Vector free_velocity(velocity_, Teuchos::Copy),
      free_acceleration(acceleration_, Teuchos::Copy);
  prescribe(load);
  supports_->clear(acceleration_);
  acceleration_.update(1.0, prescribed_, 1.0);
  load_ = load;
  step_ = 0.0;
  go_from(u);
  follow(*supports_);
  if (!is_lumped()) {
    carry_difference(free_velocity, velocity_, particles.velocity);
    carry_difference(free_acceleration, acceleration_, particles.acceleration);
  } else if (body_.particles_carry_motion()) {
    carry_difference(before, velocity_, particles.velocity);
    carry_gradient(u);
    Kokkos::deep_copy(particles.acceleration, 0.0);
    carry(acceleration_, particles.acceleration);
  }
}

TermForce Inertia::force(const TrialState& state, grid::Vector& force) const {
  const base::Stage stage("inertia");
  is_lumped() ? nodal_force(state, force) : particle_force(state, force);
  TermForce all;
  all.size = force.norm2();
  all.rounding = 16.0 * std::numeric_limits<double>::epsilon() * mass_factor() * largest_mass_ *
                 state.u.norm2();
  if (dynamics().stiffness_damping > 0.0) add_stiffness_damping(state, force);
  return all;
}

void Inertia::nodal_force(const TrialState& state, grid::Vector& force) const {
  const AtBalance at_balance{dynamics().scheme, step_};
  const double mass_damping = dynamics().mass_damping;
  const auto f = grid::node_view(force);
  const auto u = grid::node_view(state.u), from = grid::node_view(from_);
  const auto v = grid::node_view(velocity_), a = grid::node_view(acceleration_);
  const auto m = grid::node_view(mass_);
  for_each_number(
      "inertia of nodes", f.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
        double v_b = v(n, c), a_b = a(n, c);
        at_balance(u(n, c) - from(n, c), v_b, a_b);
        f(n, c) = m(n, c) * (a_b + mass_damping * v_b);
      });
  if (step_ == 0.0) return;
  supports_->clear(force);
  force.elementWiseMultiply(1.0, mass_, prescribed_, 1.0);
}

/// The displacement from which the scheme makes of prescribed components the force that their curves
/// ask for; what it makes of the change of displacement alone swings about it.
grid::Vector Inertia::seen_by_scheme(const grid::Vector& u) const {
  const TimeScheme& scheme = dynamics().scheme;
  const AtBalance at_balance{scheme, step_};
  const double mass_damping = dynamics().mass_damping, per_displacement = 1.0 / mass_factor();
  grid::Vector lacks(u.getMap());
  const auto lack = grid::node_view(lacks);
  const auto d = grid::node_view(u), from = grid::node_view(from_);
  const auto v = grid::node_view(velocity_), a = grid::node_view(acceleration_);
  const auto v_told = grid::node_view(balancing_), a_end = grid::node_view(prescribed_);
  for_each_number(
      "lack of prescribed", lack.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
        double v_b = v(n, c), a_b = a(n, c);
        at_balance(d(n, c) - from(n, c), v_b, a_b);
        const double a_lacks = scheme.acceleration_at_balance(a(n, c), a_end(n, c)) - a_b;
        lack(n, c) = per_displacement * (a_lacks + mass_damping * (v_told(n, c) - v_b));
      });
  grid::Vector seen = supports_->prescribed_part(lacks);
  seen.update(1.0, u, 1.0);
  return seen;
}

void Inertia::particle_force(const TrialState& state, grid::Vector& force) const {
  const AtBalance at_balance{dynamics().scheme, step_};
  const double mass_damping = dynamics().mass_damping;
  const auto& particles = body_.particles();
  const auto v = particles.velocity, a = particles.acceleration;
  const NodeView carried("carried", v.extent(0));
  auto points = state.points;
  if (step_ > 0.0) points.displacement = body_.halo().gather(seen_by_scheme(state.u));
  body_.kernels().add_at_particles(points, carried);
  if (step_ > 0.0) body_.halo().gather(state.u);  // the terms after this one want it
  const NodeView from = carried_from_;
  const bool has_from = from.extent(0) == v.extent(0);
  for_each_number(
      "inertia of particles", v.extent(0), KOKKOS_LAMBDA(const int p, const int c) {
        const double d = carried(p, c) - (has_from ? from(p, c) : 0.0);
        double v_b = v(p, c), a_b = a(p, c);
        at_balance(d, v_b, a_b);
        carried(p, c) = a_b + mass_damping * v_b;
      });
  const NodeView masses("masses", mass_here_.extent(0));
  body_.kernels().project_to_nodes(state.points, carried, density_, masses,
                                   body_.halo().contributions());
  body_.halo().sum_to_owner(force);
}

/// beta_R K(u) v with the nodes' velocity at the balance.
void Inertia::add_stiffness_damping(const TrialState& state, grid::Vector& force) const {
  grid::Vector velocity(velocity_, Teuchos::Copy);
  if (step_ > 0.0) {
    const AtBalance at_balance{dynamics().scheme, step_};
    const auto u = grid::node_view(state.u), from = grid::node_view(from_);
    const auto v = grid::node_view(velocity);
    const auto a = grid::node_view(acceleration_);
    for_each_number(
        "velocity", v.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
          double a_b = a(n, c);
          at_balance(u(n, c) - from(n, c), v(n, c), a_b);
        });
    supports_->clear(velocity);
    velocity.update(1.0, balancing_, 1.0);
  }
  // The halo gathers one vector at a time: the terms after this one want u again.
  auto points = state.points;
  const NodeView displacement("u", points.displacement.extent(0));
  Kokkos::deep_copy(displacement, points.displacement);
  points.displacement = displacement;
  grid::Vector product(force.getMap());
  body_.stress()->tangent_times(points, body_.halo().gather(velocity),
                                body_.halo().contributions());
  body_.halo().sum_to_owner(product);
  force.update(dynamics().stiffness_damping, product, 1.0);
  body_.halo().gather(state.u);
}

/// What the balance's force of mass grows by with its displacement, over the mass [1/s^2].
double Inertia::mass_factor() const {
  if (step_ == 0.0) return 0.0;
  const TimeScheme& scheme = dynamics().scheme;
  return scheme.acceleration_rate(step_) + dynamics().mass_damping * scheme.velocity_rate(step_);
}

/// Stands right behind the tangent of stress, which stiffness damping scales.
template <class Rows>
void Inertia::add_to_tangent(const TrialState& state, const Rows& rows) const {
  if (step_ == 0.0) return;
  const double damping = dynamics().stiffness_damping;
  if (damping > 0.0)
    rows.scale(
        static_cast<typename Rows::Real>(1.0 + damping * dynamics().scheme.velocity_rate(step_)));
  const double factor = mass_factor();
  if (is_lumped()) {
    const NodeView here = mass_here_;
    for_each_number(
        "tangent of mass", here.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
          if (here(n, 0) > 0.0) rows.add_to_diagonal(n, c, factor * here(n, 0));
        });
    return;
  }
  std::vector<double> scaled = body_.problem().density;
  for (double& rho : scaled) rho *= factor * force_of_mass;
  body_.kernels().mass_tangent(state.points, grid::to_device("scaled density", scaled), rows);
}

std::int64_t Inertia::add_tangent(const TrialState& state,
                                  const transfer::BlockRows<Device>& rows) const {
  add_to_tangent(state, rows);
  return 0;
}

std::int64_t Inertia::add_tangent(const TrialState& state,
                                  const transfer::StencilRows<Device>& rows) const {
  add_to_tangent(state, rows);
  return 0;
}

void Inertia::add_tangent_times(const TrialState& state, const ConstNodeView& direction,
                                const NodeView& product) const {
  if (step_ == 0.0) return;
  const double factor = mass_factor();
  if (is_lumped()) {
    const NodeView here = mass_here_;
    for_each_number(
        "mass times", here.extent(0), KOKKOS_LAMBDA(const int n, const int c) {
          product(n, c) += factor * here(n, 0) * direction(n, c);
        });
  } else {
    auto points = state.points;
    points.displacement = direction;
    const NodeView carried("carried", body_.particles().volume.extent(0));
    const NodeView masses("masses", mass_here_.extent(0));
    body_.kernels().add_at_particles(points, carried);
    for_each_number(
        "scale", carried.extent(0),
        KOKKOS_LAMBDA(const int p, const int c) { carried(p, c) *= factor; });
    body_.kernels().project_to_nodes(points, carried, density_, masses, product);
  }
  const double damping = dynamics().stiffness_damping;
  if (damping == 0.0) return;
  const double share = damping * dynamics().scheme.velocity_rate(step_);
  const NodeView scaled("scaled", direction.extent(0));
  for_each_number(
      "scale", scaled.extent(0),
      KOKKOS_LAMBDA(const int n, const int c) { scaled(n, c) = share * direction(n, c); });
  body_.stress()->tangent_times(state.points, scaled, product);
}

grid::ConstNodeView Inertia::particle_velocity() const {
  if (body_.particles_carry_motion()) return body_.particles().velocity;
  return carried_by(velocity_);
}

double Inertia::kinetic_energy() const {
  if (is_lumped()) {
    grid::Vector momentum(velocity_.getMap());
    momentum.elementWiseMultiply(1.0, mass_, velocity_, 0.0);
    return 0.5 * momentum.dot(velocity_);
  }
  const auto particles = particles::on_host(body_.particles());
  const auto& density = body_.problem().density;
  double sum = 0.0;
  for (int p = 0; p < particles.count(); ++p) {
    double square = 0.0;
    for (int c = 0; c < 3; ++c) square += particles.velocity(p, c) * particles.velocity(p, c);
    sum += density[particles.material(p)] * particles.volume(p) * square;
  }
  return 0.5 * force_of_mass * body_.communicator().sum(sum);
}

double Inertia::damping_power(const TrialState& state) const {
  double power = 2.0 * dynamics().mass_damping * kinetic_energy();
  if (dynamics().stiffness_damping > 0.0) {
    grid::Vector force(velocity_.getMap());
    add_stiffness_damping(state, force);
    power += force.dot(velocity_);
  }
  return power;
}

}  // namespace stroma::mechanics
