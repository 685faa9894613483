// SPDX-License-Identifier: BSD-3-Clause

#include "run/Deck.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>
#include <utility>

#include "stroma/base/FileContent.hpp"
#include "stroma/deck/PlainText.hpp"
#include "stroma/material/Models.hpp"
#include "stroma/mechanics/problem/StiffnessCases.hpp"
#include "stroma/output/OutputFiles.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "stroma/sections/BoundaryConditionsSection.hpp"
#include "stroma/sections/ExternalForcesSection.hpp"
#include "stroma/sections/GridSection.hpp"
#include "stroma/sections/ImageSection.hpp"
#include "stroma/sections/InitialConditionsSection.hpp"
#include "stroma/sections/LoadCurvesSection.hpp"
#include "stroma/sections/LoadingSection.hpp"
#include "stroma/sections/MaterialsSection.hpp"
#include "stroma/sections/OutputSection.hpp"
#include "stroma/sections/ParticlesSection.hpp"
#include "stroma/sections/RigSection.hpp"
#include "stroma/sections/SolverSection.hpp"

namespace stroma {

mechanics::LoadCurve curve_named(const DeckParameters& p, const std::optional<std::string>& name) {
  for (const auto& curve : p.load_curves.curves)
    if (name == curve.first) return mechanics::load_curve(curve.second, p.loading.seconds());
  return {};
}

std::vector<std::pair<std::string, std::optional<std::string>>> curves_of_materials(
    const DeckParameters& p) {
  std::vector<std::pair<std::string, std::optional<std::string>>> curves;
  for (const auto& [name, material] : p.materials.materials) {
    const std::string section = "Materials|" + name;
    if (material::is_pressure(material)) curves.emplace_back(section, material.load_curve);
    if (material.active_stress)
      curves.emplace_back(section + "|Active Stress", material.active_stress->load_curve);
    if (material.growth) curves.emplace_back(section + "|Growth", material.growth->load_curve);
  }
  return curves;
}

std::vector<std::pair<std::string, std::optional<std::string>>> curves_asked_for(
    const DeckParameters& p) {
  std::vector<std::pair<std::string, std::optional<std::string>>> curves;
  for (const auto& [name, condition] : p.boundary_conditions.conditions)
    curves.emplace_back("Boundary Conditions|" + name, condition.load_curve);
  if (p.rig) curves.emplace_back("Rig", p.rig->load_curve);
  for (const auto& [name, force] : p.external_forces.forces)
    curves.emplace_back("External Forces|" + name, force.load_curve);
  const auto of_materials = curves_of_materials(p);
  curves.insert(curves.end(), of_materials.begin(), of_materials.end());
  return curves;
}

bool asks_for_stiffness(const DeckParameters& p) {
  return p.rig && p.rig->kind == mechanics::stiffness_rig;
}

namespace {

std::string absolute(const deck::Document& document, const std::string& file) {
  return std::filesystem::absolute(document.resolve(file)).lexically_normal().string();
}

/// A material's fields and structure tensors ask for an image of intensities.
void refuse_fields_without_intensities(const DeckParameters& p, deck::Findings& findings) {
  using Method = image::SegmentationParameters::Method;
  const auto check = [&](const std::string& where, const material::FieldImage& image) {
    if (image.file) return;
    if (p.image.phantom)
      findings.add(where + "|Image",
                   "missing; the specimen is a phantom, which has no intensities");
    else if (image.is_the_specimens() && p.image.segmentation.method == Method::labels)
      findings.add(where + "|Image",
                   "missing; with Image|Segmentation|Method = Labels the specimen's image holds "
                   "labels, not intensities");
  };
  for (const auto& [name, material] : p.materials.materials) {
    const std::string where = "Materials|" + name + "|";
    if (material.fields)
      for (const auto& [field, parameters] : material.fields->fields)
        check(where + "Fields|" + field, parameters);
    if (material.fibers)
      for (const auto& [family, fibers] : material.fibers->families)
        if (fibers.direction_from == material::DirectionsFromImage::Kind::structure_tensor)
          check(where + "Fibers|" + family, fibers);
  }
}

void refuse_unknown_load_curves(const DeckParameters& p, deck::Findings& findings) {
  std::string known;
  for (const auto& curve : p.load_curves.curves)
    known += (known.empty() ? "\"" : ", \"") + curve.first + "\"";
  const auto look_for = [&](const std::string& where, const std::optional<std::string>& name) {
    if (!name) return;
    for (const auto& curve : p.load_curves.curves)
      if (curve.first == *name) return;
    findings.add(where + "|Load Curve",
                 "there is no \"" + *name + "\" among the Load Curves" +
                     (known.empty() ? ", of which there are none" : "; admissible: " + known));
  };
  for (const auto& [section, name] : curves_asked_for(p)) look_for(section, name);
}

void refuse_viscosity_without_time(const DeckParameters& p, deck::Findings& findings) {
  if (p.loading.has_time()) return;
  for (const auto& [name, material] : p.materials.materials)
    if (material.viscosity) {
      findings.add("Loading|Duration [s]", "missing; material \"" + name + "\" has a Viscosity");
      return;
    }
}

/// Inertia asks for masses, and a body without inertia has no motion to begin with.
void refuse_what_inertia_lacks(const DeckParameters& p, deck::Findings& findings) {
  if (!p.loading.inertia) {
    if (!p.initial_conditions.conditions.empty())
      findings.add("Initial Conditions", "is used with Loading|Inertia = true only");
    return;
  }
  for (const auto& [material, values] : p.materials.materials)
    if (!values.density)
      findings.add("Materials|" + material + "|Density [kg/m^3]",
                   "missing; Loading|Inertia = true asks for it");
  if (p.grid.deformation_gradient == mechanics::DeformationGradient::projected_displacement)
    findings.add(
        "Grid|Deformation Gradient",
        "\"Projected Displacement\" has no motion; admissible with Loading|Inertia = true: "
        "\"Incremental\"");
}

/// A stiffness is that of small strain about the unloaded state, in space, with hats.
void refuse_what_stiffness_has_not(const DeckParameters& p, deck::Findings& findings) {
  if (!asks_for_stiffness(p)) return;
  const std::string with = " with Rig|Kind = Stiffness";
  const auto refuse = [&](bool is_there, const std::string& where, const std::string& why) {
    if (is_there) findings.add(where, why);
  };
  const std::string no_steps = "is not used" + with + ", which has no load steps";
  refuse(p.loading.steps.has_value(), "Loading|Steps", no_steps);
  refuse(p.loading.times.has_value(), "Loading|Times [s]", no_steps);
  refuse(p.loading.duration.has_value(), "Loading|Duration [s]", no_steps);
  refuse(p.loading.inertia, "Loading|Inertia", no_steps);
  refuse(!p.load_curves.curves.empty(), "Load Curves", no_steps);
  refuse(p.output.image_stacks.has_value(), "Output|Image Stacks", no_steps);
  refuse(p.output.vtkhdf, "Output|VTKHDF", no_steps);
  refuse(!p.external_forces.forces.empty(), "External Forces",
         "are not used" + with + ", whose load cases are its own");
  refuse(p.grid.reset, "Grid|Reset", "found true; admissible" + with + ": false");
  refuse(p.grid.plane_strain, "Grid|Plane Strain",
         "found true; admissible" + with +
             ": false; of one layer of elements along z, Boundary = Mixed gives the components xx, "
             "yy, xy of plane strain");
  using shape::ShapeFunctions;
  refuse(p.grid.shape_functions == ShapeFunctions::quadratic_b_spline ||
             p.grid.shape_functions == ShapeFunctions::cubic_b_spline,
         "Grid|Shape Functions",
         "B-splines do not bear uniform tractions exactly; admissible" + with +
             ": Linear, GIMP, CPDI");
  refuse(p.grid.deformation_gradient != mechanics::DeformationGradient::incremental,
         "Grid|Deformation Gradient", "admissible" + with + ": Incremental");
  for (const auto& [name, material] : p.materials.materials) {
    const std::string where = "Materials|" + name;
    refuse(material.viscosity.has_value(), where + "|Viscosity",
           "has no one stiffness; admissible" + with + ": none");
    refuse(material.active_stress.has_value(), where + "|Active Stress",
           "does not act on the unloaded state; admissible" + with + ": none");
    refuse(material.growth.has_value(), where + "|Growth",
           "does not act on the unloaded state; admissible" + with + ": none");
    refuse(material::is_pressure(material), where + "|Model",
           "\"Pressure\" has no stiffness; admissible" + with + ": any other, or no material");
  }
}

/// Gives conditions and forces the curves that they name.
void attach_load_curves(DeckParameters& p) {
  const auto attach = [&](auto& named) {
    for (auto& [name, one] : named) one.curve = curve_named(p, one.load_curve);
  };
  attach(p.boundary_conditions.conditions);
  attach(p.external_forces.forces);
}

/// Images tell where the points of the undeformed body go, and the nodes of a grid that is reset are
/// none.
void refuse_displacement_images_at_nodes_with_reset(const DeckParameters& p,
                                                    deck::Findings& findings) {
  using mechanics::ImposedBy;
  for (const auto& [name, condition] : p.boundary_conditions.conditions)
    if (condition.images && p.grid.reset &&
        condition.imposed_by.value_or(ImposedBy::penalty) != ImposedBy::penalty)
      findings.add("Boundary Conditions|" + name + "|Displacement Images",
                   "move no nodes of a grid that is reset; admissible with them: Imposed By = "
                   "Penalty, or Grid|Reset = false");
}

/// A mean dilatation asks for laws with an energy of volume.
void refuse_mean_without_energy_of_volume(const DeckParameters& p, deck::Findings& findings) {
  if (p.grid.dilatation != mechanics::DilatationChoice::element_mean) return;
  for (const auto& named : p.materials.materials)
    if (!material::compressibility({named}).may_be_averaged)
      findings.add("Grid|Dilatation",
                   "\"Element Mean\" averages the energy of volume, which " +
                       (named.second.viscosity && !named.second.viscosity->is_deviatoric
                            ? "relaxes in material \"" + named.first +
                                  "\"; admissible with it: Viscosity|Applies To = Deviatoric, or "
                                  "\"Pointwise\""
                            : "Model = " + material::model_of(named.second).name +
                                  " of material \"" + named.first +
                                  "\" does not have; admissible with it: \"Pointwise\", "
                                  "\"Automatic\""));
}

}  // namespace

void for_each_image_file(DeckParameters& p,
                         const std::function<void(const std::string&, std::string&)>& visit) {
  if (p.image.file) visit("Image|File", *p.image.file);
  for (auto& [name, material] : p.materials.materials) {
    const std::string where = "Materials|" + name + "|";
    if (material.fields)
      for (auto& [field, parameters] : material.fields->fields)
        if (parameters.file) visit(where + "Fields|" + field + "|Image", *parameters.file);
    if (!material.fibers) continue;
    for (auto& [family, fibers] : material.fibers->families) {
      if (fibers.file) visit(where + "Fibers|" + family + "|Image", *fibers.file);
      for (std::string& file : fibers.images) visit(where + "Fibers|" + family + "|Images", file);
    }
  }
  for (auto& [name, condition] : p.boundary_conditions.conditions)
    if (condition.images)
      for (std::string& file : condition.images->images)
        visit("Boundary Conditions|" + name + "|Displacement Images|Images", file);
  for (auto& [name, condition] : p.initial_conditions.conditions)
    if (condition.images)
      for (std::string& file : condition.images->images)
        visit("Initial Conditions|" + name + "|Velocity Images|Images", file);
}

deck::Section<DeckParameters> deck_section() {
  deck::Section<DeckParameters> section(
      "Stroma",
      "A specimen from an image, its materials, supports and load, and how it is solved.");
  section.optional("Title", &DeckParameters::title, deck::any(),
                   "One line about the run; it stands in the results and on the pictures.");
  section.required_section(sections::image_section(), &DeckParameters::image);
  section.required_section(sections::materials_section(), &DeckParameters::materials);
  section.section(sections::particles_section(), &DeckParameters::particles);
  section.required_section(sections::grid_section(), &DeckParameters::grid);
  section.section(sections::boundary_conditions_section(), &DeckParameters::boundary_conditions);
  section.section(sections::rig_section(), &DeckParameters::rig);
  section.section(sections::external_forces_section(), &DeckParameters::external_forces);
  section.section(sections::initial_conditions_section(), &DeckParameters::initial_conditions);
  section.section(sections::load_curves_section(), &DeckParameters::load_curves);
  section.section(sections::loading_section(), &DeckParameters::loading);
  section.section(sections::solver_section(), &DeckParameters::solver);
  section.section(sections::output_section(), &DeckParameters::output);
  section.check([](const DeckParameters& p, deck::Findings& findings) {
    if (!p.rig && !p.loading.inertia && p.boundary_conditions.conditions.empty())
      findings.add(
          "Boundary Conditions",
          "missing; admissible: one condition or more, or a Rig, or Loading|Inertia = true");
    if (p.rig && !p.boundary_conditions.conditions.empty())
      findings.add("Rig", "beside Boundary Conditions; admissible: one of the two");
  });
  section.check(refuse_fields_without_intensities);
  section.check(refuse_unknown_load_curves);
  section.check(refuse_viscosity_without_time);
  section.check(refuse_displacement_images_at_nodes_with_reset);
  section.check(refuse_what_inertia_lacks);
  section.check(refuse_what_stiffness_has_not);
  section.check(refuse_mean_without_energy_of_volume);
  section.check([](const DeckParameters& p, deck::Findings& findings) {
    for (const auto& [name, force] : p.external_forces.forces) {
      if (!force.acceleration) continue;
      for (const auto& [material, values] : p.materials.materials)
        if (!values.density)
          findings.add("Materials|" + material + "|Density [kg/m^3]",
                       "missing; External Forces|" + name + " is a force per mass");
    }
  });
  return section;
}

Deck read_deck(const std::string& path, const std::vector<std::string>& overrides) {
  deck::Document document = deck::load(path, overrides);
  DeckParameters parameters = deck::read(document, deck_section());
  if (parameters.rig)
    parameters.boundary_conditions.conditions = mechanics::conditions_of(*parameters.rig);
  attach_load_curves(parameters);
  for_each_image_file(parameters, [&](const std::string& where, const std::string& name) {
    const std::string problem = deck::unwritable(absolute(document, name));  // in deck.xml
    if (!problem.empty())
      throw base::InputError(where + ": the path " + problem +
                             "; move the image, or rename its folder");
  });
  return {std::move(document), std::move(parameters), base::file_content(path), overrides};
}

namespace {

std::vector<std::string> describe_load_cases(const mechanics::RigParameters& rig) {
  std::vector<std::string> lines{rig.kind + ", that is, load cases of unit strains:"};
  for (const auto& [name, boundary] : mechanics::wanted_boundaries(rig))
    for (const mechanics::LoadCases& cases : mechanics::load_cases(boundary)) {
      std::string line = "  " + name + ":";
      for (const int unit : cases.units) line += " " + mechanics::name_of_unit(unit);
      line += cases.conditions.empty() ? "; nothing is held" : "; as in a uniform strain are";
      for (const auto& [face, condition] : cases.conditions)
        line += (&face == &cases.conditions.front().first ? " " : ", ") + condition.components +
                " of " + (*condition.face == mechanics::Face::all ? "all faces" : face);
      lines.push_back(line);
    }
  return lines;
}

}  // namespace

std::vector<std::string> describe_rig(const DeckParameters& parameters) {
  if (!parameters.rig) return {};
  if (asks_for_stiffness(parameters)) return describe_load_cases(*parameters.rig);
  std::vector<std::string> lines{parameters.rig->kind + ", that is, Boundary Conditions:"};
  const deck::Section<mechanics::BoundaryConditionsParameters> section =
      sections::boundary_conditions_section();
  const deck::NamedDeclaration& conditions = *section.declaration().named;
  for (const auto& [name, condition] : conditions.all(&parameters.boundary_conditions)) {
    std::string line;
    for (const deck::ParameterDeclaration& parameter : conditions.each->parameters)
      if (const std::optional<deck::Value> value = parameter.fetch(condition))
        line += (line.empty() ? "  " + name + ": " : ", ") + parameter.name + " = " +
                deck::print(*value);
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> input_files(const Deck& deck) {
  std::vector<std::string> files{deck.document.path()};
  DeckParameters parameters = deck.parameters;
  for_each_image_file(parameters, [&](const std::string&, const std::string& file) {
    files.push_back(deck.document.resolve(file));
  });
  return files;
}

std::vector<std::string> run_files(const Deck& deck) {
  return asks_for_stiffness(deck.parameters)
             ? output::stiffness_files(deck.parameters.output.report)
             : output::run_files(deck.parameters.output);
}

Teuchos::RCP<Teuchos::ParameterList> as_run(const Deck& deck) {
  DeckParameters parameters = deck.parameters;
  for_each_image_file(parameters, [&](const std::string&, std::string& file) {
    file = absolute(deck.document, file);
  });
  if (!asks_for_stiffness(parameters)) {
    parameters.rig.reset();
    if (!parameters.loading.times) parameters.loading.steps = parameters.loading.equal_steps();
  }
  return deck::filled(deck_section(), parameters);
}

base::InputError located(const Deck& deck, const base::InputError& error) {
  static const std::vector<std::string> sections{
      "Image",  "Materials",       "Particles",          "Grid",        "Boundary Conditions",
      "Rig",    "External Forces", "Initial Conditions", "Load Curves", "Loading",
      "Solver", "Output"};
  deck::Findings findings(deck.document);
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ");
    const std::string where = line.substr(0, colon);
    const std::string section = where.substr(0, where.find('|'));
    if (colon == std::string::npos ||
        std::find(sections.begin(), sections.end(), section) == sections.end())
      return error;
    if (deck.parameters.rig && section == "Boundary Conditions")
      findings.add("Rig", "its " + line);
    else
      findings.add(where, line.substr(colon + 2));
  }
  try {
    findings.throw_if_any();
  } catch (const base::InputError& with_lines) {
    return with_lines;
  }
  return error;
}

}  // namespace stroma
