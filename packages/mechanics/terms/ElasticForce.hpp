// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The force of the material's stress.

#include <memory>

#include "stroma/grid/Halo.hpp"
#include "stroma/mechanics/kernels/StressKernels.hpp"
#include "stroma/mechanics/terms/Term.hpp"

namespace stroma::mechanics {

/// f_Ii = sum_p V0 tau_ij dN_I/dx_j  [pN], of particles and of the fictitious points that stand
/// beside them in barely filled elements. Source: docs/theory.md, eq. (4.3).
class ElasticForce : public Term {
 public:
  /// \param halo     outlives the term
  /// \param kernels  of the body's laws and shape functions
  ElasticForce(const grid::Halo& halo, std::shared_ptr<const StressKernels> kernels);

  bool changes_with_load() const override { return false; }
  TermForce force(const TrialState& state, grid::Vector& force) const override;
  std::int64_t add_tangent(const TrialState& state,
                           const transfer::BlockRows<Device>& rows) const override;
  std::int64_t add_tangent(const TrialState& state,
                           const transfer::StencilRows<Device>& rows) const override;
  void add_tangent_times(const TrialState& state, const ConstNodeView& direction,
                         const NodeView& product) const override;
  bool remembers() const override { return kernels_->states() > 0; }
  /// Lets the laws remember the displacement (transfer::UpdateHistory): from now on, what is asked of
  /// them is asked for one that comes after it.
  void accept(const TrialState& state) override;

 private:
  const grid::Halo& halo_;
  std::shared_ptr<const StressKernels> kernels_;
};

}  // namespace stroma::mechanics
