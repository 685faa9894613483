// SPDX-License-Identifier: BSD-3-Clause

#include "run/Results.hpp"

#include "run/HistoryFigures.hpp"
#include "run/MovingSupports.hpp"
#include "run/RunFacts.hpp"
#include "run/RunSummary.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/output/files/DeckFile.hpp"

namespace stroma {

Results::Results(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
                 const std::vector<KnownFile>& files, Tables& tables,
                 const output::RunFolder& folder, base::Log& log, const ResultsSoFar& so_far)
    : communicator_(communicator),
      deck_(&deck),
      specimen_(&specimen),
      folder_(folder),
      log_(&log),
      pictures_(communicator, folder.folder(), deck.parameters.title, specimen.layout.spacing,
                deck.parameters.output.origin),
      history_(communicator, folder.history(), history_names(deck.parameters), so_far.rows),
      fields_(communicator, deck, specimen, folder),
      stacks_(communicator, deck, specimen, folder),
      tables_(&tables),
      rows_(so_far.rows) {
  if (!rows_.empty()) {
    const std::string note = fields_.resume(so_far.files, rows_);
    if (!note.empty()) log.note(note);
    stacks_.resume(rows_.back().step);
  }
  output::write_deck(communicator, folder.deck(), *as_run(deck),
                     run_facts(communicator, folder.taken(), files));
  folder.finish("deck.xml");
}

namespace {

/// Energies of a body with inertia; powers are integrated by the trapezoidal rule. At a corner of a
/// load curve that of supports jumps with their velocity.
std::optional<output::HistoryRow::Motion> motion_of(const output::HistoryRow& row,
                                                    const std::vector<output::HistoryRow>& before,
                                                    mechanics::MomentumBalance& balance,
                                                    const grid::Vector& u) {
  if (balance.inertia() == nullptr) return std::nullopt;
  output::HistoryRow::Motion motion;
  motion.kinetic_energy = balance.inertia()->kinetic_energy();
  const grid::Vector acting = balance.external_force(u);
  motion.external_power = acting.dot(balance.inertia()->velocity());
  motion.damping_power = balance.damping_power(u);
  if (before.empty()) return motion;
  const output::HistoryRow::Motion& last = *before.back().motion;
  const double half_step = 0.5 * (row.time - before.back().time);
  const double arriving_power = acting.dot(balance.inertia()->arriving_velocity());
  motion.external_work = last.external_work + half_step * (last.external_power + arriving_power);
  motion.damping_work = last.damping_work + half_step * (last.damping_power + motion.damping_power);
  return motion;
}

}  // namespace

void Results::write(output::HistoryRow row, mechanics::MomentumBalance& balance,
                    const grid::Vector& u) {
  row.reactions = balance.reactions(u);
  row.torques = balance.torques(u);
  row.pressures = pressures_at(deck_->parameters, row.load);
  row.motion = motion_of(row, rows_, balance, u);
  rows_.push_back(with_figures(std::move(row), communicator_, balance.body(), u));
  history_.append(rows_.back());
  write_missing(balance, u);
}

void Results::write_missing(mechanics::MomentumBalance& balance, const grid::Vector& u) {
  fields_.write_due(rows_.back(), balance, u);
  stacks_.write_due(rows_.back(), balance.body(), u);
}

void Results::write_last(mechanics::MomentumBalance& balance, const grid::Vector& u) {
  fields_.write_last(rows_.back(), balance, u);
  stacks_.write_last(rows_.back(), balance.body(), u);
}

void Results::write_tables(const mechanics::MomentumBalance& balance, const grid::Vector& u,
                           double room) {
  said_of_tables_ = tables_->write(folder_, rows_.back(), fields_.particle_set(),
                                   fields_.states(balance, u), room);
}

std::string Results::on_disk() const {
  if (rows_.empty()) return "nothing is on disk yet";
  return base::format("on disk in %s: history.csv to step %lld (load %.6g)",
                      folder_.folder().c_str(), static_cast<long long>(rows_.back().step),
                      rows_.back().load) +
         fields_.on_disk();
}

void Results::draw(const std::vector<output::MovingSupport>& moving,
                   const mechanics::MomentumBalance& balance, const grid::Vector& u) {
  const base::Stage stage("pictures");
  std::vector<std::string> notes{
      pictures_.draw_materials(fields_.particle_set(),
                               names(deck_->parameters.materials.materials)),
      pictures_.draw_von_mises(fields_.particle_set(), fields_.states(balance, u),
                               rows_.back().load)};
  if (!moving.empty()) notes.push_back(pictures_.draw_force(moving, rows_));
  for (const std::string& note : notes)
    if (!note.empty()) log_->note(note);
}

void Results::finish_files() { folder_.finish(); }

void Results::finish(mechanics::MomentumBalance& balance, const grid::Vector& u,
                     const std::function<double()>& seconds) {
  const auto moving = moving_supports(deck_->parameters, specimen_->body.lengths());
  if (deck_->parameters.output.pictures) draw(moving, balance, u);
  finish_files();
  print_summary(*log_, communicator_, *deck_, *specimen_, rows_, moving, balance, u);
  if (!said_of_tables_.empty()) log_->line(said_of_tables_);
  log_->line(base::format("%.1f s on %s; results in %s", seconds(),
                          base::ranks_and_threads(communicator_).c_str(),
                          folder_.folder().c_str()));
}

}  // namespace stroma
