// SPDX-License-Identifier: BSD-3-Clause

#include "run/KnownFiles.hpp"

#include <filesystem>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/base/Sha256.hpp"
#include "stroma/base/Stage.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;

KnownFile known_file(const fs::path& path) {
  std::error_code ignored;  // sha256_of_file() tells what is wrong
  const std::uintmax_t bytes = fs::file_size(path, ignored);
  return {path.string(), static_cast<std::int64_t>(bytes), base::sha256_of_file(path.string())};
}

KnownFile known_folder(const fs::path& folder) {
  std::set<fs::path> files;
  std::error_code failure;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (entry->is_regular_file(failure)) files.insert(entry->path());
  if (failure) throw base::RunError("cannot read '" + folder.string() + "': " + failure.message());
  KnownFile all{folder.string(), 0, ""};
  std::vector<std::string> names;
  for (const fs::path& path : files) {
    all.bytes += static_cast<std::int64_t>(fs::file_size(path, failure));
    names.push_back(path.lexically_relative(folder).string());
  }
  all.sha256 = base::sha256_of_files(folder.string(), names);
  return all;
}

}  // namespace

std::vector<KnownFile> known_files(const base::Communicator& communicator,
                                   const std::vector<std::string>& paths) {
  const base::Stage stage("checksums");
  std::vector<KnownFile> files;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::set<fs::path> listed;
    for (const std::string& one : paths) {
      const fs::path path = fs::absolute(one).lexically_normal();
      if (!listed.insert(path).second) continue;
      files.push_back(fs::is_directory(path) ? known_folder(path) : known_file(path));
    }
  });
  std::size_t count = files.size();
  communicator.broadcast(count);
  files.resize(count);
  for (KnownFile& file : files) {
    communicator.broadcast(file.path);
    communicator.broadcast(file.bytes);
    communicator.broadcast(file.sha256);
  }
  return files;
}

}  // namespace stroma
