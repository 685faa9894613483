/// \file
/// Volumes in HDF5 files: datasets [z][y][x], [y][x] or [c][z][y][x], read by hyperslab. The voxel
/// size is the attribute `element_size_um` (z, y, x) of the dataset, the convention of ilastik and
/// its kin.

#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/Log.hpp"
#include "image/ImageSource.hpp"

namespace stroma::image {
namespace {

/// Keeps HDF5's error stack off standard error while it lives.
class Hdf5Messages {
 public:
  Hdf5Messages() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Messages() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Hdf5Messages(const Hdf5Messages&) = delete;
  Hdf5Messages& operator=(const Hdf5Messages&) = delete;

  /// " (HDF5: REASON)" from the innermost entry of the stack, or nothing.
  static std::string reason() {
    std::string text;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first_entry, &text);
    return text.empty() ? "" : " (HDF5: " + text + ")";
  }

 private:
  static herr_t first_entry(unsigned n, const H5E_error2_t* entry, void* text) {
    if (n == 0 && entry->desc) *static_cast<std::string*>(text) = entry->desc;
    return 0;
  }
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// An HDF5 identifier that is closed when it goes.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }
  bool good() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

class Hdf5Source : public ImageSource {
 public:
  Hdf5Source(const base::Communicator& communicator, const ImageRequest& request) {
    const Hdf5Messages quiet;
    summary_.path = request.path;
    summary_.format = "HDF5";
    summary_.channel = request.channel;
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    if (communicator.size() > 1) {
      H5Pset_fapl_mpio(access.get(), communicator.raw(), MPI_INFO_NULL);
      H5Pset_all_coll_metadata_ops(access.get(), true);
    }
    file_ = Handle(H5Fopen(request.path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
    if (!file_.good())
      refuse(request.path, "is a broken or truncated HDF5 file" + Hdf5Messages::reason());
    open_dataset(request.dataset);
    take_type();
    take_size();
    check_channel(request.path, request.channel, summary_.channels);
    take_voxel_size();
  }

  void read(const Box& box, double* values) override {
    const Hdf5Messages quiet;
    std::vector<hsize_t> first, count;
    if (rank_ == 4) {
      first.push_back(static_cast<hsize_t>(summary_.channel));
      count.push_back(1);
    }
    for (int axis = std::min(rank_, 3) - 1; axis >= 0; --axis) {
      first.push_back(static_cast<hsize_t>(box.first[static_cast<std::size_t>(axis)]));
      count.push_back(static_cast<hsize_t>(box.count[static_cast<std::size_t>(axis)]));
    }
    const Handle in_file(H5Dget_space(dataset_.get()), H5Sclose);
    const Handle in_memory(H5Screate_simple(rank_, count.data(), nullptr), H5Sclose);
    const bool done = H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, first.data(), nullptr,
                                          count.data(), nullptr) >= 0 &&
                      H5Dread(dataset_.get(), H5T_NATIVE_DOUBLE, in_memory.get(), in_file.get(),
                              H5P_DEFAULT, values) >= 0;
    if (!done) {
      refuse(summary_.path, "dataset \"" + summary_.dataset +
                                "\" cannot be read (broken or truncated)" + Hdf5Messages::reason());
    }
  }

 private:
  /// Paths of all datasets of a file, in alphabetical order.
  static herr_t collect(hid_t, const char* name, const H5O_info_t* info, void* names) {
    if (info->type == H5O_TYPE_DATASET)
      static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
  }

  void open_dataset(const std::string& wanted) {
    std::vector<std::string> names;
    if (H5Ovisit2(file_.get(), H5_INDEX_NAME, H5_ITER_INC, collect, &names, H5O_INFO_BASIC) < 0)
      refuse(summary_.path,
             "is a broken HDF5 file: its datasets cannot be listed" + Hdf5Messages::reason());
    if (names.empty()) refuse(summary_.path, "holds no dataset");
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    std::string name = wanted.compare(0, 1, "/") == 0 ? wanted.substr(1) : wanted;
    if (wanted.empty()) {
      if (names.size() > 1)
        refuse(summary_.path, "holds several datasets; name one by Image|Dataset: " + list);
      name = names.front();
    }
    if (std::find(names.begin(), names.end(), name) == names.end())
      refuse(summary_.path,
             "holds no dataset \"" + wanted + "\" (Image|Dataset); admissible: " + list);
    summary_.dataset = name;
    dataset_ = Handle(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset_.good())
      refuse(summary_.path, "dataset \"" + name + "\" cannot be opened" + Hdf5Messages::reason());
  }

  void take_type() {
    const Handle type(H5Dget_type(dataset_.get()), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    const auto bytes = static_cast<int>(H5Tget_size(type.get()));
    const bool integer = kind == H5T_INTEGER && bytes <= 8;
    const bool real = kind == H5T_FLOAT && (bytes == 4 || bytes == 8);
    if (!integer && !real) {
      refuse(summary_.path,
             "dataset \"" + summary_.dataset +
                 "\" holds neither integers nor floats of 32 or 64 bits; admissible: these");
    }
    using Kind = ValueType::Kind;
    const bool has_sign = integer && H5Tget_sign(type.get()) == H5T_SGN_2;
    summary_.type = {real       ? Kind::floating
                     : has_sign ? Kind::signed_integer
                                : Kind::unsigned_integer,
                     bytes};
  }

  void take_size() {
    const Handle space(H5Dget_space(dataset_.get()), H5Sclose);
    rank_ = H5Sget_simple_extent_ndims(space.get());
    if (rank_ < 2 || rank_ > 4) {
      refuse(summary_.path,
             "dataset \"" + summary_.dataset +
                 base::format("\" has %d dimensions; admissible: [y][x], [z][y][x], [c][z][y][x]",
                              rank_));
    }
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank_));
    H5Sget_simple_extent_dims(space.get(), extent.data(), nullptr);
    summary_.file_size = {1, 1, 1};
    for (int axis = 0; axis < std::min(rank_, 3); ++axis)
      summary_.file_size[static_cast<std::size_t>(axis)] =
          static_cast<std::int64_t>(extent[static_cast<std::size_t>(rank_ - 1 - axis)]);
    summary_.channels = rank_ == 4 ? static_cast<std::int64_t>(extent[0]) : 1;
    // Chunks that were never written take no room in the file, so the file's length alone is no
    // measure.
    check_size(summary_.path, summary_.file_size, summary_.channels, summary_.type.bytes,
               H5Dget_storage_size(dataset_.get()), largest_expansion);
  }

  void take_voxel_size() {
    static const char* const name = "element_size_um";
    if (H5Aexists(dataset_.get(), name) <= 0) return;
    const Handle attribute(H5Aopen(dataset_.get(), name, H5P_DEFAULT), H5Aclose);
    const Handle space(H5Aget_space(attribute.get()), H5Sclose);
    const Handle type(H5Aget_type(attribute.get()), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    const bool numbers = kind == H5T_FLOAT || kind == H5T_INTEGER;
    double sizes[3] = {};
    const bool good = numbers && H5Sget_simple_extent_npoints(space.get()) == 3 &&
                      H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, sizes) >= 0 && sizes[0] > 0.0 &&
                      sizes[1] > 0.0 && sizes[2] > 0.0 &&
                      std::isfinite(sizes[0] + sizes[1] + sizes[2]);
    if (!good) {
      summary_.notes.push_back(
          "the attribute element_size_um is not three positive numbers (z, y, x); not used");
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
      summary_.voxel_size.set(axis, sizes[2 - axis], "HDF5 attribute element_size_um");
  }

  Handle file_;
  Handle dataset_;
  int rank_ = 0;
};

}  // namespace

std::unique_ptr<ImageSource> open_hdf5(const base::Communicator& communicator,
                                       const ImageRequest& request) {
  return std::make_unique<Hdf5Source>(communicator, request);
}

}  // namespace stroma::image
