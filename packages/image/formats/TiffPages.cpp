// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/TiffPages.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/TiffDirectory.hpp"

namespace stroma::image {
namespace {

std::string last_reason;  // libtiff's handlers are global, so this is

void keep_reason(const char* module, const char* pattern, va_list arguments) {
  char text[512];
  std::vsnprintf(text, sizeof text, pattern, arguments);
  last_reason = (module ? std::string(module) + ": " : std::string()) + text;
}

/// A page of colours that are no intensities, or of values that are no numbers of use here.
std::string trouble_with(int format, int bits, int photometric, int compression) {
  const bool whole = format != SAMPLEFORMAT_IEEEFP;
  if (format == SAMPLEFORMAT_COMPLEXINT || format == SAMPLEFORMAT_COMPLEXIEEEFP)
    return "holds complex numbers";
  const bool bytes = bits == 8 || bits == 16 || bits == 32 || bits == 64;
  const bool packed = bits >= 1 && bits <= 15 && format != SAMPLEFORMAT_INT;
  if (whole ? !bytes && !packed : !bytes || bits == 8)
    return base::format("holds %s of %d bits", whole ? "integers" : "floats", bits);
  if (photometric == PHOTOMETRIC_YCBCR || photometric == PHOTOMETRIC_CIELAB)
    return "holds colours as YCbCr or CIELab";
  if (!TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression)))
    return base::format("is compressed by method %d, which the TIFF library here does not know",
                        compression);
  return "";
}

/// Values of 1 to 15 bits, packed from the highest bit of each byte on.
void decode_packed(const unsigned char* row, int bits, std::int64_t first, std::int64_t count,
                   std::int64_t stride, double* values) {
  for (std::int64_t i = 0; i < count; ++i) {
    unsigned value = 0;
    for (std::int64_t bit = (first + i * stride) * bits, end = bit + bits; bit < end; ++bit)
      value = value << 1 | (row[bit / 8] >> (7 - bit % 8) & 1u);
    values[i] = value;
  }
}

}  // namespace

TiffMessages::TiffMessages()
    : error_(TIFFSetErrorHandler(keep_reason)), warning_(TIFFSetWarningHandler(nullptr)) {
  last_reason.clear();
}

TiffMessages::~TiffMessages() {
  TIFFSetErrorHandler(error_);
  TIFFSetWarningHandler(warning_);
}

double largest_expansion_of(const TiffPage& page) {
  switch (page.compression) {
    case COMPRESSION_NONE:
      return 1.0;
    case COMPRESSION_PACKBITS:  // 128 values from two bytes
      return 64.0;
    case COMPRESSION_LZW:  // 12 bits stand for at most 4,096 values
      return 4096.0;
    case COMPRESSION_DEFLATE:  // 258 values from two bits
    case COMPRESSION_ADOBE_DEFLATE:
      return 1032.0;
    case COMPRESSION_JPEG:  // 64 values from two bits, or a bit in progressive files
      return 1024.0;
    case COMPRESSION_LZMA:  // 273 values from 14 decisions of 1/46 bit
      return 8192.0;
    case COMPRESSION_ZSTD:  // a block of 128 KB from four bytes
      return 32768.0;
    case COMPRESSION_CCITTRLE:  // a row from a bit
    case COMPRESSION_CCITTFAX3:
    case COMPRESSION_CCITTFAX4:
      return 8.0 * std::max(1.0, static_cast<double>(page.width) / 8.0);
    default:
      return std::numeric_limits<double>::infinity();
  }
}

std::string TiffMessages::reason() { return last_reason.empty() ? "" : " (" + last_reason + ")"; }

TiffPages::TiffPages(const std::string& path)
    : path_(path), length_(std::filesystem::file_size(path)) {
  const TiffMessages messages;
  // Without a memory map (m): a file that shrinks while it is read is then an error, not a signal.
  file_.reset(TIFFOpen(path.c_str(), "rm"));
  if (!file_) refuse(path, "is a broken TIFF file" + TiffMessages::reason());
  swapped_ = TIFFIsByteSwapped(file_.get()) != 0;
  read_directories();
  read_tags();
}

void TiffPages::read_directories() {
  do {
    pages_.push_back(describe_page());
  } while (TIFFReadDirectory(file_.get()));
  if (!last_reason.empty()) {
    refuse(path_, base::format("is a broken or truncated TIFF file: page %zu cannot be read",
                               pages_.size()) +
                      TiffMessages::reason());
  }
  if (pages_.empty()) refuse(path_, "is a TIFF file without a page");
}

std::vector<TiffPage> TiffPages::leave_out_extras() {
  std::vector<TiffPage> kept, out;
  for (const TiffPage& page : pages_) (page.is_extra ? out : kept).push_back(page);
  if (kept.empty()) return {};
  pages_ = std::move(kept);
  return out;
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
  std::uint32_t depth = 1;
  TIFFGetFieldDefaulted(file, TIFFTAG_IMAGEDEPTH, &depth);
  page.width = width;
  page.height = height;
  page.depth = depth;
  page.samples = samples;
  page.samples_apart = planar == PLANARCONFIG_SEPARATE && samples > 1;
  page.tiled = TIFFIsTiled(file) != 0;
  page.compression = compression;
  page.photometric = photometric;

  page.bits = bits;
  page.type.bytes = bits <= 8 ? 1 : bits < 16 ? 2 : bits / 8;
  page.type.kind = format == SAMPLEFORMAT_INT      ? ValueType::Kind::signed_integer
                   : format == SAMPLEFORMAT_IEEEFP ? ValueType::Kind::floating
                                                   : ValueType::Kind::unsigned_integer;
  std::uint32_t subfile = 0;
  TIFFGetFieldDefaulted(file, TIFFTAG_SUBFILETYPE, &subfile);
  page.is_extra = (subfile & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0;
  std::uint16_t fill_order = FILLORDER_MSB2LSB;
  TIFFGetFieldDefaulted(file, TIFFTAG_FILLORDER, &fill_order);
  page.bits_reversed = fill_order == FILLORDER_LSB2MSB;
  page.trouble = trouble_with(format, bits, photometric, compression);
  return page;
}

void TiffPages::read_tags() {
  const auto own = std::find_if(pages_.begin(), pages_.end(),
                                [](const TiffPage& page) { return !page.is_extra; });
  const auto first = own == pages_.end() ? pages_.begin() : own;
  go_to(static_cast<std::size_t>(first - pages_.begin()));
  const char* description = nullptr;
  if (TIFFGetField(file_.get(), TIFFTAG_IMAGEDESCRIPTION, &description) && description)
    tags_.description = description;
  std::uint16_t unit = RESUNIT_INCH;
  TIFFGetFieldDefaulted(file_.get(), TIFFTAG_RESOLUTIONUNIT, &unit);
  tags_.resolution_unit = unit;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
  TIFFGetFieldDefaulted(file_.get(), TIFFTAG_ORIENTATION, &orientation);
  tags_.orientation = orientation;
  TiffDirectory directory(path_, first->offset);
  const auto take = [&](std::uint16_t tag, std::optional<double>& value, double& rounding) {
    const auto [numerator, denominator] = directory.rational(tag).value_or(std::make_pair(0u, 0u));
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

TiffPages::Pieces TiffPages::pieces_of(std::size_t index) const {
  TIFF* const file = file_.get();
  const TiffPage& page = pages_[index];
  Pieces pieces;
  std::uint32_t width = static_cast<std::uint32_t>(page.width), height = 0, depth = 1;
  if (page.tiled) {
    TIFFGetField(file, TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(file, TIFFTAG_TILELENGTH, &height);
    TIFFGetFieldDefaulted(file, TIFFTAG_TILEDEPTH, &depth);
  } else {
    TIFFGetFieldDefaulted(file, TIFFTAG_ROWSPERSTRIP, &height);
    height = std::min(height, static_cast<std::uint32_t>(page.height));
  }
  pieces.width = width;
  pieces.height = height;
  pieces.depth = depth;
  const std::int64_t values = pieces.width * (page.samples_apart ? 1 : page.samples);
  pieces.row_bytes = static_cast<std::size_t>((values * page.bits + 7) / 8);
  pieces.bytes = pieces.row_bytes * static_cast<std::size_t>(pieces.height) *
                 static_cast<std::size_t>(pieces.depth);
  return pieces;
}

void TiffPages::check_pieces(std::size_t index) {
  const TiffMessages messages;
  go_to(index);
  TIFF* const file = file_.get();
  const TiffPage& page = pages_[index];
  const Pieces pieces = pieces_of(index);
  const double bytes = static_cast<double>(pieces.row_bytes) * static_cast<double>(pieces.height) *
                       static_cast<double>(pieces.depth);
  // A tile may be larger than its image, but not by much.
  const double page_bytes = static_cast<double>(page.width) * static_cast<double>(page.height) *
                            static_cast<double>(page.depth * page.samples) * page.bits / 8;
  constexpr double always_admissible = 64.0 * 1024 * 1024;
  if (bytes < 1.0 || bytes > std::max(always_admissible, 4.0 * page_bytes)) {
    refuse(path_, base::format(
                      "page %zu of %lld x %lld pixels is cut into tiles of %lld x %lld x "
                      "%lld; admissible: 64 MB, or four times the page",
                      index, static_cast<long long>(page.width),
                      static_cast<long long>(page.height), static_cast<long long>(pieces.width),
                      static_cast<long long>(pieces.height), static_cast<long long>(pieces.depth)));
  }
  const std::uint32_t count = page.tiled ? TIFFNumberOfTiles(file) : TIFFNumberOfStrips(file);
  for (std::uint32_t piece = 0; piece < count; ++piece) {
    const std::uint64_t start = TIFFGetStrileOffset(file, piece);
    const std::uint64_t stored = TIFFGetStrileByteCount(file, piece);
    if (start > length_ || stored > length_ - start) {
      refuse(path_, base::format("is truncated: page %zu reaches to byte %llu, the file has %llu",
                                 index, static_cast<unsigned long long>(start + stored),
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

void TiffPages::read_piece(std::size_t index, const Pieces& pieces, std::int64_t x, std::int64_t y,
                           std::int64_t z, std::int64_t sample, std::vector<unsigned char>& bytes) {
  TIFF* const file = file_.get();
  const TiffPage& page = pages_[index];
  const auto px = static_cast<std::uint32_t>(x), py = static_cast<std::uint32_t>(y),
             pz = static_cast<std::uint32_t>(z);
  const auto plane = static_cast<std::uint16_t>(page.samples_apart ? sample : 0);
  // The last strip is shorter; what is missing of any other is an error, not zeros.
  const std::int64_t rows =
      page.tiled ? pieces.height * pieces.depth : std::min(pieces.height, page.height - y);
  const auto expected = static_cast<tmsize_t>(static_cast<std::size_t>(rows) * pieces.row_bytes);
  const auto decode_deep_tile = [&](std::uint32_t tile) -> tmsize_t {
    // libtiff's own reader knows tiles of one plane only.
    std::vector<unsigned char> raw(TIFFGetStrileByteCount(file, tile));
    const auto length = static_cast<tmsize_t>(raw.size());
    return TIFFReadRawTile(file, tile, raw.data(), length) == length &&
                   TIFFReadFromUserBuffer(file, tile, raw.data(), length, bytes.data(), expected)
               ? expected
               : -1;
  };
  const tmsize_t got =
      !page.tiled
          ? TIFFReadEncodedStrip(file, TIFFComputeStrip(file, py, plane), bytes.data(), expected)
      : pieces.depth > 1 ? decode_deep_tile(TIFFComputeTile(file, px, py, pz, plane))
                         : TIFFReadEncodedTile(file, TIFFComputeTile(file, px, py, pz, plane),
                                               bytes.data(), expected);
  if (got < expected) {
    refuse(path_,
           base::format("page %zu is broken or truncated: its values cannot be decoded", index) +
               TiffMessages::reason());
  }
}

void TiffPages::read(std::size_t index, std::int64_t sample, const voxels::Box& box,
                     double* values) {
  const TiffMessages messages;
  go_to(index);
  const TiffPage& page = pages_[index];
  const std::int64_t stride = page.samples_apart ? 1 : page.samples;
  const std::int64_t offset = page.samples_apart ? 0 : sample;
  const Pieces pieces = pieces_of(index);
  std::vector<unsigned char> piece(pieces.bytes);

  std::array<std::int64_t, 3> end;
  for (std::size_t a = 0; a < 3; ++a) end[a] = box.first[a] + box.count[a];
  /// The values of row y of plane z that lie in the piece whose corner is at x0, y0, z0.
  const auto decode_row = [&](std::int64_t x0, std::int64_t y0, std::int64_t z0, std::int64_t y,
                              std::int64_t z) {
    const unsigned char* const row =
        piece.data() +
        static_cast<std::size_t>((z - z0) * pieces.height + (y - y0)) * pieces.row_bytes;
    const std::int64_t from = std::max(x0, box.first[0]);
    const std::int64_t count = std::min(x0 + pieces.width, end[0]) - from;
    const std::int64_t first = (from - x0) * stride + offset;
    double* const to = values +
                       ((z - box.first[2]) * box.count[1] + (y - box.first[1])) * box.count[0] +
                       (from - box.first[0]);
    if (page.bits % 8 != 0) {
      decode_packed(row, page.bits, first, count, stride, to);
    } else {
      decode(row + first * page.type.bytes, page.type, false, count, stride, to);
    }
  };
  const auto corner = [](std::int64_t first, std::int64_t size) { return first / size * size; };
  for (std::int64_t z0 = corner(box.first[2], pieces.depth); z0 < end[2]; z0 += pieces.depth) {
    for (std::int64_t y0 = corner(box.first[1], pieces.height); y0 < end[1]; y0 += pieces.height) {
      for (std::int64_t x0 = corner(box.first[0], pieces.width); x0 < end[0]; x0 += pieces.width) {
        read_piece(index, pieces, x0, y0, z0, sample, piece);
        for (std::int64_t z = std::max(z0, box.first[2]); z < std::min(z0 + pieces.depth, end[2]);
             ++z) {
          for (std::int64_t y = std::max(y0, box.first[1]);
               y < std::min(y0 + pieces.height, end[1]); ++y)
            decode_row(x0, y0, z0, y, z);
        }
      }
    }
  }
}

}  // namespace stroma::image
