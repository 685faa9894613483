// SPDX-License-Identifier: BSD-3-Clause

#include "run/RunReport.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <vector>

#include "run/MovingSupports.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/output/files/Manifest.hpp"
#include "stroma/output/files/ParticleReader.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/report/Packed.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {
namespace {

using nlohmann::json;

// What a report takes of each, so that it has at most 30 MB whatever does not compress: maps of 16
// bits and a slice of 8 bits, a third more in base64.
constexpr std::size_t most_map_values = 9'000'000, most_steps = 32, most_image_values = 3'000'000;
constexpr std::size_t most_history_rows = 2000, most_table_rows = 2000, most_log_bytes = 200'000;

/// Head and tail of a log that is long, in whole lines.
std::string shortened(const std::string& text) {
  if (text.size() <= most_log_bytes) return text;
  const std::size_t head = text.rfind('\n', most_log_bytes / 2),
                    tail = text.find('\n', text.size() - most_log_bytes / 2);
  if (head == std::string::npos || tail == std::string::npos) return text.substr(0, most_log_bytes);
  return text.substr(0, head) + "\n[...]" + text.substr(tail);
}

/// Maps of particles.e, and the edges of the body's box by them; null where there is no such file.
json maps_of(const output::RunFiles& files, std::array<double, 3>& length,
             std::vector<output::PageArray>& arrays) {
  std::optional<output::ParticleReader> particles;
  try {
    particles.emplace(files.particles());
  } catch (const base::RunError&) {
    return nullptr;
  }
  if (particles->steps() == 0) return nullptr;
  const output::ParticleMaps maps = output::particle_maps(*particles, most_steps, most_map_values);
  length = maps.lattice.length;
  return output::describe(maps, particles->global("load"), particles->global("step"),
                          particles->global("time"), arrays);
}

/// How many voxels along x and y, and how many planes, make one of the report's.
std::array<std::int64_t, 3> merged_voxels(const voxels::IntensityVolume& volume) {
  output::MapLattice voxels;
  voxels.cell = volume.voxel_size;
  voxels.count = volume.size;
  return output::merged(voxels, most_image_values).merged;
}

/// The image that the specimen was made from, in 8 bits: means over merged voxels of every n-th
/// plane. On rank 0; a text that says why there is none where it cannot be read. Collective.
json image_of(const base::Communicator& communicator, const Deck& deck,
              std::vector<output::PageArray>& arrays) {
  const image::ImageParameters& parameters = deck.parameters.image;
  if (!parameters.file) return "The specimen is a phantom: there is no image.";
  image::ImageSummary summary;
  std::optional<voxels::IntensityVolume> volume;
  try {
    volume = image::read_volume(communicator, parameters, deck.document.folder(), summary,
                                image::require_voxel_size);
  } catch (const base::InputError& error) {
    return std::string("The image cannot be read any more: ") + error.what();
  }
  const auto [least, most] = std::minmax_element(volume->values.begin(), volume->values.end());
  const bool has_any = !volume->values.empty();
  const double low = communicator.min(has_any ? *least : HUGE_VAL),
               high = communicator.max(has_any ? *most : -HUGE_VAL);
  const double scale = high > low ? 255.0 / (high - low) : 0.0;
  const std::array<std::int64_t, 3>&size = volume->size, merged = merged_voxels(*volume);
  const std::int64_t nx = (size[0] + merged[0] - 1) / merged[0],
                     ny = (size[1] + merged[1] - 1) / merged[1];
  std::vector<std::uint8_t> bytes;
  std::vector<double> sum, voxels;
  for (std::int64_t k = merged[2] / 2; k < size[2]; k += merged[2]) {
    const voxels::Box plane{{0, 0, k}, {size[0], size[1], 1}};
    const std::vector<double> values =
        voxels::extract(communicator, *volume, communicator.is_root() ? plane : voxels::Box());
    if (!communicator.is_root()) continue;
    sum.assign(static_cast<std::size_t>(nx * ny), 0.0);
    voxels.assign(sum.size(), 0.0);
    for (std::size_t v = 0; v < values.size(); ++v) {
      const auto i = static_cast<std::int64_t>(v) % size[0],
                 j = static_cast<std::int64_t>(v) / size[0];
      const auto cell = static_cast<std::size_t>(j / merged[1] * nx + i / merged[0]);
      sum[cell] += values[v];
      voxels[cell] += 1.0;
    }
    for (std::size_t c = 0; c < sum.size(); ++c)
      bytes.push_back(static_cast<std::uint8_t>(std::lround((sum[c] / voxels[c] - low) * scale)));
  }
  if (!communicator.is_root()) return nullptr;
  json image{{"low", low}, {"high", high}, {"merged", merged}, {"format", summary.format}};
  image["count"] = {nx, ny, static_cast<std::int64_t>(bytes.size()) / (nx * ny)};
  for (std::size_t d = 0; d < 3; ++d) {
    image["cell"].push_back(volume->voxel_size[d] * static_cast<double>(merged[d]));
    image["origin"].push_back(volume->voxel_size[d] *
                              static_cast<double>(volume->first_in_file[d]));
  }
  arrays.emplace_back("image", output::packed(bytes));
  return image;
}

/// Whether a condition holds more than one component: grips that let nothing slide.
bool holds_sideways(const DeckParameters& parameters) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  return std::any_of(conditions.begin(), conditions.end(), [](const auto& named) {
    return int{named.second.prescribes(0)} + int{named.second.prescribes(1)} +
               int{named.second.prescribes(2)} >
           1;
  });
}

/// What the page has to know of the faces that turn.
json described_turns(const DeckParameters& parameters) {
  json turns = json::array();
  for (const auto& [name, condition] : parameters.boundary_conditions.conditions)
    if (condition.rotation)
      turns.push_back({{"name", name},
                       {"degrees", *condition.rotation},
                       {"follows_load", condition.curve.is_load()}});
  return turns;
}

/// For one rank.
json data_of(const Deck& deck, const output::RunFiles& files,
             std::vector<output::PageArray>& arrays) {
  const DeckParameters& p = deck.parameters;
  std::array<double, 3> length{1.0, 1.0, 1.0};
  json data{{"kind", "run"},
            {"title", p.title},
            {"folder", std::filesystem::absolute(files.folder()).filename().string()},
            {"made_by", output::program_version()},
            {"deck", deck.text},
            {"log", shortened(base::file_content(files.log()))},
            {"history",
             output::table_excerpt(base::file_content(files.history()), most_history_rows, true)},
            {"materials", names(p.materials.materials)},
            {"conditions", names(p.boundary_conditions.conditions)},
            {"turning", described_turns(p)},
            {"pressures", history_names(p).pressing},
            {"holds_sideways", holds_sideways(p)},
            {"has_time", p.loading.has_time()},
            {"y_downwards", p.output.origin == output::Origin::Top}};
  data["maps"] = maps_of(files, length, arrays);
  data["length"] = length;
  data["supports"] = described_supports(p, length);
  data["tables"] = json::object();
  for (const std::string& table : output::table_files()) {
    const std::string text = base::file_content(files.file(table));
    if (!text.empty()) data["tables"][table] = output::table_excerpt(text, most_table_rows, false);
  }
  return data;
}

/// Writes report.html whole or not at all, in place of an earlier one, and says where it is.
/// Collective.
/// \param page   on rank 0
/// \param start  when it was begun [s], by MPI_Wtime()
/// \throws base::InputError when a file of that name is there that is no report
/// \throws base::RunError
void write_report(const base::Communicator& communicator, const std::string& folder,
                  const std::string& page, double start, base::Log& log) {
  const std::string path = output::RunFiles(folder).file("report.html");
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !output::Manifest::begins_as_written(path))
      throw base::InputError("'" + path + "' is no report of Stroma; move it away, or rename it");
    output::replace_file(path, page);
    if (std::filesystem::exists(output::RunFiles(folder).file(".stroma_files"), ignored))
      output::Manifest(folder).finish({"report.html"});  // the next run may remove it
  });
  log.line(base::format("report      %s, %.1f MB, made in %.1f s", path.c_str(),
                        static_cast<double>(page.size()) * 1e-6, MPI_Wtime() - start));
}

}  // namespace

json described_supports(const DeckParameters& parameters, const std::array<double, 3>& length) {
  json supports = json::array();
  for (const output::MovingSupport& support : moving_supports(parameters, length))
    supports.push_back({{"name", support.name},
                        {"displacement", support.displacement},
                        {"strain", support.strain},
                        {"follows_load", support.follows_load}});
  return supports;
}

std::string said_in(const std::string& log, const std::string& word) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(word + " ", 0) == 0)
      return line.substr(std::min(line.find_first_not_of(' ', word.size()), line.size()));
  return "";
}

void run_report(const base::Communicator& communicator, const std::string& folder, base::Log& log) {
  const double start = MPI_Wtime();
  const output::RunFiles files(folder);
  std::optional<Deck> deck;
  json data;
  std::vector<output::PageArray> arrays;
  base::collectively(communicator, [&] {
    for (const std::string& file : {files.deck(), files.history()})
      if (!std::filesystem::is_regular_file(file))
        throw base::InputError("'" + folder + "' is no folder of results: it has no " +
                               std::filesystem::path(file).filename().string());
    deck = read_deck(files.deck(), {});
    if (communicator.is_root()) data = data_of(*deck, files, arrays);
  });
  const json image = image_of(communicator, *deck, arrays);
  std::string page;
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    data["image"] = image;
    page = output::report_page(deck->parameters.title, data, arrays);
  });
  write_report(communicator, folder, page, start, log);
}

void report_of_tables(const base::Communicator& communicator, const std::string& folder,
                      const std::string& what, const std::string& table,
                      const std::function<json(const output::RunFiles&)>& data_of, base::Log& log) {
  const double start = MPI_Wtime();
  const output::RunFiles files(folder);
  std::string page;
  base::collectively(communicator, [&] {
    if (!std::filesystem::is_regular_file(files.file(table)))
      throw base::InputError("'" + folder + "' is no folder of " + what + ": it has no " + table);
    if (!communicator.is_root()) return;
    const json data = data_of(files);
    page = output::report_page(data["title"].get<std::string>(), data, {});
  });
  write_report(communicator, folder, page, start, log);
}

}  // namespace stroma
