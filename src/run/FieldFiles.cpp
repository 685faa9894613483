// SPDX-License-Identifier: BSD-3-Clause

#include "run/FieldFiles.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "run/HomeOrder.hpp"
#include "run/MovingSupports.hpp"
#include "run/ShownFields.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/grid/ShapeGrid.hpp"
#include "stroma/mechanics/body/Lattice.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/files/VtkhdfGrid.hpp"
#include "stroma/output/files/VtkhdfParticles.hpp"

namespace stroma {

FieldFiles::FieldFiles(const base::Communicator& communicator, const Deck& deck,
                       const Specimen& specimen, const output::RunFolder& folder)
    : communicator_(communicator),
      deck_(&deck),
      specimen_(&specimen),
      folder_(folder),
      names_(history_names(deck.parameters)),
      vtkhdf_particles_(communicator, folder.folder(), "particles"),
      vtkhdf_grid_(communicator, folder.folder(), "grid"),
      provenance_{deck.parameters.title, output::program_version(), deck.text} {}

namespace {

/// Cuts a set of files at their ends. Collective. \return  whether all of them go as far
bool cut_all(const base::Communicator& communicator, const std::string& path,
             const std::vector<output::FileEnd>& ends) {
  const int ranks = static_cast<int>(ends.size());
  bool is_good = true;
  base::collectively(communicator, [&] {
    for (int r = communicator.rank(); r < ranks; r += communicator.size()) {
      const output::FileEnd& end = ends[static_cast<std::size_t>(r)];
      try {
        is_good = end.bytes > 0 && output::cut_at(output::spread_file_name(path, ranks, r), end) &&
                  is_good;
      } catch (const base::RunError&) {  // it is none of ours
        is_good = false;
      }
    }
  });
  return !communicator.any(!is_good);
}

using FilledElements = Kokkos::View<std::uint8_t*, grid::Device>;

/// The elements of this rank that have particles.
/// \param filled  of them; must outlive the part
output::GridPart part_of(const grid::Partition& partition, int rank, const FilledElements& filled) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(rank);
  output::GridPart part;
  part.elements = grid.elements;
  part.first_element = elements.begin;
  for (int d = 0; d < 3; ++d) part.element_count[d] = elements.extent(d);
  part.origin = grid.origin;
  part.spacing = grid.spacing;
  part.active = filled.data();
  return part;
}

/// On rank 0. \return  whether there was a file
bool remove_all(const base::Communicator& communicator, const std::string& path, int ranks) {
  bool was_any = false;
  for (int r = 0; communicator.is_root() && r < ranks; ++r)
    was_any = std::remove(output::spread_file_name(path, ranks, r).c_str()) == 0 || was_any;
  return was_any;
}

}  // namespace

std::string FieldFiles::resume(const FieldFilesEnd& end,
                               const std::vector<output::HistoryRow>& rows) {
  if (deck_->parameters.output.vtkhdf) {
    std::vector<output::StepSeries::Step> steps;
    for (const output::HistoryRow& row : rows) steps.emplace_back(row.step, row.time);
    vtkhdf_particles_.resume(steps);
    vtkhdf_grid_.resume(steps);
  }
  const int ranks = static_cast<int>(end.particles.size());
  const auto own = static_cast<std::size_t>(communicator_.rank());
  const bool are_ours = ranks == communicator_.size(), is_reset = deck_->parameters.grid.reset;
  adopted_.particles = end.particles;
  adopted_.grid = end.grid;
  std::string missing, note;
  if (end.particles_step >= 0) {
    const bool is_good = cut_all(communicator_, folder_.particles(), end.particles);
    if (is_good && are_ours) particles_continued_ = end.particles[own];
    if (is_good && !are_ours) adopted_.particles_step = end.particles_step;
    if (is_good) particles_step_ = end.particles_step;
    if (!is_good) missing = "particles.e";
  }
  if (end.grid_step >= 0) {
    const auto last = static_cast<int>(end.grid_files);
    for (int next = last + 1; remove_all(communicator_, folder_.grid(next), ranks);) ++next;
    const bool is_good = cut_all(communicator_, folder_.grid(last), end.grid);
    if (is_good && (are_ours || is_reset)) {
      if (are_ours) grid_continued_ = end.grid[own];
      grid_files_ = last;
      if (!are_ours)
        note = base::format(
            "the grid's files of the steps before are those of %d ranks, those of the steps to "
            "come of %d",
            ranks, communicator_.size());
    } else if (is_good) {
      adopted_.grid_step = end.grid_step;
    }
    if (is_good) grid_step_ = end.grid_step;
    if (!is_good) missing += missing.empty() ? "grid.e" : " and grid.e";
  }
  if (missing.empty()) return note;
  return missing + " of the steps before cannot be continued; begun anew with the next step";
}

bool FieldFiles::adopt(const mechanics::MomentumBalance& balance) {
  const base::Stage stage("output");
  const int ranks = static_cast<int>(adopted_.particles.size());
  if (adopted_.particles_step >= 0) {
    open_particle_file(balance);
    particle_file_->copy_steps(folder_.particles(), ranks, particle_set());
  }
  if (adopted_.grid_step >= 0) {
    const grid::Partition lattice = grid::lattice_under(balance.halo().partition());
    const auto filled = balance.body().filled_elements(lattice);
    open_grid_file(part_of(lattice, communicator_.rank(), filled));
    grid_file_->copy_steps(folder_.grid(), ranks);
  }
  return adopted_.particles_step >= 0 || adopted_.grid_step >= 0;
}

void FieldFiles::remove_adopted() const {
  const int ranks = static_cast<int>(adopted_.particles.size());
  if (adopted_.particles_step >= 0) remove_all(communicator_, folder_.particles(), ranks);
  if (adopted_.grid_step >= 0) remove_all(communicator_, folder_.grid(), ranks);
}

FieldFilesEnd FieldFiles::end() const {
  const auto everyone = [&](const output::FileEnd& own) {
    const auto steps = communicator_.gather(own.steps), bytes = communicator_.gather(own.bytes);
    std::vector<output::FileEnd> all;
    for (std::size_t r = 0; r < steps.size(); ++r) all.push_back({steps[r], bytes[r]});
    return all;
  };
  const auto at = [](const auto& file, const std::optional<output::FileEnd>& continued) {
    return file ? file->end() : continued.value_or(output::FileEnd());
  };
  return {particles_step_, grid_step_, grid_files_,
          everyone(at(particle_file_, particles_continued_)),
          everyone(at(grid_file_, grid_continued_))};
}

void FieldFiles::write_due(const output::HistoryRow& row, mechanics::MomentumBalance& balance,
                           const grid::Vector& u) {
  const auto& when = deck_->parameters.output;
  if (particles_step_ != row.step && output::is_due(row.step, when.particles_every, false))
    write_particles(row, balance, u);
  if (grid_step_ != row.step && output::is_due(row.step, when.grid_every, false))
    write_grid(row, balance, u);
}

void FieldFiles::write_last(const output::HistoryRow& row, mechanics::MomentumBalance& balance,
                            const grid::Vector& u) {
  if (particles_step_ != row.step) write_particles(row, balance, u);
  if (grid_step_ != row.step) write_grid(row, balance, u);
}

std::string FieldFiles::on_disk() const {
  const auto up_to = [](const char* file, std::int64_t step) {
    return step < 0 ? "" : base::format(", %s to step %lld", file, static_cast<long long>(step));
  };
  return up_to("particles.e", particles_step_) +
         up_to(grid_files_ > 1 ? "the grid.e files" : "grid.e", grid_step_);
}

output::ParticleSet FieldFiles::particle_set() const {
  const auto& particles = specimen_->particles;
  return {particles.count(), particles.position.data(), particles.volume.data(),
          particles.id.data(), particles.material.data()};
}

output::StatePieces FieldFiles::states(const mechanics::MomentumBalance& balance,
                                       const grid::Vector& u) const {
  auto shown =
      shown_fields(communicator_, deck_->parameters.materials.materials, *specimen_, balance);
  if (deck_->parameters.grid.reset) {  // particles have left their homes: all must be at hand
    const int count = specimen_->particles.count();
    const HomeOrder home(communicator_, balance.body().particles(), count);
    transfer::ParticleFields<grid::Device> here = balance.body().particle_fields(u), fields(0);
    const auto take_home = [&](auto& at_home, auto& view) {
      at_home = home(view);
      view = {};  // so that no two are there twice
    };
    transfer::for_each_result(take_home, fields, here);
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

std::vector<output::ShownField> FieldFiles::shown(const mechanics::MomentumBalance& balance) const {
  std::vector<output::ShownField> fields;
  for (const ShownValues& one :
       shown_fields(communicator_, deck_->parameters.materials.materials, *specimen_, balance))
    fields.push_back(one.field);
  return fields;
}

void FieldFiles::open_particle_file(const mechanics::MomentumBalance& balance) {
  particle_file_.emplace(communicator_, folder_.particles(), particle_set(), names_.materials,
                         output::history_columns(names_), provenance_,
                         deck_->parameters.output.precision, shown(balance),
                         std::exchange(particles_continued_, std::nullopt));
}

void FieldFiles::write_particles(const output::HistoryRow& row,
                                 const mechanics::MomentumBalance& balance, const grid::Vector& u) {
  const base::Stage stage("output");
  if (!particle_file_) open_particle_file(balance);
  const bool as_vtkhdf = deck_->parameters.output.vtkhdf;
  const auto fields = as_vtkhdf ? shown(balance) : std::vector<output::ShownField>();
  const output::StatePieces pieces = states(balance, u);  // the last to ask the body for something
  particle_file_->write(row.time, particle_set(), pieces, output::history_values(row));
  if (as_vtkhdf) write_vtkhdf_particles(row, pieces, fields);
  particles_step_ = row.step;
}

std::vector<output::VtkhdfNumber> FieldFiles::numbers(const output::HistoryRow& row) const {
  const std::vector<std::string> names = output::history_columns(names_);
  const std::vector<double> values = output::history_values(row);
  std::vector<output::VtkhdfNumber> numbers;
  for (std::size_t n = 0; n < names.size(); ++n) numbers.push_back({names[n], values[n]});
  return numbers;
}

void FieldFiles::write_vtkhdf_particles(const output::HistoryRow& row,
                                        const output::StatePieces& pieces,
                                        const std::vector<output::ShownField>& fields) {
  output::write_vtkhdf_particles(communicator_, vtkhdf_particles_.path(row.step), particle_set(),
                                 pieces, fields, numbers(row), deck_->parameters.output.precision);
  vtkhdf_particles_.add({row.step, row.time});
}

void FieldFiles::open_grid_file(const output::GridPart& part) {
  std::optional<output::FileEnd> continued = std::exchange(grid_continued_, std::nullopt);
  if (deck_->parameters.grid.reset) continued.reset();  // each step has a file of its own
  if (!continued) ++grid_files_;
  std::vector<std::string> vectors{"displacement", "residual"};
  if (deck_->parameters.loading.inertia) vectors.emplace_back("velocity");
  grid_file_.emplace(communicator_, folder_.grid(grid_files_), part, vectors, provenance_,
                     deck_->parameters.output.precision, continued);
}

void FieldFiles::write_grid(const output::HistoryRow& row, mechanics::MomentumBalance& balance,
                            const grid::Vector& u) {
  const base::Stage stage("output");
  const grid::Vector& force = *balance.forces(u).unbalanced;
  // The file's nodes are those of the lattice, whatever the shape functions.
  const auto lattice = balance.halo().partition().grid().width == 2
                           ? std::nullopt
                           : std::make_optional<mechanics::Lattice>(balance.halo());
  const grid::Halo& halo = lattice ? lattice->halo() : balance.halo();
  grid::Vector at_nodes(halo.owned_map());
  // A grid that is reset has other elements in each step, and so a file of its own.
  const bool is_new = !grid_file_ || deck_->parameters.grid.reset;
  const bool as_vtkhdf = deck_->parameters.output.vtkhdf;
  const auto filled =
      is_new || as_vtkhdf ? balance.body().filled_elements(halo.partition()) : FilledElements();
  const output::GridPart part = part_of(halo.partition(), communicator_.rank(), filled);
  if (is_new) open_grid_file(part);
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
  const auto values = [&](const grid::Vector& vector) {
    if (lattice) lattice->values_at_nodes(vector, at_nodes);
    return gathered(lattice ? at_nodes : vector, 1.0);
  };
  const std::vector<double> displacement = values(u);
  if (lattice) lattice->forces_at_nodes(force, at_nodes);
  const std::vector<double> residual = gathered(lattice ? at_nodes : force, 0.5);
  std::vector<output::NodalVector> vectors{{"displacement", "um", displacement.data()},
                                           {"residual", "pN", residual.data()}};
  std::vector<double> velocity;
  if (const mechanics::Inertia* inertia = balance.inertia()) {
    velocity = values(inertia->velocity());
    vectors.push_back({"velocity", "um/s", velocity.data()});
  }
  grid_file_->write(row.time, vectors);
  if (as_vtkhdf) {
    output::write_vtkhdf_grid(communicator_, vtkhdf_grid_.path(row.step), part, vectors,
                              numbers(row), deck_->parameters.output.precision);
    vtkhdf_grid_.add({row.step, row.time});
  }
  grid_step_ = row.step;
}

}  // namespace stroma
