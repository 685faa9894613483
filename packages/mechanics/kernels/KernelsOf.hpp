// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The kernels for one kind of shape functions; to be included where that kind is compiled.

#include <stdexcept>

#include "stroma/mechanics/kernels/ShapeKernels.hpp"
#include "stroma/transfer/Advance.hpp"
#include "stroma/transfer/MassTangent.hpp"
#include "stroma/transfer/Projection.hpp"
#include "stroma/transfer/Touch.hpp"

namespace stroma::mechanics {

template <class Shape>
class KernelsOf : public ShapeKernels {
 public:
  int fictitious_points() const override {
    return transfer::ElementParticles<Shape, Device>::fictitious_points;
  }
  void touch(const Points& points, const Kokkos::View<const std::uint8_t*, Device>& chosen,
             bool with_fictitious_points, const NodeView& count,
             const transfer::TouchedNodes<Device>& by_particles) const override {
    launch("touch", points,
           transfer::Touch<Shape, Device>{
               {points}, chosen, with_fictitious_points, count, by_particles});
  }
  void external_force(const Points& points,
                      const Kokkos::View<const transfer::VolumeForce*, Device>& forces,
                      const Kokkos::View<const double*, Device>& density,
                      const transfer::ForceAtParticles<Device>& at_particles,
                      const NodeView& force) const override {
    launch("external force", points,
           transfer::ExternalForce<Shape, Device>{{points}, forces, density, at_particles, force});
  }
  void spring_force(const Points& points, const BoundaryPoints& boundary,
                    const NodeView& force) const override {
    launch("spring force", points, transfer::SpringForce<Shape, Device>{{points}, boundary, force});
  }
  void boundary_gaps(const Points& points, const BoundaryPoints& boundary,
                     const NodeView& gap) const override {
    launch("boundary gaps", points, transfer::BoundaryGaps<Shape, Device>{{points}, boundary, gap});
  }
  void spring_tangent(const Points& points, const BoundaryPoints& boundary,
                      const transfer::BlockRows<Device>& rows) const override {
    launch("spring tangent", points,
           transfer::SpringTangent<Shape, Device, transfer::BlockRows<Device>>{
               {points}, boundary, rows});
  }
  void spring_tangent(const Points& points, const BoundaryPoints& boundary,
                      const transfer::StencilRows<Device>& rows) const override {
    if constexpr (Shape::width == 2)
      launch("spring tangent", points,
             transfer::SpringTangent<Shape, Device, transfer::StencilRows<Device>>{
                 {points}, boundary, rows});
    else
      throw std::logic_error("a stencil of 27 blocks cannot hold the tangent of wider functions");
  }
  void spring_tangent_times(const Points& points, const BoundaryPoints& boundary,
                            const ConstNodeView& direction,
                            const NodeView& product) const override {
    launch("spring tangent times", points,
           transfer::SpringTangentTimes<Shape, Device>{{points}, boundary, direction, product});
  }
  void project_to_nodes(const Points& points, const ConstNodeView& field,
                        const Kokkos::View<const double*, Device>& density, const NodeView& mass,
                        const NodeView& momentum) const override {
    launch("project to nodes", points,
           transfer::ProjectToNodes<Shape, Device>{{points}, field, density, mass, momentum});
  }
  void add_at_particles(const Points& points, const NodeView& field) const override {
    launch("add at particles", points, transfer::AddAtParticles<Shape, Device>{{points}, field});
  }
  void gradient_at_particles(const Points& points, const ConstNodeView& nodal,
                             const Particles::Tensor& gradient) const override {
    launch("gradient at particles", points,
           transfer::GradientAtParticles<Shape, Device>{{points}, nodal, gradient});
  }
  void mass_tangent(const Points& points, const Kokkos::View<const double*, Device>& density,
                    const transfer::BlockRows<Device>& rows) const override {
    launch(
        "mass tangent", points,
        transfer::MassTangent<Shape, Device, transfer::BlockRows<Device>>{{points}, density, rows});
  }
  void mass_tangent(const Points& points, const Kokkos::View<const double*, Device>& density,
                    const transfer::StencilRows<Device>& rows) const override {
    if constexpr (Shape::width == 2)
      launch("mass tangent", points,
             transfer::MassTangent<Shape, Device, transfer::StencilRows<Device>>{
                 {points}, density, rows});
    else
      throw std::logic_error("a stencil of 27 blocks cannot hold the mass of wider functions");
  }
  std::int64_t gradient_from_displacement(const Points& points) const override {
    return launch("gradient from displacement", points,
                  transfer::GradientFromDisplacement<Shape, Device>{{points}});
  }
  void advance(const Points& points, const Particles& moved) const override {
    launch("advance", points, transfer::Advance<Shape, Device>{{points}, moved});
  }

 private:
  template <class Kernel>
  static std::int64_t launch(const char* name, const Points& points, const Kernel& kernel) {
    return transfer::for_each_element<Shape::width, grid::ExecutionSpace>(name, points.box, kernel);
  }
};

}  // namespace stroma::mechanics
