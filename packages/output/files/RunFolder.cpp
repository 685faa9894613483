// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/RunFolder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/output/files/FolderLock.hpp"
#include "stroma/output/files/Manifest.hpp"

namespace stroma::output {
namespace {

namespace fs = std::filesystem;

void add_picture(std::vector<std::string>& names, const std::string& picture) {
  names.push_back(picture + ".png");
  for (const char* ending : {".gp", ".dat", ".raw"})
    names.push_back("pictures/" + picture + ending);
}

/// Whether a run on so many ranks writes a file of this name: NAME.N.r on N ranks, NAME on one.
/// What is not spread over the ranks is written on any number.
bool is_written_on(int ranks, const std::string& file) {
  const std::string name = Manifest::name_of(file);
  if (name != "particles.e" && name != "grid.e") return true;
  const std::size_t dot = file.find('.', name.size());
  return (dot == std::string::npos ? 1 : std::atoi(file.c_str() + dot + 1)) == ranks;
}

/// Files of these names that are there, of any set of ranks, relative to the folder.
std::vector<std::string> files_of(const std::string& folder,
                                  const std::vector<std::string>& names) {
  std::set<std::string> files;
  std::error_code ignored;
  for (const std::string& name : names)  // by its name: file systems may take DECK.XML for it
    if (fs::exists(fs::symlink_status(fs::path(folder) / name, ignored))) files.insert(name);
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string file = entry.path().filename().string();
    if (std::count(names.begin(), names.end(), Manifest::name_of(file)) > 0) files.insert(file);
  }
  return {files.begin(), files.end()};
}

std::string list_of(const std::vector<std::string>& files) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, files.size()); ++i)
    text += (i == 0 ? "'" : ", '") + files[i] + "'";
  if (files.size() > most) text += " and " + std::to_string(files.size() - most) + " more";
  return text;
}

/// Whether a path leads to a file, or into it where it is a folder (of Zarr), by whatever name.
bool leads_to(const fs::path& file, const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(file, ignored)) return fs::equivalent(path, file, ignored);
  for (fs::path at = fs::canonical(path, ignored); at.has_relative_path(); at = at.parent_path())
    if (fs::equivalent(at, file, ignored)) return true;
  return false;
}

/// For one rank. \param what  the run would do to the file
void refuse_input(const std::string& folder, const std::string& file, const std::string& input,
                  const std::string& what) {
  throw base::InputError("the output folder '" + folder + "' holds '" + input + "' as '" + file +
                         "', " + what + "; choose another folder (-o)");
}

/// For one rank; see RunFolder::refuse_inputs().
void refuse_inputs_of(const std::string& folder, const std::vector<std::string>& names,
                      const std::vector<std::string>& inputs) {
  const auto leads_here = [&](const std::string& file) {
    return std::find_if(inputs.begin(), inputs.end(), [&](const std::string& input) {
      return leads_to(fs::path(folder) / file, input);
    });
  };
  for (const std::string& file : files_of(folder, names))
    if (const auto input = leads_here(file); input != inputs.end())
      refuse_input(folder, file, *input, "a name that the run writes to");
  const Manifest manifest(folder);
  for (const std::string& file : manifest.files())
    if (const auto input = leads_here(file); input != inputs.end() && manifest.is_own(file))
      refuse_input(folder, file, *input,
                   "which an earlier run left there and this one would remove");
}

/// For one rank; see refuse_foreign_files().
void refuse(const std::string& folder, int ranks, const std::vector<std::string>& names,
            const std::vector<std::string>& inputs) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return;
  refuse_inputs_of(folder, names, inputs);
  const fs::path pictures = fs::path(folder) / "pictures";
  std::vector<std::string> foreign;
  if (fs::exists(fs::symlink_status(pictures, ignored)) && !fs::is_directory(pictures, ignored))
    foreign.emplace_back("pictures");
  const Manifest manifest(folder);
  for (const std::string& file : files_of(folder, names))
    if (!manifest.is_own(file) && is_written_on(ranks, file)) foreign.push_back(file);
  if (foreign.empty()) return;
  throw base::InputError("the output folder '" + folder + "' holds " + list_of(foreign) +
                         ", which the run would overwrite, and which no run of Stroma is known to "
                         "have left as it is; move " +
                         (foreign.size() == 1 ? "it" : "them") +
                         " away, or choose another folder (-o)");
}

}  // namespace

std::vector<std::string> table_files() {
  return {"materials.csv", "histograms.csv", "wall_distance.csv", "objects.csv"};
}

std::vector<std::string> run_files(bool pictures, bool report, bool tables) {
  std::vector<std::string> names{"deck.xml",          "history.csv",     "log.txt",
                                 "particles.e",       "grid.e",          "checkpoint.h5",
                                 "checkpoint.h5.new", "history.csv.new", "sensitivity.csv"};
  if (report) names.insert(names.end(), {"report.html", "report.html.new"});
  if (tables)
    for (const std::string& table : table_files())
      names.insert(names.end(), {table, table + ".new"});
  if (pictures)
    for (const char* picture : {"vessels", "von_mises", "force"}) add_picture(names, picture);
  return names;
}

std::vector<std::string> stiffness_files(bool report) {
  std::vector<std::string> names{"deck.xml", "log.txt", "stiffness.csv", "stiffness.json"};
  if (report) names.insert(names.end(), {"report.html", "report.html.new"});
  return names;
}

std::vector<std::string> study_files() {
  std::vector<std::string> names{"study.csv", "convergence.csv", "log.txt", "report.html",
                                 "report.html.new"};
  names.insert(names.end(), {"draws.csv", "bands.csv", "correlations.csv", "von_mises_05.tif",
                             "von_mises_50.tif", "von_mises_95.tif"});
  for (const char* picture : {"force_strain", "force_element_size", "von_mises", "force_band"})
    add_picture(names, picture);
  return names;
}

std::vector<std::string> fit_files() {
  std::vector<std::string> names{"fit.csv", "estimates.csv", "fitted.csv",
                                 "log.txt", "report.html",   "report.html.new"};
  add_picture(names, "fit");
  return names;
}

void refuse_foreign_files(const base::Communicator& communicator, const std::string& folder,
                          const std::vector<std::string>& names,
                          const std::vector<std::string>& inputs) {
  base::collectively(communicator, [&] {
    if (communicator.is_root()) refuse(folder, communicator.size(), names, inputs);
  });
}

/// The lock, and the folders that were made for it.
struct RunFolder::Hold {
  struct MadeFolders {
    std::vector<fs::path> paths;  ///< innermost first

    ~MadeFolders() {
      std::error_code ignored;
      for (const fs::path& path : paths) fs::remove(path, ignored);  // unless something is in it
    }
  };

  explicit Hold(const std::string& folder) {
    std::error_code reason, ignored;
    for (fs::path path = fs::absolute(folder).lexically_normal();
         !path.empty() && !fs::exists(fs::symlink_status(path, ignored)); path = path.parent_path())
      made.paths.push_back(path);
    fs::create_directories(folder, reason);
    if (!fs::is_directory(folder, ignored))
      throw base::InputError(
          "cannot make the output folder '" + folder +
          "': " + (fs::exists(folder, ignored) ? "a file of that name exists" : reason.message()));
    lock.emplace(folder);
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

  MadeFolders made;  ///< goes after the lock
  std::optional<FolderLock> lock;
};

RunFiles::RunFiles(std::string folder) : folder_(std::move(folder)) {
  while (folder_.size() > 1 && folder_.back() == '/') folder_.pop_back();
}

RunFolder::RunFolder(const base::Communicator& communicator, std::string folder,
                     std::vector<std::string> names)
    : RunFiles(std::move(folder)), communicator_(communicator), names_(std::move(names)) {
  base::collectively(communicator_, [&] {
    if (communicator_.is_root()) hold_ = std::make_shared<Hold>(this->folder());
  });
}

std::string RunFiles::grid(int number) const {
  return file(number == 1 ? "grid.e" : base::format("grid.e-s%03d", number));
}

std::vector<std::string> RunFolder::names(bool is_continued) const {
  std::vector<std::string> names = names_;
  if (is_continued)
    names.erase(std::remove(names.begin(), names.end(), "checkpoint.h5"), names.end());
  return names;
}

void RunFolder::refuse_foreign_files(const std::vector<std::string>& inputs,
                                     bool is_continued) const {
  output::refuse_foreign_files(communicator_, folder(), names(is_continued), inputs);
}

void RunFolder::refuse_inputs(const std::vector<std::string>& inputs, bool is_continued) const {
  base::collectively(communicator_, [&] {
    if (communicator_.is_root()) refuse_inputs_of(folder(), names(is_continued), inputs);
  });
}

void RunFolder::remove_old_results(base::Log& log) const {
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    if (!hold_->lock->note().empty()) log.note(hold_->lock->note());
    Manifest manifest(folder());
    std::size_t removed = 0;
    for (const std::string& file : manifest.files()) {
      if (!manifest.is_own(file)) continue;
      std::error_code failure;
      fs::remove_all(fs::path(folder()) / file, failure);
      if (failure)
        throw base::InputError("cannot remove an earlier run's '" + file + "' from '" + folder() +
                               "': " + failure.message());
      ++removed;
    }
    if (removed > 0)
      log.line(base::format("removed     %zu file%s of an earlier run from %s", removed,
                            removed == 1 ? "" : "s", folder().c_str()));
    manifest.begin(names_);
  });
}

void RunFolder::continue_results(base::Log& log) const {
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    if (!hold_->lock->note().empty()) log.note(hold_->lock->note());
    Manifest(folder()).begin(names_);
  });
}

void RunFolder::finish(const std::string& file) const {
  base::collectively(communicator_, [&] {
    if (communicator_.is_root()) Manifest(folder()).finish({file});
  });
}

/// The files are read again for their checksums, each by another rank.
void RunFolder::finish() const {
  const base::Stage stage("checksums");
  std::vector<std::string> written;
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    written = files_of(folder(), names_);
    const auto is_of_others = [&](const std::string& file) {
      return !is_written_on(communicator_.size(), file);
    };
    written.erase(std::remove_if(written.begin(), written.end(), is_of_others), written.end());
  });
  std::size_t count = written.size();
  communicator_.broadcast(count);
  written.resize(count);
  for (std::string& one : written) communicator_.broadcast(one);
  const auto reader = [&](std::size_t f) {
    return static_cast<int>(f % static_cast<std::size_t>(communicator_.size()));
  };
  std::vector<std::string> sums(count);
  for (std::size_t f = 0; f < count; ++f)
    if (reader(f) == communicator_.rank()) sums[f] = Manifest::whole_checksum(file(written[f]));
  for (std::size_t f = 0; f < count; ++f) communicator_.broadcast(sums[f], reader(f));
  base::collectively(communicator_, [&] {
    if (communicator_.is_root()) Manifest(folder()).end(written, sums);
  });
}

}  // namespace stroma::output
