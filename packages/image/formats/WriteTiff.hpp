// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Writes a volume as a TIFF stack.

#include <cstdint>
#include <string>

#include "stroma/base/Communicator.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Writes a multi-page TIFF, of 8 bits or of 32-bit floats, that ImageJ (and stroma) opens with its voxel size: x and y in
/// the resolution tags, z as ImageJ's `spacing`, unit micron. Rank 0 writes plane after plane; no
/// rank holds more than its slab and one plane. BigTIFF from 4 GiB on. The file gets its name once
/// it is whole. Collective.
/// \throws base::RunError on all ranks when the file cannot be written
template <class T>
void write_tiff(const base::Communicator& communicator, const std::string& path,
                const voxels::Volume<T>& volume);

/// Whether a file was written by write_tiff(): its tag Software says so.
bool is_written_by_stroma(const std::string& path);

}  // namespace stroma::image
