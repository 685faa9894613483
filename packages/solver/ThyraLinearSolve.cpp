// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/ThyraLinearSolve.hpp"

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_LinearOpWithSolveBase.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>

#include "stroma/base/Error.hpp"

namespace stroma::solver {
namespace {

using Extract = Thyra::TpetraOperatorVectorExtraction<double, grid::LocalOrdinal,
                                                      grid::GlobalOrdinal, grid::Map::node_type>;

class TangentWithSolve : public Thyra::LinearOpWithSolveBase<double> {
 public:
  TangentWithSolve(LinearSolver& solver, OnIndefinite on_indefinite)
      : solver_(&solver), on_indefinite_(on_indefinite) {}

  void set(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source) {
    source_ = source;
    tangent_ = source == Teuchos::null ? Teuchos::null : source->getOp();
    if (tangent_ == Teuchos::null) return;
    solver_->set_tangent(Extract::getConstTpetraOperator(tangent_));
  }
  const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source() const { return source_; }

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> range() const override {
    return tangent_ == Teuchos::null ? Teuchos::null : tangent_->range();
  }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> domain() const override {
    return tangent_ == Teuchos::null ? Teuchos::null : tangent_->domain();
  }

 protected:
  bool opSupportedImpl(Thyra::EOpTransp) const override { return true; }
  void applyImpl(const Thyra::EOpTransp transpose, const Thyra::MultiVectorBase<double>& x,
                 const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& y, const double alpha,
                 const double beta) const override {
    Thyra::apply(*tangent_, transpose, x, y, alpha, beta);
  }
  bool solveSupportsImpl(Thyra::EOpTransp) const override { return true; }  // symmetric
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp,
                                         const Thyra::SolveMeasureType&) const override {
    return true;
  }
  Thyra::SolveStatus<double> solveImpl(
      const Thyra::EOpTransp, const Thyra::MultiVectorBase<double>& b,
      const Teuchos::Ptr<Thyra::MultiVectorBase<double>>& x,
      const Teuchos::Ptr<const Thyra::SolveCriteria<double>> criteria) const override {
    const auto rhs = Extract::getConstTpetraMultiVector(Teuchos::rcpFromRef(b));
    const auto solution = Extract::getTpetraMultiVector(Teuchos::rcpFromPtr(x));
    const bool is_asked =
        criteria != Teuchos::null &&
        criteria->requestedTol != Thyra::SolveCriteria<double>::unspecifiedTolerance();
    Thyra::SolveStatus<double> status;
    const LinearResult result =
        answer(*rhs, *solution, is_asked ? criteria->requestedTol : 0.0, status.message);
    status.solveStatus =
        result.converged ? Thyra::SOLVE_STATUS_CONVERGED : Thyra::SOLVE_STATUS_UNCONVERGED;
    status.achievedTol = result.achieved;
    status.extraParameters = Teuchos::parameterList();
    status.extraParameters->set("Iteration Count", result.iterations);
    return status;
  }

 private:
  LinearResult answer(const grid::MultiVector& rhs, grid::MultiVector& solution, double tolerance,
                      std::string& message) const {
    try {
      return solver_->solve(rhs, solution, tolerance);
    } catch (const base::StepRejected& rejected) {
      if (on_indefinite_ == OnIndefinite::reject_step) throw;
      solution.putScalar(0.0);
      message = rejected.what();
      LinearResult none;
      none.achieved = 1.0;
      return none;
    }
  }

  LinearSolver* solver_;
  OnIndefinite on_indefinite_;
  Teuchos::RCP<const Thyra::LinearOpSourceBase<double>> source_;
  Teuchos::RCP<const Thyra::LinearOpBase<double>> tangent_;
};

class Factory : public Thyra::LinearOpWithSolveFactoryBase<double> {
 public:
  Factory(LinearSolver& solver, OnIndefinite on_indefinite)
      : solver_(&solver), on_indefinite_(on_indefinite) {}

  bool isCompatible(const Thyra::LinearOpSourceBase<double>&) const override { return true; }
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> createOp() const override {
    return Teuchos::rcp(new TangentWithSolve(*solver_, on_indefinite_));
  }
  void initializeOp(const Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>& source,
                    Thyra::LinearOpWithSolveBase<double>* op,
                    const Thyra::ESupportSolveUse) const override {
    dynamic_cast<TangentWithSolve&>(*op).set(source);
  }
  void uninitializeOp(Thyra::LinearOpWithSolveBase<double>* op,
                      Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>* source,
                      Teuchos::RCP<const Thyra::PreconditionerBase<double>>* preconditioner,
                      Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>* approximate_source,
                      Thyra::ESupportSolveUse* use) const override {
    auto& tangent = dynamic_cast<TangentWithSolve&>(*op);
    if (source) *source = tangent.source();
    if (preconditioner) *preconditioner = Teuchos::null;
    if (approximate_source) *approximate_source = Teuchos::null;
    if (use) *use = Thyra::SUPPORT_SOLVE_UNSPECIFIED;
    tangent.set(Teuchos::null);
  }

  // No parameters of its own: LinearSolver has read the deck.
  void setParameterList(const Teuchos::RCP<Teuchos::ParameterList>& list) override { list_ = list; }
  Teuchos::RCP<Teuchos::ParameterList> getNonconstParameterList() override { return list_; }
  Teuchos::RCP<Teuchos::ParameterList> unsetParameterList() override {
    const auto list = list_;
    list_ = Teuchos::null;
    return list;
  }

 private:
  LinearSolver* solver_;
  OnIndefinite on_indefinite_;
  Teuchos::RCP<Teuchos::ParameterList> list_;
};

}  // namespace

Teuchos::RCP<Thyra::LinearOpWithSolveFactoryBase<double>> thyra_factory(
    LinearSolver& solver, OnIndefinite on_indefinite) {
  return Teuchos::rcp(new Factory(solver, on_indefinite));
}

}  // namespace stroma::solver
