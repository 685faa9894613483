// SPDX-License-Identifier: BSD-3-Clause

#include "stiffness/StiffnessReport.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "run/ReportFile.hpp"
#include "run/SpecimenSlices.hpp"
#include "stiffness/ElasticTensor.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/base/FileContent.hpp"
#include "stroma/output/files/ProgramFacts.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/output/report/ReportPage.hpp"

namespace stroma {
namespace {

using nlohmann::json;

/// The compliance of a stiffness in the file; null where there is none.
json compliance_of(const json& rows) {
  if (rows.is_null()) return nullptr;
  Matrix6 stiffness;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      stiffness(i, j) =
          rows.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j)).get<double>();
  const std::optional<Matrix6> compliance = stroma::compliance_of(stiffness);
  if (!compliance) return nullptr;
  json inverse = json::array();
  for (int i = 0; i < 6; ++i) {
    inverse.push_back(json::array());
    for (int j = 0; j < 6; ++j) inverse.back().push_back((*compliance)(i, j));
  }
  return inverse;
}

/// For one rank.
json data_of(const Deck& deck, const output::RunFiles& files) {
  const std::string path = files.file("stiffness.json");
  const std::string text = base::file_content(path);
  json compliances = json::object();
  try {
    const json found = json::parse(text);
    for (const char* bound : {"Voigt", "Reuss"})
      compliances[bound] = compliance_of(found.at(bound));
  } catch (const json::exception& error) {
    throw base::RunError("'" + path + "' is no stiffness.json of Stroma: " + error.what());
  }
  return {{"kind", "stiffness"},
          {"title", deck.parameters.title},
          {"folder", std::filesystem::absolute(files.folder()).filename().string()},
          {"made_by", output::program_version()},
          {"deck", deck.text},
          {"log", log_excerpt(files)},
          {"found", text},
          {"compliances", compliances},
          {"y_downwards", deck.parameters.output.origin == output::Origin::Top}};
}

}  // namespace

void stiffness_report(const base::Communicator& communicator, const std::string& folder,
                      base::Log& log) {
  const auto collect = [&](const output::RunFiles& files, std::vector<output::PageArray>& arrays) {
    std::optional<Deck> deck;
    json data;
    base::collectively(communicator, [&] {
      deck = read_deck(files.deck(), {});
      if (communicator.is_root()) data = data_of(*deck, files);
    });
    const json image = image_slices(communicator, *deck, arrays),
               materials = material_slices(communicator, *deck, arrays);
    if (communicator.is_root()) {
      data["image"] = image;
      data["maps"] = materials;
    }
    return data;
  };
  make_report(communicator, folder, "a stiffness", {"deck.xml", "stiffness.json"}, collect, log);
}

}  // namespace stroma
