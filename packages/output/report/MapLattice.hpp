// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The cells in which particles are gathered for maps of them.

#include <array>
#include <cstddef>
#include <cstdint>

#include "stroma/output/files/ParticleReader.hpp"

namespace stroma::output {

/// Equal cells over the box of the undeformed particles, x fastest.
struct MapLattice {
  std::array<double, 3> origin{};               ///< lower corner of the box [um]
  std::array<double, 3> length{};               ///< edges of the box [um]
  std::array<double, 3> cell{};                 ///< edges of a cell; the last may stick out [um]
  std::array<std::int64_t, 3> count{};          ///< cells along x, y, z
  std::array<std::int64_t, 3> merged{1, 1, 1};  ///< distances of particles that make an edge

  std::size_t cells() const { return static_cast<std::size_t>(count[0] * count[1] * count[2]); }
  /// The cell that a place lies in, or the nearest.
  std::size_t cell_of(double x, double y, double z) const;
};

/// Cells that hold a particle each: their edges are the mean differences of the distinct coordinates
/// along the axes, so that Gauss points have one each, too; planes that are empty do not count.
/// \throws base::RunError when the file cannot be read
MapLattice lattice_of(const ParticleReader& particles);

/// The lattice with as many cells merged as it takes to have at most so many: along z until they are
/// twice as long there as in the plane, which is what is looked at, else along x and y alike.
MapLattice merged(const MapLattice& lattice, std::size_t most_cells);

}  // namespace stroma::output
