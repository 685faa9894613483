// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The command `stroma`: reads its words, starts MPI and Kokkos, and answers every error in one
/// place.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "commands/CheckCommand.hpp"
#include "commands/ImageCommand.hpp"
#include "commands/PhantomCommand.hpp"
#include "commands/VerifyCommand.hpp"
#include "fit/FitCommand.hpp"
#include "fit/FitDeck.hpp"
#include "report/ReportCommand.hpp"
#include "run/Deck.hpp"
#include "run/Simulation.hpp"
#include "stiffness/StiffnessRun.hpp"
#include "stroma/base/Communicator.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Memory.hpp"
#include "stroma/base/Session.hpp"
#include "stroma/base/Signals.hpp"
#include "stroma/deck/Nearest.hpp"
#include "stroma/output/files/ExodusFile.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "study/StudyCommand.hpp"
#include "study/StudyDeck.hpp"

namespace {

using stroma::base::ExitStatus;

struct Options {
  std::string deck, output, section;
  std::vector<std::string> overrides;
  bool quiet = false, is_restart = false;
  std::string time_limit;
  stroma::ImageOptions image;
  stroma::PhantomOptions phantom;
};

/// The deck's name without its ending.
std::string default_folder(const std::string& deck) {
  return std::filesystem::path(deck).replace_extension().string();
}

void add_deck(CLI::App& command, Options& options) {
  command.add_option("DECK", options.deck, "the deck, .xml or .yaml")->required();
  command
      .add_option("--set", options.overrides, "'Section|Parameter=value', instead of the deck's")
      ->allow_extra_args(false);
}

/// "HH:MM" or "HH:MM:SS" in seconds; nothing of an empty text.
/// \throws stroma::base::InputError
std::optional<double> seconds_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  static const std::regex form("([0-9]{1,4}):([0-5][0-9])(:([0-5][0-9]))?");
  std::smatch parts;
  const bool is_time = std::regex_match(text, parts, form);
  const int seconds = !is_time ? 0
                               : 3600 * std::stoi(parts[1]) + 60 * std::stoi(parts[2]) +
                                     (parts[4].matched ? std::stoi(parts[4]) : 0);
  if (seconds == 0)
    throw stroma::base::InputError("--time-limit: \"" + text +
                                   "\"; admissible: HH:MM or HH:MM:SS, above 0");
  return seconds;
}

void add_image(CLI::App& command, stroma::ImageOptions& options) {
  command
      .add_option("FILE", options.file,
                  "TIFF, PIC, NRRD, MetaImage, NIfTI or HDF5, or a folder of Zarr")
      ->required();
  command.add_option("--dataset", options.dataset, "dataset of an HDF5 file");
  command.add_option("--channel", options.channel, "channel, from 0");
  command.add_option("--frame", options.frame, "frame of a time series, from 0");
  command
      .add_option_function<std::vector<double>>(
          "--voxel",
          [&options](const std::vector<double>& um) {
            options.voxel_size = {um[0], um[1], um[2]};
          },
          "size of a voxel x,y,z [um], where the file does not state it")
      ->delimiter(',')
      ->expected(3);
}

void add_phantom(CLI::App& command, stroma::PhantomOptions& options) {
  command.add_option("-o,--output", options.output, "TIFF file to write")->required();
  command.add_option("--size", options.size, "voxels x,y,z")->delimiter(',');
  command.add_option("--voxel", options.voxel_size, "size of a voxel x,y,z [um]")->delimiter(',');
  command.add_option("--fraction", options.fraction, "volume fraction of the vessels");
  command.add_option("--seed", options.seed, "another seed, another network");
}

/// What to say of the first word that is no command or no option; empty if all are known.
std::string unknown_word(const CLI::App& app, const std::vector<char*>& words) {
  if (words.size() < 2) return "";
  const CLI::App* command = nullptr;
  std::vector<std::string> commands;
  for (const CLI::App* one : app.get_subcommands({})) {
    commands.push_back(one->get_name());
    if (one->get_name() == words[1]) command = one;
  }
  if (command == nullptr) {
    const std::string word = words[1];
    if (word.front() == '-') return "";
    return "no such command: \"" + word + "\"; " + stroma::deck::suggestion(word, commands);
  }
  std::vector<std::string> options;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  for (std::size_t n = 2; n < words.size(); ++n) {
    const std::string word = std::string(words[n]).substr(0, std::string(words[n]).find('='));
    if (word.rfind("--", 0) == 0 && word != "--" &&
        std::find(options.begin(), options.end(), word) == options.end())
      return command->get_name() + " has no option " + word + "; " +
             stroma::deck::suggestion(word, options);
  }
  return "";
}

/// What a deck may say; after the word Study or Fit, the deck of one.
std::string reference_of(const std::string& section) {
  const auto behind = [&](const char* word) {
    return section.substr(std::min(section.size(), std::strlen(word) + 1));
  };
  if ((section + "|").rfind("Study|", 0) == 0)
    return stroma::deck::reference(stroma::study_section(), behind("Study"));
  if ((section + "|").rfind("Fit|", 0) == 0)
    return stroma::deck::reference(stroma::fit_section(), behind("Fit"));
  return stroma::deck::reference(stroma::deck_section(), section);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Stroma: stress in tissue, from the image stack, by the implicit Material Point Method",
      "stroma");
  Options options;
  app.require_subcommand(1);
  CLI::Option* version = app.set_version_flag("--version", [&app] {
    if (app.count("--verbose") == 0) return std::string("stroma " STROMA_VERSION);
    std::string facts = stroma::output::aligned(stroma::output::program_facts());
    facts.pop_back();  // CLI11 ends the line
    return facts;
  });
  app.add_flag("--verbose", "with --version: commit, compiler, options and libraries too")
      ->needs(version);

  CLI::App* run = app.add_subcommand("run", "run a deck");
  add_deck(*run, options);
  run->add_option("-o,--output", options.output,
                  "output folder; else the deck's name without ending");
  run->add_flag("--restart", options.is_restart,
                "go on from checkpoint.h5 in the output folder, on any number of ranks");
  run->add_option("--time-limit", options.time_limit,
                  "HH:MM or HH:MM:SS; end before it, with a checkpoint");
  run->add_flag("--quiet", options.quiet, "print errors only");
  CLI::App* check =
      app.add_subcommand("check", "read everything, run nothing, say what it would be");
  add_deck(*check, options);
  CLI::App* image = app.add_subcommand("image", "say what is in an image");
  add_image(*image, options.image);
  CLI::App* phantom = app.add_subcommand("phantom", "write a synthetic microvessel volume");
  add_phantom(*phantom, options.phantom);
  CLI::App* study = app.add_subcommand("study", "run decks that differ in named parameters");
  study->add_option("STUDY", options.deck, "the study deck, .xml or .yaml")->required();
  study->add_option("-o,--output", options.output,
                    "output folder; else the deck's name without ending");
  study->add_flag("--quiet", options.quiet, "print errors only");
  CLI::App* fit = app.add_subcommand("fit", "find numbers of a deck by measured forces");
  fit->add_option("FIT", options.deck, "the deck of the fit, .xml or .yaml")->required();
  fit->add_option("-o,--output", options.output,
                  "output folder; else the deck's name without ending");
  fit->add_flag("--quiet", options.quiet, "print errors only");
  CLI::App* verify =
      app.add_subcommand("verify", "check a folder of results against its deck and image");
  verify->add_option("DIR", options.output, "the folder that a run wrote")->required();
  CLI::App* report = app.add_subcommand(
      "report", "make report.html of a folder of results, of a run, a study or a fit");
  report->add_option("DIR", options.output, "the folder")->required();
  report->add_flag("--quiet", options.quiet, "print errors only");
  CLI::App* reference = app.add_subcommand("reference", "print what a deck may say");
  reference->add_option(
      "SECTION", options.section,
      "one section, such as 'Image|Segmentation'; or Study, Fit: the deck of one");

  // Kokkos gets its own words only: it would answer --help too. Every rank parses the rest alike.
  std::vector<char*> own_words(argv, argv + argc);
  const std::vector<std::string> kokkos_words = stroma::base::take_kokkos_words(own_words);
  const stroma::base::MpiSession mpi(&argc, &argv);
  stroma::base::let_writes_fail();
  const auto communicator = stroma::base::Communicator::world();
  const auto fail = [&](ExitStatus status, const std::string& message) {
    if (communicator.is_root()) std::cerr << "stroma: " << message << "\n";
    return static_cast<int>(status);
  };
  try {
    app.parse(static_cast<int>(own_words.size()), own_words.data());
  } catch (const CLI::Success& help) {
    if (communicator.is_root()) app.exit(help);
    return std::cout.flush() ? 0 : fail(ExitStatus::run_failed, "cannot write to standard output");
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknown_word(app, own_words);
    return fail(ExitStatus::wrong_input, (unknown.empty() ? error.what() : unknown) +
                                             "\nsee: stroma --help, or stroma COMMAND --help");
  }

  std::optional<stroma::base::KokkosSession> kokkos;
  try {
    kokkos.emplace(communicator, kokkos_words);
    stroma::base::Log log(communicator, options.quiet);
    if (*run || *check) {
      const std::optional<double> time_limit = seconds_of(options.time_limit);
      std::optional<stroma::Deck> deck;
      stroma::base::collectively(
          communicator, [&] { deck = stroma::read_deck(options.deck, options.overrides); });
      const std::string folder =
          options.output.empty() ? default_folder(options.deck) : options.output;
      try {
        const stroma::RunOptions how{folder, options.is_restart, time_limit};
        if (*run)
          stroma::asks_for_stiffness(deck->parameters)
              ? stroma::run_stiffness(communicator, *deck, how, log)
              : stroma::run_simulation(communicator, *deck, how, log);
        if (*check) stroma::check_command(communicator, *deck, log);
      } catch (const stroma::base::InputError& error) {
        throw stroma::located(*deck, error);
      }
    } else if (*image) {
      stroma::image_command(communicator, options.image, log);
    } else if (*phantom) {
      stroma::phantom_command(communicator, options.phantom, log);
    } else if (*study || *fit) {
      const std::string folder =
          options.output.empty() ? default_folder(options.deck) : options.output;
      if (*study) stroma::study_command(communicator, options.deck, folder, log);
      if (*fit) stroma::fit_command(communicator, options.deck, folder, log);
    } else if (*verify) {
      stroma::verify_command(communicator, options.output, log);
    } else if (*report) {
      stroma::report_command(communicator, options.output, log);
    } else if (*reference) {
      log.line(reference_of(options.section));
    }
    log.finish();
  } catch (const stroma::base::InputError& error) {
    return fail(ExitStatus::wrong_input, error.what());
  } catch (const stroma::base::RunError& error) {
    const int status = fail(ExitStatus::run_failed, error.what());
    if (communicator.any(stroma::output::files_are_stuck())) {
      // HDF5 would try again to close them, within MPI_Finalize, and crash there.
      std::cout << std::flush;
      communicator.barrier();
      std::_Exit(status);
    }
    return status;
  } catch (const std::exception& error) {
    // Not foreseen, and perhaps met by this rank alone: say so, and do not leave the others
    // waiting.
    std::cerr << "stroma: rank " << communicator.rank() << ": "
              << (stroma::base::is_out_of_memory(error) ? stroma::base::out_of_memory
                                                        : error.what())
              << "\n";
    if (communicator.size() > 1)
      MPI_Abort(communicator.raw(), static_cast<int>(ExitStatus::run_failed));
    return static_cast<int>(ExitStatus::run_failed);
  }
  return static_cast<int>(ExitStatus::done);
}
