// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/BoundaryConditions.hpp"

#include <cmath>
#include <cstddef>

#include "stroma/base/Log.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::mechanics {

int axis_of(Face face) { return face == Face::all ? -1 : static_cast<int>(face) / 2; }

bool is_upper(Face face) { return face != Face::all && static_cast<int>(face) % 2 == 1; }

double BoundaryCondition::value(int component, const std::array<double, 3>& position,
                                const std::array<double, 3>& corner,
                                const std::array<double, 3>& length) const {
  const auto c = static_cast<std::size_t>(component);
  if (displacement) return (*displacement)[c];
  if (strain && axis_of(*face) == component)
    return (is_upper(*face) ? 1.0 : -1.0) * *strain * length[c];
  if (displacement_gradient) {
    double sum = 0.0;
    for (std::size_t d = 0; d < 3; ++d)
      sum += (*displacement_gradient)[3 * c + d] * (position[d] - corner[d]);
    return sum;
  }
  return 0.0;
}

std::array<double, 3> BoundaryCondition::carried_from(const std::array<double, 3>& x, double load,
                                                      const std::array<double, 3>& corner,
                                                      const std::array<double, 3>& length) const {
  std::array<double, 3> X = x;
  if (displacement_gradient) {
    tensor::Tensor3 motion = tensor::identity();
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3 && prescribes(c); ++d)
        motion(c, d) += load * (*displacement_gradient)[static_cast<std::size_t>(3 * c + d)];
    const tensor::Tensor3 back = tensor::inverse(motion);
    for (int c = 0; c < 3; ++c) {
      const auto i = static_cast<std::size_t>(c);
      X[i] = corner[i];
      for (int d = 0; d < 3; ++d)
        X[i] += back(c, d) * (x[static_cast<std::size_t>(d)] - corner[static_cast<std::size_t>(d)]);
    }
    return X;
  }
  for (int c = 0; c < 3; ++c)
    if (prescribes(c)) X[static_cast<std::size_t>(c)] -= load * value(c, x, corner, length);
  return X;
}

bool BoundaryCondition::is_self_contained() const {
  if (!displacement_gradient) return true;
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3 && prescribes(c); ++d)
      if (!prescribes(d) && (*displacement_gradient)[static_cast<std::size_t>(3 * c + d)] != 0.0)
        return false;
  return true;
}

bool BoundaryCondition::stays_in_plane() const {
  const int normal = axis_of(*face);
  if (normal < 0 || !prescribes(normal)) return false;
  const auto n = static_cast<std::size_t>(normal);
  if (displacement) return (*displacement)[n] == 0.0;
  if (strain) return *strain == 0.0;
  if (!displacement_gradient) return true;
  for (std::size_t d = 0; d < 3; ++d)
    if ((d != n || is_upper(*face)) && (*displacement_gradient)[3 * n + d] != 0.0) return false;
  return true;
}

int BoundaryCondition::loaded_component(const std::array<double, 3>& length) const {
  int loaded = -1;
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    if (!prescribes(c)) continue;
    const double moved = std::abs(value(c, length, {0.0, 0.0, 0.0}, length));
    if (moved > largest) {
      largest = moved;
      loaded = c;
    }
  }
  return loaded;
}

std::string conflict(const std::string& first, const std::string& second, int component,
                     const std::array<double, 3>& x, double a, double b) {
  return base::format(
      "Boundary Conditions|%s: its %c displacement, %.10g um, and that of %s, %.10g um, differ at "
      "their common point (%g, %g, %g) um; admissible: equal values, or %c left out of the "
      "Components of one of them",
      first.c_str(), "xyz"[component], a,
      second.empty() ? "plane strain" : ("\"" + second + "\"").c_str(), b, x[0], x[1], x[2],
      "xyz"[component]);
}

std::string no_particle_near(const std::string& condition) {
  return "Boundary Conditions|" + condition +
         "|Face: there is no particle in the elements along this face; admissible: a face at which "
         "the image has a label other than -1 (empty)";
}

deck::Section<BoundaryConditionsParameters> boundary_conditions_section() {
  deck::Section<BoundaryCondition> condition(
      "NAME", "One condition; NAME is the user's and appears in the results.");
  condition.required_choice("Face", &BoundaryCondition::face,
                            {{"x-", Face::x_lower},
                             {"x+", Face::x_upper},
                             {"y-", Face::y_lower},
                             {"y+", Face::y_upper},
                             {"z-", Face::z_lower},
                             {"z+", Face::z_upper},
                             {"all", Face::all}},
                            "A face of the body's box, or all six.");
  condition.required(
      "Components", &BoundaryCondition::components, deck::not_empty(),
      "The displacement components it prescribes: a selection of xyz, such as y or xyz.");
  condition.optional("Displacement [um]", &BoundaryCondition::displacement, deck::any(),
                     "Displacement at full load, x, y, z. Without any of Displacement, Strain and "
                     "Displacement Gradient the components are held at zero.");
  condition.optional(
      "Strain", &BoundaryCondition::strain, deck::any(),
      "Displacement along the outward normal at full load, as a fraction of the body's "
      "length there; the other components are held at zero.");
  condition.optional("Displacement Gradient", &BoundaryCondition::displacement_gradient,
                     deck::any(),
                     "Nine numbers G, row by row: u = G (X - lowest corner of the body's box).");
  condition.choice(
      "Imposed By", &BoundaryCondition::imposed_by,
      {{"Nodes", ImposedBy::nodes}, {"Grip", ImposedBy::grip}, {"Penalty", ImposedBy::penalty}},
      "Nodes: the nodes of the face are moved; with Grid|Reset, the face must stay in "
      "its plane (its normal displacement is prescribed as zero). Grip: the particles "
      "within one element of the face at load 0 are moved, with all nodes that they "
      "touch. Penalty: springs move points of the face that ride beside the outermost "
      "particles; for every shape function, with Grid|Reset and without. Without it: "
      "Nodes, or Grip with Grid|Reset.");
  condition.optional(
      "Penalty Factor", &BoundaryCondition::penalty_factor, deck::positive(),
      "Stiffness of the springs of Imposed By = Penalty: per area, Penalty Factor * (K + 4/3 mu) / "
      "length of the body along the face's normal. They lower the force by about 1 / Penalty "
      "Factor. Without it: 2e4.");
  condition.check([](const BoundaryCondition& p, deck::Findings& findings) {
    for (std::size_t n = 0; n < p.components.size(); ++n) {
      const char c = p.components[n];
      if (c != 'x' && c != 'y' && c != 'z') {
        findings.add("Components", "\"" + p.components + "\": '" + std::string(1, c) +
                                       "' is not a component; admissible: a selection of xyz");
        break;
      }
      if (p.components.find(c, n + 1) != std::string::npos) {
        findings.add("Components", "\"" + p.components + "\": '" + std::string(1, c) +
                                       "' stands there twice; admissible: a selection of xyz");
        break;
      }
    }
    const int given =
        (p.displacement ? 1 : 0) + (p.strain ? 1 : 0) + (p.displacement_gradient ? 1 : 0);
    if (given > 1)
      findings.add(
          p.strain ? "Strain" : "Displacement Gradient",
          "more than one of \"Displacement [um]\", \"Strain\" and \"Displacement Gradient\" is "
          "given; admissible: one of them");
    if (p.strain && *p.face == Face::all)
      findings.add("Strain",
                   "has no direction on Face = all; admissible: a single face, or "
                   "\"Displacement Gradient\"");
    else if (p.strain && !p.prescribes(axis_of(*p.face)))
      findings.add("Strain", std::string("is along the face's normal, ") + "xyz"[axis_of(*p.face)] +
                                 ", which \"Components\" does not prescribe");
    if (p.displacement_gradient) {
      const auto& G = *p.displacement_gradient;
      const double j_minus_1 =
          tensor::det_minus_one({{{G[0], G[1], G[2]}, {G[3], G[4], G[5]}, {G[6], G[7], G[8]}}});
      if (!(1.0 + j_minus_1 > 0.0))
        findings.add("Displacement Gradient",
                     "turns the body inside out; admissible: det(I + G) > 0");
    }
    if (p.penalty_factor && p.imposed_by != ImposedBy::penalty)
      findings.add("Penalty Factor", "is used with Imposed By = Penalty only");
    if (p.strain && !(*p.strain > -1.0))
      findings.add("Strain", "a body cannot be compressed by 100 % or more; admissible: > -1");
  });

  deck::Section<BoundaryConditionsParameters> section(
      "Boundary Conditions", "One sublist for each condition, named by the user.");
  section.named_sections(condition, &BoundaryConditionsParameters::conditions);
  return section;
}

}  // namespace stroma::mechanics
