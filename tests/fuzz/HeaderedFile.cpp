// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Fuzz target: a whole file of MetaImage, NRRD or NIfTI, values and all.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace {

/// A folder of its own, for headers may name files beside them.
const std::string& path() {
  static const std::string instance = [] {
    char folder[] = "/tmp/stroma_fuzz_XXXXXX";
    if (mkdtemp(folder) == nullptr) std::abort();
    return std::string(folder) + "/image";
  }();
  return instance;
}

/// By its first byte, without MPI.
std::unique_ptr<stroma::image::ImageSource> open(const stroma::image::ImageRequest& request,
                                                 std::uint8_t first) {
  if (first == 'N') return stroma::image::open_nrrd(request);
  const bool text = first >= ' ' && first < 0x7f && first != 0x5c;  // 0x5c: of 348
  return text ? stroma::image::open_metaimage(request) : stroma::image::open_nifti(request);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace stroma;
  if (size == 0) return 0;
  std::ofstream(path(), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  image::ImageRequest request;
  request.path = path();
  try {
    const auto source = open(request, bytes[0]);
    const auto& count = source->summary().file_size;
    voxels::Box box{{0, 0, 0}, {count[0], count[1], 1}};
    box.first[2] = count[2] - 1;
    std::vector<double> values(static_cast<std::size_t>(box.voxels()));
    source->read(box, values.data());
  } catch (const base::InputError&) {
  }
  return 0;
}
