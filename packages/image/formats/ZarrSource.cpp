// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Volumes in folders of Zarr, read chunk by chunk: the finest level of an OME-Zarr, or an array by
/// itself. Each rank reads the files itself.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/formats/HeaderText.hpp"
#include "stroma/image/formats/ImageSource.hpp"
#include "stroma/image/formats/LengthUnit.hpp"
#include "stroma/image/formats/VolumeHeader.hpp"
#include "stroma/image/formats/WholeNumber.hpp"
#include "stroma/image/formats/ZarrHeader.hpp"

namespace stroma::image {
namespace {

namespace fs = std::filesystem;

/// A chunk is unpacked as a whole; one larger than this and than the whole array is a mistake.
constexpr double large_chunk_bytes = 64.0 * 1024 * 1024;
/// An array of which less than this share of the chunks was ever written is a broken header.
constexpr double least_written = 1e-5;
/// What packing may add to a chunk.
constexpr double largest_overhead = 65536.0;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// A small text file; empty where there is none.
std::string text_of(const std::string& folder, const char* name) {
  const fs::path path = fs::path(folder) / name;
  if (!is_file(path)) return "";
  std::error_code ignored;
  if (fs::file_size(path, ignored) > longest_header)
    refuse(folder, std::string("its ") + name + " is larger than any header");
  return base::file_content(path.string());
}

class ZarrSource : public ImageSource {
 public:
  explicit ZarrSource(const ImageRequest& request) : folder_(request.path) {
    summary_.path = request.path;
    std::string attributes = text_of(folder_, ".zattrs");
    if (!attributes.empty() && is_zarr_series(attributes)) {
      std::error_code ignored;
      if (fs::is_directory(fs::path(folder_) / "1", ignored))
        summary_.notes.push_back("the folder holds several images (series); the first is read");
      folder_ += "/0";
      attributes = text_of(folder_, ".zattrs");
    }
    std::optional<ZarrImage> image;
    if (!attributes.empty()) image = zarr_image(summary_.path, attributes);
    summary_.format = "Zarr";
    if (image) {
      summary_.format = "OME-Zarr" + (image->version.empty() ? "" : " " + image->version);
      choose_level(*image);
      if (image->images > 1)
        summary_.notes.push_back(
            base::format("its multiscales are of %zu images; the first is read", image->images));
    }
    const std::string header = text_of(folder_, ".zarray");
    if (header.empty()) refuse_kind();
    array_ = zarr_array(summary_.path, header);
    summary_.type = array_.type;
    if (!image && !attributes.empty())
      axes_ = array_axes(summary_.path, attributes, summary_.notes);
    take_axes(request);
    check_storage();
  }

  void read(const voxels::Box& box, double* values) override {
    const std::size_t dimensions = array_.shape.size();
    std::vector<std::int64_t> first(dimensions, 0), count(dimensions, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (space_[axis] < 0) continue;
      first[static_cast<std::size_t>(space_[axis])] = box.first[axis];
      count[static_cast<std::size_t>(space_[axis])] = box.count[axis];
    }
    if (channel_ >= 0) first[static_cast<std::size_t>(channel_)] = summary_.channel;
    if (time_ >= 0) first[static_cast<std::size_t>(time_)] = summary_.frame;
    // Chunks from the one with the first value to the one with the last, the last dimension fastest.
    std::vector<std::int64_t> chunk(dimensions), begin(dimensions), end(dimensions);
    for (std::size_t d = 0; d < dimensions; ++d) {
      begin[d] = chunk[d] = first[d] / array_.chunk[d];
      end[d] = (first[d] + count[d] - 1) / array_.chunk[d] + 1;
    }
    std::vector<unsigned char> bytes(static_cast<std::size_t>(array_.chunk_bytes()));
    for (bool is_more = true; is_more;) {
      copy(load(chunk, bytes), bytes, chunk, first, box, values);
      is_more = false;
      for (std::size_t d = dimensions; d-- > 0 && !is_more;) {
        is_more = ++chunk[d] < end[d];
        if (!is_more) chunk[d] = begin[d];
      }
    }
  }

 private:
  [[noreturn]] void refuse_kind() const {
    if (is_file(fs::path(folder_) / "zarr.json"))
      refuse(summary_.path, "is Zarr of format 3; admissible: format 2, as of OME-Zarr 0.4");
    refuse(summary_.path, "holds no image: there is no .zarray in " +
                              (folder_ == summary_.path ? "it" : "'" + folder_ + "'") +
                              "; admissible: the folder of an OME-Zarr image, or of a Zarr array");
  }

  /// The finest level is the first, or that of which the array has the most values: a wrong order
  /// would otherwise be a coarse image without a word.
  void choose_level(const ZarrImage& image) {
    std::size_t finest = 0;
    double most = values_of(image.levels.front());
    for (std::size_t level = 1; level < image.levels.size(); ++level) {
      const double values = values_of(image.levels[level]);
      if (most == 0.0 || values <= most) continue;
      finest = level;
      most = values;
    }
    const ZarrLevel& chosen = image.levels[finest];
    if (finest > 0)
      summary_.notes.push_back("its levels are not ordered from the finest on: \"" +
                               printable(chosen.array) + "\" has more values than the first, \"" +
                               printable(image.levels.front().array) + "\", and is read");
    summary_.dataset = chosen.array;
    folder_ += "/" + chosen.array;
    axes_ = chosen.axes;
  }

  /// 0 where the level's array is not there, or has no header that can be read.
  double values_of(const ZarrLevel& level) const {
    try {
      const std::string header = text_of(folder_ + "/" + level.array, ".zarray");
      return header.empty() ? 0.0 : zarr_array(summary_.path, header).values();
    } catch (const base::InputError&) {
      return 0.0;  // told if it is the level that is read
    }
  }

  [[noreturn]] void refuse_axes(const std::string& keys, const char* what) const {
    refuse(summary_.path, "its axes \"" + keys + "\" " + what +
                              "; admissible: x and y, and z, c and t where it has them, each once, "
                              "one for each dimension of the array");
  }

  void take_axes(const ImageRequest& request) {
    const std::size_t dimensions = array_.shape.size();
    if (axes_.empty()) {
      if (dimensions < 2 || dimensions > 5)
        refuse(summary_.path,
               base::format("its array has %zu dimensions; admissible: 2 to 5", dimensions));
      const std::string usual = std::string("tczyx").substr(5 - dimensions);
      for (const char key : usual) axes_.push_back({key, "", 0.0});
      summary_.notes.push_back("its axes are not stated; read as " + usual);
    }
    std::string keys;
    for (const ZarrAxis& axis : axes_) keys += axis.key;
    if (axes_.size() != dimensions) refuse_axes(keys, "do not fit its array");
    int* const dimension_of[] = {&space_[0], &space_[1], &space_[2], &channel_, &time_};
    for (std::size_t d = 0; d < dimensions; ++d) {
      const std::size_t place = std::string("xyzct").find(keys[d]);
      if (place == std::string::npos) {
        if (array_.shape[d] == 1) continue;  // whatever it means, there is one of it
        refuse_axes(keys, "name an axis of several entries otherwise");
      }
      int& axis = *dimension_of[place];
      if (axis >= 0) refuse_axes(keys, "name an axis twice");
      axis = static_cast<int>(d);
    }
    if (space_[0] < 0 || space_[1] < 0) refuse_axes(keys, "name no x or no y");
    const auto extent = [&](int d) {
      return d < 0 ? std::int64_t{1} : array_.shape[static_cast<std::size_t>(d)];
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      summary_.file_size[axis] = extent(space_[axis]);
      if (space_[axis] >= 0)
        take_length(static_cast<int>(axis), axes_[static_cast<std::size_t>(space_[axis])]);
    }
    summary_.channels = extent(channel_);
    summary_.frames = extent(time_);
    summary_.channel = request.channel;
    summary_.frame = request.frame;
    check_channel(summary_.path, request.channel, summary_.channels);
    check_frame(summary_.path, request.frame, summary_.frames);
  }

  void take_length(int axis, const ZarrAxis& stated) {
    if (stated.scale == 0.0) return;
    const auto um = micrometres_per(stated.unit);
    if (um && stated.scale > 0.0 && std::isfinite(stated.scale * *um)) {
      summary_.voxel_size.set(axis, stated.scale * *um, "OME-Zarr scale");
      return;
    }
    summary_.notes.push_back(
        base::format("its scale along %c, %g %s, is no length; not used", "xyz"[axis], stated.scale,
                     stated.unit.empty() ? "without a unit" : stated.unit.c_str()));
  }

  /// Whether a path in the array's folder is the name of one of its chunks.
  bool is_chunk(const std::string& name, char separator) const {
    std::size_t at = 0;
    for (std::size_t d = 0; d < array_.shape.size(); ++d) {
      const bool is_last = d + 1 == array_.shape.size();
      const std::size_t end = is_last ? name.size() : name.find(separator, at);
      if (end == std::string::npos) return false;
      const auto number = whole_number(name.substr(at, end - at));
      if (!number || *number < 0 || *number * array_.chunk[d] >= array_.shape[d]) return false;
      at = end + 1;
    }
    return true;
  }

  double chunks_named_by(char separator) const {
    double count = 0.0;
    std::error_code trouble;
    for (fs::recursive_directory_iterator entry(folder_, trouble), end; !trouble && entry != end;
         entry.increment(trouble))
      if (is_file(entry->path()) &&
          is_chunk(entry->path().lexically_relative(folder_).generic_string(), separator))
        ++count;
    return count;
  }

  void check_storage() {
    double chunks = 1.0;
    for (std::size_t d = 0; d < array_.shape.size(); ++d)
      chunks *=
          std::ceil(static_cast<double>(array_.shape[d]) / static_cast<double>(array_.chunk[d]));
    const double bytes = array_.values() * array_.type.bytes;
    if (array_.chunk_bytes() > std::max(large_chunk_bytes, bytes))
      refuse(summary_.path,
             base::format("its array of %.0f bytes has chunks of %.0f bytes (broken)", bytes,
                          array_.chunk_bytes()));
    double written = chunks_named_by(array_.separator);
    const char other = array_.separator == '.' ? '/' : '.';
    const double written_otherwise =
        written == 0.0 && array_.shape.size() > 1 ? chunks_named_by(other) : 0.0;
    if (written_otherwise > 0.0) {
      summary_.notes.push_back(base::format(
          "the numbers in its chunks' names are parted by '%c', not by '%c' as its header has it",
          other, array_.separator));
      array_.separator = other;
      written = written_otherwise;
    }
    if (written < least_written * chunks || written == 0.0)
      refuse(summary_.path, base::format("says that it has %.0f chunks, of which %.0f were ever "
                                         "written (broken, or not copied as a whole)",
                                         chunks, written));
    if (written < chunks)
      summary_.notes.push_back(
          base::format("%.0f of the %.0f chunks were never written; they hold its fill value, %g",
                       chunks - written, chunks, array_.fill));
  }

  /// Unpacks a chunk. \return  false where it was never written
  bool load(const std::vector<std::int64_t>& chunk, std::vector<unsigned char>& bytes) const {
    std::string name;
    for (const std::int64_t number : chunk)
      name += (name.empty() ? "" : std::string(1, array_.separator)) + std::to_string(number);
    const fs::path path = fs::path(folder_) / name;
    std::error_code missing;
    if (!fs::exists(path, missing)) return false;
    if (!is_file(path)) refuse_chunk(name, "is no file");
    const std::uintmax_t size = fs::file_size(path, missing);
    if (static_cast<double>(size) > 1.1 * array_.chunk_bytes() + largest_overhead)
      refuse_chunk(name, base::format("has %llu bytes, more than packing makes of %.0f",
                                      static_cast<unsigned long long>(size), array_.chunk_bytes()));
    Bytes packed(static_cast<std::size_t>(size));
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
    if (!file) refuse_chunk(name, "cannot be read");
    const std::string wrong = unpack(packed, array_.compression, bytes.data(), bytes.size());
    if (!wrong.empty()) refuse_chunk(name, wrong);
    return true;
  }
  [[noreturn]] void refuse_chunk(const std::string& name, const std::string& what) const {
    refuse(summary_.path,
           "its chunk " + name + " of level \"" + summary_.dataset + "\" " + what + " (broken)");
  }

  /// Copies what a chunk and a box share, row by row along x.
  void copy(bool is_written, const std::vector<unsigned char>& bytes,
            const std::vector<std::int64_t>& chunk, const std::vector<std::int64_t>& first,
            const voxels::Box& box, double* values) const {
    const std::size_t dimensions = array_.shape.size();
    std::vector<std::int64_t> stride(dimensions, 1);
    for (std::size_t n = 1; n < dimensions; ++n) {
      const std::size_t d = array_.is_columnar ? n : dimensions - 1 - n;
      const std::size_t faster = array_.is_columnar ? d - 1 : d + 1;
      stride[d] = stride[faster] * array_.chunk[faster];
    }
    std::int64_t start = 0;  // of values that have one place along channel and time
    for (std::size_t d = 0; d < dimensions; ++d)
      if (!is_space(d)) start += (first[d] - chunk[d] * array_.chunk[d]) * stride[d];
    struct Span {
      std::int64_t begin = 0, end = 1, origin = 0, step = 0;  // in the image; of the chunk
    };
    std::array<Span, 3> span;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (space_[axis] < 0) continue;
      const auto d = static_cast<std::size_t>(space_[axis]);
      const std::int64_t origin = chunk[d] * array_.chunk[d];
      span[axis] = {std::max(origin, box.first[axis]),
                    std::min(origin + array_.chunk[d], box.first[axis] + box.count[axis]), origin,
                    stride[d]};
    }
    const auto [x, y, z] = span;
    for (std::int64_t k = z.begin; k < z.end; ++k)
      for (std::int64_t j = y.begin; j < y.end; ++j) {
        double* const row = values +
                            ((k - box.first[2]) * box.count[1] + j - box.first[1]) * box.count[0] +
                            x.begin - box.first[0];
        const std::int64_t at = start + (k - z.origin) * z.step + (j - y.origin) * y.step +
                                (x.begin - x.origin) * x.step;
        if (is_written)
          decode(bytes.data() + at * array_.type.bytes, array_.type, array_.is_swapped,
                 x.end - x.begin, x.step, row);
        else
          std::fill(row, row + (x.end - x.begin), array_.fill);
      }
  }

  bool is_space(std::size_t d) const {
    return std::find(space_.begin(), space_.end(), static_cast<int>(d)) != space_.end();
  }

  std::string folder_;  ///< of the array
  ZarrArray array_;
  std::vector<ZarrAxis> axes_;            ///< of its dimensions
  std::array<int, 3> space_{-1, -1, -1};  ///< dimensions of x, y, z; -1: there is none
  int channel_ = -1, time_ = -1;
};

}  // namespace

std::unique_ptr<ImageSource> open_zarr(const ImageRequest& request) {
  return std::make_unique<ZarrSource>(request);
}

bool is_zarr(const std::string& folder) {
  const auto has = [&](const char* name) { return is_file(fs::path(folder) / name); };
  return has(".zattrs") || has(".zarray") || has(".zgroup") || has("zarr.json");
}

}  // namespace stroma::image
