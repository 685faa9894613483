// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What Thyra's model hands to clients beside the residual. Claim V-THYRA-1, docs/verification.md.

#include <gtest/gtest.h>

#include <Thyra_TpetraThyraWrappers.hpp>
#include <Thyra_VectorStdOps.hpp>

#include "stroma/solver/LinearSolver.hpp"
#include "stroma/solver/ThyraModel.hpp"
#include "support/Specimen.hpp"

namespace stroma::solver {
namespace {

using Model = Thyra::ModelEvaluatorBase;
using test::Specimen;

Specimen bars() {
  Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.conditions = test::clamped(0.1);
  return specimen;
}

/// W and W_prec of a body at rest, at the load's full displacement of its supports.
struct Operators {
  Operators(mechanics::MomentumBalance& balance, PreconditionerKind kind) {
    SolverParameters parameters;
    parameters.preconditioner = kind;
    model = Teuchos::rcp(
        new ThyraModel(balance, Teuchos::null, make_preconditioner(parameters, balance)));
    Model::InArgs<double> in = model->createInArgs();
    in.setArgs(model->getNominalValues());
    W = model->create_W_op();
    preconditioner = model->create_W_prec();
    Model::OutArgs<double> out = model->createOutArgs();
    EXPECT_TRUE(out.supports(Model::OUT_ARG_W_prec));
    out.set_W_op(W);
    out.set_W_prec(preconditioner);
    model->evalModel(in, out);
  }

  Teuchos::RCP<ThyraModel> model;
  Teuchos::RCP<Thyra::LinearOpBase<double>> W;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> preconditioner;
};

Teuchos::RCP<Thyra::VectorBase<double>> random_vector(const Operators& operators) {
  const auto vector = Thyra::createMember(operators.model->get_x_space());
  Thyra::seed_randomize<double>(1);
  Thyra::randomize(-1.0, 1.0, vector.ptr());
  return vector;
}

// V-THYRA-1.
TEST(ThyraModel, WPrecOfADirectSolverIsTheInverseOfW) {
  const auto balance = bars().balance(base::Communicator::world());
  const Operators operators(*balance, PreconditionerKind::direct);
  const auto x = random_vector(operators);
  const auto y = Thyra::createMember(x->space()), z = Thyra::createMember(x->space());
  Thyra::apply(*operators.W, Thyra::NOTRANS, *x, y.ptr());
  const auto inverse = operators.preconditioner->getUnspecifiedPrecOp();
  ASSERT_FALSE(inverse.is_null());
  Thyra::apply(*inverse, Thyra::NOTRANS, *y, z.ptr());
  Thyra::Vp_StV(z.ptr(), -1.0, *x);
  EXPECT_LT(Thyra::norm(*z), 1e-9 * Thyra::norm(*x));
}

// V-THYRA-1. Definite: what conjugate gradients ask of it.
TEST(ThyraModel, WPrecIsPositive) {
  for (const auto kind : {PreconditionerKind::jacobi, PreconditionerKind::multigrid}) {
    const auto balance = bars().balance(base::Communicator::world());
    const Operators operators(*balance, kind);
    const auto x = random_vector(operators);
    const auto y = Thyra::createMember(x->space());
    Thyra::apply(*operators.preconditioner->getUnspecifiedPrecOp(), Thyra::NOTRANS, *x, y.ptr());
    EXPECT_GT(Thyra::dot(*x, *y), 0.0);
  }
}

TEST(ThyraModel, HasNoWPrecUnlessItIsGivenOne) {
  const auto balance = bars().balance(base::Communicator::world());
  const ThyraModel model(*balance, Teuchos::null);
  EXPECT_FALSE(model.createOutArgs().supports(Model::OUT_ARG_W_prec));
  EXPECT_TRUE(model.create_W_prec().is_null());
}

}  // namespace
}  // namespace stroma::solver
