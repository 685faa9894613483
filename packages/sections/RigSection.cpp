// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/sections/RigSection.hpp"

#include <algorithm>

#include "stroma/mechanics/problem/StiffnessCases.hpp"
#include "stroma/sections/Faces.hpp"

namespace stroma::sections {

using namespace mechanics;

namespace {

std::vector<std::string> names_of_rigs() {
  std::vector<std::string> names;
  for (const Rig& rig : rigs()) names.push_back(rig.name);
  return names;
}

std::string meanings_of_rigs() {
  std::string text;
  for (const Rig& rig : rigs()) text += (text.empty() ? "" : " ") + rig.name + ": " + rig.meaning;
  return text;
}

/// What a deck gives of the parameters that only some kinds take.
std::vector<std::pair<std::string, bool>> given(const RigParameters& p) {
  return {{"Face", p.face.has_value()},
          {"Strain", p.strain.has_value()},
          {"Displacement [um]", p.displacement.has_value()},
          {"Direction", p.direction.has_value()},
          {"Sides", p.sides.has_value()},
          {"Axes", p.axes.has_value()},
          {"Strains", p.strains.has_value()},
          {"Displacements [um]", p.displacements.has_value()},
          {"Angle [deg]", p.angle.has_value()},
          {"Center [um]", p.center.has_value()},
          {"Boundary", p.boundary.has_value()}};
}

/// Looks for what the kind does not take, for what it needs, and for two values in place of one.
void check_takes(const RigParameters& p, const Rig& rig, deck::Findings& findings) {
  const auto takes = [&](const std::string& name) {
    return std::find(rig.takes.begin(), rig.takes.end(), name) != rig.takes.end();
  };
  for (const auto& [name, is_given] : given(p))
    if (is_given && !takes(name)) findings.add(name, "is not used with Kind = " + rig.name);
  for (const auto& [name, is_given] :
       {std::pair<std::string, bool>{"Load Curve", p.load_curve.has_value()},
        {"Imposed By", p.imposed_by.has_value()},
        {"Penalty Factor", p.penalty_factor.has_value()}})
    if (is_given && !rig.has_steps) findings.add(name, "is not used with Kind = " + rig.name);
  const auto require = [&](const std::string& name, bool is_given) {
    if (takes(name) && !is_given) findings.add(name, "missing; required with Kind = " + rig.name);
  };
  require("Face", p.face.has_value());
  require("Direction", p.direction.has_value());
  require("Axes", p.axes.has_value());
  require("Angle [deg]", p.angle.has_value());
  const auto one_of = [&](const std::string& a, bool has_a, const std::string& b, bool has_b) {
    if (takes(a) && has_a == has_b)
      findings.add(a, (has_a ? "beside \"" + b + "\"" : std::string("missing")) +
                          "; admissible with Kind = " + rig.name + ": one of \"" + a + "\" and \"" +
                          b + "\"");
  };
  one_of("Strain", p.strain.has_value(), "Displacement [um]", p.displacement.has_value());
  one_of("Strains", p.strains.has_value(), "Displacements [um]", p.displacements.has_value());
}

void check_sizes(const RigParameters& p, const Rig& rig, deck::Findings& findings) {
  if (rig.compresses && p.strain && !(*p.strain < 0.0))
    findings.add("Strain", rig.name + " needs a compression; admissible: a number < 0");
  if (rig.compresses && p.displacement && !(*p.displacement < 0.0))
    findings.add("Displacement [um]", rig.name + " needs a compression; admissible: a number < 0");
  const auto check_length = [&](const std::string& name, double strain) {
    if (!(strain > -1.0))
      findings.add(
          name,
          "a body cannot be compressed by 100 % or more; admissible: > -1, a share, not in per cent");
  };
  if (p.strain && !p.direction) check_length("Strain", *p.strain);
  if (p.strains) check_length("Strains", std::min((*p.strains)[0], (*p.strains)[1]));
}

void check_shear(const RigParameters& p, deck::Findings& findings) {
  if (!p.face || !p.direction) return;
  if (!is_upper(*p.face))
    findings.add("Face", "Simple Shear moves an upper face; admissible: x+, y+, z+");
  if (axis_of(*p.face) == *p.direction)
    findings.add("Direction", "is the face's normal; admissible: an axis in its plane");
  if (p.sides == RigSides::sheared && !p.strain)
    findings.add("Sides", "\"Sheared\" needs \"Strain\", not \"Displacement [um]\"");
}

std::vector<std::string> names_of_boundaries() {
  std::vector<std::string> names;
  for (const auto& named : uniform_boundaries()) names.push_back(named.first);
  return names;
}

void check_boundary(const RigParameters& p, deck::Findings& findings) {
  if (!p.boundary) return;
  const std::vector<std::string>& all = *p.boundary;
  if (all.empty()) findings.add("Boundary", "is empty; admissible: one or more");
  for (auto one = all.begin(); one != all.end(); ++one)
    if (std::count(all.begin(), one, *one) > 0)
      findings.add("Boundary", "\"" + *one + "\" stands there twice");
}

}  // namespace

deck::Section<RigParameters> rig_section() {
  deck::Section<RigParameters> section(
      "Rig",
      "What is done to the specimen, in the place of Boundary Conditions: a rig stands for a "
      "list of them, which stroma check prints.");
  section.required("Kind", &RigParameters::kind, deck::one_of(names_of_rigs()), meanings_of_rigs());
  section.choice("Face", &RigParameters::face, single_faces(),
                 "The face of the body's box that moves; of all kinds but Biaxial.");
  section.optional("Strain", &RigParameters::strain, deck::any(),
                   "At full load. Displacement of the face along its outward normal, as a fraction "
                   "of the body's length there: negative compresses. Of Simple Shear: displacement "
                   "along Direction over the distance of the two faces.");
  section.optional("Displacement [um]", &RigParameters::displacement, deck::any(),
                   "The same as a length, instead of Strain.");
  section.choice("Direction", &RigParameters::direction, {{"x", 0}, {"y", 1}, {"z", 2}},
                 "Of Simple Shear: the axis along which the face is moved.");
  section.choice("Sides", &RigParameters::sides,
                 {{"Free", RigSides::free}, {"Sheared", RigSides::sheared}},
                 "Of Simple Shear. Free: nothing holds the other four faces. Sheared: they follow, "
                 "so that the whole surface has the displacement of a homogeneous shear. Without "
                 "it: Free.");
  section.choice("Axes", &RigParameters::axes,
                 {{"xy", {{0, 1}}}, {"xz", {{0, 2}}}, {"yz", {{1, 2}}}},
                 "Of Biaxial: the two axes along which the body is stretched.");
  section.optional("Strains", &RigParameters::strains, deck::any(),
                   "Of Biaxial: Strain along each of the Axes.");
  section.optional("Displacements [um]", &RigParameters::displacements, deck::any(),
                   "The same as lengths, instead of Strains.");
  section.optional("Angle [deg]", &RigParameters::angle, deck::any(),
                   "Of Torsion: angle at full load, right-handed about the axis x, y or z.");
  section.optional("Center [um]", &RigParameters::center, deck::any(),
                   "Of Torsion: a point on the axis, from the corner of the whole image, with "
                   "Image|Region, too. Without it: the middle of the body's box.");
  section.optional("Boundary", &RigParameters::boundary, deck::one_of(names_of_boundaries()),
                   "Of Stiffness: what is uniform on the surface, one or more. Displacement gives "
                   "the stiffest tensor, Traction the softest, and cannot be where empty space "
                   "cuts the surface; Mixed lies between them. Without it: all that can be.");
  section.optional(
      "Load Curve", &RigParameters::load_curve, deck::not_empty(),
      "The name of one of the Load Curves, by which the values are multiplied; without "
      "it, by the load factor.");
  section.choice("Imposed By", &RigParameters::imposed_by, ways_of_imposing(),
                 "Of all conditions of the rig, as in Boundary Conditions.");
  section.optional("Penalty Factor", &RigParameters::penalty_factor, deck::positive(),
                   "Of all conditions of the rig, as in Boundary Conditions.");
  section.check([](const RigParameters& p, deck::Findings& findings) {
    const Rig& rig = rig_of(p.kind);
    check_takes(p, rig, findings);
    check_sizes(p, rig, findings);
    check_shear(p, findings);
    check_boundary(p, findings);
    if (p.penalty_factor && p.imposed_by != ImposedBy::penalty)
      findings.add("Penalty Factor", "is used with Imposed By = Penalty only");
  });
  return section;
}

}  // namespace stroma::sections
