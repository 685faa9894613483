// SPDX-License-Identifier: BSD-3-Clause

#include "run/Simulation.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "run/Checkpoints.hpp"
#include "run/Results.hpp"
#include "run/RunLog.hpp"
#include "run/Specimen.hpp"
#include "run/StopRequest.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/solver/LoadStep.hpp"
#include "stroma/solver/StepControl.hpp"
#include "stroma/solver/TrialSolve.hpp"

namespace stroma {
namespace {

/// A step failed at the smallest size: the run ends, with all that was accepted.
class StepFailed : public base::RunError {
 public:
  using base::RunError::RunError;
};

/// Solves the step to load.next(), or halves it.
/// \return nothing when it was halved
/// \throws StepFailed when Loading|Smallest Step forbids it, or the step cannot be begun
std::optional<solver::NewtonResult> try_step(mechanics::MovingBody& body,
                                             solver::NewtonSolver& newton,
                                             solver::StepControl& load,
                                             std::optional<grid::Vector>& trial, const Deck& deck,
                                             const std::string& folder, RunLog& say) {
  try {
    const mechanics::PiecesSummary before = body.balance().supports().pieces();
    solver::begin_step(body, newton);
    say.compare_pieces(before, body.balance().supports(), load.load());
    trial.emplace(body.balance().owned_map());
    return solver::solve_step(body, newton, load.next(), *trial);
  } catch (const base::StepRejected& rejected) {
    say.rejected(load.next(), rejected.what());
    body.reject();
    if (load.reject()) return std::nullopt;
    throw StepFailed(failure(deck, body.balance(), *trial, load, rejected.what(), folder));
  } catch (const base::Interrupted&) {
    throw;
  } catch (const base::RunError& error) {
    throw StepFailed(error.what());
  }
}

/// The command by which a run goes on from its checkpoint, or begins anew if it has none.
std::string how_to_go_on(const base::Communicator& communicator, const Deck& deck,
                         const std::string& folder, bool has_checkpoint) {
  const std::string ranks =
      communicator.size() == 1 ? "" : base::format("mpirun -np %d ", communicator.size());
  std::string command = ranks + "stroma run " + deck.document.path() + " -o " + folder;
  for (const std::string& one : deck.overrides) command += " --set '" + one + "'";
  return has_checkpoint ? "to go on: " + command + " --restart"
                        : "there is no checkpoint yet; to begin anew: " + command;
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
                    const RunOptions& options, base::Log& log) {
  RunLog say(communicator, deck, log);
  StopRequest stop(communicator, options.time_limit);
  const output::RunFolder folder(communicator, options.folder,
                                 output::run_files(deck.parameters.output.pictures));
  std::optional<Checkpoint> before;
  if (options.is_restart) before.emplace(communicator, folder.checkpoint(), deck);
  folder.refuse_foreign_files(input_files(deck), options.is_restart);
  solver::try_lists(communicator, deck.parameters.solver);

  // Image stack -> labels -> particles on a grid.
  std::optional<SpecimenImage> image = read_image(communicator, deck);
  const Specimen specimen = make_specimen(communicator, deck, *image);
  image.reset();
  const std::vector<KnownFile> files = known_files(communicator, specimen.files);
  if (before) before->require_images(files);

  const std::unique_ptr<mechanics::MovingBody> body =
      before
          ? before->body(specimen, problem_of(deck, specimen))
          : std::make_unique<mechanics::MovingBody>(communicator, specimen.partition,
                                                    specimen.particles, problem_of(deck, specimen));
  before ? folder.continue_results(log) : folder.remove_old_results(log);
  base::collectively(communicator, [&] { log.open_file(folder.log(), options.is_restart); });
  if (before) say.go_on(before->state().results.rows.back());
  say.describe(specimen, body->balance());

  RunState state = before ? before->state() : RunState();
  Results results(communicator, deck, specimen, files, folder, log, state.results);
  Checkpoints checkpoints(communicator, folder.checkpoint(), deck, files,
                          before ? state.load.accepted : -1);
  solver::NewtonSolver newton(deck.parameters.solver, body->balance(),
                              [&](int iteration, double residual, long long linear) {
                                stop.obey(false);
                                say.newton(iteration, residual, linear);
                              });
  newton.remember(state.newton);
  solver::StepControl load(deck.parameters.loading, state.load);
  before.reset();

  const auto now = [&]() -> RunState { return {load.progress(), state.newton, results.so_far()}; };
  const auto conclude = [&] {
    results.write_last(body->balance(), body->displacement());
    checkpoints.write(*body, now());
    results.finish(body->balance(), body->displacement(), [&] { return say.seconds(); });
  };
  const auto end_of = [&] {
    if (!std::filesystem::is_directory(folder.folder()))
      return "the folder " + folder.folder() + " is not there any more, nor what was in it";
    return results.on_disk() + checkpoints.on_disk() + "\n" +
           how_to_go_on(communicator, deck, folder.folder(), !checkpoints.on_disk().empty());
  };

  try {
    if (options.is_restart) {
      if (results.adopt(body->balance())) {
        checkpoints.write_anew(*body, now());  // before those go of which the last one tells
        results.remove_adopted();
      }
      results.write_missing(body->balance(), body->displacement());
    } else {
      results.write({}, body->balance(), body->displacement());
    }
    while (!load.finished()) {
      const double begin = say.seconds();
      state.newton = newton.memory();  // what an interrupted try learns counts for nothing
      std::optional<grid::Vector> trial;
      const auto solved = try_step(*body, newton, load, trial, deck, folder.folder(), say);
      if (!solved) continue;

      // The step has converged: only now does anything change.
      body->accept(load.next(), *trial);
      load.accept();
      state.newton = newton.memory();
      results.write(
          row_of(load, load.load() * deck.parameters.loading.seconds(), *solved, say.seconds()),
          body->balance(), *trial);
      say.accepted(load, *solved);
      log.require_written();
      if (load.finished()) break;
      // A run that goes on from here has no preconditioner of earlier steps: neither has this one.
      if (checkpoints.is_due(load.accepted())) {
        checkpoints.write(*body, now());
        newton.attach(body->balance());
      }
      stop.learn(say.seconds() - begin, checkpoints.seconds());
      stop.obey(true);
    }
    say.stabilization(*body);
    conclude();
  } catch (const base::Interrupted& asked) {
    checkpoints.write(*body, now());
    const std::string text = std::string("stopped by ") + asked.what() + "; " + end_of();
    log.line(text);
    throw base::Interrupted(text);
  } catch (const StepFailed& failed) {
    conclude();
    throw;
  } catch (
      const base::RunError& error) {  // a file could not be written: is there room for this one?
    try {
      checkpoints.write(*body, now());
    } catch (const base::RunError&) {
    }
    throw base::RunError(std::string(error.what()) + "\n" + end_of());
  } catch (const base::InputError&) {
    throw;
  } catch (const std::exception& error) {  // perhaps of this rank alone, for want of memory
    throw std::runtime_error(
        (base::is_out_of_memory(error) ? base::out_of_memory : std::string(error.what())) + "\n" +
        end_of());
  }
}

}  // namespace stroma
