// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/ThyraModel.hpp"

#include <Thyra_DefaultPreconditioner.hpp>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Thyra_VectorStdOps.hpp>

#include "stroma/solver/ThyraLinearSolve.hpp"

namespace stroma::solver {
namespace {

using Model = Thyra::ModelEvaluatorBase;
using Extract = Thyra::TpetraOperatorVectorExtraction<double, grid::LocalOrdinal,
                                                      grid::GlobalOrdinal, grid::Map::node_type>;

/// Numbers of which every rank has all.
ThyraModel::VectorSpace replicated(const grid::RCP<const grid::Map>& map, std::size_t count) {
  const grid::RCP<const grid::Map> local =
      Teuchos::rcp(new grid::Map(count, 0, map->getComm(), Tpetra::LocallyReplicated));
  return Thyra::createVectorSpace<double>(local);
}

}  // namespace

ThyraModel::ThyraModel(mechanics::MomentumBalance& balance,
                       const Teuchos::RCP<const Factory>& factory,
                       std::shared_ptr<Preconditioner> preconditioner)
    : balance_(&balance),
      factory_(factory),
      preconditioner_(std::move(preconditioner)),
      space_(Thyra::createVectorSpace<double>(balance.owned_map())),
      load_space_(replicated(balance.owned_map(), 1)),
      reaction_space_(replicated(balance.owned_map(), 3 * balance.problem().conditions.size())) {}

Teuchos::RCP<const Teuchos::Array<std::string>> ThyraModel::get_p_names(int) const {
  return Teuchos::rcp(new Teuchos::Array<std::string>(1, "load"));
}

Model::InArgs<double> ThyraModel::createInArgs() const {
  Model::InArgsSetup<double> in;
  in.setModelEvalDescription("balance of momentum");
  in.setSupports(Model::IN_ARG_x);
  in.set_Np(1);
  return in;
}

Model::InArgs<double> ThyraModel::getNominalValues() const {
  Model::InArgs<double> nominal = createInArgs();
  const auto u = Teuchos::rcp(new grid::Vector(balance_->owned_map()));
  balance_->supports().impose(balance_->load(), *u);
  nominal.set_x(Thyra::createVector(u, space_));
  const auto load = Thyra::createMember(load_space_);
  Thyra::put_scalar(balance_->load(), load.ptr());
  nominal.set_p(0, load);
  return nominal;
}

Model::OutArgs<double> ThyraModel::createOutArgsImpl() const {
  Model::OutArgsSetup<double> out;
  out.setModelEvalDescription("balance of momentum");
  out.set_Np_Ng(1, 1);
  out.setSupports(Model::OUT_ARG_f);
  out.setSupports(Model::OUT_ARG_W_op);
  if (preconditioner_) out.setSupports(Model::OUT_ARG_W_prec);
  out.setSupports(Model::OUT_ARG_DfDp, 0, Model::DERIV_MV_JACOBIAN_FORM);
  out.set_W_properties(
      Model::DerivativeProperties(Model::DERIV_LINEARITY_NONCONST, Model::DERIV_RANK_FULL, true));
  return out;
}

Teuchos::RCP<Thyra::LinearOpBase<double>> ThyraModel::create_W_op() const {
  return Thyra::createLinearOp(balance_->tangent(), space_, space_);
}

Teuchos::RCP<Thyra::PreconditionerBase<double>> ThyraModel::create_W_prec() const {
  return preconditioner_ ? Teuchos::rcp(new Thyra::DefaultPreconditioner<double>) : Teuchos::null;
}

void ThyraModel::evalModelImpl(const Model::InArgs<double>& in,
                               const Model::OutArgs<double>& out) const {
  if (in.get_p(0) != Teuchos::null) {
    const double load = Thyra::get_ele(*in.get_p(0), 0);
    if (load != balance_->load()) balance_->set_load(load);
  }
  const double load = balance_->load(), stiffness = balance_->body().typical_diagonal();
  const mechanics::Supports& supports = balance_->supports();
  const auto x = Extract::getConstTpetraVector(in.get_x());
  auto u = x;
  if (!supports.are_imposed(load, *x)) {
    const auto imposed = Teuchos::rcp(new grid::Vector(*x, Teuchos::Copy));
    supports.impose(load, *imposed);
    u = imposed;
  }
  if (out.get_f() != Teuchos::null) {
    const auto f = Extract::getTpetraVector(out.get_f());
    balance_->residual(*u, *f);
    if (u != x) supports.excess(load, *x, stiffness, *f);
  }
  if (const auto& g = out.get_g(0); g != Teuchos::null) {
    const auto reactions = balance_->reactions(*u);
    for (std::size_t m = 0; m < reactions.size(); ++m)
      for (std::size_t c = 0; c < 3; ++c)
        Thyra::set_ele(static_cast<Teuchos::Ordinal>(3 * m + c), reactions[m][c], g.ptr());
  }
  if (const auto derivative = out.get_DfDp(0).getMultiVector(); derivative != Teuchos::null) {
    const auto d = Extract::getTpetraVector(derivative->col(0));
    grid::Vector rate(balance_->owned_map());
    balance_->load_derivative(*u, *d);
    supports.rate(load, rate);
    d->update(-stiffness, rate, 1.0);
  }
  if (out.get_W_op() != Teuchos::null || (preconditioner_ && out.get_W_prec() != Teuchos::null))
    balance_->assemble_tangent(*u);
  if (preconditioner_ && out.get_W_prec() != Teuchos::null) {
    preconditioner_->compute(balance_->tangent());
    Teuchos::rcp_dynamic_cast<Thyra::DefaultPreconditioner<double>>(out.get_W_prec(), true)
        ->initializeUnspecified(
            Thyra::createConstLinearOp(preconditioner_->apply_inverse(), space_, space_));
  }
}

Teuchos::RCP<ThyraModel> thyra_model(const SolverParameters& parameters,
                                     mechanics::MomentumBalance& balance) {
  choose_tangent(parameters, balance);
  const auto linear = Teuchos::rcp(new LinearSolver(parameters, balance));
  auto factory = thyra_factory(*linear);
  Teuchos::set_extra_data(linear, "linear solver", Teuchos::outArg(factory));
  return Teuchos::rcp(new ThyraModel(balance, factory));
}

}  // namespace stroma::solver
