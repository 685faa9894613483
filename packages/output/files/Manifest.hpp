// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Which files of a folder are Stroma's own.

#include <map>
#include <string>
#include <vector>

namespace stroma::output {

/// The list .stroma_files of an output folder. It names the files that a run writes before they
/// exist; a file that is finished gets its size and two checksums, so that one which somebody changed
/// or put there since is told apart, wherever the folder is copied to: a quick one, of its head and
/// its end, by which the next run knows what it may remove, and the SHA-256 of all of it or, above
/// 16 MiB, of samples, by which `stroma verify` knows it again. For one rank.
class Manifest {
 public:
  /// Reads the list of a folder; an empty one where there is none.
  explicit Manifest(std::string folder);

  /// Begins a new list: files of these names are being written. All files of a sequence and of a
  /// set of ranks (grid.e-s002.16.03) go by one name (grid.e).
  void begin(const std::vector<std::string>& names);
  /// These files are finished, as they are now.
  void finish(const std::vector<std::string>& files);
  /// All files are finished, but for the log, to which a line may still come; until it is finished,
  /// it is known by how it begins.
  /// \param files  their names
  /// \param sums   the whole_checksum() of each
  void end(const std::vector<std::string>& files, const std::vector<std::string>& sums);

  /// The SHA-256 of all of a file, as `sha256sum` prints it; of one above 16 MiB, "of samples" and
  /// that of 256 pieces of 64 KiB (base::sha256_of_samples), for a run shall not wait for its
  /// checksums; of a folder, that of the list of its files (base::sha256_of_files), by name. Empty
  /// where it cannot be read.
  /// \param path  of the file or the folder
  static std::string whole_checksum(const std::string& path);

  /// Whether a run has ended, or was stopped, and did not just cease.
  bool has_ended() const;
  /// The files that are finished.
  std::vector<std::string> finished() const;
  /// Whether the SHA-256 of a finished file is known; earlier versions of Stroma did not take it.
  /// \param file  one of finished()
  bool has_whole_checksum(const std::string& file) const;
  /// Whether only samples of a finished file are known.
  /// \param file  one of finished()
  bool is_sampled(const std::string& file) const;
  /// How a finished file departs from what was left.
  /// \param file  one of finished()
  /// \return what is wrong with it; empty if it is as it was
  std::string departure(const std::string& file) const;

  /// The files of the folder that the list names, as they are or changed.
  std::vector<std::string> files() const;
  /// Whether a file of the folder is as Stroma left it: a plain file, or a folder of Zarr, that is in the list with its
  /// checksum, or whose name is being written and that begins as such a file does.
  bool is_own(const std::string& file) const;

  /// Whether a file is one that a run may have left, by how it begins, or is empty.
  static bool begins_as_written(const std::string& path);

  /// The name by which the files of a sequence and of a set of ranks go.
  static std::string name_of(const std::string& file);

 private:
  struct Mark {
    std::string quick;  ///< fingerprint()
    std::string whole;  ///< whole_checksum(); empty where it is not known
  };

  void write() const;
  std::string fingerprint(const std::string& file) const;

  std::string folder_;
  std::vector<std::string> being_written_;
  std::map<std::string, Mark> finished_;  ///< by file
};

}  // namespace stroma::output
