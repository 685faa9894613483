// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Volumes in HDF5 files, read by hyperslab. Which dataset: Hdf5Layout.hpp; which dimension is
/// what: Hdf5Axes.hpp. Each rank opens the file itself.

#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/Hdf5Axes.hpp"
#include "stroma/image/formats/Hdf5File.hpp"
#include "stroma/image/formats/Hdf5Layout.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace stroma::image {
namespace {

/// Values that are turned around, or converted, are read in pieces of about so many.
constexpr std::int64_t piece_voxels = std::int64_t{1} << 22;

/// A chunk is read as a whole, whatever is wanted of it; one larger than this and than the whole
/// dataset is a mistake.
constexpr double large_chunk_bytes = 64.0 * 1024 * 1024;

std::string class_name(H5T_class_t kind) {
  switch (kind) {
    case H5T_STRING:
      return "texts";
    case H5T_COMPOUND:
      return "compound values";
    case H5T_REFERENCE:
      return "references";
    case H5T_VLEN:
      return "lists of variable length";
    case H5T_ARRAY:
      return "arrays";
    case H5T_TIME:
      return "times";
    case H5T_OPAQUE:
      return "opaque bytes";
    default:
      return "numbers of an unusual size";
  }
}

/// A dataset of which less than this share of the chunks was ever written is a broken header.
constexpr double least_written = 1e-5;

class Hdf5Source : public ImageSource {
 public:
  explicit Hdf5Source(const ImageRequest& request) {
    const hdf::Messages quiet;
    summary_.path = request.path;
    file_ = hdf::Handle(H5Fopen(request.path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file_.good())
      refuse(request.path, "is a broken or truncated HDF5 file" + hdf::Messages::reason());
    Hdf5Place place = find_place(file_.get(), request);
    summary_.format = place.format;
    summary_.dataset = place.dataset;
    summary_.voxel_size = place.voxel_size;
    summary_.notes = std::move(place.notes);
    summary_.files = std::move(place.files);
    dataset_ = hdf::Handle(H5Dopen2(file_.get(), place.dataset.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset_.good()) refuse_dataset("cannot be opened" + hdf::Messages::reason());
    take_type(place.meant_unsigned);
    take_axes(place, request);
    check_storage();
    if (!summary_.voxel_size.complete()) take_voxel_size();
  }

  void read(const voxels::Box& box, double* values) override {
    const hdf::Messages quiet;
    if (is_direct()) {
      read_as_stored(box, H5T_NATIVE_DOUBLE, values);
    } else {
      voxels::Box piece = box;
      const std::int64_t plane = box.count[0] * box.count[1];
      const std::int64_t planes = std::max<std::int64_t>(1, piece_voxels / plane);
      for (std::int64_t k = 0; k < box.count[2]; k += planes) {
        piece.first[2] = box.first[2] + k;
        piece.count[2] = std::min(planes, box.count[2] - k);
        read_turned(piece, values + k * plane);
      }
    }
    if (!meant_unsigned_) return;
    const double range = std::ldexp(1.0, 8 * summary_.type.bytes);
    for (std::int64_t i = 0; i < box.voxels(); ++i) values[i] += values[i] < 0.0 ? range : 0.0;
  }

 private:
  [[noreturn]] void refuse_dataset(const std::string& what) const {
    refuse(summary_.path, "dataset \"" + summary_.dataset + "\" " + what);
  }

  void take_type(bool meant_unsigned) {
    hdf::Handle type(H5Dget_type(dataset_.get()), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    by_bytes_ = kind == H5T_ENUM || kind == H5T_BITFIELD;  // HDF5 makes no doubles of these
    if (kind == H5T_BITFIELD)
      memory_type_ = hdf::Handle(H5Tget_native_type(type.get(), H5T_DIR_ASCEND), H5Tclose);
    if (kind == H5T_ENUM) {  // a conversion would make -1 of values without a name
      memory_type_ = hdf::Handle(H5Tcopy(type.get()), H5Tclose);
      type = hdf::Handle(H5Tget_super(type.get()), H5Tclose);
      is_swapped_ = H5Tget_order(type.get()) != H5Tget_order(H5T_NATIVE_INT);
    }
    const auto bytes = static_cast<int>(H5Tget_size(type.get()));
    const bool real = kind == H5T_FLOAT && (bytes == 2 || bytes == 4 || bytes == 8);
    const bool integer =
        (kind == H5T_INTEGER || by_bytes_) && bytes <= 8 &&
        (!by_bytes_ ||
         (memory_type_.good() && static_cast<int>(H5Tget_size(memory_type_.get())) == bytes));
    if (!integer && !real) {
      refuse_dataset("holds " + class_name(kind) +
                     "; admissible: integers up to 64 bits, floats of 16, 32 or 64 bits, enums "
                     "(among them bool) and bit fields");
    }
    using Kind = ValueType::Kind;
    const bool has_sign = kind != H5T_BITFIELD && integer && H5Tget_sign(type.get()) == H5T_SGN_2;
    meant_unsigned_ = meant_unsigned && has_sign;
    summary_.type = {real       ? Kind::floating
                     : has_sign ? Kind::signed_integer
                                : Kind::unsigned_integer,
                     bytes};
    if (!meant_unsigned_) return;
    summary_.type.kind = Kind::unsigned_integer;
    summary_.notes.emplace_back("the file's signed integers stand for unsigned ones; read so");
  }

  void take_axes(const Hdf5Place& place, const ImageRequest& request) {
    const hdf::Handle space(H5Dget_space(dataset_.get()), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space.get());
    extents_.assign(static_cast<std::size_t>(std::max(rank, 0)), 0);
    H5Sget_simple_extent_dims(space.get(), extents_.data(), nullptr);
    for (const char* const name : linear_map_attributes)
      if (!number_attribute(dataset_.get(), name, 1).empty())
        summary_.notes.push_back(not_applied(name));
    axes_ = find_axes(dataset_.get(), extents_, summary_.path, summary_.dataset, summary_.notes);
    const auto extent = [&](int axis) {
      return axis < 0 ? std::int64_t{1}
                      : static_cast<std::int64_t>(extents_[static_cast<std::size_t>(axis)]);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      summary_.file_size[axis] = extent(axes_.space[axis]);
      if (!place.size) continue;
      if ((*place.size)[axis] > summary_.file_size[axis]) {
        refuse_dataset(base::format("has %lld voxels along %c, and its attributes say %lld",
                                    static_cast<long long>(summary_.file_size[axis]), "xyz"[axis],
                                    static_cast<long long>((*place.size)[axis])));
      }
      summary_.file_size[axis] = (*place.size)[axis];
    }
    summary_.channels = place.has_own_axes ? extent(axes_.channel) : place.channels;
    summary_.frames = place.has_own_axes ? extent(axes_.time) : place.frames;
    summary_.channel = request.channel;
    summary_.frame = request.frame;
    check_channel(summary_.path, request.channel, summary_.channels);
    check_frame(summary_.path, request.frame, summary_.frames);
    if (!place.has_own_axes) return;
    own_channel_ = request.channel;
    own_frame_ = request.frame;
  }

  /// Refuses what this HDF5 cannot decompress, values that lie in other files (HDF5 takes zeros for
  /// missing ones), and sizes that the file does not hold; notes what was never written.
  void check_storage() {
    const hdf::Handle creation(H5Dget_create_plist(dataset_.get()), H5Pclose);
    const H5D_layout_t layout = H5Pget_layout(creation.get());
    if (const auto missing = missing_filter(creation.get())) {
      refuse_dataset("is compressed by " + *missing +
                     ", which this program does not support; write it with gzip, or without "
                     "compression");
    }
    if (layout == H5D_VIRTUAL || H5Pget_external_count(creation.get()) > 0)
      refuse_dataset("has its values in other files, which is not supported; copy them into one");
    const hsize_t stored = H5Dget_storage_size(dataset_.get());
    double values = 1.0;
    for (const hsize_t extent : extents_) values *= static_cast<double>(extent);
    check_size(summary_.path, summary_.file_size, 1, summary_.type.bytes, stored,
               std::numeric_limits<double>::infinity());
    if (stored == 0) refuse_dataset("holds no values: none was ever written");
    if (layout == H5D_CHUNKED) return check_chunks(creation.get());
    std::error_code trouble;
    const auto length = static_cast<double>(std::filesystem::file_size(summary_.path, trouble));
    if (values * summary_.type.bytes > std::min(static_cast<double>(stored), length)) {
      refuse_dataset(base::format(
          "says that it holds %.0f values of %d bytes; its %llu bytes in a file of %.0f cannot "
          "hold them (broken or truncated)",
          values, summary_.type.bytes, static_cast<unsigned long long>(stored), length));
    }
  }

  void check_chunks(hid_t creation) {
    std::vector<hsize_t> chunk(extents_.size(), 1);
    hsize_t written = 0;
    const hdf::Handle space(H5Dget_space(dataset_.get()), H5Sclose);
    if (H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()) < 0 ||
        H5Dget_num_chunks(dataset_.get(), space.get(), &written) < 0)
      refuse_dataset("is broken: its chunks cannot be counted" + hdf::Messages::reason());
    double bytes = summary_.type.bytes, chunks = 1.0, all_bytes = bytes;
    for (std::size_t d = 0; d < chunk.size(); ++d) {
      const auto side = static_cast<double>(std::max<hsize_t>(chunk[d], 1));
      bytes *= side;
      all_bytes *= static_cast<double>(extents_[d]);
      chunks *= std::ceil(static_cast<double>(extents_[d]) / side);
    }
    if (bytes > std::max(large_chunk_bytes, all_bytes)) {
      refuse_dataset(
          base::format("of %.0f bytes has chunks of %.0f bytes (broken)", all_bytes, bytes));
    }
    if (static_cast<double>(written) < least_written * chunks) {
      refuse_dataset(
          base::format("says that it has %.0f chunks, of which %llu were ever written (broken)",
                       chunks, static_cast<unsigned long long>(written)));
    }
    if (static_cast<double>(written) < chunks) {
      summary_.notes.push_back(base::format(
          "%.0f of the dataset's %.0f chunks were never written; they hold its fill value",
          chunks - static_cast<double>(written), chunks));
    }
  }

  void take_voxel_size() {
    static const char* const name = "element_size_um";
    const hdf::Handle root = open_object(file_.get(), "/");
    for (const hid_t object : {dataset_.get(), root.get()}) {
      if (H5Aexists(object, name) <= 0) continue;
      const std::vector<double> sizes = number_attribute(object, name);
      const bool good = sizes.size() == 3 &&
                        std::all_of(sizes.begin(), sizes.end(),
                                    [](double size) { return size > 0.0 && std::isfinite(size); });
      if (!good) {
        summary_.notes.push_back(
            "the attribute element_size_um is not three positive numbers (z, y, x); not used");
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
        summary_.voxel_size.set(axis, sizes[static_cast<std::size_t>(2 - axis)],
                                "HDF5 attribute element_size_um");
      return;
    }
    // Attributes that other programs write, without a unit or an order of their own.
    for (const char* other : {"element_size", "spacing", "voxel_size", "voxelSize", "resolution",
                              "pixelResolution", "pixel_size"}) {
      const std::vector<double> sizes = number_attribute(dataset_.get(), other);
      if (sizes.empty()) continue;
      std::string list;
      for (const double size : sizes) list += (list.empty() ? "" : ", ") + base::format("%g", size);
      summary_.notes.push_back(std::string("the attribute ") + other + " (" + list +
                               ") says neither its unit nor its order; not used");
    }
  }

  /// Whether the dataset lies as a volume does, and HDF5 makes doubles of its values.
  bool is_direct() const {
    const auto [x, y, z] = axes_.space;
    return !by_bytes_ && z < y && y < x;
  }

  /// The values of a box, in the file's own order.
  void read_as_stored(const voxels::Box& box, hid_t type, void* values) const {
    std::vector<hsize_t> first(extents_.size(), 0), count(extents_.size(), 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axes_.space[axis] < 0) continue;
      const auto d = static_cast<std::size_t>(axes_.space[axis]);
      first[d] = static_cast<hsize_t>(box.first[axis]);
      count[d] = static_cast<hsize_t>(box.count[axis]);
    }
    if (axes_.channel >= 0)
      first[static_cast<std::size_t>(axes_.channel)] = static_cast<hsize_t>(own_channel_);
    if (axes_.time >= 0)
      first[static_cast<std::size_t>(axes_.time)] = static_cast<hsize_t>(own_frame_);
    const hdf::Handle in_file(H5Dget_space(dataset_.get()), H5Sclose);
    const hdf::Handle in_memory(
        H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
    const bool done =
        H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, first.data(), nullptr, count.data(),
                            nullptr) >= 0 &&
        H5Dread(dataset_.get(), type, in_memory.get(), in_file.get(), H5P_DEFAULT, values) >= 0;
    if (!done) refuse_dataset("cannot be read (broken or truncated)" + hdf::Messages::reason());
  }

  void read_turned(const voxels::Box& box, double* values) const {
    const std::int64_t voxels = box.voxels();
    std::vector<double> stored(static_cast<std::size_t>(voxels));
    if (by_bytes_) {
      std::vector<unsigned char> bytes(stored.size() *
                                       static_cast<std::size_t>(summary_.type.bytes));
      read_as_stored(box, memory_type_.get(), bytes.data());
      decode(bytes.data(), summary_.type, is_swapped_, voxels, 1, stored.data());
    } else {
      read_as_stored(box, H5T_NATIVE_DOUBLE, stored.data());
    }
    // Stride of an axis: the product of what the later dimensions have in the box.
    std::array<std::int64_t, 3> stride{0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      stride[axis] = 1;
      for (std::size_t other = 0; other < 3; ++other) {
        if (axes_.space[other] > axes_.space[axis]) stride[axis] *= box.count[other];
      }
    }
    for (std::int64_t k = 0; k < box.count[2]; ++k) {
      for (std::int64_t j = 0; j < box.count[1]; ++j) {
        for (std::int64_t i = 0; i < box.count[0]; ++i) {
          const std::int64_t place = i * stride[0] + j * stride[1] + k * stride[2];
          *values++ = stored[static_cast<std::size_t>(place)];
        }
      }
    }
  }

  hdf::Handle file_, dataset_, memory_type_;
  std::vector<hsize_t> extents_;
  Hdf5Axes axes_;
  std::int64_t own_channel_ = 0, own_frame_ = 0;  ///< along the dataset's own axes
  bool by_bytes_ = false;                         ///< read in memory_type_, and decoded here
  bool is_swapped_ = false;                       ///< bytes of that are not in this machine's order
  bool meant_unsigned_ = false;
};

}  // namespace

std::unique_ptr<ImageSource> open_hdf5(const ImageRequest& request) {
  return std::make_unique<Hdf5Source>(request);
}

}  // namespace stroma::image
