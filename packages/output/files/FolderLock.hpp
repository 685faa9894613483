// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// One run at a time writes into a folder.

#include <string>

namespace stroma::output {

/// The lock of a folder, the file .stroma_lock in it, for as long as it lives. For one rank.
class FolderLock {
 public:
  /// Makes the file, all at once, with host, process and the time the process began. A lock of a
  /// process that is gone from this host is taken over.
  /// \throws base::InputError  another run has it; or the folder cannot be written
  explicit FolderLock(std::string folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whose lock was taken over; empty if nobody's.
  const std::string& note() const { return note_; }

 private:
  bool make() const;
  void judge();

  std::string folder_, path_, note_;
};

}  // namespace stroma::output
