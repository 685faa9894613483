// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/WriteTiff.hpp"

#include <tiffio.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <type_traits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/formats/TiffDraft.hpp"
#include "stroma/image/formats/TiffPages.hpp"

namespace stroma::image {
namespace {

/// ImageJ's description of a stack of `planes` pages.
std::string imagej_description(std::int64_t planes, double spacing) {
  return base::format(
      "ImageJ=1.53t\nimages=%lld\nslices=%lld\nunit=micron\nspacing=%.9g\nloop=false\n",
      static_cast<long long>(planes), static_cast<long long>(planes), spacing);
}

/// \return whether it could be written
template <class T>
bool write_page(TIFF* file, const voxels::Volume<T>& volume, std::int64_t index,
                const std::vector<T>& plane) {
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(volume.size[0]));
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(volume.size[1]));
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * sizeof(T)));
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT,
               std::is_floating_point_v<T> ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(volume.size[1]));
  TIFFSetField(file, TIFFTAG_SOFTWARE, stroma_software);
  TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
  TIFFSetField(file, TIFFTAG_XRESOLUTION, 1.0 / volume.voxel_size[0]);
  TIFFSetField(file, TIFFTAG_YRESOLUTION, 1.0 / volume.voxel_size[1]);
  if (index == 0)
    TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION,
                 imagej_description(volume.size[2], volume.voxel_size[2]).c_str());
  const auto bytes = static_cast<tmsize_t>(plane.size() * sizeof(T));
  return TIFFWriteEncodedStrip(file, 0, const_cast<T*>(plane.data()), bytes) == bytes &&
         TIFFWriteDirectory(file) == 1;
}

}  // namespace

template <class T>
void write_tiff(const base::Communicator& communicator, const std::string& path,
                const voxels::Volume<T>& volume) {
  const TiffMessages messages;
  std::optional<TiffDraft> draft;
  base::collectively(communicator, [&] {
    if (communicator.is_root())
      draft.emplace(path, path + "." + std::to_string(getpid()) + ".part",
                    static_cast<double>(volume.voxels()) * sizeof(T) > 4.0e9);
  });
  bool is_written = true;
  for (std::int64_t k = 0; k < volume.size[2]; ++k) {
    voxels::Box plane{{0, 0, k}, {volume.size[0], volume.size[1], communicator.is_root() ? 1 : 0}};
    const std::vector<T> values = voxels::extract(communicator, volume, plane);
    if (communicator.is_root() && is_written)
      is_written = write_page(draft->file(), volume, k, values);
  }
  base::collectively(communicator, [&] {
    if (!draft) return;
    if (!is_written) draft->fail();
    draft->close();
    draft->rename();
  });
}

template void write_tiff(const base::Communicator&, const std::string&,
                         const voxels::Volume<std::uint8_t>&);
template void write_tiff(const base::Communicator&, const std::string&,
                         const voxels::Volume<float>&);

bool is_written_by_stroma(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  const TiffMessages messages;
  const TiffFile file(TIFFOpen(path.c_str(), "rm"));
  const char* software = nullptr;
  return file && TIFFGetField(file.get(), TIFFTAG_SOFTWARE, &software) == 1 &&
         std::string(software) == stroma_software;
}

}  // namespace stroma::image
