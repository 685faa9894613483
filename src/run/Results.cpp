// SPDX-License-Identifier: BSD-3-Clause

#include "run/Results.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "run/BoundsTable.hpp"
#include "run/HomeOrder.hpp"
#include "run/MovingSupports.hpp"
#include "run/ShownFields.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/mechanics/body/Lattice.hpp"
#include "stroma/output/files/DeckFile.hpp"
#include "stroma/solver/IterationTraffic.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma {
namespace {

/// A force [pN] in the unit in which it is easily read.
std::string readable_force(double force) {
  const double size = std::abs(force);
  if (size >= 1e6) return base::format("%.5g uN", force * 1e-6);
  if (size >= 1e3) return base::format("%.5g nN", force * 1e-3);
  return base::format("%.5g pN", force);
}

}  // namespace

Results::Results(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
                 const output::RunFolder& folder, base::Log& log)
    : communicator_(communicator),
      deck_(&deck),
      specimen_(&specimen),
      folder_(folder),
      log_(&log),
      conditions_(names(deck.parameters.boundary_conditions.conditions)),
      materials_(names(deck.parameters.materials.materials)),
      provenance_{deck.parameters.title, output::library_versions().front().second, deck.text},
      pictures_(communicator, folder.folder(), deck.parameters.title, specimen.layout.spacing,
                deck.parameters.output.origin),
      history_(communicator, folder.history(), conditions_, materials_) {
  output::write_deck(communicator, folder.deck(), *as_run(deck));
  folder.finish("deck.xml");
}

output::ParticleSet Results::particle_set() const {
  const auto& particles = specimen_->particles;
  return {particles.count(), particles.position.data(), particles.volume.data(),
          particles.id.data(), particles.material.data()};
}

output::HistoryRow Results::with_figures(output::HistoryRow row,
                                         const mechanics::MomentumBalance& balance,
                                         const grid::Vector& u) const {
  const auto& particles = balance.body().particles();
  std::vector<double> sums(2 * materials_.size() + 1, 0.0);  // volume, stress * volume; energy
  std::vector<double> largest(materials_.size(), 0.0);
  balance.body().field_layers(u)(
      [&](int first, const transfer::ParticleFields<grid::Device>& fields) {
        const auto count = static_cast<int>(fields.jacobian.extent(0));
        for (int n = 0; n < count; ++n) {
          const int p = first + n;
          const std::size_t m = particles.material(p);
          const double volume = fields.jacobian(n) * particles.volume(p);
          const auto s = [&](int c) { return fields.stress(n, c); };
          const double von_mises =
              tensor::von_mises({{{s(0), s(3), s(5)}, {s(3), s(1), s(4)}, {s(5), s(4), s(2)}}});
          sums[2 * m] += volume;
          sums[2 * m + 1] += von_mises * volume;
          sums.back() += fields.energy(n) * particles.volume(p);
          largest[m] = std::max(largest[m], von_mises);
        }
      });
  communicator_.sum_all(sums.data(), sums.size());
  row.strain_energy = sums.back();
  for (std::size_t m = 0; m < materials_.size(); ++m) {
    const double volume = sums[2 * m];
    row.materials.push_back(
        {volume, volume > 0.0 ? sums[2 * m + 1] / volume : 0.0, communicator_.max(largest[m])});
  }
  return row;
}

void Results::write(output::HistoryRow row, mechanics::MomentumBalance& balance,
                    const grid::Vector& u) {
  row.reactions = balance.reactions(u);
  rows_.push_back(with_figures(std::move(row), balance, u));
  history_.append(rows_.back());

  const auto& when = deck_->parameters.output;
  if (output::is_due(rows_.back().step, when.particles_every, false)) write_particles(balance, u);
  if (output::is_due(rows_.back().step, when.grid_every, false)) write_grid(balance, u);
}

namespace {

/// \param first  of the shown values: the particle that the fields begin with
output::ParticleState state_of(const transfer::ParticleFields<grid::Device>& fields,
                               const std::vector<ShownValues>& shown, int first = 0) {
  output::ParticleState state{fields.displacement.data(), fields.stress.data(),
                              fields.jacobian.data(), fields.energy.data()};
  for (const ShownValues& one : shown) state.fields.push_back(one.values.data() + first);
  return state;
}

}  // namespace

output::StatePieces Results::states(const mechanics::MomentumBalance& balance,
                                    const grid::Vector& u) const {
  auto shown = shown_fields(communicator_, balance.body().particles());
  if (deck_->parameters.grid.reset) {  // particles have left their homes: all must be at hand
    const int count = specimen_->particles.count();
    const HomeOrder home(communicator_, balance.body().particles(), count);
    const transfer::ParticleFields<grid::Device> here = balance.body().particle_fields(u);
    transfer::ParticleFields<grid::Device> fields(0);
    transfer::for_each_result([&](auto& at_home, const auto& view) { at_home = home(view); },
                              fields, here);
    for (ShownValues& one : shown) one.values = home(one.values);
    return [fields, shown, count](const auto& use) {  // they live as long as the pieces may be
      output::in_one_piece(count, state_of(fields, shown))(use);  // asked for
    };
  }
  return [layers = balance.body().field_layers(u), shown](const auto& use) {
    layers([&](int first, const transfer::ParticleFields<grid::Device>& fields) {
      use(first, static_cast<std::int64_t>(fields.jacobian.extent(0)),
          state_of(fields, shown, first));
    });
  };
}

void Results::write_particles(const mechanics::MomentumBalance& balance, const grid::Vector& u) {
  const base::Stage stage("output");
  if (!particle_file_) {
    std::vector<output::ShownField> fields;
    for (const ShownValues& one : shown_fields(communicator_, balance.body().particles()))
      fields.push_back(one.field);
    particle_file_.emplace(communicator_, folder_.particles(), particle_set(), materials_,
                           output::history_columns(conditions_, materials_), provenance_,
                           deck_->parameters.output.precision, fields);
  }
  particle_file_->write(rows_.back().load, particle_set(), states(balance, u),
                        output::history_values(rows_.back()));
  particles_step_ = rows_.back().step;
}

void Results::open_grid_file(const mechanics::MomentumBalance& balance,
                             const grid::Partition& partition) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(communicator_.rank());
  const auto filled = balance.body().filled_elements(partition);
  output::GridPart part;
  part.elements = grid.elements;
  part.first_element = elements.begin;
  for (int d = 0; d < 3; ++d) part.element_count[d] = elements.extent(d);
  part.origin = grid.origin;
  part.spacing = grid.spacing;
  part.active = filled.data();
  grid_file_.emplace(communicator_, folder_.grid(++grid_files_), part, provenance_,
                     deck_->parameters.output.precision);
}

void Results::write_grid(mechanics::MomentumBalance& balance, const grid::Vector& u) {
  const base::Stage stage("output");
  const grid::Vector& force = *balance.forces(u).unbalanced;
  // The file's nodes are those of the lattice, whatever the shape functions.
  const auto lattice = balance.halo().partition().grid().width == 2
                           ? std::nullopt
                           : std::make_optional<mechanics::Lattice>(balance.halo());
  const grid::Halo& halo = lattice ? lattice->halo() : balance.halo();
  grid::Vector displacement_at_nodes(halo.owned_map()), force_at_nodes(halo.owned_map());
  if (lattice) {
    lattice->values_at_nodes(u, displacement_at_nodes);
    lattice->forces_at_nodes(force, force_at_nodes);
  }
  // A grid that is reset has other elements in each step, and so a file of its own.
  if (!grid_file_ || deck_->parameters.grid.reset) open_grid_file(balance, halo.partition());
  const auto gathered = [&](const grid::Vector& vector, double share) {
    const grid::ConstNodeView view = halo.gather(vector);
    std::vector<double> values(view.data(), view.data() + view.size());
    if (halo.partition().grid().flat) {  // the file's element has its two layers of nodes
      for (double& value : values) value *= share;
      values.resize(2 * view.size());
      std::copy_n(values.begin(), view.size(),
                  values.begin() + static_cast<std::ptrdiff_t>(view.size()));
    }
    return values;
  };
  const std::vector<double> displacement = gathered(lattice ? displacement_at_nodes : u, 1.0);
  const std::vector<double> residual = gathered(lattice ? force_at_nodes : force, 0.5);
  grid_file_->write(rows_.back().load, displacement.data(), residual.data());
  grid_step_ = rows_.back().step;
}

std::string Results::on_disk() const {
  const auto up_to = [](const char* file, std::int64_t step) {
    return step < 0 ? "" : base::format(", %s to step %lld", file, static_cast<long long>(step));
  };
  return base::format("on disk in %s: history.csv to step %lld (load %.6g)",
                      folder_.folder().c_str(), static_cast<long long>(rows_.back().step),
                      rows_.back().load) +
         up_to("particles.e", particles_step_) +
         up_to(grid_files_ > 1 ? "the grid.e files" : "grid.e", grid_step_);
}

void Results::finish(mechanics::MomentumBalance& balance, const grid::Vector& u,
                     const std::function<double()>& seconds) {
  if (particles_step_ != rows_.back().step) write_particles(balance, u);
  if (grid_step_ != rows_.back().step) write_grid(balance, u);
  const auto moving = moving_supports(deck_->parameters, specimen_->body.lengths());
  std::optional<base::Stage> stage("pictures");
  if (deck_->parameters.output.pictures) {
    std::vector<std::string> notes{
        pictures_.draw_materials(particle_set(), materials_),
        pictures_.draw_von_mises(particle_set(), states(balance, u), rows_.back().load)};
    if (!moving.empty()) notes.push_back(pictures_.draw_force(moving, rows_));
    for (const std::string& note : notes)
      if (!note.empty()) log_->note(note);
  }
  stage.reset();
  folder_.finish();
  print_give(balance, u);
  print_table(moving, balance.halo().partition(), seconds());
}

void Results::print_give(const mechanics::MomentumBalance& balance, const grid::Vector& u) const {
  const double springs = balance.support_energy(u);
  if (springs <= 0.0) return;
  log_->line(
      base::format("\n"
                   "penalty    the springs of the supports hold %.2g of the energy: about by so "
                   "much they lower the forces",
                   springs / (springs + rows_.back().strain_energy)));
}

void Results::print_bounds() const {
  std::vector<double> volumes;  // at load 0: of the undeformed body
  double solid = 0.0;
  for (const auto& material : rows_.front().materials) {
    volumes.push_back(material.volume);
    solid += material.volume;
  }
  const grid::Grid& grid = specimen_->body;
  const double box = grid.length(0) * grid.length(1) * grid.length(2);
  const auto lines =
      bounds_table(deck_->parameters.materials.materials, volumes, specimen_->extremes,
                   deck_->parameters.grid.plane_strain, solid < box * (1.0 - 1e-9));
  if (!lines.empty()) log_->line("");
  for (const std::string& line : lines) log_->line(line);
}

void Results::print_table(const std::vector<output::MovingSupport>& moving,
                          const grid::Partition& partition, double seconds) const {
  const auto largest_component = [](const std::array<double, 3>& v) {
    std::size_t largest = 0;
    for (std::size_t c = 1; c < 3; ++c)
      if (std::abs(v[c]) > std::abs(v[largest])) largest = c;
    return largest;
  };
  std::string head = "\n step    load  Newton  linear";
  for (const auto& support : moving)
    head += base::format("  %16s", (support.name + " force").c_str());
  for (const auto& name : materials_) head += base::format("  %28s", (name + " von Mises").c_str());
  log_->line(head);
  for (const output::HistoryRow& row : rows_) {
    std::string line = base::format("%5d  %6.4f  %6d  %6d", static_cast<int>(row.step), row.load,
                                    static_cast<int>(row.newton_iterations),
                                    static_cast<int>(row.linear_iterations));
    for (const auto& support : moving) {
      const double force = row.reactions[support.index][largest_component(support.displacement)];
      line += base::format("  %16s", readable_force(force).c_str());
    }
    for (const auto& material : row.materials)
      line += base::format("  %28s", base::format("mean %.4g, max %.4g Pa", material.von_mises_mean,
                                                  material.von_mises_max)
                                         .c_str());
    log_->line(line);
  }
  print_bounds();
  std::string stages = "\ntime";
  for (const auto& [stage, spent] : base::stage_seconds(communicator_))
    stages += base::format("  %s %.2f s", stage.c_str(), spent);
  log_->line(stages);
  log_->line("memory  " + base::readable_bytes(communicator_.max(base::peak_memory())) +
             " at most on a rank");
  const std::string exchange =
      solver::describe_traffic(communicator_, partition, deck_->parameters.solver.preconditioner);
  if (!exchange.empty()) log_->line(exchange);
  log_->line(base::format("%.1f s on %s; results in %s", seconds,
                          base::ranks_and_threads(communicator_).c_str(),
                          folder_.folder().c_str()));
}

}  // namespace stroma
