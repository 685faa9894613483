// SPDX-License-Identifier: BSD-3-Clause

#include "commands/VerifyCommand.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "run/Checkpoint.hpp"
#include "run/HistoryFigures.hpp"
#include "run/MovingSupports.hpp"
#include "stiffness/StiffnessRun.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/HistoryTable.hpp"
#include "stroma/output/files/Manifest.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/files/StateFile.hpp"
#include "stroma/output/files/StepSeries.hpp"
#include "stroma/solver/LoadStep.hpp"

namespace stroma {
namespace {

using base::format;

/// What sums of forces over other ranks, and a residual at the tolerance, leave between two answers.
constexpr double rounding = 1e-9;

/// A line for each thing that was looked at; what is wrong is counted.
class Findings {
 public:
  explicit Findings(base::Log& log) : log_(log) {}

  void tell(const std::string& what, bool is_good, const std::string& found) {
    log_.line(format("%-12s %-5s %s", what.c_str(), is_good ? "good" : "WRONG", found.c_str()));
    if (!is_good) ++wrong_;
  }
  int wrong() const { return wrong_; }

 private:
  base::Log& log_;
  int wrong_ = 0;
};

/// Whether the files that the run left are there with the contents that it left.
/// \return whether all of them could be compared
bool verify_contents(const base::Communicator& communicator, const std::string& folder,
                     Findings& findings) {
  std::vector<std::string> departures;
  std::size_t files = 0, known = 0, sampled = 0;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    const output::Manifest manifest(folder);
    for (const std::string& file : manifest.finished()) {
      ++files;
      if (manifest.has_ended() && manifest.has_whole_checksum(file)) ++known;
      if (manifest.is_sampled(file)) ++sampled;
      const std::string departure = manifest.departure(file);
      if (!departure.empty()) departures.push_back(file + " " + departure);
    }
  });
  communicator.broadcast(files);
  communicator.broadcast(known);
  communicator.broadcast(sampled);
  std::size_t wrong = departures.size();
  communicator.broadcast(wrong);
  departures.resize(wrong);
  for (std::string& departure : departures) {
    communicator.broadcast(departure);
    findings.tell("contents", false, departure);
  }
  if (known == 0)
    findings.tell("contents", true,
                  "not compared: the folder has no checksums of a run that ended");
  else if (known < files)
    findings.tell("contents", true,
                  format("of %zu of %zu files only the size, the head and the end are compared",
                         files - known, files));
  else if (wrong == 0)
    findings.tell(
        "contents", true,
        format("%zu files, SHA-256 as the run left them", files) +
            (sampled == 0 ? std::string()
                          : format(" (of %zu larger than 16 MiB: 256 samples)", sampled)));
  return known > 0 && known == files;
}

/// Whether history.csv holds the rows of the checkpoint, to the last digit. For one rank.
std::string departure_of_history(const std::string& path, const Deck& deck,
                                 const std::vector<output::HistoryRow>& rows) {
  try {
    const output::HistoryTable table(path);
    if (table.rows() != rows.size())
      return format("%zu rows instead of %zu", table.rows(), rows.size());
    const auto columns = output::history_columns(history_names(deck.parameters));
    if (table.names() != columns) return "other columns than the deck's";
    for (std::size_t s = 0; s < rows.size(); ++s) {
      const std::vector<double> values = output::history_values(rows[s]);
      for (std::size_t c = 0; c < columns.size(); ++c)
        if (table.column(columns[c])[s] != values[c])
          return format("%s of step %zu is %.17g instead of %.17g", columns[c].c_str(), s,
                        table.column(columns[c])[s], values[c]);
    }
    return "";
  } catch (const base::RunError& error) {
    return error.what();
  }
}

/// Whether a set of Exodus files ends where the checkpoint says. For one rank.
std::string departure_of_files(const std::string& path, const std::vector<output::FileEnd>& ends) {
  for (std::size_t r = 0; r < ends.size(); ++r) {
    const std::string file =
        output::spread_file_name(path, static_cast<int>(ends.size()), static_cast<int>(r));
    try {
      const output::FileEnd found = output::end_of(file);
      if (found.steps != ends[r].steps || found.bytes != ends[r].bytes)
        return format("%s has %lld steps in %lld bytes instead of %lld in %lld",
                      std::filesystem::path(file).filename().c_str(),
                      static_cast<long long>(found.steps), static_cast<long long>(found.bytes),
                      static_cast<long long>(ends[r].steps), static_cast<long long>(ends[r].bytes));
    } catch (const base::RunError& error) {
      return error.what();
    }
  }
  return "";
}

/// Whether the files of a list are those of steps of the history, in its order, up to the last. For
/// one rank.
std::string departure_of_series(const output::RunFiles& files, const std::string& list,
                                const std::vector<output::HistoryRow>& rows, std::int64_t last) {
  try {
    std::int64_t step = -1;
    for (const auto& [name, time] : output::StepSeries::listed(files.file(list))) {
      const output::StateReader file(files.file(name));
      const auto number = [&](const char* column) {
        return file.value<double>(std::string("VTKHDF/FieldData/") + column);
      };
      const auto before = std::exchange(step, static_cast<std::int64_t>(number("step")));
      if (step <= before || step >= static_cast<std::int64_t>(rows.size()))
        return format("%s has step %lld", name.c_str(), static_cast<long long>(step));
      const output::HistoryRow& row = rows[static_cast<std::size_t>(step)];
      if (time != row.time || number("time") != row.time || number("load") != row.load ||
          number("strain_energy") != row.strain_energy)
        return name + " has another time, load or energy than history.csv";
    }
    return step == last ? "" : format("up to step %lld", static_cast<long long>(step));
  } catch (const base::RunError& error) {
    return error.what();
  } catch (const base::InputError& error) {
    return error.what();
  }
}

void verify_files(const base::Communicator& communicator, const output::RunFiles& files,
                  const Deck& deck, const ResultsSoFar& results, Findings& findings) {
  const auto tell = [&](const std::string& what, std::string departure, const std::string& found) {
    communicator.broadcast(departure);
    findings.tell(what, departure.empty(), departure.empty() ? found : departure);
  };
  const FieldFilesEnd& ends = results.files;
  const auto up_to = [](std::int64_t step) {
    return format("up to step %lld", static_cast<long long>(step));
  };
  tell("history.csv",
       communicator.is_root() ? departure_of_history(files.history(), deck, results.rows) : "",
       format("%zu rows, those of the checkpoint", results.rows.size()));
  if (ends.particles_step >= 0)
    tell("particles.e",
         communicator.is_root() ? departure_of_files(files.particles(), ends.particles) : "",
         up_to(ends.particles_step));
  if (ends.grid_step >= 0)
    tell("grid.e",
         communicator.is_root()
             ? departure_of_files(files.grid(static_cast<int>(ends.grid_files)), ends.grid)
             : "",
         up_to(ends.grid_step));
  for (const auto& [list, last] :
       {std::pair<std::string, std::int64_t>{"particles.hdf.series", ends.particles_step},
        {"grid.hdf.series", ends.grid_step}})
    if (deck.parameters.output.vtkhdf && last >= 0)
      tell(list, communicator.is_root() ? departure_of_series(files, list, results.rows, last) : "",
           up_to(last));
}

/// How far reactions are from those written, and the largest of these [pN].
struct Departure {
  double difference = 0.0, largest = 0.0;
};
Departure departure_of_reactions(const std::vector<std::array<double, 3>>& reactions,
                                 const output::HistoryRow& row) {
  Departure found;
  for (std::size_t c = 0; c < reactions.size(); ++c)
    for (std::size_t d = 0; d < 3; ++d) {
      found.difference =
          std::max(found.difference, std::fabs(reactions[c][d] - row.reactions[c][d]));
      found.largest = std::max(found.largest, std::fabs(row.reactions[c][d]));
    }
  return found;
}

/// \param force  size of the forces [pN]
void verify_torques(mechanics::MomentumBalance& balance, const grid::Vector& u,
                    const std::vector<double>& written, double force, Findings& findings) {
  if (written.empty()) return;
  const std::array<double, 3> length = balance.problem().body.lengths();
  double largest = force * *std::max_element(length.begin(), length.end()), difference = 0.0;
  const std::vector<double> torques = balance.torques(u);
  for (std::size_t n = 0; n < torques.size(); ++n) {
    difference = std::max(difference, std::fabs(torques[n] - written[n]));
    largest = std::max(largest, std::fabs(written[n]));
  }
  findings.tell(
      "torques", difference <= rounding * largest,
      format("differ by %.1e of the largest", largest > 0.0 ? difference / largest : 0.0));
}

/// Where the supports' springs pull on (mechanics::Springs), the file does not say how far they aim:
/// the step is solved anew from its own end, and has to stay there. Reactions of faces by themselves
/// do so, too; of an edge at which two meet, springs do not say which face bears how much.
void verify_pulled(const Deck& deck, mechanics::MovingBody& body, const RunState& state,
                   Findings& findings) {
  constexpr double stays = 0.05;  // of the displacement
  mechanics::MomentumBalance& balance = body.balance();
  if (balance.inertia() != nullptr) {
    findings.tell("equilibrium", true, "not looked at: springs that pull on, with inertia");
    return;
  }
  const output::HistoryRow& row = state.results.rows.back();
  solver::NewtonSolver newton(deck.parameters.solver, balance);
  newton.remember(state.newton);
  grid::Vector anew(balance.owned_map());
  try {
    solver::solve_step(body, newton, state.load.load, anew);
  } catch (const base::StepRejected& rejected) {
    findings.tell("equilibrium", false, rejected.what());
    return;
  }
  const Departure reactions = departure_of_reactions(balance.reactions(anew), row);
  const double largest = std::max(state.newton.largest_force, reactions.largest);
  anew.update(-1.0, body.displacement(), 1.0);
  const double moved = anew.normInf(), farthest = std::max(body.displacement().normInf(), moved);
  findings.tell(
      "equilibrium", moved <= stays * farthest,
      format("springs that pull on: solved anew, it moves by %.1e of the displacement, and "
             "reactions change by %.1e of the largest force",
             farthest > 0.0 ? moved / farthest : 0.0,
             largest > 0.0 ? reactions.difference / largest : 0.0));
}

/// Whether what supports and loads do to the body is in balance, as it was when it was solved.
void verify_forces(const Deck& deck, mechanics::MomentumBalance& balance, const grid::Vector& u,
                   const RunState& state, Findings& findings) {
  const output::HistoryRow& row = state.results.rows.back();
  grid::Vector residual(balance.owned_map());
  const std::int64_t inverted = balance.residual(u, residual);
  const double force = std::max(state.newton.largest_force, balance.forces(u).scale);
  const double relative = force > 0.0 ? residual.norm2() / force : 0.0;
  const double allowed = std::max({deck.parameters.solver.newton_tolerance, 2.0 * row.residual,
                                   force > 0.0 ? balance.forces(u).rounding / force : 0.0});
  const auto& dynamics = balance.problem().dynamics;
  if (dynamics && dynamics->scheme.alpha_f > 0.0)
    findings.tell("equilibrium", inverted == 0,
                  "within the step, by Generalised Alpha, not at its end");
  else
    findings.tell(
        "equilibrium", inverted == 0 && relative <= allowed,
        format("residual %.2e of the forces, %.2e when it was solved", relative, row.residual));

  const Departure reactions = departure_of_reactions(balance.reactions(u), row);
  findings.tell("reactions", reactions.difference <= rounding * std::max(reactions.largest, force),
                format("differ by %.1e of the largest",
                       reactions.largest > 0.0 ? reactions.difference / reactions.largest : 0.0));

  verify_torques(balance, u, row.torques, force, findings);
}

void verify_balance(const base::Communicator& communicator, const Deck& deck,
                    mechanics::MovingBody& body, const RunState& state, Findings& findings) {
  mechanics::MomentumBalance& balance = body.balance();
  const output::HistoryRow& row = state.results.rows.back();
  const grid::Vector& u = body.displacement();
  if (balance.has_springs_that_pull_on())
    verify_pulled(deck, body, state, findings);
  else
    verify_forces(deck, balance, u, state, findings);
  const output::HistoryRow anew = with_figures(row, communicator, balance.body(), u);
  const double energy = std::fabs(anew.strain_energy - row.strain_energy);
  findings.tell("energy", energy <= rounding * std::fabs(row.strain_energy),
                format("%.9g aJ, differs by %.1e of it", anew.strain_energy,
                       row.strain_energy != 0.0 ? energy / std::fabs(row.strain_energy) : 0.0));
}

}  // namespace

void verify_command(const base::Communicator& communicator, const std::string& folder,
                    base::Log& log) {
  const output::RunFiles files(folder);
  std::optional<Deck> deck;
  base::collectively(communicator, [&] {
    if (!std::filesystem::is_regular_file(files.deck()))
      throw base::InputError("'" + folder + "' is no folder of results: it has no deck.xml");
    refuse_stiffness_folder(folder, "verify");
    deck = read_deck(files.deck(), {});
  });
  Findings findings(log);
  const bool are_compared = verify_contents(communicator, folder, findings);
  const Checkpoint checkpoint(communicator, files.checkpoint(), *deck);
  const RunState& state = checkpoint.state();
  log.line(format("%s: step %d, load %.6g", folder.c_str(), state.load.accepted, state.load.load));

  std::optional<SpecimenImage> image = read_image(communicator, *deck);
  const Specimen specimen = make_specimen(communicator, *deck, *image);
  image.reset();
  const std::vector<KnownFile> images = known_files(communicator, specimen.files);
  const bool are_the_same = checkpoint.has_images(images);
  findings.tell("images", are_the_same,
                format("%zu file%s, SHA-256 %s", images.size(), images.size() == 1 ? "" : "s",
                       are_the_same ? "as in the run" : "not as in the run"));
  verify_files(communicator, files, *deck, state.results, findings);
  if (are_the_same) {
    const auto body = checkpoint.body(specimen, problem_of(*deck, specimen));
    verify_balance(communicator, *deck, *body, state, findings);
  }
  if (findings.wrong() > 0)
    throw base::RunError(format("%d of what was looked at in '%s' %s not as the run left it",
                                findings.wrong(), folder.c_str(),
                                findings.wrong() == 1 ? "is" : "are"));
  log.line(are_compared ? "all is as the run left it"
                        : "all that could be compared is as the run left it");
}

}  // namespace stroma
