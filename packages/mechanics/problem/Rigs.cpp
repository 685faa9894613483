// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/Rigs.hpp"

#include <algorithm>
#include <cstddef>

namespace stroma::mechanics {
namespace {

Face opposite(Face face) { return face_of(axis_of(face), !is_upper(face)); }

std::string along(int axis) { return std::string(1, "xyz"[axis]); }

/// A face that is moved along its outward normal, by a strain or a displacement.
BoundaryCondition pull(Face face, const std::string& components, std::optional<double> strain,
                       std::optional<double> displacement) {
  BoundaryCondition condition = hold(face, components);
  condition.strain = strain;
  if (displacement) {
    condition.displacement.emplace();
    (*condition.displacement)[static_cast<std::size_t>(axis_of(face))] =
        is_upper(face) ? *displacement : -*displacement;
  }
  return condition;
}

NamedConditions clamped_extension(const RigParameters& p) {
  return {{"held", hold(opposite(*p.face), "xyz")},
          {"moved", pull(*p.face, "xyz", p.strain, p.displacement)}};
}

/// Two plates without friction, pulled apart or pushed together; the sides are free.
NamedConditions between_plates(const RigParameters& p) {
  const std::string normal = along(axis_of(*p.face));
  return {{"held", hold(opposite(*p.face), normal)},
          {"moved", pull(*p.face, normal, p.strain, p.displacement)}};
}

NamedConditions confined_compression(const RigParameters& p) {
  NamedConditions conditions = between_plates(p);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      if (axis != axis_of(*p.face)) {
        const Face wall = face_of(axis, upper);
        conditions.emplace_back("wall_" + name_of(wall), hold(wall, along(axis)));
      }
  return conditions;
}

/// u = gamma Y along the direction, Y the height above the face that is held: as a gradient, so
/// that sides can follow.
NamedConditions simple_shear(const RigParameters& p) {
  const int normal = axis_of(*p.face);
  BoundaryCondition sheared = hold(*p.face, "xyz");
  if (p.strain) {
    sheared.displacement_gradient.emplace();
    (*sheared.displacement_gradient)[static_cast<std::size_t>(3 * *p.direction + normal)] =
        *p.strain;
  } else {
    sheared.displacement.emplace();
    (*sheared.displacement)[static_cast<std::size_t>(*p.direction)] = *p.displacement;
  }
  NamedConditions conditions{{"held", hold(opposite(*p.face), "xyz")}, {"moved", sheared}};
  if (p.sides.value_or(RigSides::free) == RigSides::free) return conditions;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      if (axis != normal) {
        sheared.face = face_of(axis, upper);
        conditions.emplace_back("wall_" + name_of(*sheared.face), sheared);
      }
  return conditions;
}

NamedConditions biaxial(const RigParameters& p) {
  NamedConditions conditions;
  for (std::size_t n = 0; n < 2; ++n) {
    const int axis = (*p.axes)[n];
    const auto of_axis = [n](const auto& both) {
      return both ? std::optional<double>((*both)[n]) : std::nullopt;
    };
    conditions.emplace_back("held_" + along(axis), hold(face_of(axis, false), along(axis)));
    conditions.emplace_back(
        "moved_" + along(axis),
        pull(face_of(axis, true), along(axis), of_axis(p.strains), of_axis(p.displacements)));
  }
  return conditions;
}

NamedConditions torsion(const RigParameters& p) {
  BoundaryCondition turned = hold(*p.face, "xyz");
  turned.rotation = p.angle;
  turned.center = p.center;
  return {{"held", hold(opposite(*p.face), "xyz")}, {"moved", turned}};
}

NamedConditions none(const RigParameters&) { return {}; }

}  // namespace

const std::vector<Rig>& rigs() {
  static const std::vector<Rig> table{
      {"Clamped Extension",
       {"Face", "Strain", "Displacement [um]"},
       "Face is moved along its normal, the opposite face is held, both in all components.",
       clamped_extension},
      {"Roller Extension",
       {"Face", "Strain", "Displacement [um]"},
       "the same, but both faces are free to slide in their planes.",
       between_plates},
      {"Confined Compression",
       {"Face", "Strain", "Displacement [um]"},
       "Face is pushed into a chamber whose four walls and bottom let the body slide.",
       confined_compression,
       true},
      {"Unconfined Compression",
       {"Face", "Strain", "Displacement [um]"},
       "Face is pushed towards the opposite one by plates without friction; the sides are free.",
       between_plates,
       true},
      {"Simple Shear",
       {"Face", "Strain", "Displacement [um]", "Direction", "Sides"},
       "Face is moved along Direction, in its plane, the opposite face is held.",
       simple_shear},
      {"Biaxial",
       {"Axes", "Strains", "Displacements [um]"},
       "the upper faces of two Axes are moved along their normals, the lower ones held there; all "
       "four slide in their planes.",
       biaxial},
      {"Torsion",
       {"Face", "Angle [deg]", "Center [um]"},
       "Face turns about its normal through Center [um], the opposite face is held.",
       torsion},
      {stiffness_rig,
       {"Boundary"},
       "six load cases of small strain, for the 6 x 6 stiffness of the specimen as a whole; there "
       "are no load steps.",
       none,
       false,
       false}};
  return table;
}

const Rig& rig_of(const std::string& name) {
  return *std::find_if(rigs().begin(), rigs().end(),
                       [&](const Rig& rig) { return rig.name == name; });
}

NamedConditions conditions_of(const RigParameters& rig) {
  NamedConditions conditions = rig_of(rig.kind).conditions(rig);
  for (auto& [name, condition] : conditions) {
    condition.load_curve = rig.load_curve;
    condition.imposed_by = rig.imposed_by;
    condition.penalty_factor = rig.penalty_factor;
  }
  return conditions;
}

}  // namespace stroma::mechanics
