// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// An application that lets Piro, and so NOX, solve Stroma's model: the load is a parameter, the
/// reactions are responses.

#include <Piro_NOXSolver.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>

#include "Block.hpp"
#include "stroma/solver/ThyraModel.hpp"

int main(int argc, char** argv) {
  using namespace stroma;
  Tpetra::ScopeGuard mpi_and_kokkos(&argc, &argv);
  const auto balance = consumer::make_block();
  const Teuchos::RCP<Thyra::ModelEvaluator<double>> model =
      solver::thyra_model(solver::SolverParameters{}, *balance);

  const auto list = Teuchos::parameterList();
  auto& nox = list->sublist("NOX");
  nox.sublist("Printing").set("Output Information", 0);
  auto& tests = nox.sublist("Status Tests");
  tests.set("Test Type", "Combo");
  tests.set("Combo Type", "OR");
  tests.set("Number of Tests", 2);
  tests.sublist("Test 0").set("Test Type", "NormF");
  tests.sublist("Test 0").set("Scale Type", "Unscaled");
  tests.sublist("Test 0").set("Tolerance", 1e-6);  // pN
  tests.sublist("Test 1").set("Test Type", "MaxIters");
  tests.sublist("Test 1").set("Maximum Iterations", 20);
  const Piro::NOXSolver<double> piro(list, model);

  auto in = piro.createInArgs();
  const auto load = Thyra::createMember(model->get_p_space(0));
  Thyra::put_scalar(1.0, load.ptr());
  in.set_p(0, load);
  auto out = piro.createOutArgs();
  const auto reactions = Thyra::createMember(model->get_g_space(0));
  out.set_g(0, reactions);
  piro.evalModel(in, out);

  const double force = Thyra::get_ele(*reactions, consumer::force_number);
  if (base::Communicator::world().is_root()) std::printf("reaction %.10g pN\n", force);
  return std::abs(force - consumer::expected_force) < 1e-8 * consumer::expected_force ? 0 : 1;
}
