// SPDX-License-Identifier: BSD-3-Clause

#include <Amesos2.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include "stroma/base/Error.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

/// A copy without the entries that are zero, on another map. Rows of untouched and prescribed
/// components hold nothing else besides their diagonal; KLU2 would fill them in.
grid::RCP<tangent::Matrix> without_zeros(const tangent::Matrix& matrix,
                                         const grid::RCP<const grid::Map>& map) {
  const auto local = matrix.getLocalMatrixHost();
  const auto copy = Teuchos::rcp(new tangent::Matrix(map, map, matrix.getGlobalMaxNumRowEntries()));
  Teuchos::Array<grid::LocalOrdinal> columns;
  Teuchos::Array<double> values;
  for (int row = 0; row < local.numRows(); ++row) {
    columns.clear();
    values.clear();
    const auto entries = local.rowConst(row);
    for (int n = 0; n < entries.length; ++n) {
      if (entries.value(n) == 0.0) continue;
      columns.push_back(entries.colidx(n));
      values.push_back(entries.value(n));
    }
    copy->insertLocalValues(row, columns(), values());
  }
  copy->fillComplete(map, map);
  return copy;
}

/// LU factors of the matrix, held by rank 0: the matrix is brought there, and so is every
/// right-hand side. (Amesos2 can distribute KLU2 itself, but as of Trilinos 13.2 it then solves
/// another system: a tridiagonal one of 60 rows came back with an error of 9 % on two ranks.)
class GatheredFactors : public Operator {
 public:
  explicit GatheredFactors(const grid::RCP<tangent::Matrix>& matrix)
      : matrix_(matrix),
        root_map_(Teuchos::rcp(
            new grid::Map(static_cast<Tpetra::global_size_t>(matrix->getGlobalNumRows()),
                          matrix->getComm()->getRank() == 0 ? matrix->getGlobalNumRows() : 0, 0,
                          matrix->getComm()))),
        to_root_(Teuchos::rcp(new Tpetra::Import<>(matrix->getRowMap(), root_map_))) {}

  void factorize() {
    tangent::Matrix gathered(root_map_, 81);
    gathered.doImport(*matrix_, *to_root_, Tpetra::INSERT);
    gathered.fillComplete(root_map_, root_map_);
    bool failed = false;
    if (matrix_->getComm()->getRank() == 0) {
      // The same matrix on a communicator of rank 0 alone. Its columns are its rows.
      const auto alone = Teuchos::rcp(
          new grid::Map(static_cast<Tpetra::global_size_t>(matrix_->getGlobalNumRows()), 0,
                        Teuchos::rcp(new Teuchos::SerialComm<int>())));
      local_ = without_zeros(gathered, alone);
      right_side_ = Teuchos::rcp(new grid::MultiVector(alone, 1));
      solution_ = Teuchos::rcp(new grid::MultiVector(alone, 1));
      try {
        solver_ = Amesos2::create<tangent::Matrix, grid::MultiVector>("KLU2", local_);
        solver_->symbolicFactorization().numericFactorization();
      } catch (const std::exception&) {
        failed = true;
      }
    }
    int failed_on_root = failed ? 1 : 0;
    Teuchos::broadcast(*matrix_->getComm(), 0, Teuchos::outArg(failed_on_root));
    if (failed_on_root == 1) throw base::StepRejected("the tangent is singular: it has no factors");
  }

  grid::RCP<const grid::Map> getDomainMap() const override { return matrix_->getDomainMap(); }
  grid::RCP<const grid::Map> getRangeMap() const override { return matrix_->getRangeMap(); }

  void apply(const grid::MultiVector& x, grid::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    grid::MultiVector at_root(root_map_, 1), result(y.getMap(), 1);
    for (std::size_t v = 0; v < x.getNumVectors(); ++v) {
      at_root.doImport(*x.getVector(v), *to_root_, Tpetra::REPLACE);
      if (solver_ != Teuchos::null) {
        Tpetra::deep_copy(*right_side_, at_root);
        solver_->solve(solution_.ptr(), right_side_.ptr());
        Tpetra::deep_copy(at_root, *solution_);
      }
      result.doExport(at_root, *to_root_, Tpetra::REPLACE);
      y.getVectorNonConst(v)->update(alpha, result, beta);
    }
  }

 private:
  grid::RCP<tangent::Matrix> matrix_;
  grid::RCP<const grid::Map> root_map_;
  grid::RCP<const Tpetra::Import<>> to_root_;
  grid::RCP<tangent::Matrix> local_;  // on rank 0 only, as the rest
  grid::RCP<grid::MultiVector> right_side_, solution_;
  grid::RCP<Amesos2::Solver<tangent::Matrix, grid::MultiVector>> solver_;
};

/// The factorisation as a preconditioner: conjugate gradients then take one iteration, and what
/// rounding left is seen in their residual.
class DirectPreconditioner : public Preconditioner {
 public:
  void compute(const grid::RCP<const Operator>& tangent) override {
    if (factors_ == Teuchos::null) factors_ = Teuchos::rcp(new GatheredFactors(as_matrix(tangent)));
    factors_->factorize();
  }
  grid::RCP<const Operator> apply_inverse() const override { return factors_; }

 private:
  grid::RCP<GatheredFactors> factors_;
};

}  // namespace

std::unique_ptr<Preconditioner> make_direct() { return std::make_unique<DirectPreconditioner>(); }

}  // namespace stroma::solver
