// SPDX-License-Identifier: BSD-3-Clause

#include "run/RunLog.hpp"

#include <mpi.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "run/BodyNotes.hpp"
#include "run/WithoutEffect.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/solver/CurveNotes.hpp"

namespace stroma {

using base::format;

RunLog::RunLog(const base::Communicator& communicator, const Deck& deck, base::Log& log)
    : communicator_(communicator), deck_(&deck), log_(&log), start_(MPI_Wtime()) {}

namespace {

std::string name_of(const Deck& deck, const mechanics::WorstParticle& particle) {
  return format("id %lld, material \"%s\", at (%.6g, %.6g, %.6g) um",
                static_cast<long long>(particle.id),
                deck.parameters.materials.materials[static_cast<std::size_t>(particle.material)]
                    .first.c_str(),
                particle.position[0], particle.position[1], particle.position[2]);
}

/// What is to be said of particles that have lost ellipticity; nothing where none has.
std::string localization_note(const Deck& deck, const mechanics::Body& body, const grid::Vector& u,
                              int share) {
  const mechanics::Localization found = body.localization(u, share);
  if (found.particles == 0) return "";
  return format(
      "lost ellipticity: %lld particle%s%s, most of all particle %s, where a plane wave across "
      "(%.3f, %.3f, %.3f) has a modulus of %.4g Pa: the material softens, and strains localise",
      static_cast<long long>(found.particles), found.particles == 1 ? "" : "s",
      share == 1 ? "" : format(" in one element of %d that were looked at", share).c_str(),
      name_of(deck, found.worst).c_str(), found.direction[0], found.direction[1],
      found.direction[2], found.worst.figure);
}

/// Neo-Hookean bodies keep their ellipticity while von Mises' stress is below mu and J below e: the
/// least modulus of 4,000 random states of such stress with K = 2 mu was 0.38 mu.
bool is_surely_elliptic(const Deck& deck, const mechanics::Laws& laws,
                        const output::HistoryRow& row) {
  const auto& materials = deck.parameters.materials.materials;
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (!material::is_neo_hookean_alone(materials[m].second) ||
        row.materials[m].von_mises_max > laws.moduli[m].shear)
      return false;
  return true;
}

}  // namespace

double RunLog::seconds() const { return MPI_Wtime() - start_; }

void RunLog::go_on(const output::HistoryRow& row) {
  start_ -= row.wall_seconds;
  most_energy_ = row.strain_energy;
  if (row.load > 0.0) full_load_at_ = row.wall_seconds / row.load;
  log_->line(
      format("goes on    after step %lld, load %.6g", static_cast<long long>(row.step), row.load));
}

void RunLog::describe(const Specimen& specimen, const mechanics::MomentumBalance& balance) {
  const image::ImageSummary& image = specimen.image;
  const grid::Grid& grid = specimen.body;
  log_->line(format("image      %lld x %lld x %lld voxels of %g x %g x %g um (%s)",
                    static_cast<long long>(image.size[0]), static_cast<long long>(image.size[1]),
                    static_cast<long long>(image.size[2]), image.voxel_size.um[0],
                    image.voxel_size.um[1], image.voxel_size.um[2], image.format.c_str()));
  for (const std::string& note : image.notes) log_->note(note);
  log_->line(format("grid       %lld x %lld x %lld elements of %g x %g x %g um, %lld unknowns",
                    static_cast<long long>(grid.elements[0]),
                    static_cast<long long>(grid.elements[1]),
                    static_cast<long long>(grid.elements[2]), grid.spacing[0], grid.spacing[1],
                    grid.spacing[2], static_cast<long long>(balance.supports().unknowns())));
  for (const std::string& field : specimen.fields) log_->line(field);
  for (const std::string& line : describe_rig(deck_->parameters)) log_->line("rig        " + line);
  log_->line("dilatation " + specimen.dilatation);
  log_->line(format("particles  %lld, on %s", static_cast<long long>(specimen.particle_count),
                    base::ranks_and_threads(communicator_).c_str()));
  const std::string crowded = base::oversubscription(communicator_);
  if (!crowded.empty()) log_->note(crowded);
  for (const std::string& note : specimen.notes) log_->note(note);
  for (const std::string& note : body_notes(*deck_, specimen, balance)) log_->note(note);
}

void RunLog::show_progress(const std::string& state) {
  if (step_.empty()) return;
  std::string time = format("   %.0f s", seconds());
  if (full_load_at_ > 0.0)
    time += format(", about %.0f s left", std::max(full_load_at_ - seconds(), 0.0));
  log_->progress(step_ + state + time);
}

void RunLog::begin_step(const solver::StepControl& load) {
  step_.clear();
  if (!log_->shows_progress()) return;
  step_ = format("step %d of %d   load %.4g to %.4g", load.accepted() + 1,
                 load.accepted() + load.remaining(), load.load(), load.next());
  show_progress("");
}

void RunLog::newton(int iteration, double residual, long long linear_iterations) {
  log_->line(format("    Newton %2d   residual %.2e   %6lld linear iterations   %8.1f s", iteration,
                    residual, linear_iterations, seconds()));
  show_progress(format("   Newton %d   residual %.1e", iteration, residual));
}

void RunLog::compare_pieces(const mechanics::PiecesSummary& before, const mechanics::Supports& now,
                            double load) {
  const mechanics::PiecesSummary& after = now.pieces();
  if (after.count == before.count && after.carried == before.carried) return;
  log_->note(format("at load %.6g the body is in %lld piece%s instead of %lld", load,
                    static_cast<long long>(after.count), after.count == 1 ? "" : "s",
                    static_cast<long long>(before.count)));
  for (const std::string& note : now.notes()) log_->note(note);
}

void RunLog::filling(const mechanics::MomentumBalance& balance, double load) {
  if (has_told_of_filling_ || !deck_->parameters.grid.reset) return;
  const std::string note = mechanics::barely_filled_note(balance);
  if (note.empty()) return;
  has_told_of_filling_ = true;
  if (load == 0.0) return;  // told with the body
  const bool is_stiffened = balance.problem().method.stabilization > 0.0;
  log_->note(
      format("from load %.6g on, ", load) + note +
      (is_stiffened ? ", and stiffens the body: less of it, or more steps, show by how much" : ""));
}

void RunLog::accepted(const solver::StepControl& load, const solver::NewtonResult& solved) {
  const auto& loading = deck_->parameters.loading;
  const std::string time =
      loading.has_time() ? format("   time %.5g s", load.load() * loading.seconds()) : "";
  const double left = seconds() * load.remaining() / load.accepted();
  log_->line(
      format("step %3d   load %.4f%s   Newton %d   linear %lld   residual %.1e   %.1f s, about "
             "%.0f s left",
             load.accepted(), load.load(), time.c_str(), solved.iterations,
             solved.linear_iterations, solved.residual, seconds(), left));
  full_load_at_ = seconds() + left;
  if (load.finished()) log_->progress("");
  constexpr double much_more = 2.0;
  if (solved.is_limited_by_rounding && solved.residual > much_more * told_of_rounding_) {
    told_of_rounding_ = solved.residual;
    log_->note(
        format("rounding limits the residual to %.1e of the forces, which are no better; more "
               "iterations would not lower it",
               solved.residual));
  }
  constexpr double noticeable = 1e-6;
  if (!solved.is_limited_by_rounding && solved.hold_share > noticeable &&
      !std::exchange(has_told_of_holds_, true))
    log_->note(
        format("the forces on the deformed body are not in balance: the nodes that hold its "
               "free rigid motions bear %.1e of them; a support would be better",
               solved.hold_share));
}

void RunLog::localization(const mechanics::MovingBody& body, const output::HistoryRow& row) {
  const mechanics::Problem& problem = body.balance().problem();
  if (has_told_of_localization_ || is_surely_elliptic(*deck_, problem.laws, row)) return;
  const grid::Index3& elements = problem.body.elements;
  constexpr std::int64_t always = 128, at_most = 32;  // takes less than 1 % of a run
  const int share = static_cast<int>(
      std::clamp(elements[0] * elements[1] * elements[2] / always, std::int64_t{1}, at_most));
  const std::string found =
      localization_note(*deck_, body.balance().body(), body.displacement(), share);
  if (found.empty()) return;
  has_told_of_localization_ = true;
  log_->note(format("at load %.6g the body has ", row.load) + found +
             "; results from here on may depend on the grid");
}

void RunLog::rest(const output::HistoryRow& row, bool is_last) {
  most_energy_ = std::max(most_energy_, row.strain_energy);
  const material::NamedMaterials& materials = deck_->parameters.materials.materials;
  const bool may_be_free_of_stress =  // in flight, or grown
      deck_->parameters.loading.inertia ||
      std::any_of(materials.begin(), materials.end(),
                  [](const auto& named) { return named.second.growth.has_value(); });
  if (!is_last || may_be_free_of_stress) return;
  double softest = std::numeric_limits<double>::infinity(), volume = 0.0;
  for (const material::SmallStrainModuli& moduli : material::moduli_of(materials))
    if (moduli.shear > 0.0) softest = std::min(softest, moduli.shear);
  for (const auto& material : row.materials) volume += material.volume;
  constexpr double by_rounding = 1e-11;  // strains
  if (most_energy_ < by_rounding * by_rounding * softest * volume)
    log_->note(format(
        "nothing strains the body: its energy is at most %.1e aJ, and stresses and forces are 0 or "
        "errors of rounding; it is not loaded, or moves as a whole",
        most_energy_));
}

void RunLog::rejected(double load, const std::string& reason) {
  log_->line(format("step to load %.6g rejected: %s", load, reason.c_str()));
}

void RunLog::stabilization(const mechanics::MovingBody& body) {
  if (deck_->parameters.grid.reset || body.balance().problem().method.stabilization == 0.0 ||
      mechanics::count_barely_filled(body.balance()) == 0)
    return;
  log_->note(format("Grid|Stabilization adds %.1e to the stiffness of the body, to first order",
                    mechanics::stabilization_share(body.balance(), body.displacement())));
}

std::string failure(const Deck& deck, const mechanics::MomentumBalance& balance,
                    const grid::Vector& trial, const solver::StepControl& load,
                    const std::string& reason, const std::string& folder) {
  const mechanics::WorstParticle worst = balance.body().worst_particle(trial);
  const std::string lost = localization_note(deck, balance.body(), trial, 1);
  std::string advice;
  if (load.load() == 0.0)
    for (const auto& [name, curve] : deck.parameters.load_curves.curves) {
      const std::string on_start = solver::advice_on_start(name, curve);
      if (is_followed(deck.parameters, name) && !on_start.empty()) advice += "\n- " + on_start;
    }
  for (const std::string& one : solver::advice(circumstances(deck, balance)))
    advice += "\n- " + one;
  return format(
             "the load step from %.6g to %.6g of the load failed, and Loading|Smallest Step "
             "forbids smaller ones: %s\n",
             load.load(), load.next(), reason.c_str()) +
         format("worst particle: %s, J = %.4g\n", name_of(deck, worst).c_str(), worst.figure) +
         (lost.empty() ? "" : lost + "\n") + "the steps up to there are in " + folder +
         "; to go on, what may help:" + advice;
}

}  // namespace stroma
