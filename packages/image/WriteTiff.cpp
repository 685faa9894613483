#include "image/WriteTiff.hpp"

#include <tiffio.h>

#include <memory>

#include "base/Error.hpp"
#include "base/Log.hpp"
#include "image/TiffPages.hpp"

namespace stroma::image {
namespace {

struct Close {
  void operator()(TIFF* file) const { TIFFClose(file); }
};

/// ImageJ's description of a stack of `planes` pages.
std::string imagej_description(std::int64_t planes, double spacing) {
  return base::format(
      "ImageJ=1.53t\nimages=%lld\nslices=%lld\nunit=micron\nspacing=%.9g\nloop=false\n",
      static_cast<long long>(planes), static_cast<long long>(planes), spacing);
}

template <class T>
void write_page(TIFF* file, const Volume<T>& volume, std::int64_t index,
                const std::vector<T>& plane) {
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(volume.size[0]));
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(volume.size[1]));
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(volume.size[1]));
  TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
  TIFFSetField(file, TIFFTAG_XRESOLUTION, 1.0 / volume.voxel_size[0]);
  TIFFSetField(file, TIFFTAG_YRESOLUTION, 1.0 / volume.voxel_size[1]);
  if (index == 0)
    TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION,
                 imagej_description(volume.size[2], volume.voxel_size[2]).c_str());
  const auto bytes = static_cast<tmsize_t>(plane.size());
  const bool done = TIFFWriteEncodedStrip(file, 0, const_cast<T*>(plane.data()), bytes) == bytes &&
                    TIFFWriteDirectory(file) == 1;
  if (!done) throw base::InputError("plane cannot be written" + TiffMessages::reason());
}

}  // namespace

void write_tiff(const base::Communicator& communicator, const std::string& path,
                const Volume<std::uint8_t>& volume) {
  const TiffMessages messages;
  std::unique_ptr<TIFF, Close> file;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    const bool big = static_cast<double>(volume.voxels()) > 4.0e9;
    file.reset(TIFFOpen(path.c_str(), big ? "w8" : "w"));
    if (!file) throw base::InputError(path + ": cannot be written" + TiffMessages::reason());
  });
  std::string trouble;
  for (std::int64_t k = 0; k < volume.size[2]; ++k) {
    Box plane{{0, 0, k}, {volume.size[0], volume.size[1], communicator.is_root() ? 1 : 0}};
    const std::vector<std::uint8_t> values = extract(communicator, volume, plane);
    if (!communicator.is_root() || !trouble.empty()) continue;
    try {
      write_page(file.get(), volume, k, values);
    } catch (const base::InputError& error) {
      trouble = error.what();
    }
  }
  base::collectively(communicator, [&] {
    if (!trouble.empty()) throw base::InputError(path + ": " + trouble);
    if (file && TIFFFlush(file.get()) != 1)
      throw base::InputError(path + ": cannot be written" + TiffMessages::reason());
  });
}

}  // namespace stroma::image
