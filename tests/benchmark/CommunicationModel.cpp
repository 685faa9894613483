// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A model of the time that an iteration of conjugate gradients with geometric multigrid takes on
/// many ranks: what is sent is counted by the program's own arithmetic for the busiest rank, what
/// it costs follows from the few numbers in Machine. Runs on one processor and prints Markdown.
///
///     benchmark_communication

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "stroma/grid/Partition.hpp"
#include "stroma/multigrid/CoarsestGrid.hpp"
#include "stroma/multigrid/GeometricMultigrid.hpp"
#include "stroma/solver/IterationTraffic.hpp"

namespace {

using namespace stroma;

/// A cluster of today, one rank a core.
struct Machine {
  double memory = 4e9;     ///< bytes a second that a core gets when all cores of its node work
  double latency = 2e-6;   ///< of a message [s]
  double network = 0.4e9;  ///< bytes a second of a rank: 25 GB/s a node, 64 ranks on it
};

struct Times {
  double memory, neighbours, reductions, coarsest;
  double all() const { return memory + neighbours + reductions + coarsest; }
};

grid::Partition equal_boxes(const grid::Index3& elements, int ranks) {
  grid::Grid grid;
  grid.elements = elements;
  grid.spacing = {2.1, 2.1, 2.0};
  std::array<std::vector<double>, 3> weights;
  for (std::size_t d = 0; d < 3; ++d) weights[d].assign(static_cast<std::size_t>(elements[d]), 1.0);
  return grid::Partition::balanced(grid, ranks, weights);
}

/// Bytes that an iteration of one rank moves through its memory: blocks, and 12 floats a node for
/// the fields of each product.
double memory_bytes(const std::vector<multigrid::LevelPlan>& levels) {
  double bytes = 0.0;
  for (std::size_t n = 0; n < levels.size(); ++n) {
    const multigrid::LevelPlan& level = levels[n];
    const double nodes =
        static_cast<double>(level.grid.nodes(0)) * level.grid.nodes(1) * level.grid.nodes(2);
    // Before and after the coarse correction, and its residual; the finest one's K v besides.
    const double smoothing = level.is_direct ? 0.0 : 2.0 * level.smoother_degree;
    const double products = smoothing + (n == 0 ? 1.0 : 0.0);
    bytes += products * (504.0 + 48.0) * nodes;
  }
  return bytes;
}

Times model(const Machine& machine, const grid::Partition& partition, const grid::Traffic& traffic,
            const std::vector<multigrid::LevelPlan>& levels) {
  const double depth = std::ceil(std::log2(static_cast<double>(partition.ranks())));
  Times times{};
  times.memory = memory_bytes(levels) / machine.memory;
  times.neighbours = static_cast<double>(traffic.messages) * machine.latency +
                     static_cast<double>(traffic.bytes) / machine.network;
  // Up and down a binary tree; long ones in pieces, so that each byte passes a rank about twice.
  if (partition.ranks() > 1)
    times.reductions = static_cast<double>(traffic.reductions) * 2.0 * depth * machine.latency +
                       2.0 * static_cast<double>(traffic.reduced_bytes) / machine.network;
  // The factor is read twice, forward and back.
  if (levels.back().is_direct)
    times.coarsest = 2.0 * 8.0 * multigrid::CoarsestGrid::size(levels.back().grid) / machine.memory;
  return times;
}

void print(const Machine& machine, const grid::Index3& elements, int ranks) {
  const grid::Partition partition = equal_boxes(elements, ranks);
  const auto kind = solver::PreconditionerKind::geometric_multigrid;
  int busiest = 0;
  std::int64_t most = -1;
  for (int rank = 0; rank < ranks; ++rank) {
    const std::int64_t bytes = solver::iteration_traffic(partition, rank, kind).total().bytes;
    if (bytes > most) busiest = rank;
    most = std::max(most, bytes);
  }
  const grid::Traffic traffic = solver::iteration_traffic(partition, busiest, kind).total();
  const auto levels =
      multigrid::plan_levels(grid::LevelGrid(partition, busiest), partition.grid().spacing, {});
  const Times t = model(machine, partition, traffic, levels);
  std::printf(
      "| %lld x %lld x %lld | %d | %lld | %d | %lld | %.0f | %.0f | %.2f | %.2f | %.2f | %.2f | "
      "%.2f | %.0f %% |\n",
      static_cast<long long>(elements[0]), static_cast<long long>(elements[1]),
      static_cast<long long>(elements[2]), ranks,
      static_cast<long long>(partition.elements(busiest).count()), static_cast<int>(levels.size()),
      static_cast<long long>(traffic.messages), 1e-3 * static_cast<double>(traffic.bytes),
      1e-3 * static_cast<double>(traffic.reduced_bytes), 1e3 * t.memory, 1e3 * t.neighbours,
      1e3 * t.reductions, 1e3 * t.coarsest, 1e3 * t.all(), 100.0 * t.memory / t.all());
}

}  // namespace

int main() {
  const Machine machine;
  std::printf(
      "| elements | ranks | elements a rank | levels | messages | kB sent | kB summed | memory "
      "(ms) | neighbours (ms) | sums (ms) | coarsest grid (ms) | iteration (ms) | of it memory |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const int ranks : {1, 2, 16, 128, 1024, 4096}) print(machine, {256, 256, 26}, ranks);
  // Weak: 32 x 32 x 32 elements a rank.
  print(machine, {32, 32, 32}, 1);
  print(machine, {64, 64, 64}, 8);
  print(machine, {256, 128, 128}, 128);
  print(machine, {512, 512, 512}, 4096);
  return 0;
}
