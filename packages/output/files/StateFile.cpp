// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/StateFile.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <numeric>

#include "stroma/base/Error.hpp"
#include "stroma/hdf/Handle.hpp"
#include "stroma/output/files/Room.hpp"

namespace stroma::output {
namespace {

using hdf::Handle;

std::uint64_t product(const std::vector<std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{1}, std::multiplies<>());
}

std::size_t bytes_of(StateArray::Type type) { return type == StateArray::Type::byte ? 1 : 8; }

hid_t in_file(StateArray::Type type) {
  if (type == StateArray::Type::real) return H5T_IEEE_F64LE;
  return type == StateArray::Type::integer ? H5T_STD_I64LE : H5T_STD_U8LE;
}

hid_t in_memory(StateArray::Type type) {
  if (type == StateArray::Type::real) return H5T_NATIVE_DOUBLE;
  return type == StateArray::Type::integer ? H5T_NATIVE_INT64 : H5T_NATIVE_UINT8;
}

/// Pieces of at most 2^17 values, each with its checksum.
std::vector<hsize_t> chunk_of(const std::vector<std::uint64_t>& shape) {
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  const auto size = [&] {
    return std::accumulate(chunk.begin(), chunk.end(), hsize_t{1}, std::multiplies<>());
  };
  for (hsize_t& axis : chunk)
    while (axis > 1 && size() > hsize_t{1} << 17) axis = (axis + 1) / 2;
  return chunk;
}

void select(hid_t space, const Slab& box) {
  if (box.size() == 0) {
    H5Sselect_none(space);
    return;
  }
  const std::vector<hsize_t> begin(box.begin.begin(), box.begin.end()),
      count(box.count.begin(), box.count.end());
  H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr);
}

/// This rank's box in pieces along the first axis, which end where chunks do: HDF5 keeps a copy of all
/// that is written at a time.
std::vector<Slab> pieces_of(const StateArray& array, hsize_t rows_of_chunk, std::uint64_t bytes) {
  if (array.mine.size() == 0) return {};
  const std::uint64_t row = array.mine.size() / array.mine.count[0] * bytes_of(array.type);
  const std::uint64_t rows =
      std::max<std::uint64_t>(bytes / row / rows_of_chunk, 1) * rows_of_chunk;
  std::vector<Slab> pieces;
  const std::uint64_t end = array.mine.begin[0] + array.mine.count[0];
  for (std::uint64_t begin = array.mine.begin[0]; begin < end;) {
    Slab piece = array.mine;
    piece.begin[0] = begin;
    piece.count[0] = std::min((begin / rows + 1) * rows, end) - begin;
    begin += piece.count[0];
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Writes one array; all ranks come here whatever went wrong on one of them. \return  success
bool put(const base::Communicator& communicator, const Handle& file, const StateArray& array,
         std::uint64_t piece_bytes) {
  const std::vector<hsize_t> shape(array.shape.begin(), array.shape.end()),
      chunk = chunk_of(array.shape);
  const int axes = static_cast<int>(shape.size());
  const Handle space(H5Screate_simple(axes, shape.data(), nullptr), H5Sclose);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose),
      how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.get(), 1);
  H5Pset_chunk(how.get(), axes, chunk.data());
  H5Pset_fletcher32(how.get());
  H5Pset_fill_time(how.get(), H5D_FILL_TIME_NEVER);
  Handle dataset(H5Dcreate2(file.get(), array.name.c_str(), in_file(array.type), space.get(),
                            links.get(), how.get(), H5P_DEFAULT),
                 H5Dclose);
  const Handle together(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  if (communicator.size() > 1) H5Pset_dxpl_mpio(together.get(), H5FD_MPIO_COLLECTIVE);
  const std::vector<Slab> pieces = pieces_of(array, chunk[0], piece_bytes);
  const auto* values = static_cast<const char*>(array.values);
  bool is_good = hdf::put_text(dataset, "about", array.about);
  for (std::size_t n = 0; n < communicator.max(pieces.size()); ++n) {
    const Slab piece = n < pieces.size() ? pieces[n] : Slab{array.mine.begin, {0}};
    const hsize_t count = piece.size();
    const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    if (count == 0) H5Sselect_none(memory.get());
    select(space.get(), piece);
    const double nothing = 0.0;
    const void* from = count == 0 ? static_cast<const void*>(&nothing) : values;
    is_good = H5Dwrite(dataset.get(), in_memory(array.type), memory.get(), space.get(),
                       together.get(), from) >= 0 &&
              is_good;
    values += count * bytes_of(array.type);
  }
  return dataset.close() && is_good;
}

void sync(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  if (file < 0 || ::fsync(file) != 0) {
    const int reason = errno;
    if (file >= 0) ::close(file);
    throw base::RunError("cannot write '" + path + "': " + std::strerror(reason));
  }
  ::close(file);
}

/// \return  whether all that this rank has to do with the file succeeded
bool write_together(const base::Communicator& communicator, const std::string& path,
                    const std::vector<StateArray>& arrays, std::uint64_t piece) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);  // metadata with checksums
  if (communicator.size() > 1) H5Pset_fapl_mpio(access.get(), communicator.raw(), MPI_INFO_NULL);
  Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose);
  if (communicator.any(!file.good())) return false;
  bool is_good = true;
  for (const StateArray& array : arrays) is_good = put(communicator, file, array, piece) && is_good;
  return file.close() && is_good;
}

}  // namespace

std::uint64_t Slab::size() const { return product(count); }

std::string draft_of_state(const std::string& path) { return path + ".new"; }

void write_state(const base::Communicator& communicator, const std::string& path,
                 const std::vector<StateArray>& arrays, std::uint64_t piece) {
  const std::string draft = draft_of_state(path);
  std::uint64_t bytes = 1u << 16;
  for (const StateArray& array : arrays)
    bytes += 4096 + product(array.shape) * bytes_of(array.type) * 1001 / 1000;
  base::collectively(communicator, [&] {
    if (communicator.is_root()) require_room(draft, bytes);
  });
  const hdf::Messages quiet;
  const bool is_good = write_together(communicator, draft, arrays, piece);
  base::collectively(communicator, [&] {
    if (!is_good)
      throw base::RunError("cannot write '" + draft + "': HDF5 could not write all of it");
  });
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    sync(draft);
    if (std::rename(draft.c_str(), path.c_str()) != 0)
      throw base::RunError("cannot write '" + path + "': " + std::strerror(errno));
    const std::string folder = std::filesystem::path(path).parent_path().string();
    sync(folder.empty() ? "." : folder);
  });
}

StateReader::StateReader(std::string path) : path_(std::move(path)) {
  std::error_code failure;
  const auto status = std::filesystem::status(path_, failure);
  if (!std::filesystem::exists(status)) refuse("there is no such file");
  if (!std::filesystem::is_regular_file(status)) refuse("it is no file");
  const hdf::Messages quiet;
  file_ = Handle(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file_.good()) refuse("it is no HDF5 file, or it is damaged");
}

void StateReader::refuse(const std::string& problem) const {
  throw base::InputError("cannot read '" + path_ + "': " + problem);
}

bool StateReader::has(const std::string& name) const {
  const hdf::Messages quiet;
  for (std::size_t end = name.find('/');; end = name.find('/', end + 1)) {
    if (H5Lexists(file_.get(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

hdf::Handle StateReader::open(const std::string& name) const {
  Handle dataset(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.good()) refuse("it has no " + name + ", or it is damaged");
  return dataset;
}

std::vector<std::uint64_t> StateReader::shape(const std::string& name) const {
  const hdf::Messages quiet;
  const Handle dataset = open(name), space(H5Dget_space(dataset.get()), H5Sclose);
  const int axes = H5Sget_simple_extent_ndims(space.get());
  if (axes < 1) refuse(name + " is damaged");
  std::vector<hsize_t> shape(static_cast<std::size_t>(axes));
  H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr);
  return {shape.begin(), shape.end()};
}

void StateReader::read(const std::string& name, const Slab& box, StateArray::Type type,
                       const std::function<void*()>& room) const {
  const std::vector<std::uint64_t> all = shape(name);
  if (all.size() != box.begin.size()) refuse(name + " has another number of axes than expected");
  for (std::size_t d = 0; d < all.size(); ++d)
    if (box.begin[d] + box.count[d] > all[d]) refuse(name + " is smaller than expected");
  if (product(all) > (std::uint64_t{1} << 50)) refuse(name + " is damaged");
  const hdf::Messages quiet;
  const Handle dataset = open(name), stored(H5Dget_type(dataset.get()), H5Tclose),
               space(H5Dget_space(dataset.get()), H5Sclose);
  if (H5Tequal(stored.get(), in_file(type)) <= 0)
    refuse(name + " is of another type than expected");
  void* const values = room();
  const hsize_t count = box.size();
  if (count == 0) return;
  const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  select(space.get(), box);
  if (H5Dread(dataset.get(), in_memory(type), memory.get(), space.get(), H5P_DEFAULT, values) < 0)
    refuse(name + " is damaged: its checksum is not that of its values");
}

namespace {

template <class T>
constexpr StateArray::Type type_of = StateArray::Type::real;
template <>
constexpr StateArray::Type type_of<std::int64_t> = StateArray::Type::integer;
template <>
constexpr StateArray::Type type_of<std::uint8_t> = StateArray::Type::byte;

}  // namespace

template <class T>
std::vector<T> StateReader::get(const std::string& name, const Slab& box) const {
  std::vector<T> values;
  read(name, box, type_of<T>, [&] {
    values.resize(box.size());
    return values.data();
  });
  return values;
}

template std::vector<double> StateReader::get(const std::string&, const Slab&) const;
template std::vector<std::int64_t> StateReader::get(const std::string&, const Slab&) const;
template std::vector<std::uint8_t> StateReader::get(const std::string&, const Slab&) const;

}  // namespace stroma::output
