// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/terms/ElasticForce.hpp"

#include <utility>

#include "stroma/base/Stage.hpp"

namespace stroma::mechanics {

ElasticForce::ElasticForce(const grid::Halo& halo, std::shared_ptr<const StressKernels> kernels)
    : halo_(halo), kernels_(std::move(kernels)) {}

TermForce ElasticForce::force(const TrialState& state, grid::Vector& force) const {
  const base::Stage stage("internal force");
  const std::int64_t inverted = kernels_->internal_force(state.points, halo_.contributions());
  halo_.sum_to_owner(force);
  return {inverted};
}

std::int64_t ElasticForce::add_tangent(const TrialState& state,
                                       const transfer::BlockRows<Device>& rows) const {
  return kernels_->tangent(state.points, rows);
}

std::int64_t ElasticForce::add_tangent(const TrialState& state,
                                       const transfer::StencilRows<Device>& rows) const {
  return kernels_->tangent(state.points, rows);
}

void ElasticForce::add_tangent_times(const TrialState& state, const ConstNodeView& direction,
                                     const NodeView& product) const {
  kernels_->tangent_times(state.points, direction, product);
}

void ElasticForce::accept(const TrialState& state) { kernels_->update_history(state.points); }

}  // namespace stroma::mechanics
