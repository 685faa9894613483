// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/MomentumBalance.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "stroma/base/Stage.hpp"
#include "stroma/mechanics/conditions/FindSupports.hpp"
#include "stroma/mechanics/terms/DeadForces.hpp"
#include "stroma/mechanics/terms/ElasticForce.hpp"
#include "stroma/mechanics/terms/Springs.hpp"

namespace stroma::mechanics {
namespace {

bool are_same(const grid::Vector& a, const grid::Vector& b) {
  const auto x = grid::node_view(a), y = grid::node_view(b);
  int differences = 0;
  Kokkos::parallel_reduce(
      "same displacement",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(x.extent(0))),
      KOKKOS_LAMBDA(const int n, int& sum) {
        for (int c = 0; c < 3; ++c) sum += x(n, c) == y(n, c) ? 0 : 1;
      },
      differences);
  return differences == 0;
}

}  // namespace

MomentumBalance::MomentumBalance(const base::Communicator& communicator,
                                 const grid::Partition& partition,
                                 const particles::Particles<Device>& particles,
                                 const Problem& problem, double base_load, bool is_refused_if_loose)
    : body_(communicator, partition, particles, problem),
      base_load_(base_load),
      load_(base_load),
      history_load_(base_load),
      terms_(terms_of(problem)),
      stiffest_diagonal_(body_.typical_diagonal()) {
  body_.set_load(load_, 0.0);
  for (const auto& term : terms_) {
    stiffest_diagonal_ = std::max(stiffest_diagonal_, term->stiffest_diagonal());
    term->set_load(load_);
  }
  find_supports(is_refused_if_loose);
  if (inertia_ != nullptr) begin_motion();
}

void MomentumBalance::begin_motion() {
  inertia_->follow(*supports_);
  if (!inertia_->begins()) return;
  const grid::Vector at_rest(owned_map());
  inertia_->begin(*forces(at_rest).unbalanced);
  forces_load_.reset();
}

MomentumBalance::MomentumBalance(const base::Communicator& communicator,
                                 const grid::Partition& partition,
                                 const particles::Particles<Device>& particles, const Laws& laws,
                                 const NamedConditions& conditions)
    : MomentumBalance(communicator, partition, particles,
                      Problem{partition.grid(), laws, conditions}) {}

MomentumBalance::Terms MomentumBalance::terms_of(const Problem& problem) {
  Terms terms;
  terms.push_back(std::make_unique<ElasticForce>(body_.halo(), body_.stress()));
  if (problem.dynamics) {  // second, for its damping scales the tangent of stress
    auto inertia = std::make_unique<Inertia>(body_, base_load_);
    inertia_ = inertia.get();
    terms.push_back(std::move(inertia));
  }
  if (has_springs(problem)) {
    auto springs = std::make_unique<Springs>(body_);
    springs_ = springs.get();
    terms.push_back(std::move(springs));
  }
  if (has_dead_forces(problem)) terms.push_back(std::make_unique<DeadForces>(body_));
  for (const auto& make : problem.terms) terms.push_back(make(body_));
  return terms;
}

void MomentumBalance::find_supports(bool is_refused_if_loose) {
  OtherActions others;
  others.visit_held = [&](const Pieces& pieces, const HeldVisitor& visit) {
    for (const auto& term : terms_) term->visit_held(pieces, visit);
  };
  for (const auto& term : terms_)
    for (const auto& load : term->dead_loads()) others.loads.push_back(load);
  if (body_.particles().base_gradient.extent(0) != 0) {
    const grid::Vector at_rest(owned_map());
    find_steady_forces(state(at_rest));
    others.stress = steady_;
  }
  supports_ = mechanics::find_supports(body_, others, base_load_, is_refused_if_loose);
}

void MomentumBalance::set_load(double load) {
  load_ = load;
  const double step = (load - history_load_) * problem().duration;
  if (stress_follows_load() && forces_load_ != load_) forget_forces();
  body_.set_load(load, step);
  for (const auto& term : terms_) term->set_load(load);
}

void MomentumBalance::go_straight(const StraightStep& step) {
  supports_->go_straight(step);
  if (springs_ != nullptr) springs_->go_straight(step);
}

bool MomentumBalance::stress_follows_load() const {
  return !problem().drives.empty() ||
         std::any_of(terms_.begin(), terms_.end(),
                     [](const auto& term) { return term->remembers(); });
}

void MomentumBalance::stabilize(double stabilization) {
  body_.stabilize(stabilization);
  forget_forces();
}

void MomentumBalance::forget_forces() {
  forces_at_ = steady_ = Teuchos::null;
  forces_load_.reset();
  forces_ = {};
}

bool MomentumBalance::has_forces_at(const grid::Vector& u) const {
  return forces_at_ != Teuchos::null && !body_.communicator().any(!are_same(u, *forces_at_));
}

/// Adds to a force (null: none yet) and to what is said of it.
grid::RCP<grid::Vector> MomentumBalance::with_terms(bool changing, const TrialState& state,
                                                    grid::RCP<grid::Vector> sum,
                                                    TermForce& all) const {
  for (const auto& term : terms_) {
    if (term->changes_with_load() != changing) continue;
    const auto force = Teuchos::rcp(new grid::Vector(owned_map()));
    const TermForce one = term->force(state, *force);
    all.inverted += one.inverted;
    all.size = std::max(all.size, one.size);
    all.rounding = std::max(all.rounding, one.rounding);
    if (sum != Teuchos::null) force->update(1.0, *sum, 1.0);
    sum = force;
  }
  return sum;
}

void MomentumBalance::find_steady_forces(const TrialState& state) {
  forget_forces();
  of_steady_ = {};
  steady_ = with_terms(false, state, Teuchos::null, of_steady_);
  forces_at_ = Teuchos::rcp(new grid::Vector(state.u, Teuchos::Copy));
}

const ForceBalance& MomentumBalance::forces(const grid::Vector& u) {
  const bool is_here = has_forces_at(u);
  if (is_here && forces_load_ == load_) return forces_;
  const auto at_u = state(u);
  if (!is_here) find_steady_forces(at_u);
  TermForce all = of_steady_;
  const auto unbalanced = with_terms(true, at_u, steady_, all);
  forces_.unbalanced = unbalanced;
  forces_.scale = std::max(supports_->reaction_norm(*unbalanced), all.size);
  forces_.hold = supports_->hold_norm(*unbalanced);
  forces_.rounding = std::max(
      16.0 * std::numeric_limits<double>::epsilon() * stiffest_diagonal_ * u.norm2(), all.rounding);
  forces_.inverted = body_.communicator().sum(all.inverted);
  forces_load_ = load_;
  return forces_;
}

std::int64_t MomentumBalance::residual(const grid::Vector& u, grid::Vector& r) {
  const ForceBalance& at_u = forces(u);
  r.assign(*at_u.unbalanced);
  supports_->clear(r);
  return at_u.inverted;
}

/// Terms are differenced: exactly, to rounding, where their force is linear in the load.
void MomentumBalance::load_derivative(const grid::Vector& u, grid::Vector& derivative) {
  grid::Vector rate(owned_map()), force(owned_map());
  supports_->rate(load_, rate);
  tangent_times(u, rate, derivative);
  const double load = load_;
  constexpr double step = 1e-3;
  for (const double sign : {1.0, -1.0}) {
    set_load(load + sign * step);
    const auto at_u = state(u);
    for (const auto& term : terms_) {
      if (!term->changes_with_load() && !stress_follows_load()) continue;
      term->force(at_u, force);
      derivative.update(sign / (2.0 * step), force, 1.0);
    }
  }
  set_load(load);
  supports_->clear(derivative);
}

std::vector<std::array<double, 3>> MomentumBalance::reactions(const grid::Vector& u) {
  auto reactions = supports_->reactions(*forces(u).unbalanced);
  if (terms_.size() == 1) return reactions;  // stress alone, which acts for no condition
  const auto at_u = state(u);
  for (const auto& term : terms_) term->add_reactions(at_u, reactions);
  return reactions;
}

std::vector<double> MomentumBalance::torques(const grid::Vector& u) {
  const NamedConditions& conditions = problem().conditions;
  const auto turns = [](const auto& named) { return named.second.rotation.has_value(); };
  if (std::none_of(conditions.begin(), conditions.end(), turns)) return {};
  std::vector<double> all = supports_->torques(u, *forces(u).unbalanced);
  const auto at_u = state(u);
  for (const auto& term : terms_) term->add_torques(at_u, all);
  std::vector<double> of_those_that_turn;
  for (std::size_t m = 0; m < all.size(); ++m)
    if (turns(conditions[m])) of_those_that_turn.push_back(all[m]);
  return of_those_that_turn;
}

void MomentumBalance::begin_pulling(const grid::Vector& u) {
  if (springs_ == nullptr) return;
  springs_->begin_pulling(state(u));
  forces_load_.reset();
}

bool MomentumBalance::pull_on(const grid::Vector& u, double share) {
  if (springs_ == nullptr) return false;
  const ForceBalance& at_u = forces(u);
  constexpr double much = 1e4;  // times what rounding leaves
  if (at_u.scale <= much * at_u.rounding || springs_->slack(state(u)) <= share * at_u.scale)
    return false;
  springs_->pull_on(state(u));
  forces_load_.reset();
  return true;
}

double MomentumBalance::distance_of_faces(const grid::Vector& u) const {
  return springs_ == nullptr ? 0.0 : springs_->distance(state(u));
}

double MomentumBalance::support_energy(const grid::Vector& u) const {
  const auto at_u = state(u);
  double energy = 0.0;
  for (const auto& term : terms_) energy += term->support_energy(at_u);
  return energy;
}

std::int64_t MomentumBalance::internal_force(const grid::Vector& u, grid::Vector& force) const {
  return internal_force(body_.stress(), u, force);
}

std::int64_t MomentumBalance::internal_force(const std::shared_ptr<const StressKernels>& laws,
                                             const grid::Vector& u, grid::Vector& force) const {
  return body_.communicator().sum(ElasticForce(body_.halo(), laws).force(state(u), force).inverted);
}

void MomentumBalance::choose_tangent(TangentForm form) {
  if (form == form_) return;
  form_ = form;
  forget_tangent();
}

void MomentumBalance::forget_tangent() {
  rows_.reset();
  stencil_ = Teuchos::null;
  linearized_at_ = Teuchos::null;
}

grid::RCP<Tpetra::Operator<double>> MomentumBalance::tangent() {
  if (form_ == TangentForm::compressed_rows) return tangent_matrix();
  if (stencil_ == Teuchos::null)
    stencil_ = Teuchos::rcp(
        new tangent::StencilMatrix(body_.halo(), supports_->held(), body_.typical_diagonal()));
  return stencil_;
}

grid::RCP<tangent::Matrix> MomentumBalance::tangent_matrix() {
  if (form_ != TangentForm::compressed_rows)
    throw std::logic_error("the tangent is stored as a stencil, not as compressed rows");
  if (!rows_) {
    const base::Stage stage("graph");
    rows_ = std::make_unique<tangent::TangentMatrix>(body_.halo(), supports_->held(),
                                                     body_.typical_diagonal());
  }
  return rows_->matrix();
}

std::int64_t MomentumBalance::assemble_tangent(const grid::Vector& u) {
  tangent();
  if (has_forces_at(u))
    linearized_at_ = forces_at_;
  else
    linearized_at_ = Teuchos::rcp(new grid::Vector(u, Teuchos::Copy));
  const base::Stage stage("tangent");
  std::int64_t inverted = 0;
  const auto assemble = [&](auto& matrix) {
    const auto at_u = state(u);
    const auto rows = matrix.begin();
    for (const auto& term : terms_) inverted += term->add_tangent(at_u, rows);
    matrix.finish();
  };
  if (form_ == TangentForm::stencil)
    assemble(*stencil_);
  else
    assemble(*rows_);
  return body_.communicator().sum(inverted);
}

std::unique_ptr<MomentumBalance> MomentumBalance::with_hats(const grid::Partition& lattice) const {
  Problem problem = body_.problem();
  problem.method.shape_functions = shape::ShapeFunctions::linear;
  auto hats = std::make_unique<MomentumBalance>(
      body_.communicator(), lattice, body_.particles_on(lattice), problem, base_load_, false);
  for (const auto& term : hats->terms_) term->lump();
  hats->forget_forces();
  return hats;
}

void MomentumBalance::tangent_times(const grid::Vector& u, const grid::Vector& v,
                                    grid::Vector& product) const {
  auto at_u = state(u);
  // The halo has one buffer for gathered values: keep u's while v is gathered.
  const grid::NodeView displacement("u", at_u.points.displacement.extent(0));
  Kokkos::deep_copy(displacement, at_u.points.displacement);
  at_u.points.displacement = displacement;
  const grid::ConstNodeView direction = halo().gather(v);
  const grid::NodeView sum = halo().contributions();
  for (const auto& term : terms_) term->add_tangent_times(at_u, direction, sum);
  halo().sum_to_owner(product);
}

void MomentumBalance::arrive(double load, const grid::Vector& u) {
  if (inertia_ == nullptr) return;
  inertia_->arrive(load, u);
  forces_load_.reset();
}

void MomentumBalance::follow(const MomentumBalance& other) {
  body_.take_history(other.body_);
  if (inertia_ != nullptr) inertia_->take_step(*other.inertia_);
}

grid::Vector MomentumBalance::external_force(const grid::Vector& u) {
  // At prescribed components what is unbalanced is the force of the supports.
  grid::Vector sum = supports_->prescribed_part(*forces(u).unbalanced);
  const auto at_u = state(u);
  grid::Vector force(owned_map());
  for (const auto& term : terms_) {
    if (term == terms_.front() || term.get() == inertia_) continue;  // the first is that of stress
    term->force(at_u, force);
    sum.update(-1.0, force, 1.0);
  }
  return sum;
}

double MomentumBalance::damping_power(const grid::Vector& u) const {
  return inertia_->damping_power(state(u));
}

void MomentumBalance::accept(const grid::Vector& u) {
  const auto remembers = [](const auto& term) { return term->remembers(); };
  if (std::any_of(terms_.begin(), terms_.end(), remembers)) {
    const auto at_u = state(u);
    for (const auto& term : terms_) term->accept(at_u);
    forget_forces();
  }
  history_load_ = load_;
  body_.set_load(load_, 0.0);
}

void MomentumBalance::resume(double history_load, double load) {
  history_load_ = history_load;
  set_load(load);
}

}  // namespace stroma::mechanics
