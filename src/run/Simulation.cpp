// SPDX-License-Identifier: BSD-3-Clause

#include "run/Simulation.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "run/Checkpoints.hpp"
#include "run/MemoryEstimate.hpp"
#include "run/ReportFile.hpp"
#include "run/Results.hpp"
#include "run/RunLog.hpp"
#include "run/RunReport.hpp"
#include "run/Specimen.hpp"
#include "run/StopRequest.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/solver/LoadStep.hpp"
#include "stroma/solver/Stabilization.hpp"
#include "stroma/solver/StepControl.hpp"
#include "stroma/solver/TrialSolve.hpp"

namespace stroma {
namespace {

/// A step failed at the smallest size: the run ends, with all that was accepted.
class StepFailed : public base::RunError {
 public:
  using base::RunError::RunError;
};

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

/// A run whose body is there. Member functions are collective.
struct Run {
  const base::Communicator& communicator;
  const Deck& deck;
  const std::string folder;
  base::Log& log;
  RunLog& say;
  StopRequest& stop;
  mechanics::MovingBody& body;
  std::optional<solver::NewtonSolver>& newton;  // until nothing is left to solve
  solver::StepControl& load;
  Results& results;
  Checkpoints& checkpoints;
  const std::function<void(const AcceptedStep&)>& accepted;
  solver::NewtonMemory learnt =
      {};  ///< in whole tries: what an interrupted one learns does not count
  /// More than this would show in the forces; unknown where the deck or a checkpoint has set it.
  std::optional<double> bearable_stabilization = {};

  void begin(bool is_restart);
  void choose_stabilization();
  void stabilize(double stabilization);
  bool stabilize_more();
  void take_steps();
  void conclude();
  void stop_early();
  void write_tables();
  std::optional<solver::NewtonResult> try_step(std::optional<grid::Vector>& trial);
  RunState state() const { return {load.progress(), learnt, results.so_far()}; }
  std::string how_it_stands() const;
};

void Run::begin(bool is_restart) {
  if (load.accepted() == 0) choose_stabilization();
  if (!is_restart) {
    results.write({}, body.balance(), body.displacement());
    return;
  }
  if (results.adopt(body.balance())) {
    checkpoints.write_anew(body, state());  // before those go of which the last one tells
    results.remove_adopted();
  }
  results.write_missing(body.balance(), body.displacement());
}

/// Where the deck leaves it open, as far as one base configuration can tell.
void Run::choose_stabilization() {
  const DeckParameters& p = deck.parameters;
  if (p.grid.stabilization || p.grid.reset || p.loading.inertia) return;
  const auto choice = solver::bearable_stabilization(p.solver, body.balance(), load.next());
  if (!choice) return;
  bearable_stabilization = choice->bearable;
  const double now = body.balance().problem().method.stabilization;
  if (choice->bearable >= now) return;
  log.note(base::format("Grid|Stabilization = %g would add %.1e to the stiffness of the body", now,
                        choice->added));
  stabilize(choice->bearable);
}

void Run::stabilize(double stabilization) {
  log.note(base::format("Grid|Stabilization is %g now", stabilization));
  body.stabilize(stabilization);
  newton->attach(body.balance());
}

/// For a body whose first step failed. \return whether that is worth another try
bool Run::stabilize_more() {
  const bool may_be_more = load.accepted() == 0 && bearable_stabilization &&
                           *bearable_stabilization > body.balance().problem().method.stabilization;
  if (may_be_more) stabilize(*bearable_stabilization);
  return may_be_more;
}

void Run::take_steps() {
  while (!load.finished()) {
    const double begin = say.seconds();
    learnt = newton->memory();
    std::optional<grid::Vector> trial;
    const std::optional<solver::NewtonResult> solved = try_step(trial);
    if (!solved) continue;

    // The step has converged: only now does anything change.
    body.accept(load.next(), *trial);
    load.accept(solved->time_error);
    learnt = newton->memory();
    const double time = load.load() * deck.parameters.loading.seconds();
    const output::HistoryRow row = row_of(load, time, *solved, say.seconds());
    results.write(row, body.balance(), *trial);
    if (accepted) accepted({row, body.balance(), *trial, *newton});
    say.accepted(load, *solved);
    say.localization(body, results.last_row());
    say.rest(results.last_row(), load.finished());
    log.require_written();
    if (load.finished()) break;
    if (checkpoints.is_due(load.accepted())) {
      checkpoints.write(body, state());
      newton->attach(
          body.balance());  // a run that goes on from here has no preconditioner of before
    }
    stop.learn(say.seconds() - begin, checkpoints.seconds());
    stop.obey(true);
  }
  say.stabilization(body);
}

/// Solves the step to load.next(), or halves it, or stabilises the body more.
/// \return nothing when the step is to be tried anew
/// \throws StepFailed when Loading|Smallest Step forbids it, or the step cannot be begun
std::optional<solver::NewtonResult> Run::try_step(std::optional<grid::Vector>& trial) {
  say.begin_step(load);
  try {
    const mechanics::PiecesSummary before = body.balance().supports().pieces();
    solver::begin_step(body, *newton);
    say.compare_pieces(before, body.balance().supports(), load.load());
    say.filling(body.balance(), load.load());
    trial.emplace(body.balance().owned_map());
    const solver::NewtonResult solved = solver::solve_step(body, *newton, load.next(), *trial);
    if (load.is_too_long(solved.time_error))
      throw base::StepRejected(base::format(
          "its error in time is %.3g um, above Loading|Step Error [um]", solved.time_error));
    return solved;
  } catch (const base::StepRejected& rejected) {
    say.rejected(load.next(), rejected.what());
    body.reject();
    if (stabilize_more() || load.reject()) return std::nullopt;
    throw StepFailed(failure(deck, body.balance(), *trial, load, rejected.what(), folder));
  } catch (const base::Interrupted&) {
    throw;
  } catch (const base::RunError& error) {
    throw StepFailed(error.what());
  }
}

void Run::conclude() {
  body.balance().set_load(load.load());  // a try that failed was of another one
  results.write_last(body.balance(), body.displacement());
  checkpoints.write(body, state());
  write_tables();
  results.finish(body.balance(), body.displacement(), [&] { return say.seconds(); });
}

/// For a run that was asked to stop: what it takes to go on comes first.
void Run::stop_early() {
  checkpoints.write(body, state());
  try {
    body.balance().set_load(load.load());
    write_tables();
    results.finish_files();
  } catch (const base::RunError& error) {
    log.note(error.what());
  }
}

/// In the memory that the solver had: nothing can be solved any more.
void Run::write_tables() {
  newton.reset();
  body.balance().forget_tangent();
  const std::int64_t nodes =
      body.balance().halo().partition().touched_nodes(communicator.rank()).count();
  results.write_tables(body.balance(), body.displacement(),
                       room_for_tables(static_cast<double>(nodes)));
}

/// What is on disk, and the command by which the run goes on.
std::string Run::how_it_stands() const {
  if (!std::filesystem::is_directory(folder))
    return "the folder " + folder + " is not there any more, nor what was in it";
  std::string command =
      communicator.size() == 1 ? "" : base::format("mpirun -np %d ", communicator.size());
  command += "stroma run " + deck.document.path() + " -o " + folder;
  for (const std::string& one : deck.overrides) command += " --set '" + one + "'";
  return results.on_disk() + checkpoints.on_disk() + "\n" +
         (checkpoints.on_disk().empty() ? "there is no checkpoint yet; to begin anew: " + command
                                        : "to go on: " + command + " --restart");
}

/// From deck to results in the folder.
void simulate(const base::Communicator& communicator, const Deck& deck, const RunOptions& options,
              const output::RunFolder& folder, base::Log& log) {
  RunLog say(communicator, deck, log);
  StopRequest stop(communicator, options.time_limit);
  std::optional<Checkpoint> before;
  if (options.is_restart) before.emplace(communicator, folder.checkpoint(), deck);
  folder.refuse_foreign_files(input_files(deck), options.is_restart);
  solver::try_lists(communicator, deck.parameters.solver);

  // Image stack -> labels -> particles on a grid.
  std::optional<SpecimenImage> image = read_image(communicator, deck);
  const Specimen specimen = make_specimen(communicator, deck, *image);
  Tables tables(communicator, deck, specimen, image->labels);
  image.reset();
  // An image may be of several files: data beside a header, slices.
  folder.refuse_inputs(specimen.files, options.is_restart);
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

  const RunState at_start = before ? before->state() : RunState();
  Results results(communicator, deck, specimen, files, tables, folder, log, at_start.results);
  Checkpoints checkpoints(communicator, folder.checkpoint(), deck, files,
                          before ? at_start.load.accepted : -1);
  before.reset();
  std::optional<solver::NewtonSolver> newton;
  newton.emplace(deck.parameters.solver, body->balance(),
                 [&](int iteration, double residual, long long linear) {
                   stop.obey(false);
                   say.newton(iteration, residual, linear);
                 });
  newton->remember(at_start.newton);
  solver::StepControl load(deck.parameters.loading, at_start.load);
  Run run{communicator,
          deck,
          folder.folder(),
          log,
          say,
          stop,
          *body,
          newton,
          load,
          results,
          checkpoints,
          options.accepted,
          at_start.newton};
  try {
    run.begin(options.is_restart);
    run.take_steps();
    run.conclude();
  } catch (const base::Interrupted& asked) {
    run.stop_early();
    const std::string text = std::string("stopped by ") + asked.what() + "; " + run.how_it_stands();
    log.line(text);
    throw base::Interrupted(text);
  } catch (const StepFailed&) {
    run.conclude();
    throw;
  } catch (const base::RunError& error) {
    // A file could not be written: is there room for this one?
    try {
      checkpoints.write(*body, run.state());
    } catch (const base::RunError&) {
    }
    throw base::RunError(std::string(error.what()) + "\n" + run.how_it_stands());
  } catch (const base::InputError&) {
    throw;
  } catch (const std::exception& error) {  // perhaps of this rank alone, for want of memory
    throw std::runtime_error(
        (base::is_out_of_memory(error) ? base::out_of_memory : std::string(error.what())) + "\n" +
        run.how_it_stands());
  }
}

/// Makes report.html of what is in the folder, now that the body's memory is free.
void report(const base::Communicator& communicator, const Deck& deck,
            const output::RunFolder& folder, base::Log& log) {
  if (deck.parameters.output.report)
    report_at_end(log, [&] { run_report(communicator, folder.folder(), log); });
}

}  // namespace

void run_simulation(const base::Communicator& communicator, const Deck& deck,
                    const RunOptions& options, base::Log& log) {
  const output::RunFolder folder(communicator, options.folder, run_files(deck));
  try {
    simulate(communicator, deck, options, folder, log);
  } catch (const StepFailed&) {
    report(communicator, deck, folder, log);
    throw;
  }
  report(communicator, deck, folder, log);
  folder.finish("log.txt");
}

}  // namespace stroma
