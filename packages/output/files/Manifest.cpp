// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/Manifest.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Sha256.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma::output {
namespace {

namespace fs = std::filesystem;

const char* const head =
    "Stroma wrote the files below, and its next run into this folder removes them, but for those "
    "that were changed since.";

/// Stands between the two checksums of a file.
const std::string before_whole = ", SHA-256 ";
const std::string of_samples = "of samples ";
constexpr int samples = 256;
constexpr std::size_t sample =
    1 << 16;  // bytes: 16 MiB in all, what a file may have that is read whole

/// Some bytes of a file from a place on.
std::string bytes_of(std::ifstream& file, std::uintmax_t place, std::size_t count) {
  std::string bytes(count, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(place));
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// The files in a folder, relative to it, in order.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code failure;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (!entry->is_directory() || entry->is_symlink())
      files.push_back(entry->path().lexically_relative(folder).string());
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether all files in a folder are such as those of Zarr: .zattrs, .zarray, .zgroup and numbers.
bool is_like_zarr(const fs::path& folder) {
  const std::vector<std::string> files = files_in(folder);
  return std::all_of(files.begin(), files.end(), [](const std::string& file) {
    const std::string name = fs::path(file).filename().string();
    return name.rfind(".z", 0) == 0 || name.find_first_not_of("0123456789") == std::string::npos;
  });
}

/// Whether a text is how a log begins: behind notes, with the first line of a run, a study or a fit.
bool is_begin_of_log(const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  const auto is = [&](const char* begin) { return line.rfind(begin, 0) == 0; };
  do {
    if (!std::getline(lines, line)) return false;
  } while (is("note: "));
  return is("removed     ") || is("image      ") || is("goes on    after step ") ||
         is("title       ") || is("study       ") || is("fit         ");
}

}  // namespace

Manifest::Manifest(std::string folder) : folder_(std::move(folder)) {
  std::ifstream file(folder_ + "/.stroma_files");
  std::string line;
  if (!std::getline(file, line) || line != head) return;
  while (std::getline(file, line)) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos) continue;
    const std::string name = line.substr(0, tab), rest = line.substr(tab + 1);
    const std::size_t whole = rest.find(before_whole);
    if (rest == "being written")
      being_written_.push_back(name);
    else if (whole == std::string::npos)
      finished_[name] = {rest, ""};
    else
      finished_[name] = {rest.substr(0, whole), rest.substr(whole + before_whole.size())};
  }
}

void Manifest::begin(const std::vector<std::string>& names) {
  being_written_ = names;
  finished_.clear();
  write();
}

void Manifest::finish(const std::vector<std::string>& files) {
  for (const std::string& file : files)
    finished_[file] = {fingerprint(file), whole_checksum(folder_ + "/" + file)};
  write();
}

void Manifest::end(const std::vector<std::string>& files, const std::vector<std::string>& sums) {
  being_written_ = {"log.txt"};
  for (std::size_t f = 0; f < files.size(); ++f)
    if (files[f] != "log.txt") finished_[files[f]] = {fingerprint(files[f]), sums[f]};
  write();
}

std::string Manifest::whole_checksum(const std::string& path) {
  std::error_code ignored;
  try {
    if (fs::is_directory(path, ignored)) return base::sha256_of_files(path, files_in(path));
    const std::uintmax_t size = fs::file_size(path, ignored);
    return ignored || size <= samples * sample
               ? base::sha256_of_file(path)
               : of_samples + base::sha256_of_samples(path, size, samples, sample);
  } catch (const base::RunError&) {
    return "";
  }
}

bool Manifest::has_ended() const { return being_written_ == std::vector<std::string>{"log.txt"}; }

std::vector<std::string> Manifest::finished() const {
  std::vector<std::string> files;
  for (const auto& [file, mark] : finished_) files.push_back(file);
  return files;
}

bool Manifest::has_whole_checksum(const std::string& file) const {
  return !finished_.at(file).whole.empty();
}

bool Manifest::is_sampled(const std::string& file) const {
  return finished_.at(file).whole.rfind(of_samples, 0) == 0;
}

std::string Manifest::departure(const std::string& file) const {
  const std::string path = folder_ + "/" + file;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return "is missing";
  const auto size_in = [](const std::string& mark) { return mark.substr(0, mark.find(',')); };
  const Mark& left = finished_.at(file);
  const std::string quick = fingerprint(file);
  if (quick == "unknown") return "cannot be read";
  if (!fs::is_directory(path, ignored) && size_in(quick) != size_in(left.quick))
    return "was changed: " + size_in(quick) + " instead of " + size_in(left.quick);
  if (quick != left.quick) return "was changed: another content";
  if (left.whole.empty()) return "";
  const std::string whole = whole_checksum(path);
  if (whole.empty()) return "cannot be read";
  return whole == left.whole ? "" : "was changed: another content";
}

std::vector<std::string> Manifest::files() const {
  std::set<std::string> found;
  std::error_code ignored;
  const auto add = [&](const std::string& file) {
    if (fs::exists(fs::symlink_status(fs::path(folder_) / file, ignored))) found.insert(file);
  };
  for (const std::string& name : being_written_) add(name);
  for (const auto& [file, mark] : finished_) add(file);
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const std::string file = entry.path().filename().string(), name = name_of(file);
    if (name != file && std::count(being_written_.begin(), being_written_.end(), name) > 0)
      add(file);
  }
  return {found.begin(), found.end()};
}

bool Manifest::is_own(const std::string& file) const {
  const fs::path path = fs::path(folder_) / file;
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(path, ignored);
  const bool may_be_folder = path.filename().string().find(".zarr") != std::string::npos;
  if (!fs::is_regular_file(status) && !(may_be_folder && fs::is_directory(status))) return false;
  const auto found = finished_.find(file);
  if (found != finished_.end()) return found->second.quick == fingerprint(file);
  return std::count(being_written_.begin(), being_written_.end(), name_of(file)) > 0 &&
         begins_as_written(path);
}

bool Manifest::begins_as_written(const std::string& file_path) {
  const fs::path path = file_path;
  if (fs::is_directory(path)) return is_like_zarr(path);
  std::ifstream file(path, std::ios::binary);
  const std::string begin = bytes_of(file, 0, 4096);
  const auto is = [&](const std::string& text) { return begin.rfind(text, 0) == 0; };
  const std::string ending = path.extension().string(), name = path.filename().string();
  if (begin.empty() || ending == ".new") return true;
  if (name == "log.txt") return is_begin_of_log(begin);
  if (ending == ".xml") return is("<!-- The deck as it was run");
  if (ending == ".csv")
    return is("step,load,") || is("step,time,") || is("material,") || is("label_material,") ||
           is("object,") || is("member,") || is("series,") || is("run,") || is("parameter,") ||
           is("measurement,") || is("load,") || is("input,") || is("boundary,");
  if (ending == ".json") return is("{\n  \"stiffness\"");
  if (ending == ".series") return is("{\n \"file-series-version\"");
  if (ending == ".html") return is("<!doctype html>\n<!-- A report of Stroma");
  if (ending == ".png") return is("\x89PNG");
  if (ending == ".tif") return is("II") || is("MM");
  if (ending == ".gp") return is("# Draws ../");
  return ending == ".dat" || ending == ".raw" || is("\x89HDF") || is("CDF");
}

std::string Manifest::name_of(const std::string& file) {
  static const std::regex spread("((particles|grid)\\.e)(-s[0-9]+)?(\\.[0-9]+\\.[0-9]+)?");
  static const std::regex step("(particles|grid)-s[0-9]+(\\.hdf)(\\.new)?");
  static const std::regex stack("(image_(un)?deformed)-s[0-9]+(\\.ome\\.(tif|zarr)(\\.new)?)");
  std::smatch parts;
  if (std::regex_match(file, parts, stack)) return parts[1].str() + parts[3].str();
  if (std::regex_match(file, parts, step)) return parts[1].str() + parts[2].str();
  return std::regex_match(file, parts, spread) ? parts[1].str() : file;
}

void Manifest::write() const {
  std::string text = std::string(head) + "\n";
  for (const std::string& name : being_written_) text += name + "\tbeing written\n";
  for (const auto& [file, mark] : finished_) {
    text += file + "\t" + mark.quick;
    if (!mark.whole.empty()) text += before_whole + mark.whole;
    text += "\n";
  }
  replace_file(folder_ + "/.stroma_files", text);
}

/// Size, and FNV-1a of the first and the last 64 KiB: any program that changes a results file of
/// gigabytes changes its head, and that is read in no time. Of a folder, the same of each file in
/// it, by name.
std::string Manifest::fingerprint(const std::string& file) const {
  constexpr std::size_t piece = 1u << 16;
  const std::string path = folder_ + "/" + file;
  std::error_code failure;
  std::uintmax_t size = 0;
  std::string bytes;
  if (fs::is_directory(path, failure)) {
    for (const std::string& one : files_in(path))
      bytes += one + ": " + fingerprint(file + "/" + one) + "\n";
    size = bytes.size();
  } else {
    size = fs::file_size(path, failure);
    if (failure) return "unknown";
    std::ifstream stream(path, std::ios::binary);
    bytes = bytes_of(stream, 0, piece);
    if (size > piece)
      bytes += bytes_of(stream, std::max<std::uintmax_t>(piece, size - piece), piece);
  }
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return base::format("%llu bytes, checksum %016llx", static_cast<unsigned long long>(size),
                      static_cast<unsigned long long>(hash));
}

}  // namespace stroma::output
