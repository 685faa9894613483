// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The grid of one step as a file of VTKHDF: what grid.e has of it.

#include <string>
#include <vector>

#include "stroma/output/files/GridPart.hpp"
#include "stroma/output/files/VtkhdfFile.hpp"

namespace stroma::output {

/// Writes the active elements as hexahedra at their reference positions [um], and at the nodes that
/// they use the vectors and `id`, the number in the whole grid from 1.
/// Field data: the row of history.csv. Collective.
/// \param communicator  of the ranks that share the grid
/// \param path          of the file
/// \param part          this rank's
/// \param vectors       at the nodes
/// \param numbers       the row
/// \param precision     of what is real
/// \throws base::RunError on all ranks; a file of before is still there
void write_vtkhdf_grid(const base::Communicator& communicator, const std::string& path,
                       const GridPart& part, const std::vector<NodalVector>& vectors,
                       const std::vector<VtkhdfNumber>& numbers, Precision precision);

}  // namespace stroma::output
