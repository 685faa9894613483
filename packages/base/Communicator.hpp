// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The ranks of a run: a value type around MPI_Comm with the few collectives Stroma needs.

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace stroma::base {

/// MPI datatype of a C++ arithmetic type.
template <class T>
MPI_Datatype mpi_type() {
  if constexpr (std::is_same_v<T, double>) return MPI_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return MPI_FLOAT;
  if constexpr (std::is_same_v<T, char>) return MPI_CHAR;
  if constexpr (std::is_same_v<T, std::int8_t>) return MPI_INT8_T;
  if constexpr (std::is_same_v<T, std::uint8_t>) return MPI_UINT8_T;
  if constexpr (std::is_same_v<T, std::int16_t>) return MPI_INT16_T;
  if constexpr (std::is_same_v<T, std::uint16_t>) return MPI_UINT16_T;
  if constexpr (std::is_same_v<T, std::int32_t>) return MPI_INT32_T;
  if constexpr (std::is_same_v<T, std::uint32_t>) return MPI_UINT32_T;
  if constexpr (std::is_same_v<T, std::int64_t>) return MPI_INT64_T;
  if constexpr (std::is_same_v<T, std::uint64_t>) return MPI_UINT64_T;
  if constexpr (std::is_same_v<T, long long>) return MPI_LONG_LONG;
}

/// A group of ranks. Copying shares the underlying MPI communicator, which the caller keeps alive.
/// Every member function but rank(), size() and raw() is collective.
class Communicator {
 public:
  explicit Communicator(MPI_Comm communicator);
  static Communicator world() { return Communicator(MPI_COMM_WORLD); }
  static Communicator self() { return Communicator(MPI_COMM_SELF); }

  int rank() const { return rank_; }
  int size() const { return size_; }
  MPI_Comm raw() const { return communicator_; }
  bool is_root() const { return rank_ == 0; }

  void barrier() const { MPI_Barrier(communicator_); }

  template <class T>
  T sum(T value) const {
    return reduce(value, MPI_SUM);
  }
  template <class T>
  T min(T value) const {
    return reduce(value, MPI_MIN);
  }
  template <class T>
  T max(T value) const {
    return reduce(value, MPI_MAX);
  }
  /// True on all ranks if it is true on one.
  bool any(bool value) const { return max(value ? 1 : 0) == 1; }

  /// Sums an array over the ranks, in place on every rank.
  template <class T>
  void sum_all(T* values, std::size_t count) const {
    MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(count), mpi_type<T>(), MPI_SUM,
                  communicator_);
  }
  /// Sum of the values of the ranks before this one.
  template <class T>
  T sum_before(T value) const {
    T result = 0;
    MPI_Exscan(&value, &result, 1, mpi_type<T>(), MPI_SUM, communicator_);
    return rank_ == 0 ? T(0) : result;
  }

  template <class T>
  void broadcast(T& value, int root = 0) const {
    MPI_Bcast(&value, 1, mpi_type<T>(), root, communicator_);
  }
  template <class T>
  void broadcast(T* values, std::size_t count, int root = 0) const {
    MPI_Bcast(values, static_cast<int>(count), mpi_type<T>(), root, communicator_);
  }
  void broadcast(std::string& text, int root = 0) const;

  /// One value of each rank, in rank order, on every rank.
  template <class T>
  std::vector<T> gather(T value) const {
    std::vector<T> all(static_cast<std::size_t>(size_));
    MPI_Allgather(&value, 1, mpi_type<T>(), all.data(), 1, mpi_type<T>(), communicator_);
    return all;
  }

 private:
  template <class T>
  T reduce(T value, MPI_Op operation) const {
    T result;
    MPI_Allreduce(&value, &result, 1, mpi_type<T>(), operation, communicator_);
    return result;
  }

  MPI_Comm communicator_;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace stroma::base
