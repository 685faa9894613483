// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// An HDF5 file of arrays that the ranks of a run share: written whole by all of them, read in any
/// pieces by any number.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/hdf/Handle.hpp"

namespace stroma::output {

/// A box of an array, in the order of its axes, the slowest first.
struct Slab {
  std::vector<std::uint64_t> begin, count;

  std::uint64_t size() const;
};

/// An array over all ranks, and the box of it that this rank holds. Nothing is owned.
struct StateArray {
  enum class Type { real, integer, byte };

  std::string name;   ///< with its groups: "grid/displacement"
  std::string about;  ///< axes and unit, for people
  Type type = Type::real;
  std::vector<std::uint64_t> shape;  ///< the same on all ranks
  Slab mine;                         ///< of no size, where this rank has nothing of it
  const void* values = nullptr;      ///< (box), the last axis fastest
};

/// Writes a file of arrays, all ranks their parts: under a temporary name, synced, then renamed, so
/// that a file of that name is whole, the one before until then. Every dataset is checked by
/// Fletcher's sum, and everything else in the file by HDF5's own. Collective.
/// \param communicator  of the ranks
/// \param path          of the file
/// \param arrays        the same names, types and shapes on all ranks
/// \param piece         bytes that a rank writes at a time, and of which HDF5 keeps a copy; or a chunk
/// \throws base::RunError on all ranks, with the reason; the file of before is still there
void write_state(const base::Communicator& communicator, const std::string& path,
                 const std::vector<StateArray>& arrays,
                 std::uint64_t piece = std::uint64_t{1} << 26);

/// The temporary name.
std::string draft_of_state(const std::string& path);

/// Such a file, for one rank.
class StateReader {
 public:
  /// \throws base::InputError when it cannot be read, or is damaged
  explicit StateReader(std::string path);

  const std::string& path() const { return path_; }
  bool has(const std::string& name) const;
  /// \throws base::InputError  when there is no such array
  std::vector<std::uint64_t> shape(const std::string& name) const;

  /// A box of an array; T is double, std::int64_t or std::uint8_t.
  /// \throws base::InputError  when it is not there, of another type or shape, or damaged
  template <class T>
  std::vector<T> get(const std::string& name, const Slab& box) const;
  /// All of it.
  template <class T>
  std::vector<T> get(const std::string& name) const {
    const std::vector<std::uint64_t> all = shape(name);
    return get<T>(name, {std::vector<std::uint64_t>(all.size(), 0), all});
  }
  /// The only value of an array.
  template <class T>
  T value(const std::string& name) const {
    return get<T>(name, {{0}, {1}}).front();
  }

 private:
  hdf::Handle open(const std::string& name) const;
  /// \param room  makes room for the values, once it is known that there are as many
  void read(const std::string& name, const Slab& box, StateArray::Type type,
            const std::function<void*()>& room) const;
  [[noreturn]] void refuse(const std::string& problem) const;

  std::string path_;
  hdf::Handle file_;
};

}  // namespace stroma::output
