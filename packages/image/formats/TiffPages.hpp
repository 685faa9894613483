// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The pages of a TIFF file, one by one, before anyone knows how they stack up to a volume.

#include <tiffio.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stroma/image/formats/ImageSummary.hpp"
#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// Keeps libtiff's messages off standard error while it lives, and the last error for ours.
class TiffMessages {
 public:
  TiffMessages();
  ~TiffMessages();
  TiffMessages(const TiffMessages&) = delete;
  TiffMessages& operator=(const TiffMessages&) = delete;
  /// ": REASON", or nothing.
  static std::string reason();

 private:
  TIFFErrorHandler error_;
  TIFFErrorHandler warning_;
};

/// One page: the values lie in strips or tiles.
struct TiffPage {
  std::uint64_t offset = 0;  ///< of its directory
  std::int64_t width = 0, height = 0;
  std::int64_t depth = 1;      ///< planes in it (ImageDepth)
  std::int64_t samples = 1;    ///< values per pixel
  bool samples_apart = false;  ///< each sample has planes of its own
  bool tiled = false;
  int compression = 1;
  int photometric = 1;
  int bits = 8;                ///< of a value, as stored
  ValueType type;              ///< of a value, as read
  std::string trouble;         ///< why it cannot be read here; empty: it can
  bool is_extra = false;       ///< a reduced image or a mask (NewSubfileType)
  bool bits_reversed = false;  ///< in each byte, as stored (FillOrder)
};

/// The most that a page's compression can gain, by the rules of its format; infinity where there is
/// no such limit.
double largest_expansion_of(const TiffPage& page);

/// What the first page says of the whole file.
struct TiffTags {
  std::string description;
  std::optional<double> pixels_per_unit_x, pixels_per_unit_y;  ///< resolution tags, exact
  double rounding_x = 0.0,
         rounding_y = 0.0;             ///< how far the tags may lie from what their writer meant
  int resolution_unit = RESUNIT_INCH;  ///< RESUNIT_NONE, RESUNIT_INCH or RESUNIT_CENTIMETER
  int orientation = ORIENTATION_TOPLEFT;
};

/// An open TIFF file.
class TiffPages {
 public:
  /// \throws base::InputError when libtiff cannot make sense of it
  explicit TiffPages(const std::string& path);

  /// All of the file's directories in their order, until extras are left out.
  const std::vector<TiffPage>& pages() const { return pages_; }
  /// Thumbnails, the lower levels of a pyramid and transparency are no planes of the volume: from now on
  /// pages are without them. \return  those left out; none where all are extras
  std::vector<TiffPage> leave_out_extras();
  const TiffTags& tags() const { return tags_; }
  std::uint64_t file_length() const { return length_; }
  bool is_swapped() const { return swapped_; }

  /// \throws base::InputError when strips or tiles of the page lie beyond the end of the file, or
  ///   are larger than what they hold, or than any use
  void check_pieces(std::size_t index);
  /// Where the values of an uncompressed page in one piece start; nothing when it is in several
  /// pieces.
  std::optional<std::uint64_t> start_of_values(std::size_t page);
  /// A box of one sample of a page, x fastest; along z, of its depth.
  /// \throws base::InputError when it cannot be decoded
  void read(std::size_t index, std::int64_t sample, const voxels::Box& box, double* values);

 private:
  struct Close {
    void operator()(TIFF* file) const { TIFFClose(file); }
  };

  /// What a page's values are cut into: its strips or tiles.
  struct Pieces {
    std::int64_t width = 0, height = 0, depth = 1;
    std::size_t row_bytes = 0, bytes = 0;  ///< of a piece's row, and of all of it, decoded
  };

  void read_directories();
  void read_tags();
  TiffPage describe_page();
  void go_to(std::size_t page);
  Pieces pieces_of(std::size_t index) const;
  /// Decodes the piece that holds a pixel of a plane, and as much of it as the page has.
  void read_piece(std::size_t index, const Pieces& pieces, std::int64_t x, std::int64_t y,
                  std::int64_t z, std::int64_t sample, std::vector<unsigned char>& bytes);

  std::string path_;
  std::uint64_t length_ = 0;
  bool swapped_ = false;
  std::unique_ptr<TIFF, Close> file_;
  std::vector<TiffPage> pages_;
  TiffTags tags_;
};

}  // namespace stroma::image
