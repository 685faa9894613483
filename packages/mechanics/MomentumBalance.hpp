// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The balance of momentum of a body of particles on a grid: what a solver, or another Trilinos
/// application, couples to.

#include <Teuchos_RCP.hpp>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "stroma/grid/Halo.hpp"
#include "stroma/mechanics/Problem.hpp"
#include "stroma/mechanics/Supports.hpp"
#include "stroma/mechanics/kernels/ShapeKernels.hpp"
#include "stroma/particles/Particles.hpp"
#include "stroma/tangent/StencilMatrix.hpp"
#include "stroma/tangent/TangentMatrix.hpp"
#include "stroma/transfer/GridToParticles.hpp"

namespace stroma::mechanics {

/// The particle that fares worst: the one with the smallest J.
struct WorstParticle {
  std::int64_t id = -1;
  int material = 0;
  double jacobian = 0.0;
  std::array<double, 3> position{};  ///< at the base configuration [um]
};

/// How the tangent is stored: compressed rows for any package of Trilinos, or the stencil, which
/// takes a sixth of the memory.
enum class TangentForm { compressed_rows, stencil };

/// Residual and tangent of the quasi-static balance of momentum on the grid of one base
/// configuration. The unknown u is the displacement of the grid's nodes since then [um], in a
/// Tpetra vector over owned_map():
///
///     r_Ii(u) = sum_p V0 tau_ij dN_I/dx_j + s_Ii(u) - load f_Ii     [pN],      K = dr/du  [pN/um],
///
/// with f the external force at full load and s the springs of conditions imposed by penalty.
/// Prescribed components of u (see Supports) are set by
/// supports().impose(load, u); their rows of the residual are zero and their rows and columns of
/// the tangent hold only a diagonal, so that K is symmetric and every Newton increment keeps them.
///
/// Every member function is collective. Functions that evaluate particles return how many of them,
/// over all ranks, u turns inside out; the results are then not finite and the caller rejects u.
class MomentumBalance {
 public:
  using Device = grid::Device;

  /// \param communicator         of the ranks that share the body
  /// \param partition            which elements and nodes are whose
  /// \param particles            this rank's, in the order of their elements
  /// \param problem              materials, conditions, loads and the choice of method
  /// \param base_load            load factor at the base configuration
  /// \param is_refused_if_loose  whether the loads must be held (SupportedBody)
  /// \throws base::InputError  see Supports
  MomentumBalance(const base::Communicator& communicator, const grid::Partition& partition,
                  const particles::Particles<Device>& particles, const Problem& problem,
                  double base_load = 0.0, bool is_refused_if_loose = true);
  /// A body without external forces on a grid that is not reset.
  MomentumBalance(const base::Communicator& communicator, const grid::Partition& partition,
                  const particles::Particles<Device>& particles, const Laws& laws,
                  const NamedConditions& conditions);
  MomentumBalance(const MomentumBalance&) = delete;
  MomentumBalance& operator=(const MomentumBalance&) = delete;

  const grid::RCP<const grid::Map>& owned_map() const { return halo_.owned_map(); }
  const grid::Halo& halo() const { return halo_; }
  const Supports& supports() const { return *supports_; }
  const Problem& problem() const { return problem_; }
  const particles::Particles<Device>& particles() const { return particles_; }
  /// (local element of a partition) whether the element holds a particle. The partition is that of
  /// the grid, or of the lattice under it. Collective.
  Kokkos::View<std::uint8_t*, Device> filled_elements(const grid::Partition& partition) const;

  /// Load factor by which external forces are multiplied (0 at the start).
  void set_load(double load) { load_ = load; }

  /// Internal force [pN] at all owned unknowns.
  std::int64_t internal_force(const grid::Vector& u, grid::Vector& force) const;
  /// Internal force with that of springs, less external force [pN]: at prescribed components the
  /// force of the support on the body, elsewhere the residual.
  std::int64_t unbalanced_force(const grid::Vector& u, grid::Vector& force) const;
  /// Unbalanced force with prescribed components cleared.
  std::int64_t residual(const grid::Vector& u, grid::Vector& r) const;
  /// Chooses how the tangent is stored, before it is first used; compressed rows otherwise. Another
  /// choice later gives up the operator that there is.
  void choose_tangent(TangentForm form);
  /// Assembles the tangent at u into the one operator that tangent() returns.
  std::int64_t assemble_tangent(const grid::Vector& u);
  /// The tangent's operator; built at the first call.
  grid::RCP<Tpetra::Operator<double>> tangent();
  /// The same as a matrix, when it is stored as compressed rows.
  grid::RCP<tangent::Matrix> tangent_matrix();
  /// product = K(u) v without forming K and without regard to what is prescribed.
  void tangent_times(const grid::Vector& u, const grid::Vector& v, grid::Vector& product) const;

  /// Where the tangent was last assembled [um]; null: nowhere yet.
  const grid::RCP<const grid::Vector>& linearization_point() const { return linearized_at_; }

  /// The same body, conditions and base with hats on the lattice under the shape functions: what
  /// multigrid coarsens from. Springs are lumped, for a field of hats that satisfies theirs does
  /// not satisfy those of wider functions. Collective.
  std::unique_ptr<MomentumBalance> with_hats(const grid::Partition& lattice) const;

  /// External force at full load [pN], at all owned unknowns; null if there is none.
  const grid::RCP<const grid::Vector>& external_force() const { return external_force_; }
  /// Force of each condition's support on the body [pN] at a displacement and its unbalanced force.
  std::vector<std::array<double, 3>> reactions(const grid::Vector& u,
                                               const grid::Vector& unbalanced_force) const;
  /// Energy that the springs of conditions imposed by penalty hold because the supports pull [aJ],
  /// sum R^2 / (2 sum k) over conditions and components; 0 without any. Its share of all energy is
  /// what they take off the stiffness of the body between its supports.
  double spring_energy(const grid::Vector& u) const;
  /// Size of the forces [pN] to which a residual is compared: the largest of the Euclidean norms of
  /// the reactions, of the springs' and of the external force.
  double force_scale(const grid::Vector& u, const grid::Vector& unbalanced_force) const;
  /// How many times stiffer than an element the springs of conditions imposed by penalty are; 1
  /// without any. Their residual tells so much less of the body's.
  double spring_contrast() const { return stiffest_diagonal_ / typical_diagonal_; }
  /// How far rounding alone puts the residual from zero at a displacement [pN].
  double rounding(const grid::Vector& u) const;

  /// The displacement of the particles from the undeformed body, put on the grid anew (the paper's
  /// equation 1): u_I = sum_p m_p N_I u_p / sum_p m_p N_I  [um]; 0 where no particle is.
  void project_displacement(const grid::Vector& u, grid::Vector& projected) const;
  /// Sets the base gradient of movable particles from a displacement of the nodes that leads from
  /// the undeformed body to the base (the paper's equation 2).
  /// \throws base::RunError when it turns particles inside out
  void set_base_gradient(const grid::Vector& projected);
  /// Lets particles that track their displacement keep it when the nodes' displacement since an
  /// undeformed base is replaced by another.
  void replace_displacement(const grid::Vector& old, const grid::Vector& now);
  /// Lets the laws remember an accepted displacement (transfer::UpdateHistory): from now on, what is
  /// asked of them is asked for a displacement that comes after it.
  void commit_history(const grid::Vector& u);
  /// Takes what the particles of another balance of the same body remember; for with_hats().
  void take_history(const MomentumBalance& other);
  /// The particles at the displaced configuration, in the same order.
  particles::Particles<Device> moved_particles(const grid::Vector& u) const;

  /// Results at this rank's particles.
  transfer::ParticleFields<Device> particle_fields(const grid::Vector& u) const;
  /// The same, one layer of elements along z at a time, so that nobody keeps them all: a function
  /// that calls visit(first particle, fields of the layer) for each layer that holds particles, in
  /// the order of the particles, as often as it is called. Making it is collective, calling it is
  /// not; it is good until the next call of a member function.
  using FieldVisitor = std::function<void(int, const transfer::ParticleFields<Device>&)>;
  std::function<void(const FieldVisitor&)> field_layers(const grid::Vector& u) const;
  WorstParticle worst_particle(const grid::Vector& u) const;
  /// The largest stress component of a particle in moduli K + 4/3 mu of its material [-]: about how
  /// much the body is strained where it is strained most. Rounding makes 1e-15 of a body at rest.
  double largest_strain(const grid::Vector& u) const;

 private:
  using Points = transfer::PointSet<Device>;
  Points points(const grid::Vector& u) const;
  void find_fictitious_points(double stabilization);
  /// (touched node) the elements around it, of any rank, in which a chosen particle, or a
  /// fictitious point, touches it.
  Supports::NodeCounts elements_around(
      const Kokkos::View<const std::uint8_t*, Device>& chosen, bool with_fictitious_points,
      const transfer::TouchedNodes<Device>& by_particles = {}) const;
  void find_supports(const Problem& problem, double base_load, bool is_refused_if_loose);
  void sum_up(const Pieces& pieces, BodyStatics& statics) const;
  void find_external_force(const Problem& problem);
  /// Calls use(boundary point, its gap [um]) for each of this rank's, on the host.
  template <class Use>
  void for_each_gap(const grid::Vector& u, const Use& use) const;

  base::Communicator communicator_;
  Problem problem_;
  std::shared_ptr<const ShapeKernels> kernels_;
  std::shared_ptr<const StressKernels> stress_;
  grid::Halo halo_;
  particles::Particles<Device> particles_;
  transfer::ElementBox box_;
  Kokkos::View<const double*, Device> density_;  // of each material
  Kokkos::View<const float*, Device> fictitious_volume_;
  transfer::BoundaryPointSet<Device> boundary_;
  transfer::ParticleDomains<Device> domains_;
  bool stretches_domains_;
  double typical_diagonal_;   // [pN/um]
  double stiffest_diagonal_;  // with springs [pN/um]
  double base_load_, load_;
  grid::RCP<const grid::Vector> external_force_;
  std::unique_ptr<Supports> supports_;
  TangentForm form_ = TangentForm::compressed_rows;
  std::unique_ptr<tangent::TangentMatrix> rows_;
  grid::RCP<tangent::StencilMatrix> stencil_;
  grid::RCP<const grid::Vector> linearized_at_;
};

}  // namespace stroma::mechanics
