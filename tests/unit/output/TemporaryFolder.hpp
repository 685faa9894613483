// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A folder that all ranks of a test share and that goes with it.

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "stroma/base/Communicator.hpp"

namespace stroma {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    if (communicator_.is_root()) {
      path_ = (std::filesystem::temp_directory_path() / "stroma_output_XXXXXX").string();
      if (mkdtemp(path_.data()) == nullptr) path_ = "/nowhere";
    }
    communicator_.broadcast(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    communicator_.barrier();
    std::error_code ignored;
    if (communicator_.is_root()) std::filesystem::remove_all(path_, ignored);
    communicator_.barrier();
  }
  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  base::Communicator communicator_ = base::Communicator::world();
  std::string path_;
};

inline std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

/// The message of the Error that work() throws; empty, and a failed test, when it throws none.
template <class Error, class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error of the expected class";
  return "";
}

}  // namespace stroma
