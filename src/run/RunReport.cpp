// SPDX-License-Identifier: BSD-3-Clause

#include "run/RunReport.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "run/MovingSupports.hpp"
#include "run/ReportFile.hpp"
#include "run/SpecimenSlices.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/ParticleReader.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {
namespace {

using nlohmann::json;

// What a report takes of each, so that it has at most 30 MB whatever does not compress: maps of 16
// bits and a slice of 8 bits, a third more in base64.
constexpr std::size_t most_map_values = 9'000'000, most_steps = 32;
constexpr std::size_t most_history_rows = 2000, most_table_rows = 2000;

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

/// Whether a condition holds more than one component: grips that let nothing slide.
bool holds_sideways(const DeckParameters& parameters) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  return std::any_of(conditions.begin(), conditions.end(), [](const auto& named) {
    return int{named.second.prescribes(0)} + int{named.second.prescribes(1)} +
               int{named.second.prescribes(2)} >
           1;
  });
}

using mechanics::BoundaryCondition;
using mechanics::Face;

/// Along which axes walls at both ends keep the body's length.
json described_walls(const DeckParameters& parameters, const std::array<double, 3>& length) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  json walls = json::array();
  for (int axis = 0; axis < 3; ++axis) {
    const auto stands = [&](bool upper) {
      const Face face = mechanics::face_of(axis, upper);
      const std::array<double, 3> at = upper ? length : std::array<double, 3>{};
      return std::any_of(conditions.begin(), conditions.end(), [&](const auto& named) {
        const BoundaryCondition& condition = named.second;
        return condition.applies_to(face) && condition.keeps_plane(face) && !condition.images &&
               condition.full(axis, at, {}, length) == 0.0;
      });
    };
    walls.push_back(stands(false) && stands(true));
  }
  return walls;
}

/// Shear strains of the body between faces that move in their planes and faces that stay, by the
/// names of the conditions that move.
json described_shears(const DeckParameters& parameters, const std::array<double, 3>& length) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  json shears = json::object();
  for (const output::MovingSupport& support : moving_supports(parameters, length)) {
    const std::optional<Face> face = conditions[support.index].second.face;
    if (!face || *face == Face::all) continue;
    const int axis = mechanics::axis_of(*face);
    const auto a = static_cast<std::size_t>(axis);
    const Face opposite = mechanics::face_of(axis, !mechanics::is_upper(*face));
    const bool is_held = std::any_of(conditions.begin(), conditions.end(), [&](const auto& named) {
      const BoundaryCondition& condition = named.second;
      return condition.face == opposite && condition.loaded_component(length) < 0 &&
             condition.prescribes((axis + 1) % 3) && condition.prescribes((axis + 2) % 3) &&
             !condition.images && !condition.rotation;
    });
    if (is_held && support.displacement[a] == 0.0)
      shears[support.name] =
          std::hypot(support.displacement[(a + 1) % 3], support.displacement[(a + 2) % 3]) /
          length[a];
  }
  return shears;
}

/// By how much a body is stretched between faces that move along one axis in proportion to the load, if
/// that is all that strains it; else null.
json described_stretch(const DeckParameters& parameters, const std::array<double, 3>& length) {
  const auto& conditions = parameters.boundary_conditions.conditions;
  const auto& materials = parameters.materials.materials;
  if (!parameters.external_forces.forces.empty() ||
      std::any_of(materials.begin(), materials.end(), [](const auto& named) {
        return named.second.active_stress || named.second.growth ||
               material::is_pressure(named.second);
      }))
    return nullptr;
  std::optional<int> axis;
  double strain = 0.0;
  for (const auto& [name, condition] : conditions) {
    if (condition.images || condition.rotation || condition.displacement_gradient) return nullptr;
    if (condition.loaded_component(length) < 0) continue;
    if (condition.face == Face::all || !condition.curve.is_load()) return nullptr;
    const int along = mechanics::axis_of(*condition.face);
    if (axis && along != *axis) return nullptr;
    axis = along;
    for (int c = 0; c < 3; ++c) {
      const double moved = condition.prescribes(c) ? condition.full(c, {}, {}, length) : 0.0;
      if (c == along)
        strain += (mechanics::is_upper(*condition.face) ? moved : -moved) /
                  length[static_cast<std::size_t>(c)];
      else if (moved != 0.0)
        return nullptr;
    }
  }
  return axis && strain != 0.0 ? json{{"axis", *axis}, {"strain", strain}} : json(nullptr);
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
            {"log", log_excerpt(files)},
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
  data["shears"] = described_shears(p, length);
  data["walls"] = described_walls(p, length);
  data["stretch"] = data["maps"].is_null() ? json(nullptr) : described_stretch(p, length);
  data["tables"] = json::object();
  for (const std::string& table : output::table_files()) {
    const std::string text = base::file_content(files.file(table));
    if (!text.empty()) data["tables"][table] = output::table_excerpt(text, most_table_rows, false);
  }
  return data;
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

void run_report(const base::Communicator& communicator, const std::string& folder, base::Log& log) {
  const auto collect = [&](const output::RunFiles& files, std::vector<output::PageArray>& arrays) {
    std::optional<Deck> deck;
    json data;
    base::collectively(communicator, [&] {
      deck = read_deck(files.deck(), {});
      if (communicator.is_root()) data = data_of(*deck, files, arrays);
    });
    const json image = image_slices(communicator, *deck, arrays);
    if (communicator.is_root()) data["image"] = image;
    return data;
  };
  make_report(communicator, folder, "results", {"deck.xml", "history.csv"}, collect, log);
}

}  // namespace stroma
