// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The balance of momentum as a Thyra model evaluator: f(u) = residual, W(u) = tangent.

#include <Thyra_StateFuncModelEvaluatorBase.hpp>

#include "stroma/mechanics/MomentumBalance.hpp"

namespace stroma::solver {

/// f(x) = residual at the displacement x, W_op = tangent there. Steady state, no parameters: any
/// Thyra client (NOX, LOCA, Piro) can drive it.
class ThyraModel : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  using Factory = Thyra::LinearOpWithSolveFactoryBase<double>;

  /// \param balance  outlives the model
  /// \param factory  makes the linear solver that W stands for
  ThyraModel(mechanics::MomentumBalance& balance, const Teuchos::RCP<const Factory>& factory);

  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_x_space() const override { return space_; }
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> get_f_space() const override { return space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override;
  Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override;
  Teuchos::RCP<Thyra::LinearOpBase<double>> create_W_op() const override;
  Teuchos::RCP<const Factory> get_W_factory() const override { return factory_; }

 private:
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override;
  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override;

  mechanics::MomentumBalance* balance_;
  Teuchos::RCP<const Factory> factory_;
  Teuchos::RCP<const Thyra::VectorSpaceBase<double>> space_;
};

}  // namespace stroma::solver
