#include "Simulation.hpp"

#include <mpi.h>

#include <optional>
#include <utility>

#include "Results.hpp"
#include "Specimen.hpp"
#include "base/Error.hpp"
#include "base/Session.hpp"
#include "base/Signals.hpp"
#include "mechanics/BarelyFilled.hpp"
#include "solver/LoadStep.hpp"
#include "solver/StepControl.hpp"
#include "solver/TrialSolve.hpp"

namespace stroma {
namespace {

using base::format;

void describe(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
              const mechanics::MomentumBalance& balance, base::Log& log) {
  const image::ImageSummary& image = specimen.image;
  const grid::Grid& grid = specimen.body;
  log.line(format("image      %lld x %lld x %lld voxels of %g x %g x %g um (%s)",
                  static_cast<long long>(image.size[0]), static_cast<long long>(image.size[1]),
                  static_cast<long long>(image.size[2]), image.voxel_size.um[0],
                  image.voxel_size.um[1], image.voxel_size.um[2], image.format.c_str()));
  for (const std::string& note : image.notes) log.note(note);
  log.line(format("grid       %lld x %lld x %lld elements of %g x %g x %g um, %lld unknowns",
                  static_cast<long long>(grid.elements[0]),
                  static_cast<long long>(grid.elements[1]),
                  static_cast<long long>(grid.elements[2]), grid.spacing[0], grid.spacing[1],
                  grid.spacing[2], static_cast<long long>(balance.supports().unknowns())));
  log.line("dilatation " + specimen.dilatation);
  log.line(format("particles  %lld, on %s", static_cast<long long>(specimen.particle_count),
                  base::ranks_and_threads(communicator).c_str()));
  const std::string crowded = base::oversubscription(communicator);
  if (!crowded.empty()) log.note(crowded);
  for (const std::string& note : specimen.notes) log.note(note);
  for (const std::string& note : balance.supports().notes()) log.note(note);
  for (const std::string& note : {mechanics::barely_filled_note(balance),
                                  solver::contrast_note(circumstances(deck, balance))})
    if (!note.empty()) log.note(note);
}

/// Begins a step; says so when the body came apart, or together, with the grid's reset.
void begin_step(mechanics::MovingBody& body, solver::NewtonSolver& newton, double load,
                base::Log& log) {
  const mechanics::PiecesSummary before = body.balance().supports().pieces();
  solver::begin_step(body, newton);
  const mechanics::Supports& supports = body.balance().supports();
  if (supports.pieces().count == before.count && supports.pieces().carried == before.carried)
    return;
  log.note(format("at load %.6g the body is in %lld pieces instead of %lld", load,
                  static_cast<long long>(supports.pieces().count),
                  static_cast<long long>(before.count)));
  for (const std::string& note : supports.notes()) log.note(note);
}

/// Says, once each, what a converged step leaves to be said.
class StepNotes {
 public:
  explicit StepNotes(base::Log& log) : log_(log) {}

  void look_at(const solver::NewtonResult& solved) {
    if (solved.is_limited_by_rounding && !std::exchange(has_told_of_rounding_, true))
      log_.note(format(
          "rounding limits the residual to %.1e of the forces; more iterations would not lower it",
          solved.residual));
    constexpr double noticeable = 1e-6;
    if (!solved.is_limited_by_rounding && solved.hold_share > noticeable &&
        !std::exchange(has_told_of_holds_, true))
      log_.note(
          format("the forces on the deformed body are not in balance: the nodes that hold its "
                 "free rigid motions bear %.1e of them; a support would be better",
                 solved.hold_share));
  }

 private:
  base::Log& log_;
  bool has_told_of_rounding_ = false, has_told_of_holds_ = false;
};

std::string failure(const Deck& deck, const mechanics::MomentumBalance& balance,
                    const grid::Vector& trial, double load, double next, const std::string& reason,
                    const std::string& folder) {
  const mechanics::WorstParticle worst = balance.worst_particle(trial);
  std::string advice;
  for (const std::string& one : solver::advice(circumstances(deck, balance)))
    advice += "\n- " + one;
  return format(
             "the load step from %.6g to %.6g of the load failed, and Loading|Smallest Step "
             "forbids "
             "smaller ones: %s\n",
             load, next, reason.c_str()) +
         format("worst particle: id %lld, material \"%s\", at (%.6g, %.6g, %.6g) um, J = %.4g\n",
                static_cast<long long>(worst.id),
                deck.parameters.materials.materials[static_cast<std::size_t>(worst.material)]
                    .first.c_str(),
                worst.position[0], worst.position[1], worst.position[2], worst.jacobian) +
         "the steps up to there are in " + folder + "; to go on, what may help:" + advice;
}

}  // namespace

void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const std::string& output_folder, base::Log& log) {
  const double start = MPI_Wtime();
  const auto seconds = [&] { return MPI_Wtime() - start; };

  const output::RunFolder folder(communicator, output_folder,
                                 output::run_files(deck.parameters.output.pictures));
  folder.refuse_foreign_files(input_files(deck));
  solver::try_lists(communicator, deck.parameters.solver);

  // Image stack -> labels -> particles on a grid.
  std::optional<image::LabelVolume> labels;
  image::ImageSummary summary;
  labels = read_labels(communicator, deck, summary);
  const Specimen specimen = make_specimen(communicator, deck, *labels, summary);
  labels.reset();

  const DeckParameters& p = deck.parameters;
  mechanics::MovingBody body(communicator, specimen.partition, specimen.particles,
                             problem_of(deck, specimen));
  folder.remove_old_results(log);
  base::collectively(communicator, [&] { log.open_file(folder.log()); });
  describe(communicator, deck, specimen, body.balance(), log);
  Results results(communicator, deck, specimen, folder, log);

  const base::StopRequests stop;
  const auto end_if_asked = [&] {
    const std::string signal = stop.asked(communicator);
    if (signal.empty()) return;
    const std::string text = "stopped by " + signal + "; " + results.on_disk();
    log.line(text);
    throw base::Interrupted(text);
  };
  solver::NewtonSolver newton(
      p.solver, body.balance(), [&](int iteration, double residual, long long linear) {
        end_if_asked();
        log.line(format("    Newton %2d   residual %.2e   %6lld linear iterations   %8.1f s",
                        iteration, residual, linear, seconds()));
      });
  solver::StepControl load(p.loading);
  StepNotes notes(log);
  results.write({}, body.balance(), body.displacement());

  while (!load.finished()) {
    const double next = load.next();
    try {
      begin_step(body, newton, load.load(), log);
    } catch (const base::RunError&) {
      results.finish(body.balance(), body.displacement(), seconds);
      throw;
    }
    grid::Vector trial(body.balance().owned_map());
    solver::NewtonResult solved;
    try {
      solved = solver::solve_step(body, newton, next, trial);
    } catch (const base::StepRejected& rejected) {
      log.line(format("step to load %.6g rejected: %s", next, rejected.what()));
      const double from = load.load();
      body.reject();
      if (!load.reject()) {
        results.finish(body.balance(), body.displacement(), seconds);
        throw base::RunError(
            failure(deck, body.balance(), trial, from, next, rejected.what(), folder.folder()));
      }
      continue;
    } catch (const base::RunError&) {
      results.finish(body.balance(), body.displacement(), seconds);
      throw;
    }

    // The step has converged: only now does anything change.
    body.accept(next, trial);
    load.accept();

    output::HistoryRow row;
    row.step = load.accepted();
    row.load = load.load();
    row.newton_iterations = solved.iterations;
    row.linear_iterations = solved.linear_iterations;
    row.residual = solved.residual;
    row.wall_seconds = seconds();
    results.write(row, body.balance(), trial);
    log.line(
        format("step %3d   load %.4f   Newton %d   linear %lld   residual %.1e   %.1f s, about "
               "%.0f s left",
               load.accepted(), load.load(), solved.iterations, solved.linear_iterations,
               solved.residual, seconds(), seconds() * (1.0 - load.load()) / load.load()));
    notes.look_at(solved);
    log.require_written();
    if (!load.finished()) end_if_asked();
  }
  if (!p.grid.reset && mechanics::count_barely_filled(body.balance()) > 0)
    log.note(format("Grid|Stabilization adds %.1e to the stiffness of the body, to first order",
                    mechanics::stabilization_share(body.balance(), body.displacement())));
  results.finish(body.balance(), body.displacement(), seconds);
}

}  // namespace stroma
