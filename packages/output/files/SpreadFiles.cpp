// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/SpreadFiles.hpp"

#include <netcdf.h>

#include <algorithm>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::output {
namespace {

void check(int code, const std::string& path) {
  if (code != NC_NOERR) throw base::RunError("cannot read '" + path + "': " + nc_strerror(code));
}

/// Length of a dimension; 0 if there is none, as of an empty block.
std::size_t length_of(int file, const std::string& dimension) {
  int id = -1;
  std::size_t length = 0;
  if (nc_inq_dimid(file, dimension.c_str(), &id) != NC_NOERR) return 0;
  nc_inq_dimlen(file, id, &length);
  return length;
}

std::shared_ptr<const int> opened(const std::string& path) {
  int id = -1;
  check(nc_open(path.c_str(), NC_NOWRITE, &id), path);
  return {new int(id), [](const int* open) {
            nc_close(*open);
            delete open;
          }};
}

}  // namespace

SpreadFiles::SpreadFiles(const std::string& path, int ranks, ExodusStep::At at,
                         const std::vector<std::int64_t>& ids)
    : at_(at), wanted_(ids.size()) {
  std::vector<std::pair<std::int64_t, std::size_t>> sorted;
  for (std::size_t n = 0; n < ids.size(); ++n) sorted.emplace_back(ids[n], n);
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> is_found(ids.size(), false);
  const bool at_nodes = at == ExodusStep::At::nodes;
  for (int r = 0; r < ranks; ++r) {
    File kept;
    kept.path = spread_file_name(path, ranks, r);
    kept.id = opened(kept.path);
    const std::size_t count = length_of(*kept.id, at_nodes ? "num_nodes" : "num_elem");
    std::vector<long long> map(count);
    int variable = -1;
    if (count > 0) {
      check(nc_inq_varid(*kept.id, at_nodes ? "node_num_map" : "elem_num_map", &variable),
            kept.path);
      check(nc_get_var_longlong(*kept.id, variable, map.data()), kept.path);
    }
    for (std::size_t e = 0; e < count; ++e) {
      const auto place = std::lower_bound(sorted.begin(), sorted.end(),
                                          std::pair<std::int64_t, std::size_t>(map[e], 0));
      if (place == sorted.end() || place->first != map[e]) continue;
      kept.entries.push_back({e, place->second});
      is_found[place->second] = true;
    }
    const std::size_t blocks = at_nodes ? 0 : length_of(*kept.id, "num_el_blk");
    for (std::size_t b = 1; b <= blocks; ++b)
      kept.blocks.push_back(length_of(*kept.id, base::format("num_el_in_blk%zu", b)));
    if (!kept.entries.empty() || r == 0)
      files_.push_back(std::move(kept));  // the first has the times
  }
  if (std::count(is_found.begin(), is_found.end(), false) > 0)
    throw base::RunError("cannot read '" + path + "': it does not hold all of the body");
  const std::size_t steps = length_of(*files_.front().id, "time_step");
  for (std::size_t s = 1; s <= steps; ++s)
    times_.push_back(read(files_.front(), "time_whole", static_cast<std::int64_t>(s), 1).front());
}

std::vector<double> SpreadFiles::read(const File& file, const std::string& name, std::int64_t step,
                                      std::size_t count) {
  std::vector<double> values(count);
  if (count == 0) return values;
  int variable = -1;
  check(nc_inq_varid(*file.id, name.c_str(), &variable), file.path);
  const std::size_t from[2] = {static_cast<std::size_t>(step - 1), 0}, size[2] = {1, count};
  check(nc_get_vara_double(*file.id, variable, from, size, values.data()), file.path);
  return values;
}

std::vector<double> SpreadFiles::globals(std::int64_t step) const {
  return read(files_.front(), "vals_glo_var", step, length_of(*files_.front().id, "num_glo_var"));
}

std::vector<double> SpreadFiles::values(std::int64_t step, int variable) const {
  std::vector<double> values(wanted_);
  for (const File& file : files_) {
    std::vector<double> all;
    if (at_ == ExodusStep::At::nodes) {
      all = read(file, base::format("vals_nod_var%d", variable), step,
                 file.entries.empty() ? 0 : length_of(*file.id, "num_nodes"));
    } else {
      for (std::size_t b = 0; b < file.blocks.size(); ++b) {
        const auto block =
            read(file, base::format("vals_elem_var%deb%zu", variable, b + 1), step, file.blocks[b]);
        all.insert(all.end(), block.begin(), block.end());
      }
    }
    for (const Entry& entry : file.entries) values[entry.wanted] = all[entry.in_file];
  }
  return values;
}

}  // namespace stroma::output
