// SPDX-License-Identifier: BSD-3-Clause

#include <Ifpack2_Factory.hpp>
#include <stdexcept>

#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/mechanics/body/Lattice.hpp"
#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

using Smoother = Ifpack2::Preconditioner<double>;

/// What the smoother damps: the waves that hats do not have, of which the shortest resists least,
/// since the functions nearly cancel in it. Its share of the largest eigenvalue is 1/20 for
/// quadratic and 1/230 for cubic B-splines (docs/theory.md, section 9).
struct Range {
  int degree;    ///< of the polynomial: that which took the least time
  double ratio;  ///< largest eigenvalue by the smallest damped
};
Range range_of(int width) {
  const bool is_cubic = width > shape::kind_of(shape::ShapeFunctions::quadratic_b_spline).width;
  return is_cubic ? Range{8, 240.0} : Range{3, 12.0};
}

/// One cycle on two levels for the tangent K of wider shape functions. The coarse one is that of
/// the hats on the lattice under them, where a cycle M of the geometric multigrid stands for a
/// solve:
///
///     x = S b,   x += P M P^T (b - K x),   x += S (b - K x)
///
/// with P the interpolation of hats at the places of the functions (mechanics::Lattice), and S a
/// Chebyshev polynomial in the Jacobi-scaled tangent. Symmetric. Source: docs/theory.md, eq.
/// (9.6).
class HatsCycle : public Operator {
 public:
  HatsCycle(const grid::RCP<const tangent::Matrix>& matrix, const grid::RCP<Smoother>& smoother,
            const mechanics::Supports& supports, const mechanics::Lattice& lattice,
            const grid::RCP<const Operator>& coarse)
      : matrix_(matrix),
        smoother_(smoother),
        supports_(&supports),
        lattice_(&lattice),
        coarse_(coarse),
        residual_(matrix->getRangeMap()),
        correction_(matrix->getDomainMap()),
        coarse_residual_(lattice.halo().owned_map()),
        coarse_correction_(lattice.halo().owned_map()) {}

  grid::RCP<const grid::Map> getDomainMap() const override { return matrix_->getDomainMap(); }
  grid::RCP<const grid::Map> getRangeMap() const override { return matrix_->getRangeMap(); }
  bool hasTransposeApply() const override { return true; }  // symmetric

  void apply(const grid::MultiVector& b, grid::MultiVector& x, Teuchos::ETransp, double alpha,
             double beta) const override {
    if (alpha != 1.0 || beta != 0.0) throw std::logic_error("a cycle is applied as it is");
    for (std::size_t column = 0; column < b.getNumVectors(); ++column) {
      const auto right = b.getVector(column);
      const auto solution = x.getVectorNonConst(column);
      smoother_->apply(*right, *solution);
      find_residual(*right, *solution);
      supports_->clear(residual_);
      lattice_->forces_at_nodes(residual_, coarse_residual_);
      coarse_->apply(coarse_residual_, coarse_correction_);
      lattice_->to_coefficients(coarse_correction_, correction_);
      supports_->clear(correction_);
      solution->update(1.0, correction_, 1.0);
      find_residual(*right, *solution);
      smoother_->apply(residual_, correction_);
      solution->update(1.0, correction_, 1.0);
    }
  }

 private:
  void find_residual(const grid::Vector& b, const grid::Vector& x) const {
    matrix_->apply(x, residual_);
    residual_.update(1.0, b, -1.0);
  }

  grid::RCP<const tangent::Matrix> matrix_;
  grid::RCP<Smoother> smoother_;
  const mechanics::Supports* supports_;
  const mechanics::Lattice* lattice_;
  grid::RCP<const Operator> coarse_;
  mutable grid::Vector residual_, correction_, coarse_residual_, coarse_correction_;
};

class HatsMultigrid : public Preconditioner {
 public:
  explicit HatsMultigrid(const mechanics::MomentumBalance& balance)
      : balance_(&balance),
        lattice_(balance.halo()),
        hats_(balance.with_hats(lattice_.halo().partition())) {
    hats_->choose_tangent(mechanics::TangentForm::stencil);
    cycle_ = Teuchos::rcp(new multigrid::GeometricMultigrid(
        Teuchos::rcp_dynamic_cast<const tangent::StencilMatrix>(hats_->tangent(), true),
        lattice_.halo().partition().grid().spacing, mechanics::barely_held_elements(*hats_)));
    const Range range = range_of(balance.halo().partition().grid().width);
    smoothing_.set("chebyshev: degree", range.degree);
    smoothing_.set("chebyshev: ratio eigenvalue", range.ratio);
    smoothing_.set("chebyshev: eigenvalue max iterations", 20);
    smoothing_.set("chebyshev: boost factor", 1.2);
    smoothing_.set("chebyshev: zero starting solution", true);
  }

  void compute(const grid::RCP<const Operator>& tangent) override {
    const auto matrix = as_matrix(tangent);
    if (smoother_ == Teuchos::null) {
      smoother_ = Ifpack2::Factory().create<Tpetra::RowMatrix<double>>("CHEBYSHEV", matrix);
      smoother_->setParameters(smoothing_);
      smoother_->initialize();
      whole_ =
          Teuchos::rcp(new HatsCycle(matrix, smoother_, balance_->supports(), lattice_, cycle_));
    }
    smoother_->compute();
    grid::Vector u(lattice_.halo().owned_map());
    lattice_.values_at_nodes(*balance_->linearization_point(), u);
    hats_->follow(*balance_);
    if (hats_->assemble_tangent(u) > 0) {  // hats alone turn a particle inside out
      u.putScalar(0.0);
      hats_->assemble_tangent(u);
    }
    cycle_->compute();
  }
  grid::RCP<const Operator> apply_inverse() const override { return whole_; }

 private:
  const mechanics::MomentumBalance* balance_;
  mechanics::Lattice lattice_;
  std::unique_ptr<mechanics::MomentumBalance> hats_;
  grid::RCP<multigrid::GeometricMultigrid> cycle_;
  Teuchos::ParameterList smoothing_;
  grid::RCP<Smoother> smoother_;
  grid::RCP<const Operator> whole_;
};

}  // namespace

std::unique_ptr<Preconditioner> make_hats_multigrid(const mechanics::MomentumBalance& balance) {
  return std::make_unique<HatsMultigrid>(balance);
}

}  // namespace stroma::solver
