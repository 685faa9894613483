// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/OutputFiles.hpp"

#include "stroma/base/Log.hpp"
#include "stroma/output/files/Manifest.hpp"
#include "stroma/output/files/RunFolder.hpp"

namespace stroma::output {

std::vector<std::string> run_files(const OutputParameters& wanted) {
  std::vector<std::string> names = run_files(wanted.pictures, wanted.report, wanted.tables);
  if (wanted.vtkhdf)
    for (const char* of : {"particles", "grid"})
      for (const char* ending : {".hdf", ".hdf.series", ".hdf.series.new"})
        names.push_back(std::string(of) + ending);
  if (!wanted.image_stacks) return names;
  for (const bool is_deformed : are_deformed(*wanted.image_stacks)) {
    const std::string file =
        Manifest::name_of(image_stack_file(*wanted.image_stacks, is_deformed, 0));
    names.insert(names.end(), {file, file + ".new"});
  }
  return names;
}

std::vector<bool> are_deformed(const ImageStacksParameters& wanted) {
  if (wanted.frame == StackFrame::both) return {false, true};
  return {wanted.frame == StackFrame::deformed};
}

std::string image_stack_file(const ImageStacksParameters& wanted, bool is_deformed,
                             std::int64_t step) {
  return std::string(is_deformed ? "image_deformed" : "image_undeformed") +
         (wanted.every == 0 ? "" : base::format("-s%04lld", static_cast<long long>(step))) +
         (wanted.format == image::StackFormat::ome_tiff ? ".ome.tif" : ".ome.zarr");
}

}  // namespace stroma::output
