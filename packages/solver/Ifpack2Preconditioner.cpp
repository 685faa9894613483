// SPDX-License-Identifier: BSD-3-Clause

#include <Ifpack2_Factory.hpp>

#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

/// Jacobi (the paper's) or a Chebyshev polynomial in the Jacobi-scaled matrix.
class Ifpack2Preconditioner : public Preconditioner {
 public:
  explicit Ifpack2Preconditioner(const SolverParameters& parameters)
      : method_(parameters.preconditioner == PreconditionerKind::chebyshev ? "CHEBYSHEV"
                                                                           : "RELAXATION") {
    if (parameters.preconditioner == PreconditionerKind::jacobi) {
      list_.set("relaxation: type", "Jacobi");
    } else {
      list_.set("chebyshev: degree", 4);
      list_.set("chebyshev: ratio eigenvalue", 30.0);
      // Power iterations approach the largest eigenvalue from below; beyond it the polynomial is
      // negative and conjugate gradients break down. More of them, and a margin.
      list_.set("chebyshev: eigenvalue max iterations", 30);
      list_.set("chebyshev: boost factor", 1.2);
    }
    if (parameters.ifpack2 != Teuchos::null) list_.setParameters(*parameters.ifpack2);
  }

  void compute(const grid::RCP<const Operator>& tangent) override {
    if (preconditioner_ == Teuchos::null) {
      preconditioner_ =
          Ifpack2::Factory().create<Tpetra::RowMatrix<double>>(method_, as_matrix(tangent));
      preconditioner_->setParameters(list_);
      preconditioner_->initialize();
    }
    preconditioner_->compute();
  }
  bool worth_keeping() const override { return false; }
  grid::RCP<const Operator> apply_inverse() const override { return preconditioner_; }

 private:
  std::string method_;
  Teuchos::ParameterList list_;
  grid::RCP<Ifpack2::Preconditioner<double>> preconditioner_;
};

}  // namespace

std::unique_ptr<Preconditioner> make_ifpack2(const SolverParameters& parameters) {
  return std::make_unique<Ifpack2Preconditioner>(parameters);
}

}  // namespace stroma::solver
