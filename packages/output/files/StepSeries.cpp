// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/StepSeries.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/output/files/Manifest.hpp"
#include "stroma/output/files/WriteFile.hpp"

namespace stroma::output {
namespace fs = std::filesystem;

StepSeries::StepSeries(const base::Communicator& communicator, std::string folder, std::string name)
    : communicator_(communicator), folder_(std::move(folder)), name_(std::move(name)) {}

std::vector<std::pair<std::string, double>> StepSeries::listed(const std::string& path) {
  const std::string text = base::file_content(path);
  try {
    const auto list = nlohmann::json::parse(text);
    std::vector<std::pair<std::string, double>> files;
    for (const auto& file : list.at("files")) files.emplace_back(file.at("name"), file.at("time"));
    return files;
  } catch (const nlohmann::json::exception&) {
    throw base::RunError("'" + path + "' is not there, or no list of files");
  }
}

std::string StepSeries::path(std::int64_t step) const {
  return folder_ + "/" +
         base::format("%s-s%04lld.hdf", name_.c_str(), static_cast<long long>(step));
}

void StepSeries::resume(const std::vector<Step>& steps) {
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    std::set<std::string> kept;
    std::error_code failure;
    for (const Step& step : steps)
      if (fs::exists(path(step.first), failure)) {
        steps_.push_back(step);
        kept.insert(fs::path(path(step.first)).filename().string());
      }
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string file = entry.path().filename().string();
      if (Manifest::name_of(file) != name_ + ".hdf" || kept.count(file) > 0) continue;
      fs::remove(entry.path(), failure);
      if (failure) throw base::RunError(file + ": cannot be removed: " + failure.message());
    }
    if (!steps_.empty()) write();
  });
}

void StepSeries::add(const Step& step) {
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    if (steps_.empty() || steps_.back().first < step.first) steps_.push_back(step);
    write();
  });
}

void StepSeries::write() const {
  nlohmann::ordered_json list;
  list["file-series-version"] = "1.0";
  for (const auto& [number, time] : steps_)
    list["files"].push_back({{"name", fs::path(path(number)).filename()}, {"time", time}});
  replace_file(folder_ + "/" + name_ + ".hdf.series", list.dump(1) + "\n");
}

}  // namespace stroma::output
