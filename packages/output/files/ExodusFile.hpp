// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What the two Exodus files of a run share: making, checking, naming, parallel information.

#include <cstdint>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"

namespace stroma::output {

/// Size of a floating-point number in a file: 8 or 4 bytes.
enum class Precision { Double, Single };

/// Where results come from; kept in the file.
struct Provenance {
  std::string title;    ///< the deck's; its first 80 bytes are kept, the format's limit
  std::string version;  ///< of Stroma
  std::string deck;     ///< the deck's text, kept as information records of 80 characters
};

/// How large the numbers in a file get, which decides its format.
struct FileSize {
  std::int64_t largest_id = 0;  ///< of nodes and elements, over all ranks, from 1
  std::int64_t entries = 0;     ///< nodes or elements of this file, whichever are more
};

/// A new Exodus file, with all that does not change from step to step; the steps are added by
/// add_step() (ExodusStep.hpp). Every member function turns a failure of the library into a
/// base::RunError that names the file, what was being written, and the library's reason. Calls of
/// the Exodus library not wrapped here go through check(), with id().
class ExodusFile {
 public:
  /// Creates (or replaces) a file.
  /// \param path          of the file
  /// \param precision     of the numbers in it
  /// \param longest_name  length of the longest name of a block or variable in it
  /// \param size          of what it will hold
  static ExodusFile create(const std::string& path, Precision precision, std::size_t longest_name,
                           const FileSize& size);
  ExodusFile(ExodusFile&& other) noexcept;
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;
  ExodusFile& operator=(ExodusFile&&) = delete;
  ~ExodusFile();

  /// Closes the file and reports what only then fails, such as a full disk.
  void close();

  int id() const { return id_; }

  /// \param code  what the library returned: negative for an error
  /// \param what  what was written, e.g. "the coordinates"
  void check(int code, const char* what) const;

  /// Title, version and deck.
  void put_provenance(const Provenance& provenance) const;

  /// Names of the variables of a kind (EX_GLOBAL, EX_NODAL, EX_ELEM_BLOCK), and how many they are.
  void put_variable_names(int kind, const std::vector<std::string>& names) const;

  /// Calls put(start, size, values) for consecutive pieces of value(0), ..., value(count - 1);
  /// start counts from 1, as the Exodus library does.
  template <class T, class Value, class Put>
  static void in_pieces(std::int64_t count, const Value& value, const Put& put) {
    std::vector<T> buffer(static_cast<std::size_t>(count < piece ? count : piece));
    for (std::int64_t start = 0; start < count; start += piece) {
      const std::int64_t size = (count - start < piece) ? count - start : piece;
      for (std::int64_t i = 0; i < size; ++i)
        buffer[static_cast<std::size_t>(i)] = value(start + i);
      put(start + 1, size, buffer.data());
    }
  }

  /// Entries that pass through a buffer at a time.
  static constexpr std::int64_t piece = 65536;

 private:
  ExodusFile(int id, std::string path) : id_(id), path_(std::move(path)) {}

  int id_;
  std::string path_;
};

/// From now on netCDF keeps no whole variables of HDF5 files in caches, of up to 16 MB each: more
/// than a run's matrix.
void keep_no_variables_in_memory();

/// Whether an errno tells of a disk that does not take what is written.
bool is_of_the_disk(int reason);

/// Whether this rank holds files that could not be closed, as on a full disk. A process with such a
/// file must end without MPI_Finalize, in which HDF5 would try to close it again and crash.
bool files_are_stuck();

/// Name of the file that one rank writes: `path` alone for one rank; else the name that nem_spread
/// gives, path.N.r with r padded with zeros to the width of N.
std::string spread_file_name(const std::string& path, int ranks, int rank);

/// What a spread file says of its place in the whole. Counts of the nodes and elements of this
/// file.
struct ParallelPart {
  int ranks = 1;
  int rank = 0;
  std::int64_t global_nodes = 0;
  std::int64_t global_elements = 0;
  std::vector<std::int64_t> global_block_ids;
  std::vector<std::int64_t> global_block_counts;
  std::int64_t nodes = 0;
  std::int64_t elements = 0;
  /// Nodes of this file (numbered from 1, ascending) that other ranks hold too, by rank.
  struct Shared {
    int rank;
    std::vector<std::int64_t> nodes;
  };
  std::vector<Shared> shared;
  std::vector<std::int64_t> border_elements;  ///< elements of this file with a shared node, from 1
};

/// Writes the Nemesis part of a spread file: initial and global information, load balance, and the
/// communication maps of shared nodes. Nothing for one rank.
void put_parallel_part(const ExodusFile& file, const ParallelPart& part);

}  // namespace stroma::output
