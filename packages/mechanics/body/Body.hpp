// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A body of particles on the grid of one base configuration.

#include <array>
#include <functional>
#include <memory>
#include <utility>

#include "stroma/grid/Halo.hpp"
#include "stroma/mechanics/kernels/ShapeKernels.hpp"
#include "stroma/mechanics/problem/Problem.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/transfer/GridToParticles.hpp"

namespace stroma::mechanics {

/// The particle that fares worst: the one with the smallest figure of some kind.
struct WorstParticle {
  std::int64_t id = -1;
  int material = 0;
  double figure = 0.0;
  std::array<double, 3> position{};  ///< at the base configuration [um]
};

/// Particles whose material has lost ellipticity (transfer::WaveModulus).
struct Localization {
  std::int64_t particles = 0;         ///< of all ranks
  WorstParticle worst;                ///< figure: the modulus of a plane wave [Pa], < 0
  std::array<double, 3> direction{};  ///< a band across it takes the strain; of unit length
};

/// Results at the particles of a rank, one layer of elements along z at a time, so that nobody keeps
/// them all. Good until the halo is used again; does not communicate.
class FieldLayers {
 public:
  using Fields = transfer::ParticleFields<grid::Device>;
  /// Takes the first particle and the fields of a layer.
  using Visitor = std::function<void(int, const Fields&)>;

  FieldLayers(std::shared_ptr<const StressKernels> stress,
              const transfer::PointSet<grid::Device>& at_u)
      : stress_(std::move(stress)), at_u_(at_u) {}

  /// Layers of this rank's elements.
  int count() const { return at_u_.box.elements[2]; }
  /// The first particle of a layer; of the layer behind the last, the number of all.
  int first_particle(int layer) const;
  /// Calls visit for one layer, if it holds particles.
  void visit(int layer, const Visitor& use) const;
  /// For each layer, in the order of the particles; as often as it is called.
  void operator()(const Visitor& use) const;

 private:
  std::shared_ptr<const StressKernels> stress_;
  transfer::PointSet<grid::Device> at_u_;
};

/// The particles, the grid under them, and the ways between the two. The displacement u of the
/// grid's nodes since the base configuration [um] is a Tpetra vector over halo().owned_map(); it
/// deforms the particles. Member functions are collective unless they say otherwise.
class Body {
 public:
  using Device = grid::Device;
  using Points = transfer::PointSet<Device>;
  using NodeCounts = Kokkos::View<std::uint8_t*, Device>;

  /// \param communicator  of the ranks that share the body
  /// \param partition     which elements and nodes are whose
  /// \param particles     this rank's, in the order of their elements
  /// \param problem       materials, conditions, loads and the choice of method
  /// \throws base::InputError when the shape functions cannot work with the grid or the particles,
  ///         or when sizes are beyond what numbers hold (Scales.hpp)
  Body(const base::Communicator& communicator, const grid::Partition& partition,
       const particles::Particles<Device>& particles, const Problem& problem);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  // Not collective.
  const base::Communicator& communicator() const { return halo_.communicator(); }
  const grid::Halo& halo() const { return halo_; }
  const Problem& problem() const { return problem_; }
  const particles::Particles<Device>& particles() const { return particles_; }
  const transfer::ElementBox& box() const { return box_; }
  const ShapeKernels& kernels() const { return *kernels_; }
  const std::shared_ptr<const StressKernels>& stress() const { return stress_; }
  /// (material) [kg/m^3]; 1 where the problem gives none.
  const Kokkos::View<const double*, Device>& density() const { return density_; }
  /// Whether velocities and accelerations are the particles' (Particles::velocity).
  bool particles_carry_motion() const {
    const auto& dynamics = problem_.dynamics;
    return dynamics && (problem_.method.reset || !dynamics->lumped);
  }
  /// Whether particles carry velocity gradients too (Particles::velocity_gradient).
  bool particles_carry_gradients() const {
    return particles_carry_motion() && problem_.dynamics->lumped;
  }
  /// Whether a motion begins with this body: it was not given particles that have one.
  bool begins_motion() const { return begins_motion_; }
  /// About the size of an element's entries on the tangent's diagonal [pN/um].
  double typical_diagonal() const { return typical_diagonal_; }

  /// From now on the materials' drives are those of a load factor.
  ///
  /// \param load       the load factor
  /// \param time_step  time since the histories of the particles [s]
  void set_load(double load, double time_step);
  double time_step() const { return time_step_; }

  /// The body's points with a displacement, good until the halo gathers another vector.
  Points points(const grid::Vector& u) const;

  /// (local element) what it lacks to being full of particles (mechanics::missing_volume()). Collective.
  Kokkos::View<double*, Device> missing_volume(double share) const;
  /// The particles in the elements of a partition of the grid, or of the lattice under it.
  particles::Particles<Device> particles_on(const grid::Partition& partition) const;
  /// (local element of a partition) whether the element holds a particle. The partition is that of
  /// the grid, or of the lattice under it.
  Kokkos::View<std::uint8_t*, Device> filled_elements(const grid::Partition& partition) const;
  /// (touched node) the elements around it, of any rank, in which a particle touches it.
  ///
  /// \param chosen                 (particle) 0: it does not count; empty: all do
  /// \param with_fictitious_points  whether these count too
  /// \param by_particles           if not empty, gets the nodes that each element's particles touch
  NodeCounts elements_around(const Kokkos::View<const std::uint8_t*, Device>& chosen,
                             bool with_fictitious_points,
                             const transfer::TouchedNodes<Device>& by_particles = {}) const;

  /// The displacement of the particles from the undeformed body, put on the grid anew (the paper's
  /// equation 1): u_I = sum_p m_p N_I u_p / sum_p m_p N_I  [um]; 0 where no particle is.
  void project_displacement(const grid::Vector& u, grid::Vector& projected) const;
  /// The same of any vector of the particles, such as their velocity, in its unit.
  ///
  /// \param u             displacement since the base [um]
  /// \param field, means  (particle, component), and its means at owned nodes
  void find_nodal_means(const grid::Vector& u, const grid::ConstNodeView& field,
                        grid::Vector& means) const;
  /// Sets the base gradient of movable particles from a displacement of the nodes that leads from
  /// the undeformed body to the base (the paper's equation 2).
  /// \throws base::RunError when it turns particles inside out
  void set_base_gradient(const grid::Vector& projected);
  /// Lets particles that track their displacement keep it when the nodes' displacement since an
  /// undeformed base is replaced by another.
  void replace_displacement(const grid::Vector& old, const grid::Vector& now);
  /// Changes the method's stabilization [-], >= 0.
  void stabilize(double stabilization);
  /// Takes what the particles of the same body on another grid remember (transfer::UpdateHistory).
  void take_history(const Body& other);
  /// The particles at the displaced configuration, in the same order.
  particles::Particles<Device> moved_particles(const grid::Vector& u) const;

  /// Results at this rank's particles.
  transfer::ParticleFields<Device> particle_fields(const grid::Vector& u) const;
  /// The same, layer by layer.
  FieldLayers field_layers(const grid::Vector& u) const;
  /// The one with the smallest J.
  WorstParticle worst_particle(const grid::Vector& u) const;
  /// Where a plane wave has a negative modulus, of one element in `share` (transfer::is_drawn).
  /// Takes as long as a tangent of these.
  Localization localization(const grid::Vector& u, int share) const;
  /// The largest of a particle's mean stress in moduli K, and its other stress in moduli mu, of its
  /// material [-]: about how much the body is strained where it is strained most. Rounding makes 1e-15
  /// of a body at rest.
  double largest_strain(const grid::Vector& u) const;

 private:
  void find_fictitious_points();
  /// \param figure  (particle); what is no number is less than any
  WorstParticle worst_by(const Kokkos::View<const double*, Device>& figure) const;

  Problem problem_;
  std::shared_ptr<const ShapeKernels> kernels_;
  std::shared_ptr<const StressKernels> stress_;
  grid::Halo halo_;
  particles::Particles<Device> particles_;
  transfer::ElementBox box_;
  Kokkos::View<const double*, Device> density_;
  Kokkos::View<const float*, Device> fictitious_volume_;
  transfer::ParticleDomains<Device> domains_;
  double typical_diagonal_;
  double time_step_ = 0.0;
  bool begins_motion_ = true;
  Kokkos::View<const material::MaterialFactors*, Device> factors_;  // (material) or empty
};

}  // namespace stroma::mechanics
