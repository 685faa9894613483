// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/VtkhdfFile.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "stroma/base/Error.hpp"
#include "stroma/hdf/Handle.hpp"
#include "stroma/output/files/Room.hpp"

namespace stroma::output {
namespace {

using hdf::Handle;
using Number = VtkhdfColumn::Number;

std::int64_t corners_of(VtkCell cell) { return cell == VtkCell::vertex ? 1 : 8; }

std::int64_t bytes_of(Number number, Precision precision) {
  if (number == Number::byte) return 1;
  return number == Number::real && precision == Precision::Single ? 4 : 8;
}

hid_t in_file(Number number, Precision precision) {
  if (number == Number::integer) return H5T_STD_I64LE;
  if (number == Number::byte) return H5T_STD_U8LE;
  return precision == Precision::Single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
}

/// A name that HDF5 does not take for a path.
std::string plain(std::string name) {
  std::replace(name.begin(), name.end(), '/', '|');
  return name;
}

/// Rows over all ranks, and this rank's.
struct Rows {
  std::int64_t all, before, mine;

  Rows(const base::Communicator& communicator, std::int64_t own)
      : all(communicator.sum(own)), before(communicator.sum_before(own)), mine(own) {}
};

/// A dataset of as many rows; each rank writes its own.
class Table {
 public:
  /// Collective.
  Table(const Handle& file, const std::string& name, const Rows& rows, int width, hid_t type)
      : before_(static_cast<hsize_t>(rows.before)), width_(static_cast<hsize_t>(width)) {
    const std::array<hsize_t, 2> shape{static_cast<hsize_t>(rows.all), width_};
    space_ = Handle(H5Screate_simple(width == 1 ? 1 : 2, shape.data(), nullptr), H5Sclose);
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose),
        how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.get(), 1);
    H5Pset_fill_time(how.get(), H5D_FILL_TIME_NEVER);
    dataset_ = Handle(H5Dcreate2(file.get(), name.c_str(), type, space_.get(), links.get(),
                                 how.get(), H5P_DEFAULT),
                      H5Dclose);
  }

  const Handle& dataset() const { return dataset_; }

  /// Rows of this rank, by itself. \return  success
  template <class T>
  bool put(std::int64_t first, std::int64_t count, const T* values) const {
    if (count == 0) return true;
    if (!dataset_.good()) return false;
    const std::array<hsize_t, 2> begin{before_ + static_cast<hsize_t>(first), 0},
        size{static_cast<hsize_t>(count), width_};
    const hsize_t total = size[0] * size[1];
    const Handle memory(H5Screate_simple(1, &total, nullptr), H5Sclose);
    H5Sselect_hyperslab(space_.get(), H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr);
    return H5Dwrite(dataset_.get(), in_memory(values), memory.get(), space_.get(), H5P_DEFAULT,
                    values) >= 0;
  }

 private:
  static hid_t in_memory(const double*) { return H5T_NATIVE_DOUBLE; }
  static hid_t in_memory(const std::int64_t*) { return H5T_NATIVE_INT64; }

  hsize_t before_, width_;
  Handle space_, dataset_;
};

/// Calls put(first, count, values) for pieces of value(0), ..., value(count - 1).
template <class Value, class Put>
bool in_pieces(std::int64_t count, const Value& value, const Put& put) {
  bool is_good = true;
  ExodusFile::in_pieces<std::int64_t>(
      count, value, [&](std::int64_t start, std::int64_t size, const std::int64_t* values) {
        is_good = put(start - 1, size, values) && is_good;
      });
  return is_good;
}

/// The datasets of a file that is being written.
class Datasets : public VtkhdfPieces {
 public:
  /// Collective.
  Datasets(const base::Communicator& communicator, const Handle& file, const VtkhdfPart& part,
           const std::vector<VtkhdfColumn>& columns, const std::vector<VtkhdfNumber>& numbers,
           Precision precision)
      : corners_(corners_of(part.cell)),
        of_points_(communicator, part.points),
        points_(file, "VTKHDF/Points", of_points_, 3, in_file(Number::real, precision)),
        cells_(file, "VTKHDF/Connectivity", Rows(communicator, part.cells * corners_), 1,
               in_file(Number::integer, precision)) {
    put_counts(communicator, file, part);
    put_shape_of_cells(communicator, file, part);
    for (const VtkhdfColumn& column : columns) {
      columns_.emplace_back(file, "VTKHDF/PointData/" + plain(column.name), of_points_,
                            column.components, in_file(column.number, precision));
      note(hdf::put_text(columns_.back().dataset(), "unit", column.unit));
    }
    const Rows of_root(communicator, communicator.is_root() ? 1 : 0);
    for (const VtkhdfNumber& number : numbers) {
      const Table table(file, "VTKHDF/FieldData/" + plain(number.name), of_root, 1, H5T_IEEE_F64LE);
      if (communicator.is_root()) note(table.put(0, 1, &number.value));
    }
    const Handle group(H5Gopen2(file.get(), "VTKHDF", H5P_DEFAULT), H5Gclose);
    note(hdf::put_text(group, "Type", "UnstructuredGrid"));
    put_version(group);
  }

  void points(std::int64_t first, std::int64_t count, const double* values) const override {
    note(points_.put(first, count, values));
  }
  void cells(std::int64_t first, std::int64_t count, const std::int64_t* points) const override {
    note(cells_.put(first * corners_, count * corners_, points));
  }
  void column(std::size_t column, std::int64_t first, std::int64_t count,
              const double* values) const override {
    note(columns_.at(column).put(first, count, values));
  }

  /// Whether all that this rank has written so far went well.
  bool good() const { return good_; }

 private:
  void note(bool went_well) const { good_ = good_ && went_well; }

  void put_counts(const base::Communicator& communicator, const Handle& file,
                  const VtkhdfPart& part) {
    const Rows one(communicator, 1);
    const auto put = [&](const char* name, std::int64_t count) {
      note(Table(file, name, one, 1, H5T_STD_I64LE).put(0, 1, &count));
    };
    put("VTKHDF/NumberOfPoints", part.points);
    put("VTKHDF/NumberOfCells", part.cells);
    put("VTKHDF/NumberOfConnectivityIds", part.cells * corners_);
  }

  /// Each part's offsets into its own corners, and what kind its cells are.
  void put_shape_of_cells(const base::Communicator& communicator, const Handle& file,
                          const VtkhdfPart& part) {
    const Table offsets(file, "VTKHDF/Offsets", Rows(communicator, part.cells + 1), 1,
                        H5T_STD_I64LE);
    const Table types(file, "VTKHDF/Types", Rows(communicator, part.cells), 1, H5T_STD_U8LE);
    note(in_pieces(
        part.cells + 1, [&](std::int64_t n) { return n * corners_; },
        [&](auto first, auto size, auto values) { return offsets.put(first, size, values); }));
    note(in_pieces(
        part.cells, [&](std::int64_t) { return static_cast<std::int64_t>(part.cell); },
        [&](auto first, auto size, auto values) { return types.put(first, size, values); }));
  }

  void put_version(const Handle& group) {
    const hsize_t two = 2;
    const std::array<std::int64_t, 2> version{1, 0};
    const Handle space(H5Screate_simple(1, &two, nullptr), H5Sclose);
    const Handle attribute(
        H5Acreate2(group.get(), "Version", H5T_STD_I64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    note(attribute.good() && H5Awrite(attribute.get(), H5T_NATIVE_INT64, version.data()) >= 0);
  }

  std::int64_t corners_;
  Rows of_points_;
  Table points_, cells_;
  std::vector<Table> columns_;
  mutable bool good_ = true;
};

/// Bytes of the file, its head generously.
std::uint64_t size_of(const base::Communicator& communicator, const VtkhdfPart& part,
                      const std::vector<VtkhdfColumn>& columns, std::size_t numbers,
                      Precision precision) {
  std::int64_t a_point = 3 * bytes_of(Number::real, precision);
  for (const VtkhdfColumn& column : columns)
    a_point += column.components * bytes_of(column.number, precision);
  const std::int64_t a_cell = 8 * corners_of(part.cell) + 8 + 1;
  const std::int64_t heads =
      4096 * static_cast<std::int64_t>(columns.size() + numbers + 16) + 32 * communicator.size();
  return static_cast<std::uint64_t>(communicator.sum(a_point * part.points + a_cell * part.cells) +
                                    heads);
}

}  // namespace

void write_vtkhdf(const base::Communicator& communicator, const std::string& path,
                  const VtkhdfPart& part, const std::vector<VtkhdfColumn>& columns,
                  const std::vector<VtkhdfNumber>& numbers, Precision precision,
                  const std::function<void(const VtkhdfPieces&)>& put) {
  const std::string draft = path + ".new";
  const std::uint64_t bytes = size_of(communicator, part, columns, numbers.size(), precision);
  base::collectively(communicator, [&] {
    if (communicator.is_root()) require_room(draft, bytes);
  });
  const hdf::Messages quiet;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  if (communicator.size() > 1) H5Pset_fapl_mpio(access.get(), communicator.raw(), MPI_INFO_NULL);
  Handle file(H5Fcreate(draft.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose);
  bool is_good = !communicator.any(!file.good());
  if (is_good) {
    const Datasets datasets(communicator, file, part, columns, numbers, precision);
    base::collectively(communicator, [&] { put(datasets); });
    is_good = datasets.good();
  }
  is_good = file.close() && is_good;
  base::collectively(communicator, [&] {
    if (!is_good)
      throw base::RunError("cannot write '" + draft + "': HDF5 could not write all of it");
  });
  base::collectively(communicator, [&] {
    if (communicator.is_root() && std::rename(draft.c_str(), path.c_str()) != 0)
      throw base::RunError("cannot write '" + path + "': " + std::strerror(errno));
  });
}

}  // namespace stroma::output
