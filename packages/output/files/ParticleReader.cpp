// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/ParticleReader.hpp"

#include <netcdf.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/ExodusFile.hpp"

namespace stroma::output {
namespace {

namespace fs = std::filesystem;

/// Particles that a piece has at most, and how far apart in the file's order its first and last may
/// be.
constexpr std::size_t piece_size = ExodusFile::piece, piece_span = 8 * piece_size;

/// A file of netCDF, and what is read of it.
class Reader {
 public:
  Reader(int id, const std::string& path) : id_(id), path_(path) {}

  void check(int code) const {
    if (code != NC_NOERR) throw base::RunError("cannot read '" + path_ + "': " + nc_strerror(code));
  }
  /// Length of a dimension; 0 if there is none, as of an empty block.
  std::size_t length(const std::string& dimension) const {
    int found = -1;
    std::size_t length = 0;
    if (nc_inq_dimid(id_, dimension.c_str(), &found) == NC_NOERR)
      check(nc_inq_dimlen(id_, found, &length));
    return length;
  }
  std::vector<double> numbers(const std::string& variable, const std::vector<std::size_t>& from,
                              const std::vector<std::size_t>& size) const {
    std::vector<double> values(product(size));
    check(nc_get_vara_double(id_, number_of(variable), from.data(), size.data(), values.data()));
    return values;
  }
  std::vector<long long> integers(const std::string& variable, std::size_t from,
                                  std::size_t size) const {
    std::vector<long long> values(size);
    const std::size_t first[2] = {from, 0}, count[2] = {size, 1};
    check(nc_get_vara_longlong(id_, number_of(variable), first, count, values.data()));
    return values;
  }
  /// A list of names; empty if there is none.
  std::vector<std::string> names(const std::string& variable, const std::string& count) const {
    std::vector<std::string> names;
    const std::size_t entries = length(count);
    int dimensions[2] = {-1, -1};
    std::size_t letters = 0;
    if (entries == 0) return names;
    check(nc_inq_vardimid(id_, number_of(variable), dimensions));
    check(nc_inq_dimlen(id_, dimensions[1], &letters));
    std::vector<char> text(entries * letters + 1, '\0');
    check(nc_get_var_text(id_, number_of(variable), text.data()));
    for (std::size_t n = 0; n < entries; ++n) {
      const std::string name(text.data() + n * letters, letters);
      names.emplace_back(name.c_str());  // up to the first zero
    }
    return names;
  }

 private:
  static std::size_t product(const std::vector<std::size_t>& factors) {
    std::size_t result = 1;
    for (const std::size_t factor : factors) result *= factor;
    return result;
  }
  int number_of(const std::string& variable) const {
    int number = -1;
    check(nc_inq_varid(id_, variable.c_str(), &number));
    return number;
  }

  int id_;
  const std::string& path_;
};

/// The files of the newest whole set.
std::vector<std::string> files_of(const std::string& path) {
  if (fs::is_regular_file(path)) return {path};
  const std::regex first(R"(.*\.([0-9]+)\.0+)");
  std::optional<fs::file_time_type> newest;
  std::vector<std::string> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path(), ignored)) {
    const std::string name = entry.path().string();
    std::smatch parts;
    if (name.rfind(path + ".", 0) != 0 || !std::regex_match(name, parts, first)) continue;
    const int ranks = std::stoi(parts[1].str().substr(0, 6));
    std::vector<std::string> set;
    for (int r = 0; r < ranks; ++r) set.push_back(spread_file_name(path, ranks, r));
    const bool is_whole = std::all_of(
        set.begin(), set.end(), [](const std::string& file) { return fs::is_regular_file(file); });
    const fs::file_time_type time = fs::last_write_time(entry.path(), ignored);
    if (!is_whole || (newest && time <= *newest)) continue;
    newest = time;
    files = std::move(set);
  }
  if (files.empty()) throw base::RunError("there is no '" + path + "'");
  return files;
}

}  // namespace

ParticleReader::ParticleReader(const std::string& path) {
  keep_no_variables_in_memory();
  for (const std::string& name : files_of(path)) {
    File file{name, nullptr, {}};
    int id = -1;
    Reader(id, name).check(nc_open(name.c_str(), NC_NOWRITE, &id));
    file.id = {new int(id), [](const int* open) {
                 nc_close(*open);
                 delete open;
               }};
    const Reader reader(id, name);
    const std::size_t blocks = reader.length("num_el_blk");
    for (std::size_t b = 1; b <= blocks; ++b)
      file.blocks.push_back(reader.length(base::format("num_el_in_blk%zu", b)));
    const std::size_t steps = reader.length("time_step");
    if (files_.empty()) {
      materials_ = reader.names("eb_names", "num_el_blk");
      variables_ = reader.names("name_elem_var", "num_elem_var");
      globals_ = reader.names("name_glo_var", "num_glo_var");
      steps_ = steps;
    }
    steps_ = std::min(steps_, steps);  // of a killed run, one rank may have a step more
    files_.push_back(std::move(file));
  }
}

std::vector<double> ParticleReader::global(const std::string& name) const {
  const auto found = std::find(globals_.begin(), globals_.end(), name);
  const File& file = files_.front();
  if (found == globals_.end())
    throw base::RunError("'" + file.path + "' has no global variable " + name);
  if (steps_ == 0) return {};
  return Reader(*file.id, file.path)
      .numbers("vals_glo_var", {0, static_cast<std::size_t>(found - globals_.begin())},
               {steps_, 1});
}

void ParticleReader::for_pieces(std::size_t step, const std::vector<std::string>& names,
                                const std::function<void(const ParticlePiece&)>& use) const {
  std::vector<std::size_t> numbers;
  for (const std::string& name : names) {
    const auto found = std::find(variables_.begin(), variables_.end(), name);
    if (found == variables_.end())
      throw base::RunError("'" + files_.front().path + "' has no variable " + name);
    numbers.push_back(static_cast<std::size_t>(found - variables_.begin()) + 1);
  }
  for (const File& file : files_) {
    const Reader reader(*file.id, file.path);
    for (std::size_t b = 0; b < file.blocks.size(); ++b) {
      for (std::size_t first = 0; first < file.blocks[b];) {
        std::vector<long long> nodes = reader.integers(
            base::format("connect%zu", b + 1), first, std::min(piece_size, file.blocks[b] - first));
        const auto end = std::find_if(nodes.begin(), nodes.end(), [&](long long node) {
          return node >= nodes.front() + static_cast<long long>(piece_span);
        });
        nodes.erase(end, nodes.end());  // nodes ascend within a block
        ParticlePiece piece;
        piece.material = b;
        piece.count = nodes.size();
        const auto low = static_cast<std::size_t>(nodes.front() - 1);
        const auto span = static_cast<std::size_t>(nodes.back() - nodes.front() + 1);
        for (int axis = 0; axis < 3; ++axis) {
          const auto all = reader.numbers(std::string("coord") + "xyz" [axis], { low }, {span});
          for (const long long node : nodes)
            piece.position[static_cast<std::size_t>(axis)].push_back(
                all[static_cast<std::size_t>(node - nodes.front())]);
        }
        piece.volume =
            reader.numbers(base::format("attrib%zu", b + 1), {first, 1}, {piece.count, 1});
        for (const std::size_t number : numbers)
          piece.values.push_back(
              reader.numbers(base::format("vals_elem_var%zueb%zu", number, b + 1), {step, first},
                             {1, piece.count}));
        use(piece);
        first += piece.count;
      }
    }
  }
}

}  // namespace stroma::output
