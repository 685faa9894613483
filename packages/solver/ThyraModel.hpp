// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The balance of momentum as a Thyra model evaluator.

#include <Thyra_StateFuncModelEvaluatorBase.hpp>
#include <memory>

#include "stroma/mechanics/MomentumBalance.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {

/// The balance of momentum for any Thyra client (NOX, LOCA, Piro, a coupled model):
///
/// - x: the displacement of the nodes since the base [um]; nominal: zero, but for what is prescribed;
/// - p_0 ("load"): the load factor; nominal: that of the balance. Where a client gives none, the
///   balance's counts;
/// - f(x, p_0): the residual [pN] at x with its prescribed components set to their values u*(p_0).
///   At these, f = k (x - u*), with k the diagonal entry that the tangent has there: a Newton step
///   from any x satisfies the conditions, and Newton's order is kept;
/// - W = df/dx, and df/dp_0;
/// - g_0: the reactions [pN], x, y, z of each condition in its order;
/// - W_prec, if a preconditioner is given.
///
/// Particles that are turned inside out make f not finite, which NOX looks for.
class ThyraModel : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  using Factory = Thyra::LinearOpWithSolveFactoryBase<double>;
  using VectorSpace = Teuchos::RCP<const Thyra::VectorSpaceBase<double>>;

  /// \param balance         outlives the model
  /// \param factory         makes the linear solver that W stands for; null: the client's affair
  /// \param preconditioner  for W_prec; null: none
  ThyraModel(mechanics::MomentumBalance& balance, const Teuchos::RCP<const Factory>& factory,
             std::shared_ptr<Preconditioner> preconditioner = nullptr);

  VectorSpace get_x_space() const override { return space_; }
  VectorSpace get_f_space() const override { return space_; }
  VectorSpace get_p_space(int) const override { return load_space_; }
  Teuchos::RCP<const Teuchos::Array<std::string>> get_p_names(int) const override;
  VectorSpace get_g_space(int) const override { return reaction_space_; }
  Thyra::ModelEvaluatorBase::InArgs<double> createInArgs() const override;
  Thyra::ModelEvaluatorBase::InArgs<double> getNominalValues() const override;
  Teuchos::RCP<Thyra::LinearOpBase<double>> create_W_op() const override;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> create_W_prec() const override;
  Teuchos::RCP<const Factory> get_W_factory() const override { return factory_; }

 private:
  Thyra::ModelEvaluatorBase::OutArgs<double> createOutArgsImpl() const override;
  void evalModelImpl(const Thyra::ModelEvaluatorBase::InArgs<double>& in,
                     const Thyra::ModelEvaluatorBase::OutArgs<double>& out) const override;

  mechanics::MomentumBalance* balance_;
  Teuchos::RCP<const Factory> factory_;
  std::shared_ptr<Preconditioner> preconditioner_;
  VectorSpace space_, load_space_, reaction_space_;
};

/// The model with Stroma's linear solver for W, which it owns.
/// \param parameters  of the linear solver
/// \param balance     outlives the model
Teuchos::RCP<ThyraModel> thyra_model(const SolverParameters& parameters,
                                     mechanics::MomentumBalance& balance);

}  // namespace stroma::solver
