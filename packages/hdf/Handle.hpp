// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What all that reads or writes HDF5 shares: handles that close themselves, quiet errors.

#include <hdf5.h>

#include <string>
#include <utility>

namespace stroma::hdf {

/// Keeps HDF5's error stack off standard error while it lives.
class Messages {
 public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  /// " (HDF5: REASON)" from the innermost entry of the stack, or nothing.
  static std::string reason();

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// An HDF5 identifier that is closed when it goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close give_back) : id_(id), close_(give_back) {}
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { close(); }
  /// Closes it now. \return  whether that went well, which is when the last data are written
  bool close() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }
  hid_t get() const { return id_; }
  bool good() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Writes a text beside an object, as an attribute of ASCII or UTF-8 without an end. Collective.
/// \return  whether it is there
bool put_text(const Handle& object, const char* name, const std::string& text);

}  // namespace stroma::hdf
