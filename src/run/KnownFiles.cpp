// SPDX-License-Identifier: BSD-3-Clause

#include "run/KnownFiles.hpp"

#include <filesystem>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/base/Sha256.hpp"
#include "stroma/base/Stage.hpp"

namespace stroma {

std::vector<KnownFile> known_files(const base::Communicator& communicator,
                                   const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  const base::Stage stage("checksums");
  std::vector<KnownFile> files;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::set<fs::path> listed;
    for (const std::string& one : paths) {
      const fs::path path = fs::absolute(one).lexically_normal();
      if (!listed.insert(path).second) continue;
      std::error_code ignored;  // sha256_of_file() tells what is wrong
      const std::uintmax_t bytes = fs::file_size(path, ignored);
      files.push_back(
          {path.string(), static_cast<std::int64_t>(bytes), base::sha256_of_file(path.string())});
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
