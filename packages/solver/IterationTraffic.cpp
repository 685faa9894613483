// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/IterationTraffic.hpp"

#include "stroma/base/Log.hpp"
#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {
namespace {

// r.z and p.Kp, and the norm of the residual.
constexpr std::int64_t sums_of_belos = 3;

/// One cycle: GeometricMultigrid::apply().
grid::Traffic cycle_traffic(const grid::Partition& partition, int rank) {
  const grid::LevelGrid finest(partition, rank);
  const auto levels = multigrid::plan_levels(finest, partition.grid().spacing, {});
  grid::Traffic traffic = grid::box_sum_traffic(finest, sizeof(float));  // of the right-hand side
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const multigrid::LevelPlan& level = levels[n];
    const grid::Traffic sum = grid::box_sum_traffic(level.grid, sizeof(float));
    if (n > 0) traffic += sum;  // of the restricted residual
    if (level.is_direct) {
      const std::int64_t unknowns = 3 * level.grid.all_nodes();
      traffic += grid::Traffic{0, 0, 0, 1, unknowns * std::int64_t{sizeof(double)}};
    } else {
      // A smoother of some degree takes as many products, and one less when it starts from zero.
      traffic += (level.smoother_degree - 1) * sum;
      if (n + 1 < levels.size()) traffic += level.smoother_degree * sum;
    }
  }
  return traffic;
}

}  // namespace

grid::Traffic IterationTraffic::total() const {
  grid::Traffic all = product;
  if (preconditioner) all += *preconditioner;
  all += dots;
  return all;
}

IterationTraffic iteration_traffic(const grid::Partition& partition, int rank,
                                   PreconditionerKind kind) {
  IterationTraffic traffic;
  if (partition.ranks() > 1)  // a rank alone does not call MPI for them
    traffic.dots = {0, 0, 0, sums_of_belos, sums_of_belos * std::int64_t{sizeof(double)}};
  if (takes_stencil(kind, partition.grid())) {
    // The vector is made consistent before, the product summed behind.
    traffic.product = 2 * grid::box_sum_traffic(grid::LevelGrid(partition, rank), sizeof(double));
    traffic.preconditioner = cycle_traffic(partition, rank);
  } else {
    traffic.product = grid::rows_product_traffic(partition, rank);
    if (kind == PreconditionerKind::jacobi) traffic.preconditioner = grid::Traffic{};
  }
  return traffic;
}

std::string describe_traffic(const base::Communicator& communicator,
                             const grid::Partition& partition, PreconditionerKind kind) {
  if (communicator.size() == 1) return "";
  const IterationTraffic mine = iteration_traffic(partition, communicator.rank(), kind);
  const std::int64_t most = communicator.max(mine.total().bytes);
  const int rank =
      communicator.min(mine.total().bytes == most ? communicator.rank() : communicator.size());
  const IterationTraffic fullest = iteration_traffic(partition, rank, kind);
  const auto kilobytes = [](const grid::Traffic& traffic) {
    return 1e-3 * static_cast<double>(traffic.bytes);
  };
  const grid::Traffic total = fullest.total();
  return base::format(
      "exchange   a linear iteration sends from the busiest rank %.1f kB (product K v %.1f kB, "
      "preconditioner %s) in %lld messages to %d neighbour%s, and sums over all ranks %lld times",
      kilobytes(total), kilobytes(fullest.product),
      fullest.preconditioner ? base::format("%.1f kB", kilobytes(*fullest.preconditioner)).c_str()
                             : "not counted",
      static_cast<long long>(total.messages), total.neighbours, total.neighbours == 1 ? "" : "s",
      static_cast<long long>(total.reductions));
}

}  // namespace stroma::solver
