// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What readers of HDF5 files share: handles that close themselves, quiet errors, attributes,
/// names.

#include <hdf5.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stroma::image {

/// Keeps HDF5's error stack off standard error while it lives.
class Hdf5Messages {
 public:
  Hdf5Messages();
  ~Hdf5Messages();
  Hdf5Messages(const Hdf5Messages&) = delete;
  Hdf5Messages& operator=(const Hdf5Messages&) = delete;

  /// " (HDF5: REASON)" from the innermost entry of the stack, or nothing.
  static std::string reason();

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// An HDF5 identifier that is closed when it goes.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }
  bool good() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Opens a group or a dataset by its path within the file; a handle that is not good() if it
/// cannot.
Hdf5Handle open_object(hid_t file, const std::string& path);

/// Paths of all datasets of a file, in alphabetical order, without a slash in front. Nothing when
/// the file is too broken to be walked through.
std::optional<std::vector<std::string>> datasets_of(hid_t file);

/// Texts of an attribute: strings of fixed or variable length, one or a list; or one text written
/// as a list of single characters, as Imaris does. Nothing when it is absent or no text.
std::vector<std::string> text_attribute(hid_t object, const char* name);

/// Numbers of an attribute (integers or floats), at most `most` of them. Nothing when it is absent
/// or anything else.
std::vector<double> number_attribute(hid_t object, const char* name, std::size_t most = 16);

/// The first filter of a dataset that this HDF5 does not have: "lzf (filter 32000)"; nothing if it
/// has them all.
std::optional<std::string> missing_filter(hid_t creation_properties);

}  // namespace stroma::image
