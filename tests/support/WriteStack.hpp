// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Small image stacks for fields, as files.

#include <array>
#include <cstring>
#include <string>

#include "support/Program.hpp"

namespace stroma::test {

/// Writes NAME.mhd and NAME.raw with intensity(i, j, k) at each voxel, as bytes, floats or doubles.
template <class Value, class Intensity>
void write_stack(const TemporaryFolder& folder, const std::string& name,
                 const std::array<int, 3>& voxels, const Intensity& intensity) {
  const char* type = sizeof(Value) == 1   ? "MET_UCHAR"
                     : sizeof(Value) == 4 ? "MET_FLOAT"
                                          : "MET_DOUBLE";
  folder.write(name + ".mhd",
               "ObjectType = Image\nNDims = 3\nDimSize = " + std::to_string(voxels[0]) + " " +
                   std::to_string(voxels[1]) + " " + std::to_string(voxels[2]) +
                   "\nElementType = " + type +
                   "\nElementByteOrderMSB = False\nElementDataFile = " + name + ".raw\n");
  std::string bytes;
  for (int k = 0; k < voxels[2]; ++k)
    for (int j = 0; j < voxels[1]; ++j)
      for (int i = 0; i < voxels[0]; ++i) {
        const auto value = static_cast<Value>(intensity(i, j, k));
        char raw[sizeof(Value)];
        std::memcpy(raw, &value, sizeof(Value));
        bytes.append(raw, sizeof(Value));
      }
  folder.write(name + ".raw", bytes);
}

}  // namespace stroma::test
