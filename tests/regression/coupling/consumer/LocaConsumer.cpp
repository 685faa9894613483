// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// An application that lets LOCA follow Stroma's model from load 0 to full load, and holds the
/// curve against a history.csv of the program: LocaConsumer HISTORY.

#include <LOCA.H>
#include <LOCA_Thyra.H>
#include <LOCA_Thyra_SaveDataStrategy.H>
#include <NOX_Thyra.H>

#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "Block.hpp"
#include "stroma/solver/ThyraModel.hpp"

namespace {

using Model = Thyra::ModelEvaluator<double>;

/// Keeps the force at each load.
class Curve : public LOCA::Thyra::SaveDataStrategy {
 public:
  explicit Curve(const Teuchos::RCP<Model>& model) : model_(model) {}

  void saveSolution(const NOX::Abstract::Vector& x, double load) override {
    auto in = model_->createInArgs();
    in.set_x(dynamic_cast<const NOX::Thyra::Vector&>(x).getThyraRCPVector());
    const auto p = Thyra::createMember(model_->get_p_space(0));
    Thyra::put_scalar(load, p.ptr());
    in.set_p(0, p);
    auto out = model_->createOutArgs();
    const auto reactions = Thyra::createMember(model_->get_g_space(0));
    out.set_g(0, reactions);
    model_->evalModel(in, out);
    force_[load] = Thyra::get_ele(*reactions, consumer::force_number);
  }
  const std::map<double, double>& force() const { return force_; }

 private:
  Teuchos::RCP<Model> model_;
  std::map<double, double> force_;
};

/// (load, force of the upper support) of each row of history.csv.
std::map<double, double> read_history(const char* path) {
  std::ifstream file(path);
  const auto cells = [&] {
    std::string line, cell;
    std::getline(file, line);
    std::istringstream stream(line);
    std::vector<std::string> row;
    while (std::getline(stream, cell, ',')) row.push_back(cell);
    return row;
  };
  std::map<std::string, std::size_t> column;
  for (const std::string& name : cells()) column.emplace(name, column.size());
  std::map<double, double> force;
  for (auto row = cells(); !row.empty(); row = cells())
    force[std::stod(row[column.at("load")])] = std::stod(row[column.at("top.reaction_y")]);
  return force;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace stroma;
  Tpetra::ScopeGuard mpi_and_kokkos(&argc, &argv);
  const auto balance = consumer::make_block();
  const Teuchos::RCP<Model> model = solver::thyra_model(solver::SolverParameters{}, *balance);
  const auto expected = read_history(argv[1]);
  const double step = 1.0 / static_cast<double>(expected.size() - 1);

  const auto list = Teuchos::parameterList();
  auto& loca = list->sublist("LOCA");
  auto& stepper = loca.sublist("Stepper");
  stepper.set("Continuation Method", "Natural");
  stepper.set("Continuation Parameter", "load");
  stepper.set("Initial Value", 0.0);
  stepper.set("Min Value", 0.0);
  stepper.set("Max Value", 1.0);
  stepper.set("Max Steps", 100);
  loca.sublist("Predictor").set("Method", "Tangent");
  auto& steps = loca.sublist("Step Size");
  steps.set("Method", "Constant");
  steps.set("Initial Step Size", step);
  steps.set("Min Step Size", step);
  steps.set("Max Step Size", step);
  list->sublist("NOX").sublist("Printing").set("Output Information", 0);

  const auto global = LOCA::createGlobalData(list);
  LOCA::ParameterVector parameters;
  parameters.addParameter("load", 0.0);
  const NOX::Thyra::Vector start(*model->getNominalValues().get_x());
  const auto group =
      Teuchos::rcp(new LOCA::Thyra::Group(global, start, model, parameters, 0, true));
  const auto curve = Teuchos::rcp(new Curve(model));
  group->setSaveDataStrategy(curve);
  const auto test = Teuchos::rcp(new NOX::StatusTest::Combo(
      NOX::StatusTest::Combo::OR,
      Teuchos::rcp(new NOX::StatusTest::NormF(1e-6, NOX::StatusTest::NormF::Unscaled)),  // pN
      Teuchos::rcp(new NOX::StatusTest::MaxIters(20))));
  LOCA::Stepper loca_stepper(global, group, test, list);
  const bool is_finished = loca_stepper.run() == LOCA::Abstract::Iterator::Finished;
  LOCA::destroyGlobalData(global);

  double largest = 0.0;
  for (const auto& [load, force] : expected) {
    const auto near = curve->force().lower_bound(load - 1e-9);
    if (near == curve->force().end() || near->first > load + 1e-9) {
      if (base::Communicator::world().is_root()) std::printf("no step at load %g\n", load);
      return 1;
    }
    largest = std::max(largest, std::abs(near->second - force) / consumer::expected_force);
  }
  if (base::Communicator::world().is_root())
    std::printf("%zu steps; largest difference of a force: %.1e of the full one\n",
                curve->force().size(), largest);
  return is_finished && largest < 1e-8 ? 0 : 1;
}
