#include "Simulation.hpp"

#include <mpi.h>

#include <optional>
#include <utility>

#include "Results.hpp"
#include "Specimen.hpp"
#include "base/Error.hpp"
#include "base/Session.hpp"
#include "base/Signals.hpp"
#include "solver/LoadStep.hpp"
#include "solver/StepControl.hpp"

namespace stroma {
namespace {

using base::format;

void describe(const base::Communicator& communicator, const Specimen& specimen,
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
  for (const auto& hold : balance.supports().rigid_holds())
    log.note(
        format("the boundary conditions leave a rigid motion free; u_%c is held at the node at "
               "(%g, %g, %g) um, which has no effect on the stress",
               "xyz"[hold.component], hold.position[0], hold.position[1], hold.position[2]));
}

std::string failure(const Deck& deck, const mechanics::WorstParticle& worst, double load,
                    double next, const std::string& reason, const std::string& folder) {
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
         "the steps up to there are in " + folder +
         "; to go on: a smaller load, a smaller Loading|Smallest Step, or a finer grid there";
}

}  // namespace

void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const std::string& output_folder, base::Log& log) {
  const double start = MPI_Wtime();
  const auto seconds = [&] { return MPI_Wtime() - start; };

  const output::RunFolder folder(communicator, output_folder,
                                 output::run_files(deck.parameters.output.pictures));
  folder.refuse_foreign_files(input_files(deck));

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
  describe(communicator, specimen, body.balance(), log);
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
  results.write({}, body.balance(), body.displacement());

  while (!load.finished()) {
    const double next = load.next();
    try {
      solver::begin_step(body, newton);
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
        throw base::RunError(failure(deck, body.balance().worst_particle(trial), from, next,
                                     rejected.what(), folder.folder()));
      }
      continue;
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
    log.require_written();
    if (!load.finished()) end_if_asked();
  }
  results.finish(body.balance(), body.displacement(), seconds);
}

}  // namespace stroma
