// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/GeometricMultigrid.hpp"

#include <algorithm>

#include "stroma/base/Stage.hpp"
#include "stroma/multigrid/GalerkinProduct.hpp"

namespace stroma::multigrid {
namespace {

constexpr double direct_size = 3e7;  // doubles; a coarsest level with more is smoothed instead
constexpr int coarsest_degree = 16;
constexpr std::array<bool, 3> nowhere{false, false, false};

}  // namespace

std::array<bool, 3> directions_to_coarsen(const grid::LevelGrid& grid,
                                          std::array<double, 3>& spacing) {
  const grid::LevelGrid next = grid.coarsened({true, true, true});
  double shortest = 0.0;
  for (int d = 0; d < 3; ++d)
    if (next.all_elements(d) < grid.all_elements(d) && (shortest == 0.0 || spacing[d] < shortest))
      shortest = spacing[d];
  std::array<bool, 3> directions{};
  for (std::size_t d = 0; d < 3; ++d) {
    directions[d] =
        next.all_elements(static_cast<int>(d)) < grid.all_elements(static_cast<int>(d)) &&
        spacing[d] < 1.9 * shortest;
    if (directions[d]) spacing[d] *= 2.0;
  }
  return directions;
}

std::vector<LevelPlan> plan_levels(grid::LevelGrid grid, std::array<double, 3> spacing,
                                   const MultigridSettings& settings) {
  std::vector<LevelPlan> levels;
  while (true) {
    const auto directions = CoarsestGrid::work(grid) > settings.direct_work
                                ? directions_to_coarsen(grid, spacing)
                                : nowhere;
    const bool is_coarsest = directions == nowhere;
    const bool is_direct = is_coarsest && CoarsestGrid::size(grid) <= direct_size;
    levels.push_back({grid, directions, is_direct,
                      is_coarsest && !is_direct ? coarsest_degree : settings.smoother_degree});
    if (is_coarsest) return levels;
    grid = grid.coarsened(directions);
  }
}

GeometricMultigrid::Level::Level(const base::Communicator& communicator,
                                 const grid::LevelGrid& grid, bool is_finest, int degree)
    : exchange(communicator, grid),
      stencil(is_finest ? tangent::Stencil() : tangent::Stencil(grid)),
      fields(grid),
      smoother(grid, degree) {}

GeometricMultigrid::GeometricMultigrid(const grid::RCP<const tangent::StencilMatrix>& matrix,
                                       const std::array<double, 3>& spacing,
                                       const ElementPatches::Chosen& patched,
                                       const MultigridSettings& settings)
    : matrix_(matrix) {
  for (const LevelPlan& plan : plan_levels(matrix->exchange().grid(), spacing, settings)) {
    levels_.push_back(std::make_unique<Level>(matrix->exchange().communicator(), plan.grid,
                                              levels_.empty(), plan.smoother_degree));
    if (plan.is_direct) coarsest_.emplace(plan.grid);
    if (plan.directions != nowhere) levels_.back()->transfer.emplace(plan.grid, plan.directions);
  }
  levels_.front()->smoother.patch(at(0).exchange, patched, settings.patched_degree);
}

const tangent::Stencil& GeometricMultigrid::stencil(int level) const {
  return level == 0 ? matrix_->stencil() : at(level).stencil;
}

void GeometricMultigrid::compute() {
  for (int level = 0; level < levels(); ++level) {
    Level& here = *levels_[static_cast<std::size_t>(level)];
    if (level + 1 < levels()) {
      const base::Stage stage("coarse operators");
      galerkin_product(stencil(level), *here.transfer, at(level + 1).stencil);
    }
    if (level + 1 < levels() || !coarsest_) {
      const base::Stage stage("eigenvalues");
      here.smoother.compute(stencil(level), here.exchange, here.fields);
    } else {
      const base::Stage stage("coarsest factors");
      coarsest_->factorize(stencil(level), here.exchange);
    }
  }
}

/// Coarse b = P^T (b - K x). Shared nodes pass on their owner's b once, and each rank's part of K
/// x.
void GeometricMultigrid::restrict_residual(int level) const {
  const Level& here = at(level);
  const LevelFields& f = here.fields;
  const grid::LevelGrid& grid = here.exchange.grid();
  const int owned[3] = {grid.owned_nodes(0), grid.owned_nodes(1), grid.owned_nodes(2)};
  stencil(level).multiply(f.x, f.y);
  const base::Stage stage("transfer");
  grid::for_each_line("residual", f.y.nodes, [&](const int line, const int j, const int k) {
    const int own = j < owned[1] && k < owned[2] ? owned[0] : 0;
    for (int c = 0; c < 3; ++c) {
      float* const y = f.y.line(c, line);
      const float* const b = f.b.line(c, line);
      for (int i = 0; i < own; ++i) y[i] = b[i] - y[i];
      for (int i = own; i < f.y.nodes[0]; ++i) y[i] = -y[i];
    }
  });
  const Level& next = at(level + 1);
  here.transfer->restrict_to(f.y, next.fields.b);
  next.exchange.sum(next.fields.b);
}

void GeometricMultigrid::cycle(int level) const {
  const Level& here = at(level);
  if (level + 1 == levels()) {
    const base::Stage stage("coarsest solve");
    if (coarsest_)
      coarsest_->solve(here.fields.b, here.fields.x, here.exchange);
    else
      here.smoother.smooth_from_zero(stencil(level), here.exchange, here.fields);
    return;
  }
  {
    const base::Stage stage("smoothing");
    here.smoother.smooth_from_zero(stencil(level), here.exchange, here.fields);
  }
  restrict_residual(level);
  cycle(level + 1);
  {
    const base::Stage stage("transfer");
    here.transfer->add_interpolated(at(level + 1).fields.x, here.fields.x);
  }
  const base::Stage stage("smoothing");
  here.smoother.smooth(stencil(level), here.exchange, here.fields);
}

void GeometricMultigrid::apply(const grid::MultiVector& x, grid::MultiVector& y, Teuchos::ETransp,
                               double alpha, double beta) const {
  const LevelFields& fields = at(0).fields;
  for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
    matrix_->to_field(x, column, fields.b);
    cycle(0);
    matrix_->from_field(fields.x, x, column, 1.0 / matrix_->held_diagonal(), alpha, beta, y);
  }
}

}  // namespace stroma::multigrid
