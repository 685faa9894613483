// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/ExodusStep.hpp"

#include <netcdf.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {
namespace {

/// The head of a classic file with 64-bit offsets: "CDF", 2, and the number of records, four bytes,
/// the highest first.
constexpr std::size_t head_size = 8;

std::string head_of(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw base::RunError("cannot read '" + path + "': " + std::strerror(errno));
  std::string head(head_size, '\0');
  if (!file.read(head.data(), head_size))
    throw base::RunError("cannot read '" + path + "': it is no Exodus file");
  return head;
}

bool is_classic(const std::string& head) { return head.compare(0, 4, "CDF\x02") == 0; }

std::int64_t records_of(const std::string& head) {
  std::int64_t records = 0;
  for (std::size_t i = 4; i < head_size; ++i)
    records = 256 * records + static_cast<unsigned char>(head[i]);
  return records;
}

std::int64_t steps_of_hdf5(const std::string& path) {
  int id = -1, dimension = -1;
  std::size_t steps = 0;
  const int opened = nc_open(path.c_str(), NC_NOWRITE, &id);
  if (opened != NC_NOERR)
    throw base::RunError("cannot read '" + path + "': " + nc_strerror(opened));
  const bool is_good = nc_inq_dimid(id, "time_step", &dimension) == NC_NOERR &&
                       nc_inq_dimlen(id, dimension, &steps) == NC_NOERR;
  nc_close(id);
  if (!is_good) throw base::RunError("cannot read '" + path + "': it is no Exodus file");
  return static_cast<std::int64_t>(steps);
}

}  // namespace

/// Opened by netCDF, not by Exodus, which would have readers see each variable as it comes.
ExodusStep::ExodusStep(const std::string& path, std::int64_t record)
    : path_(path), record_(static_cast<std::size_t>(record)) {
  keep_no_variables_in_memory();
  errno = 0;
  check(nc_open(path.c_str(), NC_WRITE, &id_), "a step");
  int before = 0;
  check(nc_set_fill(id_, NC_NOFILL, &before), "a step");
}

ExodusStep::~ExodusStep() {
  if (id_ >= 0) nc_close(id_);
}

void ExodusStep::close() {
  const int id = id_;
  id_ = -1;
  check(nc_close(id), "the last data");
}

void ExodusStep::check(int code, const std::string& what) const {
  if (code == NC_NOERR) return;
  const int system_reason = errno;
  const std::string reason =
      is_of_the_disk(system_reason) ? std::strerror(system_reason) : nc_strerror(code);
  throw base::RunError("cannot write " + what + " to '" + path_ + "': " + reason);
}

void ExodusStep::put(const std::string& name, std::int64_t start, std::int64_t size,
                     const double* values) const {
  int variable = -1;
  errno = 0;
  check(nc_inq_varid(id_, name.c_str(), &variable), name);
  const std::size_t from[2] = {record_, static_cast<std::size_t>(start - 1)};
  const std::size_t count[2] = {1, static_cast<std::size_t>(size)};
  check(nc_put_vara_double(id_, variable, from, count, values), "a variable");
}

void ExodusStep::put_globals(const std::vector<double>& values) const {
  if (!values.empty())
    put("vals_glo_var", 1, static_cast<std::int64_t>(values.size()), values.data());
}

void ExodusStep::put_time(double time) const { put("time_whole", 1, 1, &time); }

void ExodusStep::put_piece(At at, int variable, std::int64_t block, std::int64_t start,
                           std::int64_t size, const double* values) const {
  put(at == At::nodes
          ? base::format("vals_nod_var%d", variable)
          : base::format("vals_elem_var%deb%lld", variable, static_cast<long long>(block)),
      start, size, values);
}

void add_step(const base::Communicator& communicator, const std::string& path, FileEnd& end,
              double time, const std::function<void(const ExodusStep&)>& put) {
  std::optional<ExodusStep> step;
  try {
    base::collectively(communicator, [&] {
      step.emplace(path, end.steps);
      put(*step);
      step->put_time(time);
    });
    FileEnd after;
    base::collectively(communicator, [&] {
      step->close();
      after = end_of(path);
    });
    end = after;
  } catch (const base::RunError&) {
    step.reset();
    try {
      cut_at(path, end);
    } catch (const base::RunError&) {  // on a disk that takes nothing at all
    }
    throw;
  }
}

FileEnd end_of(const std::string& path) {
  const std::string head = head_of(path);
  std::error_code failure;
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(path, failure));
  return {is_classic(head) ? records_of(head) : steps_of_hdf5(path), bytes};
}

bool cut_at(const std::string& path, const FileEnd& end) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return false;
  const FileEnd found = end_of(path);
  if (found.steps < end.steps) return false;
  std::string head = head_of(path);
  if (!is_classic(head)) return true;
  if (found.bytes < end.bytes) return false;
  auto rest = static_cast<std::size_t>(end.steps);
  for (std::size_t i = head_size; i > 4; rest /= 256) head[--i] = static_cast<char>(rest % 256);
  errno = 0;
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.write(head.data(), head_size);
  file.close();
  if (file.fail()) throw base::RunError("cannot change '" + path + "': " + std::strerror(errno));
  std::error_code failure;
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(end.bytes), failure);
  if (failure) throw base::RunError("cannot shorten '" + path + "': " + failure.message());
  return true;
}

}  // namespace stroma::output
