// SPDX-License-Identifier: BSD-3-Clause

#include "stiffness/ApparentStiffness.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/mechanics/conditions/FacesReached.hpp"
#include "stroma/mechanics/terms/UnitLoads.hpp"
#include "stroma/solver/RefinedSolve.hpp"

namespace stroma {
namespace {

using mechanics::UniformBoundary;
using mechanics::UnitFields;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Residual of the linear problems, by their right-hand sides.
constexpr double tolerance = 1e-11;

double volume_of_box(const mechanics::Body& body) {
  const grid::Grid& box = body.problem().body;
  return box.length(0) * box.length(1) * box.length(2);
}

/// Mean stress of the box under a displacement [Pa].
Vector6 mean_stress(const mechanics::Body& body, const UnitFields& fields, const grid::Vector& u) {
  grid::Vector force(u.getMap());
  mechanics::elastic_force(body, u, force);
  Vector6 stress;
  for (int k = 0; k < 6; ++k) stress(k) = fields.displacement(k).dot(force) / volume_of_box(body);
  return stress;
}

/// Its mean strain, by what the surface does.
Vector6 mean_strain(const mechanics::Body& body, const UnitFields& fields, const grid::Vector& u) {
  Vector6 strain;
  for (int k = 0; k < 6; ++k) strain(k) = fields.traction(k).dot(u) / volume_of_box(body);
  return strain;
}

void solve_cases(const Deck& deck, mechanics::MomentumBalance& balance, UniformBoundary boundary,
                 const mechanics::LoadCases& cases, bool knows_strain, ApparentStiffness& result) {
  const solver::SolverParameters& parameters = deck.parameters.solver;
  solver::choose_tangent(parameters, balance);
  solver::LinearSolver linear(parameters, balance);
  const grid::Vector at_rest(balance.owned_map());
  const mechanics::Body& body = balance.body();
  const UnitFields fields(body);
  solver::linearize(linear, balance, at_rest);
  grid::Vector u(balance.owned_map());
  for (const int unit : cases.units) {
    const grid::Vector load = fields.load(boundary, unit);
    const std::int64_t before = linear.total_iterations();
    const double residual = solver::solve_refined(linear, balance, at_rest, load, u, tolerance);
    result.cases[static_cast<std::size_t>(unit)] = {linear.total_iterations() - before, residual};
    if (boundary != UniformBoundary::traction) u.update(1.0, fields.displacement(unit), 1.0);
    result.stress.col(unit) = mean_stress(body, fields, u);
    grid::Vector surface(balance.owned_map());
    for (int k = 0; k < 6; ++k) surface.update(result.stress(k, unit), fields.traction(k), 1.0);
    result.largest_residual = std::max(result.largest_residual, residual * load.norm2());
    result.largest_force = std::max(result.largest_force, surface.norm2());
    result.strain.col(unit) =
        knows_strain ? mean_strain(body, fields, u) : Vector6(Vector6::Unit(unit));
  }
}

}  // namespace

mechanics::Problem problem_of(const Deck& deck, const Specimen& specimen, UniformBoundary boundary,
                              const mechanics::LoadCases& cases) {
  mechanics::Problem problem = problem_of(deck, specimen);
  problem.conditions = cases.conditions;
  problem.terms.emplace_back([boundary, units = cases.units](const mechanics::Body& body) {
    return std::make_unique<mechanics::UnitLoads>(body, boundary, units);
  });
  return problem;
}

std::array<double, 6> solid_shares_of_faces(const base::Communicator& communicator,
                                            const Specimen& specimen) {
  return mechanics::filled_shares_of_faces(communicator, specimen.body,
                                           specimen.layout.outer_thickness, specimen.particles);
}

bool are_solid(const std::array<double, 6>& shares) {
  return *std::min_element(shares.begin(), shares.end()) > 1.0 - 1e-9;
}

std::int64_t ApparentStiffness::iterations() const {
  return std::accumulate(
      cases.begin(), cases.end(), std::int64_t{0},
      [](std::int64_t sum, const SolvedCase& one) { return sum + one.iterations; });
}

Matrix6 voigt_stiffness(const mechanics::Body& body) {
  const UnitFields fields(body);
  Matrix6 mean;
  for (int unit = 0; unit < 6; ++unit)
    mean.col(unit) = mean_stress(body, fields, fields.displacement(unit));
  return mean;
}

ApparentStiffness apparent_stiffness(
    const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
    UniformBoundary boundary,
    const std::function<void(const mechanics::MomentumBalance&)>& report) {
  const base::Stage stage("stiffness");
  const bool is_solid = are_solid(solid_shares_of_faces(communicator, specimen));
  if (boundary == UniformBoundary::traction && !is_solid)
    throw std::logic_error("a traction cannot act where empty space cuts the surface");
  ApparentStiffness result;
  try {
    for (const mechanics::LoadCases& cases : mechanics::load_cases(boundary)) {
      mechanics::MomentumBalance balance(communicator, specimen.partition, specimen.particles,
                                         problem_of(deck, specimen, boundary, cases));
      if (report) report(balance);
      solve_cases(deck, balance, boundary, cases, is_solid, result);
    }
  } catch (const base::StepRejected& failure) {
    throw base::RunError(std::string("the load cases cannot be solved: ") + failure.what());
  }
  const Matrix6 found = result.stress * result.strain.inverse();
  const Matrix6 kelvin = to_kelvin(found);
  result.symmetry_error = (kelvin - kelvin.transpose()).norm() / kelvin.norm();
  result.stiffness = 0.5 * (found + found.transpose());
  return result;
}

}  // namespace stroma
