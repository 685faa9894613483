// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A TIFF file that is being written.

#include <tiffio.h>

#include <memory>
#include <string>

namespace stroma::image {

struct CloseTiff {
  void operator()(TIFF* file) const { TIFFClose(file); }
};
using TiffFile = std::unique_ptr<TIFF, CloseTiff>;

/// What the tag Software says of files that we write.
inline constexpr const char* stroma_software = "Stroma";

/// A file that gets its name when it is whole, and goes away if it does not come to that.
class TiffDraft {
 public:
  /// \param path   its name
  /// \param draft  the name until then
  /// \param big    a BigTIFF, as files above 4 GB must be
  /// \throws base::RunError when it cannot be made
  TiffDraft(std::string path, std::string draft, bool big);
  ~TiffDraft();
  TiffDraft(const TiffDraft&) = delete;
  TiffDraft& operator=(const TiffDraft&) = delete;

  TIFF* file() { return file_.get(); }
  /// \throws base::RunError with libtiff's reason
  [[noreturn]] void fail() const;
  /// Everything is written; the file is closed.
  /// \throws base::RunError when the system could not keep it, of which libtiff does not tell
  void close();
  /// Gives it its name. \throws base::RunError
  void rename();

  const std::string& draft() const { return draft_; }

 private:
  std::string path_, draft_;
  TiffFile file_;
};

}  // namespace stroma::image
