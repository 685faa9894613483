// SPDX-License-Identifier: BSD-3-Clause

#include "run/Simulation.hpp"

#include <optional>

#include "run/Results.hpp"
#include "run/RunLog.hpp"
#include "run/Specimen.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Signals.hpp"
#include "stroma/solver/LoadStep.hpp"
#include "stroma/solver/StepControl.hpp"
#include "stroma/solver/TrialSolve.hpp"

namespace stroma {
namespace {

/// Ends the run where a signal asks for it, and says what is on disk.
class StopRequest {
 public:
  StopRequest(const base::Communicator& communicator, const Results& results, base::Log& log)
      : communicator_(communicator), results_(results), log_(log) {}

  /// \throws base::Interrupted
  void obey() const {
    const std::string signal = signals_.asked(communicator_);
    if (signal.empty()) return;
    const std::string text = "stopped by " + signal + "; " + results_.on_disk();
    log_.line(text);
    throw base::Interrupted(text);
  }

 private:
  base::StopRequests signals_;
  base::Communicator communicator_;
  const Results& results_;
  base::Log& log_;
};

/// Solves the step to load.next(), or halves it.
/// \return nothing when it was halved
/// \throws base::RunError when Loading|Smallest Step forbids it
std::optional<solver::NewtonResult> try_step(mechanics::MovingBody& body,
                                             solver::NewtonSolver& newton,
                                             solver::StepControl& load, grid::Vector& trial,
                                             const Deck& deck, const std::string& folder,
                                             RunLog& say) {
  try {
    return solver::solve_step(body, newton, load.next(), trial);
  } catch (const base::StepRejected& rejected) {
    say.rejected(load.next(), rejected.what());
    body.reject();
    if (load.reject()) return std::nullopt;
    throw base::RunError(failure(deck, body.balance(), trial, load, rejected.what(), folder));
  }
}

output::HistoryRow row_of(const solver::StepControl& load, double time,
                          const solver::NewtonResult& solved, double seconds) {
  output::HistoryRow row;
  row.step = load.accepted();
  row.load = load.load();
  row.time = time;
  row.newton_iterations = solved.iterations;
  row.linear_iterations = solved.linear_iterations;
  row.residual = solved.residual;
  row.wall_seconds = seconds;
  return row;
}

}  // namespace

void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const std::string& output_folder, base::Log& log) {
  RunLog say(communicator, deck, log);
  const output::RunFolder folder(communicator, output_folder,
                                 output::run_files(deck.parameters.output.pictures));
  folder.refuse_foreign_files(input_files(deck));
  solver::try_lists(communicator, deck.parameters.solver);

  // Image stack -> labels -> particles on a grid.
  std::optional<SpecimenImage> image = read_image(communicator, deck);
  const Specimen specimen = make_specimen(communicator, deck, *image);
  image.reset();

  mechanics::MovingBody body(communicator, specimen.partition, specimen.particles,
                             problem_of(deck, specimen));
  folder.remove_old_results(log);
  base::collectively(communicator, [&] { log.open_file(folder.log()); });
  say.describe(specimen, body.balance());
  Results results(communicator, deck, specimen, folder, log);
  const auto finish = [&] {
    results.finish(body.balance(), body.displacement(), [&] { return say.seconds(); });
  };

  const StopRequest stop(communicator, results, log);
  solver::NewtonSolver newton(deck.parameters.solver, body.balance(),
                              [&](int iteration, double residual, long long linear) {
                                stop.obey();
                                say.newton(iteration, residual, linear);
                              });
  solver::StepControl load(deck.parameters.loading);
  results.write({}, body.balance(), body.displacement());

  while (!load.finished()) {
    std::optional<grid::Vector> trial;
    std::optional<solver::NewtonResult> solved;
    try {
      const mechanics::PiecesSummary before = body.balance().supports().pieces();
      solver::begin_step(body, newton);
      say.compare_pieces(before, body.balance().supports(), load.load());
      trial.emplace(body.balance().owned_map());
      solved = try_step(body, newton, load, *trial, deck, folder.folder(), say);
    } catch (const base::Interrupted&) {
      throw;  // at once: who sent the signal gives seconds, and what is on disk has been told
    } catch (const base::RunError&) {
      finish();
      throw;
    }
    if (!solved) continue;

    // The step has converged: only now does anything change.
    body.accept(load.next(), *trial);
    load.accept();
    results.write(
        row_of(load, load.load() * deck.parameters.loading.seconds(), *solved, say.seconds()),
        body.balance(), *trial);
    say.accepted(load, *solved);
    log.require_written();
    if (!load.finished()) stop.obey();
  }
  say.stabilization(body);
  finish();
}

}  // namespace stroma
