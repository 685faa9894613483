// SPDX-License-Identifier: BSD-3-Clause

#include "ReferenceCase.hpp"

#include "stroma/image/formats/WriteTiff.hpp"
#include "support/Places.hpp"

namespace stroma::test {
namespace {

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>\n";
}

std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">\n" + content + "</ParameterList>\n";
}

std::vector<CaseCondition> conditions_of(const std::string& name) {
  const auto strain = [](const char* value) { return parameter("Strain", "double", value); };
  switch (name.front()) {
    case 'C':  // rollers, symmetry planes
      return {{"bottom", "y-", "y", "", "F_y0"},
              {"top", "y+", "y", strain("0.10"), "F_y1"},
              {"left", "x-", "x", "", ""},
              {"back", "z-", "z", "", ""}};
    case 'E':
      break;
    case 'L': {
      const std::string moved =
          name[1] == '4' || name[1] == '6'
              ? parameter("Displacement Gradient", "Array(double)", "{0, 0.3, 0, 0, 0, 0, 0, 0, 0}")
              : strain(name[1] == '3' ? "-0.20" : "0.20");
      return {{"bottom", "y-", "xyz", "", "F_y0"}, {"top", "y+", "xyz", moved, "F_y1"}};
    }
    case 'T':  // a ramp, held
      return {
          {"bottom", "y-", "xyz", "", "F_y0"},
          {"top", "y+", "xyz", strain("0.10") + parameter("Load Curve", "string", "ramp"), "F_y1"}};
    default:  // clamped grips
      return {{"bottom", "y-", "xyz", "", "F_y0"}, {"top", "y+", "xyz", strain("0.10"), "F_y1"}};
  }
  if (name == "E_confined_compression") {
    return {{"bottom", "y-", "y", "", "F_y0"}, {"top", "y+", "y", strain("-0.20"), "F_y1"},
            {"left", "x-", "x", "", ""},       {"right", "x+", "x", "", ""},
            {"back", "z-", "z", "", ""},       {"front", "z+", "z", "", ""}};
  }
  // Simple shear on the whole boundary. A force at an edge counts for the condition named first.
  const std::string shear =
      parameter("Displacement Gradient", "Array(double)", "{0, 0.2, 0, 0, 0, 0, 0, 0, 0}");
  std::vector<CaseCondition> all;
  for (const auto& [face, reference] :
       {std::pair{"y+", "F_y1"}, {"y-", "F_y0"}, {"x-", ""}, {"x+", ""}, {"z-", ""}, {"z+", ""}})
    all.push_back({std::string("face ") + face, face, "xyz", shear, reference});
  return all;
}

/// Values of all points, one list for each element.
nlohmann::json by_element(const nlohmann::json& of_points) {
  nlohmann::json elements;
  for (std::size_t n = 0; n < of_points.size(); ++n) elements[n / 8].push_back(of_points[n]);
  return elements;
}

/// The cases with laws of their own (L) in the words of the others.
nlohmann::json in_one_form(nlohmann::json reference) {
  if (!reference.contains("law_of_point")) return reference;
  auto& grid = reference["grid"];
  grid["n_cells"] = grid["elements"];
  grid["cell_um"] = grid["size_um"];
  reference["quadrature"]["name"] = "gauss2";
  const auto laws = reference["law_of_point"].get<std::string>();
  for (std::size_t n = 0; n < laws.size(); n += 8) {
    int flags = 0;
    for (std::size_t p = 0; p < 8; ++p) flags |= (laws[n + p] == '1' ? 1 : 0) << p;
    reference["flags"].push_back(flags);
  }
  reference["pattern"] = {{"vessel_flags_per_cell_bitmask", reference["flags"]}};
  auto& results = reference["results"];
  results["nodal_displacements"] = results["displacement"];
  for (const char* name : {"cauchy_xx_yy_zz_xy_yz_zx", "von_mises"})
    results[name] = by_element(results[name]);
  return reference;
}

using Names = std::vector<std::pair<const char*, const char*>>;

/// Numbers and lists of the reference under the deck's names.
std::string numbers(const nlohmann::json& given, const Names& names) {
  std::string text;
  for (const auto& [key, name] : names) {
    if (!given.contains(key)) continue;
    std::string value = given.at(key).dump();
    const bool is_list = given.at(key).is_array();
    if (is_list) value = "{" + value.substr(1, value.size() - 2) + "}";
    text += parameter(name, is_list ? "Array(double)" : "double", value);
  }
  return text;
}

/// A material's parameters in the deck, from those of the reference.
std::string law_parameters(const nlohmann::json& material) {
  const auto model = material.at("law").get<std::string>();
  std::string text = parameter("Model", "string", model) +
                     numbers(material, {{"C1", "C1 [Pa]"},
                                        {"C2", model == "Veronda-Westmann" ? "C2" : "C2 [Pa]"},
                                        {"C", "C [Pa]"},
                                        {"M", "M"},
                                        {"mu", "Shear Modulus [Pa]"},
                                        {"lam", "Lame Modulus [Pa]"},
                                        {"beta", "Beta"},
                                        {"c", "C [Pa]"},
                                        {"k1", "K1 [Pa]"},
                                        {"k2", "K2"},
                                        {"kappa", "Kappa"},
                                        {"K", "Bulk Modulus [Pa]"},
                                        {"nu", "Poisson Ratio"}});
  if (material.contains("prony"))
    text += list("Viscosity",
                 numbers(material.at("prony"),
                         {{"g0", "G0"}, {"g", "Moduli"}, {"tau", "Relaxation Times [s]"}}));
  std::string families;
  if (material.contains("fiber"))
    families += list("family", parameter("Law", "string", "Exponential-Power") +
                                   numbers(material.at("fiber"), {{"ksi", "Xi [Pa]"},
                                                                  {"alpha", "Alpha"},
                                                                  {"beta", "Beta"},
                                                                  {"direction", "Direction"}}));
  if (material.contains("fibers"))
    for (const auto& direction : material.at("fibers"))
      families += list("family " + std::to_string(families.size()),
                       numbers({{"direction", direction}}, {{"direction", "Direction"}}));
  return families.empty() ? text : text + list("Fibers", families);
}

}  // namespace

fs::path reference_file(const std::string& name) {
  return clone_folder() / "tests" / "data" / "reference" / (name + ".json");
}

ReferenceCase::ReferenceCase(const std::string& file)
    : json_(in_one_form(nlohmann::json::parse(content_of(reference_file(file))))),
      name_(file),
      elements_(json_.at("grid").at("n_cells").get<std::array<std::int64_t, 3>>()),
      element_size_(json_.at("grid").at("cell_um").get<std::array<double, 3>>()),
      conditions_(conditions_of(file)) {}

std::int64_t ReferenceCase::particle_id(std::int64_t element, std::int64_t point) const {
  const std::int64_t i = element % elements_[0], j = element / elements_[0] % elements_[1],
                     k = element / (elements_[0] * elements_[1]);
  return (2 * i + point % 2) +
         2 * elements_[0] * ((2 * j + point / 2 % 2) + 2 * elements_[1] * (2 * k + point / 4));
}

bool ReferenceCase::is_vessel(std::int64_t element, int point) const {
  const auto& pattern = json_.at("pattern");
  if (!pattern.contains("vessel_flags_per_cell_bitmask")) return false;
  const auto flags =
      pattern.at("vessel_flags_per_cell_bitmask").at(static_cast<std::size_t>(element)).get<int>();
  return (flags >> point & 1) != 0;
}

void ReferenceCase::write_labels(const fs::path& path) const {
  voxels::Volume<std::uint8_t> labels(
      base::Communicator::self(), {2 * elements_[0], 2 * elements_[1], 2 * elements_[2]},
      {element_size_[0] / 2, element_size_[1] / 2, element_size_[2] / 2});
  const std::int64_t elements = elements_[0] * elements_[1] * elements_[2];
  for (std::int64_t e = 0; e < elements; ++e)
    for (int p = 0; p < 8; ++p)
      labels.values[static_cast<std::size_t>(particle_id(e, p))] = is_vessel(e, p) ? 1 : 0;
  image::write_tiff(base::Communicator::self(), path.string(), labels);
}

std::string ReferenceCase::loading() const {
  const auto& steps = results().at("steps");
  if (!steps.front().contains("time"))
    return list("Loading", parameter("Steps", "int", std::to_string(steps.size())));
  nlohmann::json times;
  for (const auto& step : steps) times.push_back(step.at("time"));
  return list("Loading", numbers({{"times", times}}, {{"times", "Times [s]"}})) +
         list("Load Curves", list("ramp", parameter("Times [s]", "Array(double)", "{0, 1}") +
                                              parameter("Values", "Array(double)", "{0, 1}")));
}

fs::path ReferenceCase::write_deck(const TemporaryFolder& folder) const {
  write_labels(folder / "labels.tif");
  const auto sized = [](const std::array<double, 3>& a, double factor) {
    std::ostringstream text;
    text.precision(17);
    text << "{" << a[0] * factor << ", " << a[1] * factor << ", " << a[2] * factor << "}";
    return text.str();
  };
  const auto material = [&](int label, const char* mu) {
    const std::string text = parameter("Label", "int", std::to_string(label));
    if (json_.contains("materials")) return text + law_parameters(json_.at("materials").at(label));
    return text + parameter("Shear Modulus [Pa]", "double", mu) +
           parameter("Poisson Ratio", "double", name_.front() == 'F' ? "0.495" : "0.4");
  };
  const bool gauss = json_.at("quadrature").at("name") == "gauss2";
  std::string boundary;
  for (const CaseCondition& condition : conditions_)
    boundary += list(condition.name, parameter("Face", "string", condition.face) +
                                         parameter("Components", "string", condition.components) +
                                         condition.load);
  return folder.write(
      name_ + ".xml",
      list("Stroma",
           list("Image",
                parameter("File", "string", "labels.tif") +
                    parameter("Voxel Size [um]", "Array(double)", sized(element_size_, 0.5)) +
                    list("Segmentation", parameter("Method", "string", "Labels"))) +
               list("Materials", list("collagen", material(0, "520.8")) +
                                     list("vessel", material(1, "1041.6"))) +
               list("Particles", parameter("Layout", "string", gauss ? "Gauss" : "Voxel Centers")) +
               list("Grid",
                    parameter("Element Size [um]", "Array(double)", sized(element_size_, 1.0)) +
                        parameter("Plane Strain", "bool", name_.front() == 'D' ? "true" : "false") +
                        parameter("Dilatation", "string",
                                  has_mean_dilatation() ? "Element Mean" : "Pointwise")) +
               list("Boundary Conditions", boundary) + loading() +
               list("Solver", parameter("Newton Tolerance", "double", "1e-12") +
                                  parameter("Linear Tolerance", "double", "1e-8") +
                                  parameter("Preconditioner", "string", "Jacobi")) +
               list("Output", parameter("Pictures", "bool", "false") +
                                  parameter("Particles Every", "int", "0") +
                                  parameter("Grid Every", "int", "0"))));
}

}  // namespace stroma::test
