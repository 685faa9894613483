// SPDX-License-Identifier: BSD-3-Clause

#include "run/RunSummary.hpp"

#include <array>
#include <cmath>

#include "run/BoundsTable.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/solver/IterationTraffic.hpp"

namespace stroma {
namespace {

/// A force [pN] in the unit in which it is easily read.
std::string readable_force(double force) {
  const double size = std::abs(force);
  if (size >= 1e6) return base::format("%.5g uN", force * 1e-6);
  if (size >= 1e3) return base::format("%.5g nN", force * 1e-3);
  return base::format("%.5g pN", force);
}

/// How much the springs of conditions imposed by penalty give way.
void print_give(base::Log& log, double strain_energy, const mechanics::MomentumBalance& balance,
                const grid::Vector& u) {
  if (balance.has_springs_that_pull_on())
    log.line(
        base::format("\n"
                     "penalty    the springs of the supports hold their faces to within %.2g um "
                     "(root mean square)",
                     balance.distance_of_faces(u)));
  const double springs = balance.support_energy(u);
  if (springs <= 0.0) return;
  log.line(
      base::format("\n"
                   "penalty    the springs of the supports hold %.2g of the energy: about by so "
                   "much they lower the forces",
                   springs / (springs + strain_energy)));
}

void print_bounds(base::Log& log, const Deck& deck, const Specimen& specimen,
                  const output::HistoryRow& undeformed) {
  std::vector<double> volumes;  // at load 0: of the undeformed body
  double solid = 0.0;
  for (const auto& material : undeformed.materials) {
    volumes.push_back(material.volume);
    solid += material.volume;
  }
  const grid::Grid& grid = specimen.body;
  const double box = grid.length(0) * grid.length(1) * grid.length(2);
  const auto lines = bounds_table(deck.parameters.materials.materials, volumes, specimen.extremes,
                                  deck.parameters.grid.plane_strain, solid < box * (1.0 - 1e-9));
  if (!lines.empty()) log.line("");
  for (const std::string& line : lines) log.line(line);
}

/// \param has_time  whether time is something else than the load
void print_steps(base::Log& log, const std::vector<output::HistoryRow>& rows,
                 const std::vector<output::MovingSupport>& moving,
                 const std::vector<std::string>& materials, bool has_time) {
  const auto largest_component = [](const std::array<double, 3>& v) {
    std::size_t largest = 0;
    for (std::size_t c = 1; c < 3; ++c)
      if (std::abs(v[c]) > std::abs(v[largest])) largest = c;
    return largest;
  };
  std::string head =
      has_time ? "\n step    time (s)  Newton  linear" : "\n step    load  Newton  linear";
  for (const auto& support : moving)
    head += base::format("  %16s", (support.name + " force").c_str());
  for (const auto& name : materials) head += base::format("  %28s", (name + " von Mises").c_str());
  log.line(head);
  for (const output::HistoryRow& row : rows) {
    std::string line = base::format("%5d", static_cast<int>(row.step));
    line += has_time ? base::format("  %10.5g", row.time) : base::format("  %6.4f", row.load);
    line += base::format("  %6d  %6d", static_cast<int>(row.newton_iterations),
                         static_cast<int>(row.linear_iterations));
    for (const auto& support : moving) {
      const double force = row.reactions[support.index][largest_component(support.displacement)];
      line += base::format("  %16s", readable_force(force).c_str());
    }
    for (const auto& material : row.materials) {
      const std::string stress = material.volume > 0.0
                                     ? base::format("mean %.4g, max %.4g Pa",
                                                    material.von_mises_mean, material.von_mises_max)
                                     : "no particle";
      line += base::format("  %28s", stress.c_str());
    }
    log.line(line);
  }
}

}  // namespace

void print_costs(base::Log& log, const base::Communicator& communicator, const Deck& deck,
                 const grid::Partition& partition) {
  std::string stages = "\ntime";
  for (const auto& [stage, spent] : base::stage_seconds(communicator))
    stages += base::format("  %s %.2f s", stage.c_str(), spent);
  log.line(stages);
  log.line("memory  " + base::readable_bytes(communicator.max(base::peak_memory())) +
           " at most on a rank");
  const std::string exchange =
      solver::describe_traffic(communicator, partition, deck.parameters.solver.preconditioner);
  if (!exchange.empty()) log.line(exchange);
}

void print_summary(base::Log& log, const base::Communicator& communicator, const Deck& deck,
                   const Specimen& specimen, const std::vector<output::HistoryRow>& rows,
                   const std::vector<output::MovingSupport>& moving,
                   const mechanics::MomentumBalance& balance, const grid::Vector& u) {
  print_give(log, rows.back().strain_energy, balance, u);
  print_steps(log, rows, moving, names(deck.parameters.materials.materials),
              deck.parameters.loading.has_time());
  print_bounds(log, deck, specimen, rows.front());
  print_costs(log, communicator, deck, balance.halo().partition());
}

}  // namespace stroma
