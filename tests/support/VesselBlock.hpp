// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A deck that tests of the whole program start from.

#include <string>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {

/// A drawn block of vessels in collagen on elements of 2 x 2 x 2 voxels: the image, the materials
/// and the grid of a deck in YAML, to which the caller adds the rest. The grid's section comes
/// last, so that a text may go on with it. \param size  voxels, such as "32, 40, 24"
inline std::string vessel_block(const std::string& size) {
  return R"(Stroma:
  Image:
    Phantom:
      Kind: Vessels
      Size: [)" +
         size + R"(]
      Voxel Size [um]: [1.05, 1.05, 1.0]
      Volume Fraction: 0.2
      Seed: 3
  Materials:
    collagen:
      Label: 0
      Shear Modulus [Pa]: 520.8
      Poisson Ratio: 0.4
    vessel:
      Label: 1
      Shear Modulus [Pa]: 1041.6
      Poisson Ratio: 0.4
  Grid:
    Element Size [um]: [2.1, 2.1, 2.0]
)";
}

/// The section of clamped grips that stretch it by 10 %.
inline std::string clamped_stretch() {
  return R"(  Boundary Conditions:
    bottom:
      Face: y-
      Components: xyz
    top:
      Face: y+
      Components: xyz
      Strain: 0.1
)";
}

/// Runs the prepare.sh of an input deck's folder, which makes its image.
inline bool prepare(const fs::path& folder) {
  const std::string line = "cd " + quoted(folder) +
                           " && env -i PATH=\"$PATH\" HOME=" + quoted(folder) +
                           " LD_LIBRARY_PATH=\"$LD_LIBRARY_PATH\" OMPI_ALLOW_RUN_AS_ROOT=1 "
                           "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_ess_singleton_isolated=1 "
                           "OMPI_MCA_orte_create_session_dirs=0 bash prepare.sh " +
                           quoted(stroma_program()) + " > /dev/null";
  return std::system(line.c_str()) == 0;
}

}  // namespace stroma::test
