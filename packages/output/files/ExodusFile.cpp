// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/ExodusFile.hpp"

#include <exodusII.h>
#include <hdf5.h>
#include <netcdf.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <limits>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {
namespace {

std::string reason_of_library() {
  const char* message = nullptr;
  const char* function = nullptr;
  int code = 0;
  ex_get_err(&message, &function, &code);
  std::string reason = (message != nullptr) ? message : "";
  reason.resize(std::min(reason.find('\n'), reason.size()));  // further lines are guesses
  if (reason.rfind("Error: ", 0) == 0) reason.erase(0, 7);
  return reason.empty() ? base::format("Exodus error %d", code) : reason;
}

/// Pointers that the C interface wants for a list of names.
std::vector<char*> pointers(const std::vector<std::string>& names) {
  std::vector<char*> result;
  for (const std::string& name : names) result.push_back(const_cast<char*>(name.c_str()));
  return result;
}

/// The text's lines, in pieces of what an information record holds.
std::vector<std::string> records(const std::string& text) {
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    for (std::size_t start = 0; start == 0 || start < line.size(); start += MAX_LINE_LENGTH) {
      pieces.push_back(line.substr(start, MAX_LINE_LENGTH));
    }
  }
  return pieces;
}

/// 1, ..., count without those of a sorted list.
std::vector<std::int64_t> all_but(const std::vector<std::int64_t>& left_out, std::int64_t count) {
  std::vector<std::int64_t> rest;
  rest.reserve(static_cast<std::size_t>(count) - left_out.size());
  auto next = left_out.begin();
  for (std::int64_t i = 1; i <= count; ++i) {
    if (next != left_out.end() && *next == i) {
      ++next;
    } else {
      rest.push_back(i);
    }
  }
  return rest;
}

bool is_for_classic(const FileSize& size) {
  return size.largest_id <= std::numeric_limits<std::int32_t>::max() &&
         size.entries < std::int64_t{1} << 27;  // eight 4-byte corners of an element: below 2^32
}

}  // namespace

ExodusFile ExodusFile::create(const std::string& path, Precision precision,
                              std::size_t longest_name, const FileSize& size) {
  ex_opts(0);  // so that the library does not print
  keep_no_variables_in_memory();
  // The library does not tell why it cannot create a file; the operating system does.
  std::FILE* trial = std::fopen(path.c_str(), "ab");
  if (trial == nullptr)
    throw base::RunError("cannot create '" + path + "': " + std::strerror(errno));
  std::fclose(trial);
  int memory_bytes = 8;
  int file_bytes = (precision == Precision::Double) ? 8 : 4;
  const int format = is_for_classic(size) ? EX_LARGE_MODEL : EX_NETCDF4 | EX_ALL_INT64_DB;
  const int id =
      ex_create(path.c_str(), EX_CLOBBER | EX_ALL_INT64_API | format, &memory_bytes, &file_bytes);
  const int system_reason = errno;
  if (id < 0)
    throw base::RunError(
        "cannot create '" + path + "': " +
        (is_of_the_disk(system_reason) ? std::strerror(system_reason) : reason_of_library()));
  ExodusFile file(id, path);
  file.check(ex_set_max_name_length(id, static_cast<int>(std::max<std::size_t>(longest_name, 32))),
             "the length of names");
  return file;
}

ExodusFile::ExodusFile(ExodusFile&& other) noexcept
    : id_(other.id_), path_(std::move(other.path_)) {
  other.id_ = -1;
}

ExodusFile::~ExodusFile() {
  if (id_ >= 0) ex_close(id_);
}

void ExodusFile::close() {
  const int id = id_;
  id_ = -1;
  const int flushed = ex_update(id);
  const int closed = ex_close(id);
  check(std::min(flushed, closed), "the last data");
}

void keep_no_variables_in_memory() { nc_set_chunk_cache(std::size_t{1} << 16, 101, 0.75f); }

bool is_of_the_disk(int reason) {
  return reason == ENOSPC || reason == EDQUOT || reason == EFBIG || reason == EIO;
}

void ExodusFile::check(int code, const char* what) const {
  if (code >= 0) return;
  const int system_reason = errno;  // the library swallows it
  std::string reason = reason_of_library();
  if (is_of_the_disk(system_reason)) reason = std::strerror(system_reason);
  throw base::RunError("cannot write " + std::string(what) + " to '" + path_ + "': " + reason);
}

void ExodusFile::put_provenance(const Provenance& provenance) const {
  const std::time_t now = std::time(nullptr);
  char date[16], time[16];
  std::tm local{};
  localtime_r(&now, &local);
  std::strftime(date, sizeof date, "%Y-%m-%d", &local);
  std::strftime(time, sizeof time, "%H:%M:%S", &local);
  std::string name = "Stroma";
  std::string version = provenance.version.substr(0, MAX_STR_LENGTH);
  char* qa[1][4] = {{name.data(), version.data(), date, time}};
  check(ex_put_qa(id_, 1, qa), "the version");

  const std::vector<std::string> lines = records(provenance.deck);
  if (lines.empty()) return;
  std::vector<char*> info = pointers(lines);
  check(ex_put_info(id_, static_cast<int>(info.size()), info.data()), "the deck");
}

void ExodusFile::put_variable_names(int kind, const std::vector<std::string>& names) const {
  if (names.empty()) return;
  const auto type = static_cast<ex_entity_type>(kind);
  const int count = static_cast<int>(names.size());
  std::vector<char*> list = pointers(names);
  check(ex_put_variable_param(id_, type, count), "the number of variables");
  check(ex_put_variable_names(id_, type, count, list.data()), "the names of the variables");
}

bool files_are_stuck() { return H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_FILE) > 0; }

std::string spread_file_name(const std::string& path, int ranks, int rank) {
  if (ranks == 1) return path;
  const int width = static_cast<int>(std::to_string(ranks).size());
  return path + base::format(".%d.%0*d", ranks, width, rank);
}

void put_parallel_part(const ExodusFile& file, const ParallelPart& part) {
  if (part.ranks == 1) return;
  const int id = file.id();
  char kind[] = "p";  // a file of one rank, not a scalar file with load-balance information
  file.check(ex_put_init_info(id, part.ranks, 1, kind), "the number of ranks");
  file.check(ex_put_init_global(id, part.global_nodes, part.global_elements,
                                static_cast<std::int64_t>(part.global_block_ids.size()), 0, 0),
             "the global counts");
  std::vector<std::int64_t> block_ids = part.global_block_ids;
  std::vector<std::int64_t> block_counts = part.global_block_counts;
  file.check(ex_put_eb_info_global(id, block_ids.data(), block_counts.data()), "the global blocks");

  // Everything that is shared is a border, all else is internal.
  std::vector<std::int64_t> border_nodes;
  for (const auto& shared : part.shared) {
    border_nodes.insert(border_nodes.end(), shared.nodes.begin(), shared.nodes.end());
  }
  std::sort(border_nodes.begin(), border_nodes.end());
  border_nodes.erase(std::unique(border_nodes.begin(), border_nodes.end()), border_nodes.end());
  std::vector<std::int64_t> border_elements = part.border_elements;
  std::vector<std::int64_t> internal_nodes = all_but(border_nodes, part.nodes);
  std::vector<std::int64_t> internal_elements = all_but(border_elements, part.elements);

  const auto size = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
  file.check(
      ex_put_loadbal_param(id, size(internal_nodes), size(border_nodes), 0, size(internal_elements),
                           size(border_elements), size(part.shared), 0, part.rank),
      "the load balance");
  std::vector<std::int64_t> map_ids, map_counts;
  for (const auto& shared : part.shared) {
    map_ids.push_back(shared.rank + 1);
    map_counts.push_back(size(shared.nodes));
  }
  if (!part.shared.empty()) {
    file.check(
        ex_put_cmap_params(id, map_ids.data(), map_counts.data(), nullptr, nullptr, part.rank),
        "the communication maps");
  }
  file.check(ex_put_processor_node_maps(id, internal_nodes.data(), border_nodes.data(), nullptr,
                                        part.rank),
             "the node maps");
  file.check(
      ex_put_processor_elem_maps(id, internal_elements.data(), border_elements.data(), part.rank),
      "the element maps");
  for (const auto& shared : part.shared) {
    std::vector<std::int64_t> nodes = shared.nodes;
    std::vector<std::int64_t> ranks(nodes.size(), shared.rank);
    file.check(ex_put_node_cmap(id, shared.rank + 1, nodes.data(), ranks.data(), part.rank),
               "a communication map");
  }
}

}  // namespace stroma::output
