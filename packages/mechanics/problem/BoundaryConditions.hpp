// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What holds and moves the body's faces.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/mechanics/problem/LoadCurve.hpp"
#include "stroma/mechanics/problem/VectorField.hpp"

namespace stroma::mechanics {

enum class Face { x_lower, x_upper, y_lower, y_upper, z_lower, z_upper, all };

/// The face at an end of an axis (0, 1, 2).
inline Face face_of(int axis, bool is_upper) {
  return static_cast<Face>(2 * axis + (is_upper ? 1 : 0));
}

/// Axis (0, 1, 2) of a face's normal, -1 for Face::all.
int axis_of(Face face);
/// Whether the face is the upper one of its axis.
bool is_upper(Face face);
/// As decks name it: "x-", "x+", ... "all".
std::string name_of(Face face);

/// The ends of a load step along which prescribed displacements go straight from where they were to
/// where they shall be. Schemes that have the balance within a step take displacements from there to
/// its end on a line: those of the supports must lie on it, or they would strain what is beside them.
struct StraightStep {
  double begin = 0.0, end = 0.0;  ///< [load]

  /// What is `at` a load: within the step, on the line.
  template <class At>
  double on_the_line(double load, const At& at) const {
    if (!(begin < load && load < end)) return at(load);
    const double share = (load - begin) / (end - begin);
    return (1.0 - share) * at(begin) + share * at(end);
  }
};

/// How a condition reaches the grid: at the nodes of the face; by a grip, the particles that lie
/// within one element of the face at load 0, which move as prescribed with all nodes they touch; or
/// by a penalty, stiff springs on points of the face that ride beside the outermost particles.
enum class ImposedBy { nodes, grip, penalty };

/// One condition on the displacement of a face. At most one of the five values is given; without
/// any, the components are held at zero.
struct BoundaryCondition {
  std::optional<Face> face;
  std::string components;                                      ///< a selection of "xyz"
  std::optional<std::array<double, 3>> displacement;           ///< [um], at full load
  std::optional<double> strain;                                ///< along the outward normal [-]
  std::optional<std::array<double, 9>> displacement_gradient;  ///< G, row by row [-]
  std::optional<double> rotation;               ///< angle at full load, right-handed [deg]
  std::optional<std::array<double, 3>> axis;    ///< of the rotation, of any length; else the normal
  std::optional<std::array<double, 3>> center;  ///< on the axis [um]; else the body box's middle
  std::optional<VectorImages> images;           ///< of the displacement at full load
  std::shared_ptr<const VectorField> field = {};  ///< what they hold around the face
  std::optional<ImposedBy> imposed_by;            ///< else Problem::imposed_by()
  /// Springs' stiffness per area, in moduli M per length of the body along the face's normal [-].
  std::optional<double> penalty_factor;   ///< else Problem::spring_stiffness()
  std::optional<std::string> load_curve;  ///< the deck's name of `curve`
  LoadCurve curve = {};                   ///< the factor s of the five values

  bool prescribes(int component) const {
    return components.find("xyz"[component]) != std::string::npos;
  }

  /// The factor s at a load: the curve's, but 0 at load 0, where the body is undeformed. What a curve
  /// has from its start on comes with the first step.
  double factor(double load) const { return load > 0.0 ? curve.at(load) : 0.0; }

  /// Displacement component [um] of a point of the face at a load factor, of which s is the factor: s times the given displacement, or that of the images at X, or strain * length along the outward normal, or G (X - corner); or, about the
  /// unit axis a, with r = X - center and the angle t = s * rotation,
  ///
  ///     u = sin t  a x r + (1 - cos t)  a x (a x r).
  ///
  /// \param component  0, 1, 2 for x, y, z
  /// \param position   X [um]
  /// \param corner     lowest corner of the body's box [um]
  /// \param length     edges of the body's box [um]
  /// \param load       the load factor
  double value(int component, const std::array<double, 3>& position,
               const std::array<double, 3>& corner, const std::array<double, 3>& length,
               double load) const;
  /// The same at s = 1: what the deck gives.
  double full(int component, const std::array<double, 3>& position,
              const std::array<double, 3>& corner, const std::array<double, 3>& length) const;

  /// Its derivative by the load factor [um].
  double rate(int component, const std::array<double, 3>& position,
              const std::array<double, 3>& corner, const std::array<double, 3>& length,
              double load) const;
  /// Its derivative by s, at s = 0 [um]: where it sets out for.
  double direction(int component, const std::array<double, 3>& position,
                   const std::array<double, 3>& corner, const std::array<double, 3>& length) const;
  /// a x (x - center) of a turning face: how far a point at x goes per radian, and so the lever of a
  /// force there about the axis [um].
  std::array<double, 3> lever(const std::array<double, 3>& x, const std::array<double, 3>& corner,
                              const std::array<double, 3>& length) const;
  /// Whether value() is proportional to the load.
  bool is_linear() const { return !rotation && curve.is_load(); }

  /// The point X of the undeformed body [um] that the condition has carried to a position x [um] at
  /// a load factor: x = X + u(X). Components that it does not prescribe count as not moved. Images
  /// are for grids that are not reset, whose nodes are where they were.
  std::array<double, 3> carried_from(const std::array<double, 3>& x, double load,
                                     const std::array<double, 3>& corner,
                                     const std::array<double, 3>& length) const;

  /// Whether the prescribed displacement can be told from prescribed components alone, as
  /// carried_from() must: with a Displacement Gradient, no prescribed row refers to a direction
  /// that is free; with a Rotation, directions that are free lie along its axis.
  bool is_self_contained() const;

  /// Whether it applies to a face, which is not Face::all.
  bool applies_to(Face other) const { return *face == Face::all || *face == other; }
  /// Whether it keeps one of its faces a plane across its axis: the face's normal displacement is
  /// prescribed, and the same everywhere on it.
  bool keeps_plane(Face of_its_faces) const;

  /// Component along which the face moves most at s = 1, -1 if it stays, turns or
  /// follows images.
  int loaded_component(const std::array<double, 3>& length) const;

 private:
  double at_factor(int component, const std::array<double, 3>& position,
                   const std::array<double, 3>& corner, const std::array<double, 3>& length,
                   double factor) const;
  double rate_of_factor(int component, const std::array<double, 3>& position,
                        const std::array<double, 3>& corner, const std::array<double, 3>& length,
                        double factor) const;
  std::array<double, 3> unit_axis() const;
  /// X - center.
  std::array<double, 3> arm(const std::array<double, 3>& position,
                            const std::array<double, 3>& corner,
                            const std::array<double, 3>& length) const;
};

/// Components ("xyz" or fewer) of a face that are held at zero.
BoundaryCondition hold(Face face, const std::string& components);

using NamedConditions = std::vector<std::pair<std::string, BoundaryCondition>>;

/// A condition at a point of the undeformed body [um].
struct ConditionAt {
  const BoundaryCondition& condition;
  const std::array<double, 3>& X;
};

/// What two conditions want of one displacement component at a load at which they differ.
struct Disagreement {
  double load, a, b;  ///< [1], [um]
};

/// Where two conditions do not want the same displacement component at all loads.
///
/// \param a, b       the conditions, each where it has the point
/// \param component  0, 1, 2 for x, y, z
/// \param corner     lowest corner of the body's box [um]
/// \param length     edges of the body's box [um]
std::optional<Disagreement> disagreement(const ConditionAt& a, const ConditionAt& b, int component,
                                         const std::array<double, 3>& corner,
                                         const std::array<double, 3>& length);

/// What to tell the user when two conditions disagree on a component at a point x [um].
std::string conflict(const std::string& first, const std::string& second, int component,
                     const std::array<double, 3>& x, const Disagreement& found);
/// And of a condition that moves a slice in plane strain along z, by found.a.
std::string moved_across_plane_strain(const std::string& name, const Disagreement& found);
/// What to tell the user when the face of a condition or a traction, or one of all faces, has no
/// particle.
std::string no_particle_at(const std::string& section, const std::string& face = "this face");

struct BoundaryConditionsParameters {
  NamedConditions conditions;
};

}  // namespace stroma::mechanics
