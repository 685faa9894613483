// SPDX-License-Identifier: BSD-3-Clause

#include "stiffness/StiffnessFiles.hpp"

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

using base::format;
using mechanics::name_of_unit;
using Json = nlohmann::ordered_json;

const char* const face_names[] = {"x-", "x+", "y-", "y+", "z-", "z+"};

using NamedBounds = std::vector<std::pair<std::string, double material::Bounds::*>>;
const NamedBounds& kinds_of_bounds() {
  static const NamedBounds kinds{{"Reuss", &material::Bounds::reuss},
                                 {"Hashin-Shtrikman -", &material::Bounds::lower},
                                 {"Hashin-Shtrikman +", &material::Bounds::upper},
                                 {"Voigt", &material::Bounds::voigt}};
  return kinds;
}

using NamedModuli =
    std::vector<std::pair<std::string, material::Bounds material::MixtureBounds::*>>;
const NamedModuli& bounded_moduli() {
  static const NamedModuli moduli{{"K", &material::MixtureBounds::bulk},
                                  {"G", &material::MixtureBounds::shear},
                                  {"E", &material::MixtureBounds::young}};
  return moduli;
}

/// A figure with its name and unit; "-" without one.
struct Figure {
  std::string name, unit;
  double value;
};

/// The upper triangle: C_xx_xx, C_xx_yy, ...
std::vector<Figure> components(const std::string& letter, const std::string& unit,
                               const Matrix6& matrix) {
  std::vector<Figure> figures;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j)
      figures.push_back(
          {letter + "_" + name_of_unit(i) + "_" + name_of_unit(j), unit, matrix(i, j)});
  return figures;
}

/// E, nu and G along axes that have these letters.
std::vector<Figure> moduli(const Matrix6& compliance, const std::string& axes) {
  const EngineeringModuli all = engineering_moduli(compliance);
  std::vector<Figure> figures;
  const auto name = [&](const char* letter, std::initializer_list<int> of) {
    std::string text = std::string(letter) + "_";
    for (const int axis : of) text += axes[static_cast<std::size_t>(axis)];
    return text;
  };
  for (int i = 0; i < 3; ++i) figures.push_back({name("E", {i}), "Pa", all.young(i)});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j) figures.push_back({name("nu", {i, j}), "-", all.nu(i, j)});
  for (int i = 0; i < 3; ++i) {
    const auto [a, b] = mechanics::axes_of_unit(3 + i);
    figures.push_back({name("G", {a, b}), "Pa", all.shear(i)});
  }
  return figures;
}

/// The moduli of a tensor in its frame: two of an isotropic one, and those that follow.
std::vector<Figure> moduli(const ClosestTensor& tensor, Symmetry symmetry) {
  if (symmetry == Symmetry::isotropic) {
    const double K = bulk_modulus(tensor.stiffness), G = shear_modulus(tensor.stiffness);
    return {{"K", "Pa", K},
            {"G", "Pa", G},
            {"E", "Pa", 9.0 * K * G / (3.0 * K + G)},
            {"nu", "-", (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G)}};
  }
  const std::optional<Matrix6> compliance = compliance_of(tensor.in_frame);
  return compliance ? moduli(*compliance, "123") : std::vector<Figure>{};
}

Json matrix_of(const Matrix6& matrix) {
  Json rows = Json::array();
  for (int i = 0; i < 6; ++i) {
    Json row = Json::array();
    for (int j = 0; j < 6; ++j) row.push_back(matrix(i, j));
    rows.push_back(row);
  }
  return rows;
}

Json object_of(const std::vector<Figure>& figures) {
  if (figures.empty()) return nullptr;
  Json object;
  for (const Figure& one : figures) object[one.name] = one.value;
  return object;
}

Json frame_of(const ClosestTensor& tensor) {
  Json axes = Json::array();
  for (int a = 0; a < 3; ++a)
    axes.push_back({tensor.frame(a, 0), tensor.frame(a, 1), tensor.frame(a, 2)});
  return axes;
}

Json closest_of(const BoundaryResults& results) {
  Json all;
  for (std::size_t n = 0; n < results.closest.size(); ++n) {
    const auto& [name, symmetry] = symmetries()[n];
    const ClosestTensor& tensor = results.closest[n];
    Json one{{"distance", tensor.distance}};
    if (symmetry != Symmetry::isotropic) {
      one["distance along the specimen's axes"] = tensor.along_specimen;
      one["axes"] = frame_of(tensor);
    }
    one["stiffness"] = matrix_of(tensor.stiffness);
    one["moduli"] = object_of(moduli(tensor, symmetry));
    all[name] = one;
  }
  return all;
}

Json cases_of(const ApparentStiffness& found) {
  Json all;
  for (std::size_t unit = 0; unit < found.cases.size(); ++unit)
    all[name_of_unit(static_cast<int>(unit))] = {{"iterations", found.cases[unit].iterations},
                                                 {"residual", found.cases[unit].residual}};
  return all;
}

Json bounds_of(const StiffnessResults& results) {
  if (!results.bounds) return nullptr;
  Json all;
  for (const auto& [kind, bound] : kinds_of_bounds())
    for (const auto& [letter, modulus] : bounded_moduli())
      all[kind][letter] = ((*results.bounds).*modulus).*bound;
  return all;
}

/// How the load cases were solved.
std::vector<Figure> solving(const ApparentStiffness& found) {
  std::vector<Figure> figures;
  for (std::size_t unit = 0; unit < found.cases.size(); ++unit) {
    const std::string name = name_of_unit(static_cast<int>(unit));
    figures.push_back(
        {"iterations_" + name, "-", static_cast<double>(found.cases[unit].iterations)});
    figures.push_back({"residual_" + name, "-", found.cases[unit].residual});
  }
  return figures;
}

class Rows {
 public:
  void add(const std::string& boundary, const std::string& tensor,
           const std::vector<Figure>& figures) {
    for (const Figure& one : figures)
      text_ +=
          boundary + "," + tensor + "," + one.name + "," + one.unit + format(",%.17g\n", one.value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_ = "boundary,tensor,figure,unit,value\n";
};

std::vector<Figure> described(const ClosestTensor& tensor, Symmetry symmetry) {
  std::vector<Figure> figures{{"distance", "-", tensor.distance}};
  if (symmetry != Symmetry::isotropic) {
    figures.push_back({"distance_along_specimen", "-", tensor.along_specimen});
    for (int a = 0; a < 3; ++a)
      for (int d = 0; d < 3; ++d)
        figures.push_back({format("axis_%d_%c", a + 1, "xyz"[d]), "-", tensor.frame(a, d)});
  }
  for (const Figure& one : moduli(tensor, symmetry)) figures.push_back(one);
  for (const Figure& one : components("C", "Pa", tensor.stiffness)) figures.push_back(one);
  return figures;
}

std::string listed(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& one : figures)
    text += (text.empty() ? "" : ", ") + one.name +
            format(" %.4g%s", one.value, one.unit == "-" ? "" : (" " + one.unit).c_str());
  return text;
}

}  // namespace

BoundaryResults::BoundaryResults(std::string boundary, ApparentStiffness apparent)
    : name(std::move(boundary)),
      found(std::move(apparent)),
      compliance(compliance_of(found.stiffness)) {
  for (const auto& named : symmetries())
    closest.push_back(stroma::closest(found.stiffness, named.second));
}

std::optional<Matrix6> StiffnessResults::reuss() const {
  if (!bounds || !(bounds->bulk.reuss > 0.0)) return std::nullopt;
  return isotropic_stiffness(bounds->bulk.reuss, bounds->shear.reuss);
}

std::string stiffness_table(const StiffnessResults& results) {
  Rows rows;
  for (const BoundaryResults& one : results.all) {
    rows.add(one.name, "specimen", components("C", "Pa", one.found.stiffness));
    if (one.compliance) {
      rows.add(one.name, "specimen", components("S", "1/Pa", *one.compliance));
      rows.add(one.name, "specimen", moduli(*one.compliance, "xyz"));
    }
    rows.add(one.name, "specimen", {{"symmetry_error", "-", one.found.symmetry_error}});
    rows.add(one.name, "specimen", solving(one.found));
    for (std::size_t n = 0; n < one.closest.size(); ++n)
      rows.add(one.name, symmetries()[n].first, described(one.closest[n], symmetries()[n].second));
  }
  rows.add("bounds", "Voigt", components("C", "Pa", results.voigt));
  if (const auto reuss = results.reuss())
    rows.add("bounds", "Reuss", components("C", "Pa", *reuss));
  if (results.bounds)
    for (const auto& [kind, bound] : kinds_of_bounds())
      for (const auto& [letter, modulus] : bounded_moduli())
        rows.add("bounds", kind, {{letter, "Pa", ((*results.bounds).*modulus).*bound}});
  return rows.text();
}

std::string stiffness_json(const StiffnessResults& results) {
  const std::optional<Matrix6> reuss = results.reuss();
  Json found;
  for (const BoundaryResults& one : results.all)
    found[one.name] = {
        {"stiffness", matrix_of(one.found.stiffness)},
        {"compliance", one.compliance ? matrix_of(*one.compliance) : Json()},
        {"moduli", one.compliance ? object_of(moduli(*one.compliance, "xyz")) : Json()},
        {"symmetry error", one.found.symmetry_error},
        {"mean stress", matrix_of(one.found.stress)},
        {"mean strain", matrix_of(one.found.strain)},
        {"closest", closest_of(one)},
        {"load cases", cases_of(one.found)},
    };
  Json order = Json::array(), faces, shares;
  for (const auto& [material, share] : results.shares) shares[material] = share;
  for (int i = 0; i < 6; ++i) order.push_back(name_of_unit(i));
  for (std::size_t face = 0; face < 6; ++face) faces[face_names[face]] = results.face_shares[face];
  const Json all{{"stiffness", found},
                 {"title", results.title},
                 {"order", order},
                 {"shear strains", "engineering"},
                 {"unit", "Pa"},
                 {"box [um]", results.box},
                 {"solid share", results.solid_share},
                 {"solid share of faces", faces},
                 {"share of materials", shares},
                 {"Voigt", matrix_of(results.voigt)},
                 {"Reuss", reuss ? matrix_of(*reuss) : Json()},
                 {"bounds", bounds_of(results)}};
  return all.dump(2) + "\n";
}

namespace {

std::string line_of(const ClosestTensor& tensor, const std::string& name, Symmetry symmetry) {
  std::string line = format("  %-24s %5.2f %% away", name.c_str(), 100.0 * tensor.distance);
  if (symmetry == Symmetry::isotropic) line += ": " + listed(moduli(tensor, symmetry));
  if (symmetry == Symmetry::transversely_isotropic) {
    const auto shown = [&](int d) {  // no -0.0000
      const double component = tensor.frame(2, d);
      return std::abs(component) < 5e-5 ? 0.0 : component;
    };
    line += format(", about (%.4f, %.4f, %.4f)", shown(0), shown(1), shown(2));
  }
  return line;
}

void add_lines(const BoundaryResults& one, std::vector<std::string>& lines) {
  lines.emplace_back();
  lines.push_back("stiffness  " + one.name + ", Pa:");
  std::string head = "          ";
  for (int j = 0; j < 6; ++j) head += format("%12s", name_of_unit(j).c_str());
  lines.push_back(head);
  for (int i = 0; i < 6; ++i) {
    std::string line = format("        %s", name_of_unit(i).c_str());
    for (int j = 0; j < 6; ++j) line += format("%12.5g", one.found.stiffness(i, j));
    lines.push_back(line);
  }
  lines.push_back(format("  departs from symmetry by %.1e", one.found.symmetry_error));
  lines.push_back(one.compliance ? "  " + listed(moduli(*one.compliance, "xyz"))
                                 : "  nothing holds it together: some strain costs no energy");
  for (std::size_t n = 0; n < one.closest.size(); ++n)
    lines.push_back(line_of(one.closest[n], symmetries()[n].first, symmetries()[n].second));
}

}  // namespace

std::vector<std::string> stiffness_lines(const StiffnessResults& results) {
  std::vector<std::string> lines;
  for (const BoundaryResults& one : results.all) add_lines(one, lines);
  if (!results.bounds) return lines;
  lines.emplace_back();
  std::string head = "bounds    ";
  for (const auto& kind : kinds_of_bounds()) head += format("%20s", kind.first.c_str());
  lines.push_back(head);
  for (const auto& [letter, modulus] : bounded_moduli()) {
    std::string line = format("        %s ", letter.c_str());
    for (const auto& kind : kinds_of_bounds())
      line += format("%17.5g Pa", ((*results.bounds).*modulus).*kind.second);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace stroma
