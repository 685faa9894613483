// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/MovingBody.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/mechanics/body/FittedGrid.hpp"
#include "stroma/particles/Migration.hpp"

namespace stroma::mechanics {
namespace {

bool is_movable(const Problem& problem) {
  return problem.method.reset ||
         problem.method.deformation_gradient == DeformationGradient::projected_displacement;
}

/// Whether all that moves or drives the body grows with the load, so that it goes on as it came.
bool follows_the_load(const Problem& problem) {
  const auto follows = [](const auto& named) { return named.second.curve.is_load(); };
  return std::all_of(problem.conditions.begin(), problem.conditions.end(), follows) &&
         std::all_of(problem.forces.begin(), problem.forces.end(), follows) &&
         std::all_of(problem.drives.begin(), problem.drives.end(), [](const MaterialDrives& m) {
           return m.active.is_load() && m.growth.is_load();
         });
}

particles::Particles<grid::Device> start_of(const base::Communicator& communicator,
                                            particles::Particles<grid::Device> particles,
                                            const Problem& problem) {
  if (!is_movable(problem)) return particles;
  particles::make_movable(communicator, particles);
  if (!problem.method.reset) particles.base_gradient = {};  // the base stays the undeformed body
  return particles;
}

}  // namespace

MovingBody::MovingBody(const base::Communicator& communicator, const grid::Partition& partition,
                       const particles::Particles<grid::Device>& particles, const Problem& problem)
    : communicator_(communicator),
      problem_(problem),
      balance_(std::make_unique<MomentumBalance>(
          communicator, partition, start_of(communicator, particles, problem), problem)),
      displacement_(std::make_unique<grid::Vector>(balance_->owned_map())) {}

namespace {

/// The balance of a body that goes on.
std::unique_ptr<MomentumBalance> balance_at(
    const base::Communicator& communicator, const grid::Partition& partition,
    particles::Particles<grid::Device> particles, const Problem& problem, const Motion& motion,
    const std::function<void(particles::Particles<grid::Device>&)>& restore) {
  particles = start_of(communicator, std::move(particles), problem);
  restore(particles);
  grid::Partition now = partition;
  if (motion.grid) {
    now = particles::balanced_partition(communicator, *motion.grid, particles);
    particles = particles::migrate(communicator, now, particles);
  }
  auto balance =
      std::make_unique<MomentumBalance>(communicator, now, particles, problem, motion.base_load);
  balance->resume(motion.history_load, motion.load);
  return balance;
}

}  // namespace

MovingBody::MovingBody(const base::Communicator& communicator, const grid::Partition& partition,
                       const particles::Particles<grid::Device>& particles, const Problem& problem,
                       const Motion& motion,
                       const std::function<void(particles::Particles<grid::Device>&)>& restore)
    : communicator_(communicator),
      problem_(problem),
      balance_(balance_at(communicator, partition, particles, problem, motion, restore)),
      displacement_(std::make_unique<grid::Vector>(balance_->owned_map())),
      motion_(motion) {}

void MovingBody::resume(const grid::Vector& u, const grid::Vector* previous) {
  displacement_->assign(u);
  previous_.reset();
  if (previous != nullptr) previous_ = std::make_unique<grid::Vector>(*previous, Teuchos::Copy);
}

void MovingBody::resume_motion(const grid::Vector& velocity, const grid::Vector& acceleration) {
  balance_->inertia()->resume(motion_.load, *displacement_, velocity, acceleration);
  balance_->forget_forces();
  is_predictable_ = motion_.load > 0.0;
}

void MovingBody::stabilize(double stabilization) {
  problem_.method.stabilization = stabilization;
  balance_->stabilize(stabilization);
}

bool MovingBody::begin_step() {
  if (!motion_.has_news) return false;
  if (motion_.history_load != motion_.load) balance_->accept(*displacement_);
  motion_.history_load = motion_.load;
  if (problem_.method.reset) reset_grid();
  motion_.has_news = false;
  if (problem_.method.deformation_gradient == DeformationGradient::projected_displacement)
    project();
  return problem_.method.reset;
}

void MovingBody::rest_on(const grid::Partition& partition,
                         const particles::Particles<grid::Device>& particles) {
  try {
    balance_ = std::make_unique<MomentumBalance>(communicator_, partition, particles, problem_,
                                                 motion_.load);
  } catch (const base::InputError& error) {
    // The conditions were fine in the undeformed body: the motion has brought them into conflict,
    // or torn the body apart.
    throw base::RunError(
        base::format("when the grid was reset at load %.6g: %s", motion_.load, error.what()));
  }
  displacement_ = std::make_unique<grid::Vector>(balance_->owned_map());
  previous_.reset();
}

void MovingBody::reset_grid() {
  const base::Stage stage("grid reset");
  auto moved = balance_->body().moved_particles(*displacement_);
  const grid::Grid grid = fitted_grid(communicator_, problem_, motion_.load,
                                      balance_->halo().partition().grid(), moved);
  const grid::Partition partition = particles::balanced_partition(communicator_, grid, moved);
  moved = particles::migrate(communicator_, partition, moved);
  rest_on(partition, moved);
  motion_.grid = grid;
  motion_.base_load = motion_.load;
}

void MovingBody::project() {
  grid::Vector projected(balance_->owned_map());
  balance_->body().project_displacement(*displacement_, projected);
  if (problem_.method.reset) {
    balance_->body().set_base_gradient(projected);
    // How far elements are filled, and how stiff they are, follows from the projected gradients.
    rest_on(balance_->halo().partition(), balance_->body().particles());
  } else {
    balance_->body().replace_displacement(*displacement_, projected);
    balance_->forget_forces();
    previous_->update(1.0, projected, -1.0, *displacement_, 1.0);  // the last step's change stays
    displacement_->assign(projected);
  }
}

std::optional<grid::Vector> MovingBody::extrapolated(double load) const {
  if (problem_.dynamics || !follows_the_load(problem_)) return std::nullopt;
  return on_the_line(load);
}

std::optional<grid::Vector> MovingBody::predicted(double load) const {
  if (!is_predictable_ || balance_->inertia()->has_idle_nodes()) return std::nullopt;
  if (is_line_better_)
    if (auto line = on_the_line(load)) return line;
  return balance_->inertia()->predicted(load);
}

/// Through the last two accepted steps.
std::optional<grid::Vector> MovingBody::on_the_line(double load) const {
  if (!previous_) return std::nullopt;
  const double ratio = (load - motion_.load) / (motion_.load - motion_.previous_load);
  grid::Vector u(*displacement_, Teuchos::Copy);
  u.update(-ratio, *previous_, 1.0 + ratio);
  return u;
}

void MovingBody::accept(double load, const grid::Vector& u) {
  if (problem_.dynamics) {
    const auto distance = [&](grid::Vector guess) {
      guess.update(-1.0, u, 1.0);
      return guess.norm2();
    };
    const auto line = on_the_line(load);
    is_line_better_ = line && distance(*line) < distance(balance_->inertia()->predicted(load));
  }
  previous_ = std::move(displacement_);
  displacement_ = std::make_unique<grid::Vector>(u, Teuchos::Copy);
  motion_.previous_load = motion_.load;
  motion_.load = load;
  motion_.has_news = true;
  is_predictable_ = true;
  balance_->arrive(load, u);
}

}  // namespace stroma::mechanics
