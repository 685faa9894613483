// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// An application that couples Stroma's model to a second physics, in a product space: the grip
/// hangs on the spring of a testing machine. Unknowns are the displacement u and the load factor s;
///
///     r_u = r(u, s),     r_s = R(u, s) - k (d - s),
///
/// with R the force of the grip on the body, k the machine's stiffness per load factor, and d where
/// the machine is driven to. NOX drives Newton on both; the tangent is bordered,
///
///     W = [ K         dr/ds ]
///         [ dR/du     dR/ds + k ].

#include <NOX.H>
#include <NOX_Thyra.H>

#include <Thyra_DefaultProductVectorSpace.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_ProductVectorBase.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>
#include <vector>

#include "Block.hpp"
#include "stroma/solver/NewtonSolver.hpp"
#include "stroma/solver/ThyraModel.hpp"

namespace {

using namespace stroma;
using Vector = Thyra::VectorBase<double>;
using MultiVector = Thyra::MultiVectorBase<double>;
using Space = Thyra::VectorSpaceBase<double>;
using Extract = Thyra::TpetraOperatorVectorExtraction<double, grid::LocalOrdinal,
                                                      grid::GlobalOrdinal, grid::Map::node_type>;
using Teuchos::RCP;

constexpr double machine = 2.0 * consumer::expected_force;  // k [pN]
constexpr double driven_to = 4.0;                           // a strain of 40 %, but for the spring

RCP<const Vector> part(const Vector& x, int block) {
  return dynamic_cast<const Thyra::ProductVectorBase<double>&>(x).getVectorBlock(block);
}
RCP<Vector> part(Vector& x, int block) {
  return dynamic_cast<Thyra::ProductVectorBase<double>&>(x).getNonconstVectorBlock(block);
}
double number(const Vector& x) { return Thyra::get_ele(x, 0); }

/// The bordered tangent.
class Tangent : public Thyra::LinearOpBase<double> {
 public:
  Tangent(const RCP<const Space>& space, const RCP<solver::ThyraModel>& model,
          mechanics::MomentumBalance& balance)
      : space_(space), model_(model), balance_(&balance), K_(model->create_W_op()) {}

  void assemble(const RCP<const Vector>& u, const RCP<const Vector>& s) {
    auto in = model_->createInArgs();
    in.set_x(u);
    in.set_p(0, s);
    auto out = model_->createOutArgs();
    out.set_W_op(K_);
    along_ = Thyra::createMember(model_->get_f_space());
    out.set_DfDp(0,
                 Thyra::ModelEvaluatorBase::Derivative<double>(
                     RCP<MultiVector>(along_), Thyra::ModelEvaluatorBase::DERIV_MV_JACOBIAN_FORM));
    model_->evalModel(in, out);
    at_ = Teuchos::rcp(new grid::Vector(*Extract::getConstTpetraVector(u), Teuchos::Copy));
    balance_->supports().impose(balance_->load(), *at_);
    grid::Vector rate(balance_->owned_map());
    balance_->supports().rate(balance_->load(), rate);
    force_along_ = force_of(rate);
    solve_ = Thyra::linearOpWithSolve<double>(*model_->get_W_factory(), K_);
  }

  /// x = W^-1 b, by two solves with K.
  void solve(const Vector& b, Vector& x) const {
    const auto a = Thyra::createMember(model_->get_x_space()), c = a->clone_v();
    for (const auto& [right, left] :
         {std::pair{part(b, 0), a}, std::pair{RCP<const Vector>(along_), c}}) {
      Thyra::assign(left.ptr(), 0.0);
      solve_->solve(Thyra::NOTRANS, *right, left.ptr());
    }
    const double s = (number(*part(b, 1)) - slope(*a)) / (machine + force_along_ - slope(*c));
    Thyra::V_VpStV(part(x, 0).ptr(), *a, -s, *c);
    Thyra::put_scalar(s, part(x, 1).ptr());
  }

  RCP<const Space> range() const override { return space_; }
  RCP<const Space> domain() const override { return space_; }

 protected:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override {
    return transpose == Thyra::NOTRANS;
  }
  void applyImpl(Thyra::EOpTransp, const MultiVector& X, const Teuchos::Ptr<MultiVector>& Y,
                 double alpha, double beta) const override {
    for (Teuchos::Ordinal column = 0; column < X.domain()->dim(); ++column) {
      const auto x = X.col(column);
      const auto y = Y->col(column), product = y->clone_v();
      const auto v = part(*x, 0);
      const double s = number(*part(*x, 1));
      Thyra::apply(*K_, Thyra::NOTRANS, *v, part(*product, 0).ptr());
      Thyra::Vp_StV(part(*product, 0).ptr(), s, *along_);
      Thyra::put_scalar(slope(*v) + (machine + force_along_) * s, part(*product, 1).ptr());
      Thyra::Vt_S(y.ptr(), beta);
      Thyra::Vp_StV(y.ptr(), alpha, *product);
    }
  }

 private:
  /// How the grip's force changes when the nodes move: that of the forces K v.
  double force_of(const grid::Vector& v) const {
    grid::Vector force(balance_->owned_map());
    balance_->tangent_times(*at_, v, force);
    return balance_->supports().reactions(force)[1][1];
  }
  double slope(const Vector& v) const {
    grid::Vector free(*Extract::getConstTpetraVector(Teuchos::rcpFromRef(v)), Teuchos::Copy);
    balance_->supports().clear(free);
    return force_of(free);
  }

  RCP<const Space> space_;
  RCP<solver::ThyraModel> model_;
  mechanics::MomentumBalance* balance_;
  RCP<Thyra::LinearOpBase<double>> K_;
  RCP<Thyra::LinearOpWithSolveBase<double>> solve_;
  RCP<Vector> along_;
  RCP<grid::Vector> at_;
  double force_along_ = 0.0;
};

/// What NOX asks to solve with it.
class Solve : public Thyra::LinearOpWithSolveBase<double> {
 public:
  RCP<const Thyra::LinearOpSourceBase<double>> source;

  RCP<const Space> range() const override { return tangent().range(); }
  RCP<const Space> domain() const override { return tangent().domain(); }

 protected:
  bool opSupportedImpl(Thyra::EOpTransp transpose) const override {
    return transpose == Thyra::NOTRANS;
  }
  void applyImpl(Thyra::EOpTransp transpose, const MultiVector& x,
                 const Teuchos::Ptr<MultiVector>& y, double alpha, double beta) const override {
    Thyra::apply(tangent(), transpose, x, y, alpha, beta);
  }
  bool solveSupportsImpl(Thyra::EOpTransp transpose) const override {
    return transpose == Thyra::NOTRANS;
  }
  bool solveSupportsSolveMeasureTypeImpl(Thyra::EOpTransp,
                                         const Thyra::SolveMeasureType&) const override {
    return true;
  }
  Thyra::SolveStatus<double> solveImpl(
      Thyra::EOpTransp, const MultiVector& b, const Teuchos::Ptr<MultiVector>& x,
      const Teuchos::Ptr<const Thyra::SolveCriteria<double>>) const override {
    for (Teuchos::Ordinal column = 0; column < b.domain()->dim(); ++column)
      tangent().solve(*b.col(column), *x->col(column));
    Thyra::SolveStatus<double> status;
    status.solveStatus = Thyra::SOLVE_STATUS_CONVERGED;
    return status;
  }

 private:
  const Tangent& tangent() const { return dynamic_cast<const Tangent&>(*source->getOp()); }
};

class Factory : public Thyra::LinearOpWithSolveFactoryBase<double> {
 public:
  using Source = Thyra::LinearOpSourceBase<double>;
  bool isCompatible(const Source&) const override { return true; }
  RCP<Thyra::LinearOpWithSolveBase<double>> createOp() const override {
    return Teuchos::rcp(new Solve);
  }
  void initializeOp(const RCP<const Source>& source, Thyra::LinearOpWithSolveBase<double>* op,
                    Thyra::ESupportSolveUse) const override {
    dynamic_cast<Solve&>(*op).source = source;
  }
  void uninitializeOp(Thyra::LinearOpWithSolveBase<double>* op, RCP<const Source>* source,
                      RCP<const Thyra::PreconditionerBase<double>>*, RCP<const Source>*,
                      Thyra::ESupportSolveUse*) const override {
    if (source) *source = dynamic_cast<Solve&>(*op).source;
  }
  void setParameterList(const RCP<Teuchos::ParameterList>&) override {}
  RCP<Teuchos::ParameterList> getNonconstParameterList() override { return Teuchos::null; }
  RCP<Teuchos::ParameterList> unsetParameterList() override { return Teuchos::null; }
};

/// Body and machine.
class Coupled : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  explicit Coupled(mechanics::MomentumBalance& balance)
      : balance_(&balance),
        body_(solver::thyra_model(exact(), balance)),
        space_(Thyra::productVectorSpace<double>(
            Teuchos::tuple<RCP<const Space>>(body_->get_x_space(), body_->get_p_space(0))())) {}

  RCP<const Space> get_x_space() const override { return space_; }
  RCP<const Space> get_f_space() const override { return space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override {
    Thyra::ModelEvaluatorBase::InArgsSetup<double> in;
    in.setModelEvalDescription("body and machine");
    in.setSupports(Thyra::ModelEvaluatorBase::IN_ARG_x);
    return in;
  }
  RCP<Thyra::LinearOpBase<double>> create_W_op() const override {
    return Teuchos::rcp(new Tangent(space_, body_, *balance_));
  }
  RCP<const Thyra::LinearOpWithSolveFactoryBase<double>> get_W_factory() const override {
    return Teuchos::rcp(new Factory);
  }

 private:
  static solver::SolverParameters exact() {
    solver::SolverParameters parameters;
    parameters.preconditioner = solver::PreconditionerKind::direct;
    parameters.linear_tolerance = 1e-13;
    return parameters;
  }
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override {
    Thyra::ModelEvaluatorBase::OutArgsSetup<double> out;
    out.setModelEvalDescription("body and machine");
    out.setSupports(Thyra::ModelEvaluatorBase::OUT_ARG_f);
    out.setSupports(Thyra::ModelEvaluatorBase::OUT_ARG_W_op);
    return out;
  }
  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override {
    const auto u = part(*in.get_x(), 0), s = part(*in.get_x(), 1);
    if (out.get_f() != Teuchos::null) {
      auto body_in = body_->createInArgs();
      body_in.set_x(u);
      body_in.set_p(0, s);
      auto body_out = body_->createOutArgs();
      const auto reactions = Thyra::createMember(body_->get_g_space(0));
      body_out.set_f(part(*out.get_f(), 0));
      body_out.set_g(0, reactions);
      body_->evalModel(body_in, body_out);
      const double force = Thyra::get_ele(*reactions, consumer::force_number);
      Thyra::put_scalar(force - machine * (driven_to - number(*s)), part(*out.get_f(), 1).ptr());
    }
    if (out.get_W_op() != Teuchos::null)
      Teuchos::rcp_dynamic_cast<Tangent>(out.get_W_op(), true)->assemble(u, s);
  }

  mechanics::MomentumBalance* balance_;
  RCP<solver::ThyraModel> body_;
  RCP<const Space> space_;
};

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard mpi_and_kokkos(&argc, &argv);
  const auto balance = consumer::make_block();
  const RCP<Thyra::ModelEvaluator<double>> model = Teuchos::rcp(new Coupled(*balance));

  const auto start = Thyra::createMember(model->get_x_space());
  Thyra::assign(start.ptr(), 0.0);
  const RCP<Thyra::PreconditionerBase<double>> no_preconditioner;
  const RCP<Thyra::PreconditionerFactoryBase<double>> no_factory;
  const auto group =
      Teuchos::rcp(new NOX::Thyra::Group(NOX::Thyra::Vector(start), model, model->create_W_op(),
                                         model->get_W_factory(), no_preconditioner, no_factory));
  const auto test = Teuchos::rcp(new NOX::StatusTest::Combo(
      NOX::StatusTest::Combo::OR,
      Teuchos::rcp(new NOX::StatusTest::NormF(1e-7, NOX::StatusTest::NormF::Unscaled)),  // pN
      Teuchos::rcp(new NOX::StatusTest::MaxIters(20))));
  const auto list = Teuchos::parameterList();
  list->set("Nonlinear Solver", "Line Search Based");
  list->sublist("Line Search").set("Method", "Full Step");
  list->sublist("Printing").set("Output Information", 0);
  const auto nox = NOX::Solver::buildSolver(group, test, list);
  std::vector<double> norm;
  auto status = NOX::StatusTest::Unconverged;
  while (status == NOX::StatusTest::Unconverged) {
    status = nox->step();
    norm.push_back(nox->getSolutionGroup().getNormF());
  }

  // The order of the last step that rounding has not ended.
  double order = 0.0;
  for (std::size_t n = 2; n < norm.size(); ++n)
    if (norm[n] > 1e-7)
      order = std::log(norm[n] / norm[n - 1]) / std::log(norm[n - 1] / norm[n - 2]);
  const auto& x = dynamic_cast<const NOX::Thyra::Vector&>(nox->getSolutionGroup().getX());
  const double s = number(*part(x.getThyraVector(), 1));
  const double force = machine * (driven_to - s);
  if (base::Communicator::world().is_root()) {
    for (const double r : norm) std::printf("%.3e ", r);
    std::printf("\nload %.12g, force %.10g pN, order %.2f\n", s, force, order);
  }

  // The same load, by the body alone.
  const auto alone = consumer::make_block();
  solver::SolverParameters parameters;
  parameters.newton_tolerance = 1e-11;
  solver::NewtonSolver newton(parameters, *alone);
  grid::Vector u(alone->owned_map()), change(alone->owned_map());
  alone->set_load(s);
  alone->supports().impose(s, change);
  newton.predict(u, change);
  newton.solve(u);
  const double by_body = alone->reactions(u)[1][1];
  const bool is_right = std::abs(by_body - force) < 1e-8 * force;
  return status == NOX::StatusTest::Converged && is_right && order > 1.8 && order < 2.4 ? 0 : 1;
}
