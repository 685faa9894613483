// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The transfer kernels that ask nothing of a law, of one kind of shape functions, behind one
/// interface: what is compiled once per kind, and chosen once per run.

#include <memory>

#include "stroma/grid/Types.hpp"
#include "stroma/shape/ShapeFunctions.hpp"
#include "stroma/transfer/BoundaryPoints.hpp"
#include "stroma/transfer/ExternalForce.hpp"
#include "stroma/transfer/StencilRows.hpp"
#include "stroma/transfer/Tangent.hpp"
#include "stroma/transfer/Touch.hpp"

namespace stroma::mechanics {

/// Launches kernels over the points of a rank. Views over nodes are those of the touched nodes
/// (grid::Partition::touched_nodes); what is "added to" must be zeroed by the caller. Functions
/// that return a number count the points that the displacement turns inside out.
class ShapeKernels {
 public:
  using Device = grid::Device;
  using Points = transfer::PointSet<Device>;
  using BoundaryPoints = transfer::BoundaryPointSet<Device>;
  using NodeView = grid::NodeView;
  using ConstNodeView = grid::ConstNodeView;
  using Particles = particles::Particles<Device>;

  virtual ~ShapeKernels() = default;

  /// Fictitious points of an element that has some (transfer::ElementParticles).
  virtual int fictitious_points() const = 0;
  /// transfer::Touch; count is added to.
  virtual void touch(const Points& points, const Kokkos::View<const std::uint8_t*, Device>& chosen,
                     bool with_fictitious_points, const NodeView& count,
                     const transfer::TouchedNodes<Device>& by_particles) const = 0;

  /// transfer::ExternalForce; force is added to.
  virtual void external_force(const Points& points,
                              const Kokkos::View<const transfer::VolumeForce*, Device>& forces,
                              const Kokkos::View<const double*, Device>& density,
                              const transfer::ForceAtParticles<Device>& at_particles,
                              const NodeView& force) const = 0;
  /// transfer::SpringForce; force is added to.
  virtual void spring_force(const Points& points, const BoundaryPoints& boundary,
                            const NodeView& force) const = 0;
  /// transfer::BoundaryGaps.
  virtual void boundary_gaps(const Points& points, const BoundaryPoints& boundary,
                             const NodeView& gap) const = 0;
  /// transfer::SpringTangent.
  virtual void spring_tangent(const Points& points, const BoundaryPoints& boundary,
                              const transfer::BlockRows<Device>& rows) const = 0;
  virtual void spring_tangent(const Points& points, const BoundaryPoints& boundary,
                              const transfer::StencilRows<Device>& rows) const = 0;
  /// transfer::SpringTangentTimes; product is added to.
  virtual void spring_tangent_times(const Points& points, const BoundaryPoints& boundary,
                                    const ConstNodeView& direction,
                                    const NodeView& product) const = 0;
  /// transfer::ProjectToNodes; mass and momentum are added to.
  virtual void project_to_nodes(const Points& points, const ConstNodeView& field,
                                const Kokkos::View<const double*, Device>& density,
                                const NodeView& mass, const NodeView& momentum) const = 0;
  /// transfer::AddAtParticles.
  virtual void add_at_particles(const Points& points, const NodeView& field) const = 0;
  /// transfer::GradientAtParticles: writes the particles' gradients of nodal values.
  virtual void gradient_at_particles(const Points& points, const ConstNodeView& nodal,
                                     const Particles::Tensor& gradient) const = 0;
  /// transfer::MassTangent.
  virtual void mass_tangent(const Points& points,
                            const Kokkos::View<const double*, Device>& density,
                            const transfer::BlockRows<Device>& rows) const = 0;
  virtual void mass_tangent(const Points& points,
                            const Kokkos::View<const double*, Device>& density,
                            const transfer::StencilRows<Device>& rows) const = 0;
  /// transfer::GradientFromDisplacement: writes the particles' base gradients.
  virtual std::int64_t gradient_from_displacement(const Points& points) const = 0;
  /// transfer::Advance: writes position, base displacement and gradient of `moved`.
  virtual void advance(const Points& points, const Particles& moved) const = 0;
};

/// The kernels for a choice of shape functions, in space or in plane strain.
std::shared_ptr<const ShapeKernels> kernels_for(shape::ShapeFunctions shape_functions, bool flat);

// One per kind, each in its own file: they take long to compile.
std::shared_ptr<const ShapeKernels> linear_kernels();
std::shared_ptr<const ShapeKernels> gimp_kernels(bool flat);
std::shared_ptr<const ShapeKernels> cpdi_kernels(bool flat);
std::shared_ptr<const ShapeKernels> quadratic_b_spline_kernels(bool flat);
std::shared_ptr<const ShapeKernels> cubic_b_spline_kernels(bool flat);

}  // namespace stroma::mechanics
