// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What a run writes, and how often.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stroma/image/stacks/StackWriter.hpp"
#include "stroma/output/files/ExodusFile.hpp"
#include "stroma/output/pictures/RasterPlot.hpp"

namespace stroma::output {

/// Where the voxels of an image stack lie.
enum class StackFrame {
  undeformed,  ///< those of the image, or of its region
  deformed,    ///< voxels of the same size where the body has gone
  both
};

/// Results put back onto the voxels of the image.
struct ImageStacksParameters {
  std::vector<std::string> quantities{"von_mises"};  ///< variables of particles.e, and "label"
  StackFrame frame = StackFrame::undeformed;
  image::StackFormat format = image::StackFormat::ome_tiff;
  image::Compression compression = image::Compression::none;
  int every = 0;  ///< load steps between stacks
};

/// What is written, and how often. 0 steps between writes means: the last step only. The last step
/// has a checkpoint in any case.
struct OutputParameters {
  int particles_every = 1;           ///< load steps between writes of particles.e
  int grid_every = 1;                ///< load steps between writes of grid.e
  int checkpoint_every = 0;          ///< load steps between checkpoints; 0: no matter how many
  double checkpoint_minutes = 10.0;  ///< between checkpoints; 0: no matter how many
  Precision precision = Precision::Double;
  bool vtkhdf = false;  ///< the same steps as VTKHDF, too
  std::optional<ImageStacksParameters> image_stacks;
  bool tables = true;
  bool pictures = true;
  bool report = true;
  Origin origin = Origin::Top;  ///< of y, in pictures
};

/// Whether a step is to be written, when every n-th is. Step 0 is written as the others are: it is
/// a multiple of every n, but not the last step.
inline bool is_due(std::int64_t step, int every, bool last_step) {
  return last_step || (every > 0 && step % every == 0);
}

}  // namespace stroma::output
