// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/TiffDraft.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/TiffPages.hpp"

namespace stroma::image {

TiffDraft::TiffDraft(std::string path, std::string draft, bool big)
    : path_(std::move(path)), draft_(std::move(draft)) {
  file_.reset(TIFFOpen(draft_.c_str(), big ? "w8" : "w"));
  if (!file_) fail();
}

TiffDraft::~TiffDraft() {
  file_.reset();
  if (!draft_.empty()) std::remove(draft_.c_str());
}

void TiffDraft::fail() const {
  throw base::RunError(path_ + ": cannot be written" + TiffMessages::reason());
}

void TiffDraft::close() {
  if (TIFFFlush(file_.get()) != 1) fail();
  errno = 0;
  const bool kept = fsync(TIFFFileno(file_.get())) == 0 || errno == EINVAL;
  file_.reset();
  if (!kept) throw base::RunError(path_ + ": cannot be written: " + std::strerror(errno));
}

void TiffDraft::rename() {
  if (std::rename(draft_.c_str(), path_.c_str()) != 0)
    throw base::RunError(path_ + ": cannot be written: " + std::strerror(errno));
  draft_.clear();
}

}  // namespace stroma::image
