// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/multigrid/BlockJacobi.hpp"
#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

grid::RCP<const tangent::StencilMatrix> as_stencil(const grid::RCP<const Operator>& tangent) {
  return Teuchos::rcp_dynamic_cast<const tangent::StencilMatrix>(tangent, true);
}

class MultigridPreconditioner : public Preconditioner {
 public:
  explicit MultigridPreconditioner(const mechanics::MomentumBalance& balance)
      : spacing_(balance.halo().partition().grid().spacing),
        patched_(mechanics::barely_held_elements(balance)) {}
  void compute(const grid::RCP<const Operator>& tangent) override {
    if (cycle_ == Teuchos::null)
      cycle_ =
          Teuchos::rcp(new multigrid::GeometricMultigrid(as_stencil(tangent), spacing_, patched_));
    cycle_->compute();
  }
  grid::RCP<const Operator> apply_inverse() const override { return cycle_; }

 private:
  std::array<double, 3> spacing_;
  multigrid::ElementPatches::Chosen patched_;
  grid::RCP<multigrid::GeometricMultigrid> cycle_;
};

class BlockJacobiPreconditioner : public Preconditioner {
 public:
  void compute(const grid::RCP<const Operator>& tangent) override {
    jacobi_ = Teuchos::rcp(new multigrid::BlockJacobi(as_stencil(tangent)));
  }
  bool worth_keeping() const override { return false; }
  grid::RCP<const Operator> apply_inverse() const override { return jacobi_; }

 private:
  grid::RCP<const Operator> jacobi_;
};

}  // namespace

std::unique_ptr<Preconditioner> make_geometric_multigrid(
    const mechanics::MomentumBalance& balance) {
  return std::make_unique<MultigridPreconditioner>(balance);
}
std::unique_ptr<Preconditioner> make_block_jacobi() {
  return std::make_unique<BlockJacobiPreconditioner>();
}

}  // namespace stroma::solver
