// SPDX-License-Identifier: BSD-3-Clause

#include "run/ReportFile.hpp"

#include <mpi.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/Manifest.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {

using nlohmann::json;

std::string log_excerpt(const output::RunFiles& files) {
  constexpr std::size_t most_bytes = 200'000;
  std::string text = base::file_content(files.log());
  if (text.size() <= most_bytes) return text;
  const std::size_t head = text.rfind('\n', most_bytes / 2),
                    tail = text.find('\n', text.size() - most_bytes / 2);
  if (head == std::string::npos || tail == std::string::npos) return text.substr(0, most_bytes);
  return text.substr(0, head) + "\n[...]" + text.substr(tail);
}

std::string said_in(const std::string& log, const std::string& word) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(word + " ", 0) == 0)
      return line.substr(std::min(line.find_first_not_of(' ', word.size()), line.size()));
  return "";
}

void make_report(const base::Communicator& communicator, const std::string& folder,
                 const std::string& what, const std::vector<std::string>& needed,
                 const ReportData& collect, base::Log& log) {
  const double start = MPI_Wtime();
  const output::RunFiles files(folder);
  const std::string path = files.file("report.html");
  base::collectively(communicator, [&] {
    for (const std::string& file : needed)
      if (!std::filesystem::is_regular_file(files.file(file)))
        throw base::InputError("'" + folder + "' is no folder of " + what + ": it has no " + file);
  });
  std::vector<output::PageArray> arrays;
  const json data = collect(files, arrays);
  std::string page;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    page = output::report_page(data["title"].get<std::string>(), data, arrays);
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !output::Manifest::begins_as_written(path))
      throw base::InputError("'" + path + "' is no report of Stroma; move it away, or rename it");
    output::replace_file(path, page);
    if (std::filesystem::exists(files.file(".stroma_files"), ignored))
      output::Manifest(folder).finish({"report.html"});  // the next run may remove it
  });
  log.line(base::format("report      %s, %.1f MB, made in %.1f s", path.c_str(),
                        static_cast<double>(page.size()) * 1e-6, MPI_Wtime() - start));
}

void report_of_tables(const base::Communicator& communicator, const std::string& folder,
                      const std::string& what, const std::string& table,
                      const std::function<json(const output::RunFiles&)>& data_of, base::Log& log) {
  const auto collect = [&](const output::RunFiles& files, std::vector<output::PageArray>&) {
    json data;
    base::collectively(communicator, [&] {
      if (communicator.is_root()) data = data_of(files);
    });
    return data;
  };
  make_report(communicator, folder, what, {table}, collect, log);
}

void report_at_end(base::Log& log, const std::function<void()>& make) {
  try {
    make();
  } catch (const base::RunError& error) {
    log.note(std::string("report.html was not written: ") + error.what());
  }
}

}  // namespace stroma
