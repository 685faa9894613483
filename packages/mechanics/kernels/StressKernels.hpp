// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The transfer kernels that ask for stress, of one kind of shape functions and a body's laws,
/// behind one interface: what is compiled once per kind and set of laws, and chosen once per run.

#include <memory>
#include <vector>

#include "stroma/grid/Types.hpp"
#include "stroma/material/AnyLaw.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/shape/ShapeFunctions.hpp"
#include "stroma/transfer/GridToParticles.hpp"
#include "stroma/transfer/StencilRows.hpp"
#include "stroma/transfer/Tangent.hpp"

namespace stroma::mechanics {

/// Launches kernels over the points of a rank. Views over nodes are those of the touched nodes
/// (grid::Partition::touched_nodes); what is "added to" must be zeroed by the caller. Functions
/// that return a number count the points that the displacement turns inside out.
class StressKernels {
 public:
  using Device = grid::Device;
  using Points = transfer::PointSet<Device>;
  using NodeView = grid::NodeView;
  using ConstNodeView = grid::ConstNodeView;

  virtual ~StressKernels() = default;

  /// Numbers of history that particles must have (Particles::history); 0: none.
  virtual int states() const = 0;
  /// Whether mean dilatation may average the laws' energies of volume: whether all have one.
  virtual bool may_be_averaged() const = 0;
  /// Numbers that the laws take from particles (Particles::own_numbers); 0: none.
  virtual int own_numbers() const = 0;
  /// Of small strain, of a particle, by its material and what it has of its own.
  virtual material::SmallStrainModuli moduli_of(const particles::HostParticles& particles,
                                                int p) const = 0;

  /// transfer::InternalForce; force is added to.
  virtual std::int64_t internal_force(const Points& points, const NodeView& force) const = 0;
  /// transfer::Tangent.
  virtual std::int64_t tangent(const Points& points,
                               const transfer::BlockRows<Device>& rows) const = 0;
  /// The same as a stencil of 27 blocks a row: of hats only.
  virtual std::int64_t tangent(const Points& points,
                               const transfer::StencilRows<Device>& rows) const = 0;
  /// transfer::TangentTimes; product is added to.
  virtual void tangent_times(const Points& points, const ConstNodeView& direction,
                             const NodeView& product) const = 0;
  /// transfer::GridToParticles, of all particles.
  virtual void particle_fields(const Points& points,
                               const transfer::ParticleFields<Device>& fields) const = 0;
  /// transfer::GridToParticles, of the layer k of elements, whose first particle is `first`.
  virtual void layer_fields(const Points& points, int k, int first,
                            const transfer::ParticleFields<Device>& fields) const = 0;
  /// transfer::WaveModulus; of particles of elements that are not drawn nothing is set.
  virtual void wave_moduli(const Points& points,
                           const Kokkos::View<const material::FiberDirection*, Device>& directions,
                           int share, const Kokkos::View<double*, Device>& least,
                           const Kokkos::View<double* [3], Device>& across) const = 0;
  /// transfer::UpdateHistory: writes the particles' history, if they have one. For displacements
  /// that were accepted.
  virtual void update_history(const Points& points) const = 0;
};

/// The laws of all materials, of those that a deck may name.
struct LawList {
  std::vector<material::AnyLaw> of_material;
  std::vector<material::FiberDirections> directions = {};  ///< those that laws point to
};

/// The kernels for a choice of shape functions, in space or in plane strain, and the laws of all
/// materials. A body of neo-Hookean laws whose numbers do not vary has kernels of its own.
std::shared_ptr<const StressKernels> stress_kernels(const LawList& laws,
                                                    shape::ShapeFunctions shape_functions,
                                                    bool flat);

// One per kind, each in its own file: they take long to compile.
std::shared_ptr<const StressKernels> linear_stress_kernels(const LawList& laws);
std::shared_ptr<const StressKernels> gimp_stress_kernels(const LawList& laws, bool flat);
std::shared_ptr<const StressKernels> cpdi_stress_kernels(const LawList& laws, bool flat);
std::shared_ptr<const StressKernels> quadratic_b_spline_stress_kernels(const LawList& laws,
                                                                       bool flat);
std::shared_ptr<const StressKernels> cubic_b_spline_stress_kernels(const LawList& laws, bool flat);

}  // namespace stroma::mechanics
