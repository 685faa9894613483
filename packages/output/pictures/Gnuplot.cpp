// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/Gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

#include "stroma/base/Log.hpp"

extern char** environ;

namespace stroma::output {
namespace {

const char* const viridis[] = {"#440154", "#481567", "#482677", "#453781", "#404788",
                               "#39568c", "#33638d", "#2d708e", "#287d8e", "#238a8d",
                               "#1f968b", "#20a387", "#29af7f", "#3cbb75", "#55c667",
                               "#73d055", "#95d840", "#b8de29", "#dce319", "#fde725"};

bool one_has_hung = false;  // in this process: the next one will hang too

/// The first line that tells something in what gnuplot printed.
std::string first_complaint(const std::string& path) {
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    const auto start = line.find_first_not_of(" \t^\r");
    if (start != std::string::npos && line.find("line ") != std::string::npos)
      return line.substr(start);
  }
  return "gnuplot failed";
}

/// Waits for a child that leads a group of processes; ends the group when it takes too long.
/// \return  its status, or nothing then
std::optional<int> status_of(pid_t child, std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + patience;
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if ((ended < 0 && errno != EINTR) || Clock::now() > end) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(-child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return std::nullopt;
}

}  // namespace

std::chrono::milliseconds gnuplot_patience() { return std::chrono::seconds(one_has_hung ? 5 : 60); }

std::string gnuplot_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'')
      quoted += "''";
    else if (c == '\n' || c == '\r')
      quoted += ' ';
    else
      quoted += c;
  }
  return quoted + "'";
}

std::string gnuplot_head(const std::string& name, int width, int height, const std::string& title) {
  const auto line_break = title.find('\n');
  std::string first = title.substr(0, line_break);
  std::string rest = line_break == std::string::npos ? "" : title.substr(line_break + 1);
  if (first.empty()) std::swap(first, rest);  // the deck has no title
  std::string script;
  script += "# Draws ../" + name + ".png. Change it and run: gnuplot " + name + ".gp\n";
  script += base::format(
      "set terminal pngcairo noenhanced size %d,%d font 'Sans,14' background '#ffffff'\n", width,
      height);
  script += "set encoding utf8\nset output '../" + name + ".png'\n";
  script += "set tmargin 5\n";
  const auto heading = [&](int number, const std::string& text, double pixels_down, double points,
                           const char* style) {
    // A character is about 0.75 as many pixels wide as it has points; a long title gets smaller
    // ones.
    const double fitting = width / (0.75 * static_cast<double>(text.size() + 1));
    script += base::format(
        "set label %d %s at screen 0.5, screen %.5f center font 'Sans%s,%.3g'%s\n", number,
        gnuplot_quoted(text).c_str(), 1.0 - pixels_down / height, style,
        std::max(6.0, std::min(points, fitting)), number == 1 ? "" : " tc rgb '#444444'");
  };
  heading(1, first, 42.0, 16.0, ":Bold");
  heading(2, rest, 78.0, 13.0, "");
  script += "set border lw 1 lc rgb '#444444'\nset tics out nomirror tc rgb '#222222'\n";
  return script;
}

std::string viridis_palette() {
  std::string script = "set palette defined (";
  for (std::size_t i = 0; i < std::size(viridis); ++i) {
    script += base::format("%s%zu '%s'", i == 0 ? "" : ", ", i, viridis[i]);
  }
  return script + ")\n";
}

std::string viridis_colour(double place) {
  const double last = static_cast<double>(std::size(viridis) - 1);
  return viridis[static_cast<std::size_t>(std::lround(last * std::clamp(place, 0.0, 1.0)))];
}

std::string run_gnuplot(const std::string& folder, const std::string& script,
                        std::chrono::milliseconds patience) {
  const std::string printed = folder + "/.gnuplot_output";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, printed.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // A group of its own, to be ended with all that it starts; it may be ended by a broken pipe.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  sigset_t usual;
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  std::string program = "gnuplot", option = "-d", argument = script;
  char* arguments[] = {program.data(), option.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int code = posix_spawnp(&child, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);

  std::string failure;
  if (code != 0) {
    failure = (code == ENOENT) ? "gnuplot is not installed"
                               : "gnuplot cannot be run (" + std::string(std::strerror(code)) + ")";
  } else {
    const std::optional<int> status = status_of(child, patience);
    if (!status) {
      one_has_hung = true;
      failure = base::format("gnuplot did not come to an end in %.3g s", 1e-3 * patience.count());
    } else if (!WIFEXITED(*status) || WEXITSTATUS(*status) != 0) {
      failure = first_complaint(printed);
    }
  }
  std::error_code ignored;
  std::filesystem::remove(printed, ignored);
  return failure;
}

}  // namespace stroma::output
