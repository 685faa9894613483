#include "image/TiffPages.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/Log.hpp"
#include "image/ImageSource.hpp"

namespace stroma::image {
namespace {

std::string last_reason;  // libtiff's handlers are global, so this is

void keep_reason(const char* module, const char* pattern, va_list arguments) {
  char text[512];
  std::vsnprintf(text, sizeof text, pattern, arguments);
  last_reason = (module ? std::string(module) + ": " : std::string()) + text;
}

/// Reads unsigned integers of a TIFF directory in the file's byte order.
class DirectoryReader {
 public:
  DirectoryReader(const std::string& path, std::uint64_t offset) : file_(path, std::ios::binary) {
    char head[4] = {};
    file_.read(head, 4);
    big_endian_ = head[0] == 'M';
    big_tiff_ = (head[2] + head[3]) == 43;
    file_.seekg(static_cast<std::streamoff>(offset));
  }

  std::uint64_t integer(int bytes) {
    unsigned char raw[8] = {};
    file_.read(reinterpret_cast<char*>(raw), bytes);
    if (!big_endian_) std::reverse(raw, raw + bytes);
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | raw[i];
    return value;
  }

  /// The two integers of a rational tag; 0/0 when the directory has none.
  std::pair<std::uint32_t, std::uint32_t> rational(std::uint16_t tag) {
    const std::uint64_t entries = integer(big_tiff_ ? 8 : 2);
    for (std::uint64_t i = 0; i < entries && file_; ++i) {
      const std::uint64_t entry_tag = integer(2);
      const std::uint64_t type = integer(2);
      integer(big_tiff_ ? 8 : 4);  // count
      if (entry_tag != tag || type != TIFF_RATIONAL) {
        integer(big_tiff_ ? 8 : 4);
        continue;
      }
      // A rational takes 8 bytes: in place in a BigTIFF, elsewhere in a classic one.
      if (!big_tiff_) file_.seekg(static_cast<std::streamoff>(integer(4)));
      const auto numerator = static_cast<std::uint32_t>(integer(4));
      const auto denominator = static_cast<std::uint32_t>(integer(4));
      if (file_) return {numerator, denominator};
    }
    return {0, 0};
  }

 private:
  std::ifstream file_;
  bool big_endian_ = false;
  bool big_tiff_ = false;
};

}  // namespace

TiffMessages::TiffMessages()
    : error_(TIFFSetErrorHandler(keep_reason)), warning_(TIFFSetWarningHandler(nullptr)) {
  last_reason.clear();
}

TiffMessages::~TiffMessages() {
  TIFFSetErrorHandler(error_);
  TIFFSetWarningHandler(warning_);
}

std::string TiffMessages::reason() { return last_reason.empty() ? "" : " (" + last_reason + ")"; }

TiffPages::TiffPages(const std::string& path)
    : path_(path), length_(std::filesystem::file_size(path)) {
  const TiffMessages messages;
  file_.reset(TIFFOpen(path.c_str(), "r"));
  if (!file_) refuse(path, "is a broken TIFF file" + TiffMessages::reason());
  swapped_ = TIFFIsByteSwapped(file_.get()) != 0;
  read_directories();
  read_tags();
}

void TiffPages::read_directories() {
  do {
    std::uint32_t subfile = 0;
    TIFFGetFieldDefaulted(file_.get(), TIFFTAG_SUBFILETYPE, &subfile);
    // Thumbnails and the lower levels of a pyramid are no planes of the volume.
    if (subfile & FILETYPE_REDUCEDIMAGE) continue;
    pages_.push_back(describe_page());
  } while (TIFFReadDirectory(file_.get()));
  if (!last_reason.empty()) {
    refuse(path_, base::format("is a broken or truncated TIFF file: page %zu cannot be read",
                               pages_.size()) +
                      TiffMessages::reason());
  }
  if (pages_.empty()) refuse(path_, "is a TIFF file without a page");
}

TiffPage TiffPages::describe_page() {
  TIFF* const file = file_.get();
  TiffPage page;
  page.offset = TIFFCurrentDirOffset(file);
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, samples = 1, planar = PLANARCONFIG_CONTIG, format = SAMPLEFORMAT_UINT;
  std::uint16_t compression = COMPRESSION_NONE, photometric = PHOTOMETRIC_MINISBLACK;
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &planar);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetFieldDefaulted(file, TIFFTAG_COMPRESSION, &compression);
  TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &photometric);
  page.width = width;
  page.height = height;
  page.samples = samples;
  page.samples_apart = planar == PLANARCONFIG_SEPARATE && samples > 1;
  page.tiled = TIFFIsTiled(file) != 0;
  page.compression = compression;
  page.photometric = photometric;

  using Kind = ValueType::Kind;
  page.type.bytes = bits / 8;
  if (format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID) {
    page.type.kind = Kind::unsigned_integer;
  } else if (format == SAMPLEFORMAT_INT) {
    page.type.kind = Kind::signed_integer;
  } else if (format == SAMPLEFORMAT_IEEEFP) {
    page.type.kind = Kind::floating;
  } else {
    page.trouble = "holds complex numbers";
  }
  const bool floats = page.type.kind == Kind::floating;
  const bool admissible = floats ? bits == 32 || bits == 64 : bits == 8 || bits == 16 || bits == 32;
  if (page.trouble.empty() && !admissible)
    page.trouble = base::format("holds %s of %d bits", floats ? "floats" : "integers", bits);
  if (photometric == PHOTOMETRIC_YCBCR || photometric == PHOTOMETRIC_CIELAB)
    page.trouble = "holds colours as YCbCr or CIELab";
  if (!TIFFIsCODECConfigured(compression))
    page.trouble = base::format(
        "is compressed by method %d, which the TIFF library here does not know", compression);
  return page;
}

void TiffPages::read_tags() {
  go_to(0);
  const char* description = nullptr;
  if (TIFFGetField(file_.get(), TIFFTAG_IMAGEDESCRIPTION, &description) && description)
    tags_.description = description;
  std::uint16_t unit = RESUNIT_INCH;
  TIFFGetFieldDefaulted(file_.get(), TIFFTAG_RESOLUTIONUNIT, &unit);
  tags_.resolution_unit = unit;
  const auto take = [&](std::uint16_t tag, std::optional<double>& value, double& rounding) {
    const auto [numerator, denominator] = DirectoryReader(path_, pages_[0].offset).rational(tag);
    if (numerator == 0 || denominator == 0) return;
    value = static_cast<double>(numerator) / denominator;
    // Some writers keep a decimal over 10^6 or so, others turn a float into a fraction.
    const double step = denominator >= 10000 ? 0.5 / denominator : 0.0;
    rounding = std::max(1.0000001 * step, 6.0e-8 * *value);
  };
  take(TIFFTAG_XRESOLUTION, tags_.pixels_per_unit_x, tags_.rounding_x);
  take(TIFFTAG_YRESOLUTION, tags_.pixels_per_unit_y, tags_.rounding_y);
}

void TiffPages::go_to(std::size_t page) {
  if (TIFFCurrentDirOffset(file_.get()) == pages_[page].offset) return;
  if (!TIFFSetSubDirectory(file_.get(), pages_[page].offset))
    refuse(path_, base::format("page %zu cannot be read", page) + TiffMessages::reason());
}

void TiffPages::check_extent(std::size_t page) {
  const TiffMessages messages;
  go_to(page);
  TIFF* const file = file_.get();
  const std::uint32_t pieces =
      pages_[page].tiled ? TIFFNumberOfTiles(file) : TIFFNumberOfStrips(file);
  for (std::uint32_t piece = 0; piece < pieces; ++piece) {
    const std::uint64_t end =
        TIFFGetStrileOffset(file, piece) + TIFFGetStrileByteCount(file, piece);
    if (end > length_) {
      refuse(path_, base::format("is truncated: page %zu reaches to byte %llu, the file has %llu",
                                 page, static_cast<unsigned long long>(end),
                                 static_cast<unsigned long long>(length_)));
    }
  }
}

std::optional<std::uint64_t> TiffPages::start_of_values(std::size_t page) {
  const TiffMessages messages;
  go_to(page);
  if (pages_[page].compression != COMPRESSION_NONE || pages_[page].tiled) return std::nullopt;
  const std::uint32_t strips = TIFFNumberOfStrips(file_.get());
  const std::uint64_t first = TIFFGetStrileOffset(file_.get(), 0);
  std::uint64_t next = first;
  for (std::uint32_t strip = 0; strip < strips; ++strip) {
    if (TIFFGetStrileOffset(file_.get(), strip) != next) return std::nullopt;
    next += TIFFGetStrileByteCount(file_.get(), strip);
  }
  return first;
}

void TiffPages::read(std::size_t index, std::int64_t sample, std::int64_t first_column,
                     std::int64_t columns, std::int64_t first_row, std::int64_t rows,
                     double* values) {
  const TiffMessages messages;
  go_to(index);
  TIFF* const file = file_.get();
  const TiffPage& page = pages_[index];
  const std::int64_t stride = page.samples_apart ? 1 : page.samples;
  const std::int64_t offset = page.samples_apart ? 0 : sample;
  const auto plane = static_cast<std::uint16_t>(page.samples_apart ? sample : 0);

  std::uint32_t piece_width = static_cast<std::uint32_t>(page.width), piece_height = 0;
  if (page.tiled) {
    TIFFGetField(file, TIFFTAG_TILEWIDTH, &piece_width);
    TIFFGetField(file, TIFFTAG_TILELENGTH, &piece_height);
  } else {
    TIFFGetFieldDefaulted(file, TIFFTAG_ROWSPERSTRIP, &piece_height);
    piece_height = std::min(piece_height, static_cast<std::uint32_t>(page.height));
  }
  const auto piece_bytes =
      static_cast<std::size_t>(page.tiled ? TIFFTileSize64(file) : TIFFStripSize64(file));
  std::vector<unsigned char> piece(piece_bytes);

  const std::int64_t last_row = first_row + rows, last_column = first_column + columns;
  for (std::int64_t y = first_row / piece_height * piece_height; y < last_row; y += piece_height) {
    for (std::int64_t x = first_column / piece_width * piece_width; x < last_column;
         x += piece_width) {
      const auto px = static_cast<std::uint32_t>(x), py = static_cast<std::uint32_t>(y);
      // The last strip is shorter; what is missing of any other is an error, not zeros.
      const std::int64_t piece_rows =
          page.tiled ? piece_height : std::min<std::int64_t>(piece_height, page.height - y);
      const std::int64_t expected = piece_rows * piece_width * stride * page.type.bytes;
      const tmsize_t got =
          page.tiled
              ? TIFFReadEncodedTile(file, TIFFComputeTile(file, px, py, 0, plane), piece.data(), -1)
              : TIFFReadEncodedStrip(file, TIFFComputeStrip(file, py, plane), piece.data(), -1);
      if (got < expected) {
        refuse(path_, base::format("page %zu is broken or truncated: its values cannot be decoded",
                                   index) +
                          TiffMessages::reason());
      }
      const std::int64_t from = std::max(x, first_column);
      const std::int64_t to = std::min<std::int64_t>(x + piece_width, last_column);
      for (std::int64_t row = std::max(y, first_row); row < std::min(y + piece_rows, last_row);
           ++row) {
        const std::int64_t value = ((row - y) * piece_width + (from - x)) * stride + offset;
        decode(piece.data() + value * page.type.bytes, page.type, false, to - from, stride,
               values + (row - first_row) * columns + (from - first_column));
      }
    }
  }
}

}  // namespace stroma::image
