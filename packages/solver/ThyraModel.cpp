// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/ThyraModel.hpp"

#include <Thyra_TpetraThyraWrappers.hpp>

namespace stroma::solver {
namespace {

using Model = Thyra::ModelEvaluatorBase;
using Extract = Thyra::TpetraOperatorVectorExtraction<double, grid::LocalOrdinal,
                                                      grid::GlobalOrdinal, grid::Map::node_type>;

}  // namespace

ThyraModel::ThyraModel(mechanics::MomentumBalance& balance,
                       const Teuchos::RCP<const Factory>& factory)
    : balance_(&balance),
      factory_(factory),
      space_(Thyra::createVectorSpace<double>(balance.owned_map())) {}

Model::InArgs<double> ThyraModel::createInArgs() const {
  Model::InArgsSetup<double> in;
  in.setModelEvalDescription("balance of momentum");
  in.setSupports(Model::IN_ARG_x);
  return in;
}

Model::InArgs<double> ThyraModel::getNominalValues() const { return createInArgs(); }

Model::OutArgs<double> ThyraModel::createOutArgsImpl() const {
  Model::OutArgsSetup<double> out;
  out.setModelEvalDescription("balance of momentum");
  out.setSupports(Model::OUT_ARG_f);
  out.setSupports(Model::OUT_ARG_W_op);
  out.set_W_properties(
      Model::DerivativeProperties(Model::DERIV_LINEARITY_NONCONST, Model::DERIV_RANK_FULL, true));
  return out;
}

Teuchos::RCP<Thyra::LinearOpBase<double>> ThyraModel::create_W_op() const {
  return Thyra::createLinearOp(balance_->tangent(), space_, space_);
}

void ThyraModel::evalModelImpl(const Model::InArgs<double>& in,
                               const Model::OutArgs<double>& out) const {
  const auto x = Extract::getConstTpetraVector(in.get_x());
  // Particles turned inside out make the results NaN, which NOX looks for.
  if (out.get_f() != Teuchos::null) balance_->residual(*x, *Extract::getTpetraVector(out.get_f()));
  if (out.get_W_op() != Teuchos::null) balance_->assemble_tangent(*x);
}

}  // namespace stroma::solver
