// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// VTKHDF: an unstructured grid of VTK with its fields in HDF5, one file for all ranks.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "stroma/base/Communicator.hpp"
#include "stroma/output/files/ExodusFile.hpp"

namespace stroma::output {

/// What kind of cell a grid is made of, by VTK's numbers.
enum class VtkCell : std::uint8_t { vertex = 1, hexahedron = 12 };

/// The part of a grid that one rank holds. Its cells have its own points alone, so that points of
/// common faces are there once for each part.
struct VtkhdfPart {
  VtkCell cell = VtkCell::vertex;  ///< the same on all ranks
  std::int64_t points = 0;
  std::int64_t cells = 0;
};

/// A field at the points.
struct VtkhdfColumn {
  enum class Number { real, integer, byte };

  std::string name, unit;
  int components = 1;  ///< 3: a vector; 6: a symmetric tensor, xx yy zz xy yz zx
  Number number = Number::real;
};

/// Takes the values of one rank, in pieces of any size and order. Nothing communicates.
class VtkhdfPieces {
 public:
  virtual ~VtkhdfPieces() = default;
  /// \param first   of them
  /// \param count   how many
  /// \param values  (point, xyz) [um]
  virtual void points(std::int64_t first, std::int64_t count, const double* values) const = 0;
  /// \param first   of them
  /// \param count   how many
  /// \param points  (cell, corner) in VTK's order; points of this rank, from 0
  virtual void cells(std::int64_t first, std::int64_t count, const std::int64_t* points) const = 0;
  /// \param column  which
  /// \param first   of its rows
  /// \param count   how many
  /// \param values  (point, component)
  virtual void column(std::size_t column, std::int64_t first, std::int64_t count,
                      const double* values) const = 0;
};

/// A number of the whole.
struct VtkhdfNumber {
  std::string name;
  double value = 0.0;
};

/// Writes a file of format version 1.0, `UnstructuredGrid`, of one step: under a temporary name, and
/// renamed when it is whole. Each rank is a part, and writes by itself; datasets are contiguous.
/// Every dataset of a field has an attribute `unit`. Collective.
/// \param communicator  of the ranks
/// \param path          of the file
/// \param part          this rank's
/// \param columns       point data; the same on all ranks
/// \param numbers       field data; those of rank 0 are taken
/// \param precision     of what is real
/// \param put           hands out this rank's values; called once; may throw what a run may
/// \throws base::RunError on all ranks, with the reason; a file of before is still there
void write_vtkhdf(const base::Communicator& communicator, const std::string& path,
                  const VtkhdfPart& part, const std::vector<VtkhdfColumn>& columns,
                  const std::vector<VtkhdfNumber>& numbers, Precision precision,
                  const std::function<void(const VtkhdfPieces&)>& put);

}  // namespace stroma::output
