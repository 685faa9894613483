#include <Amesos2.hpp>

#include "base/Error.hpp"
#include "solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

/// A factorisation of the matrix, applied as a preconditioner: conjugate gradients then take one
/// iteration, and what rounding left is seen in their residual.
class DirectPreconditioner : public Preconditioner {
 public:
  void compute(const grid::RCP<mechanics::Matrix>& matrix) override {
    try {
      if (factors_ == Teuchos::null) {
        factors_ = Teuchos::rcp(new Factors(matrix));
      } else {
        factors_->factor_again();
      }
    } catch (const std::exception& error) {
      throw base::StepRejected(std::string("the tangent could not be factorised: ") + error.what());
    }
  }
  grid::RCP<const Operator> apply_inverse() const override { return factors_; }

 private:
  class Factors : public Operator {
   public:
    explicit Factors(const grid::RCP<mechanics::Matrix>& matrix)
        : matrix_(matrix),
          solver_(Amesos2::create<mechanics::Matrix, grid::MultiVector>("KLU2", matrix)) {
      solver_->symbolicFactorization().numericFactorization();
    }
    void factor_again() {
      solver_->setA(matrix_, Amesos2::SYMBFACT);
      solver_->numericFactorization();
    }
    grid::RCP<const grid::Map> getDomainMap() const override { return matrix_->getDomainMap(); }
    grid::RCP<const grid::Map> getRangeMap() const override { return matrix_->getRangeMap(); }
    void apply(const grid::MultiVector& x, grid::MultiVector& y, Teuchos::ETransp,
               double alpha, double beta) const override {
      if (alpha == 1.0 && beta == 0.0) {
        solver_->solve(&y, &x);
        return;
      }
      grid::MultiVector solution(y.getMap(), y.getNumVectors());
      solver_->solve(&solution, &x);
      y.update(alpha, solution, beta);
    }

   private:
    grid::RCP<mechanics::Matrix> matrix_;
    grid::RCP<Amesos2::Solver<mechanics::Matrix, grid::MultiVector>> solver_;
  };

  grid::RCP<Factors> factors_;
};

}  // namespace

std::unique_ptr<Preconditioner> make_direct() { return std::make_unique<DirectPreconditioner>(); }

}  // namespace stroma::solver
