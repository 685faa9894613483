#include "output/RunFolder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <regex>
#include <vector>

#include "base/Error.hpp"
#include "base/Log.hpp"

namespace stroma::output {
namespace {

namespace fs = std::filesystem;

/// Whether the name is one that a run gives to a file of its own.
bool is_result(const std::string& name) {
  static const std::regex results(
      "(particles|grid)\\.e(-s[0-9]+)?(\\.[0-9]+\\.[0-9]+)?|history\\.csv|deck\\.xml|log\\.txt|"
      "checkpoint\\."
      "h5|"
      "(vessels|von_mises|force)\\.png");
  return std::regex_match(name, results);
}

void try_to_write(const std::string& folder) {
  const std::string trial = folder + "/.stroma_trial";
  std::FILE* file = std::fopen(trial.c_str(), "w");
  if (file == nullptr) {
    throw base::InputError("cannot write into the output folder '" + folder +
                           "': " + std::strerror(errno));
  }
  std::fclose(file);
  std::remove(trial.c_str());
}

}  // namespace

RunFolder::RunFolder(const base::Communicator& communicator, std::string folder)
    : communicator_(communicator), folder_(std::move(folder)) {
  while (folder_.size() > 1 && folder_.back() == '/') folder_.pop_back();
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    std::error_code reason;
    fs::create_directories(folder_, reason);
    if (!fs::is_directory(folder_)) {
      throw base::InputError(
          "cannot make the output folder '" + folder_ +
          "': " + (fs::exists(folder_) ? "a file of that name exists" : reason.message()));
    }
    try_to_write(folder_);
  });
}

std::string RunFolder::grid(int number) const {
  return file(number == 1 ? "grid.e" : base::format("grid.e-s%03d", number));
}

void RunFolder::remove_old_results() const {
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    try {
      std::vector<fs::path> old;
      for (const auto& entry : fs::directory_iterator(folder_)) {
        if (entry.is_regular_file() && is_result(entry.path().filename()))
          old.push_back(entry.path());
      }
      for (const fs::path& path : old) fs::remove(path);
    } catch (const fs::filesystem_error& error) {
      throw base::InputError("cannot remove an earlier run's results from '" + folder_ +
                             "': " + error.code().message());
    }
  });
}

}  // namespace stroma::output
