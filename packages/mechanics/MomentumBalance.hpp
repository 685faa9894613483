#pragma once

/// \file
/// The balance of momentum of a body of particles on a grid: what a solver, or another Trilinos
/// application, couples to.

#include <Teuchos_RCP.hpp>
#include <array>
#include <memory>
#include <vector>

#include "grid/Halo.hpp"
#include "material/NeoHookean.hpp"
#include "mechanics/StencilMatrix.hpp"
#include "mechanics/Supports.hpp"
#include "mechanics/TangentMatrix.hpp"
#include "particles/Particles.hpp"
#include "shape/Linear.hpp"
#include "transfer/GridToParticles.hpp"

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

/// Residual and tangent of the quasi-static balance of momentum. The unknown u is the displacement
/// of the grid's nodes since the base configuration [um], in a Tpetra vector over owned_map():
///
///     r_Ii(u) = sum_p V0 tau_ij dN_I/dx_j     [pN],      K = dr/du  [pN/um].
///
/// Prescribed components of u (see Supports) are set by supports().impose(load, u); their rows of
/// the residual are zero and their rows and columns of the tangent hold only a diagonal, so that K
/// is symmetric and every Newton increment keeps them.
///
/// Every member function is collective. Functions that evaluate particles return how many of them,
/// over all ranks, u turns inside out; the results are then not finite and the caller rejects u.
class MomentumBalance {
 public:
  using Device = grid::Device;
  using Law = material::NeoHookean;
  using Shape = shape::Linear;

  MomentumBalance(const base::Communicator& communicator, const grid::Partition& partition,
                  const particles::Particles<Device>& particles, const std::vector<Law>& laws,
                  const NamedConditions& conditions);
  MomentumBalance(const MomentumBalance&) = delete;
  MomentumBalance& operator=(const MomentumBalance&) = delete;

  const grid::RCP<const grid::Map>& owned_map() const { return halo_.owned_map(); }
  const grid::Halo& halo() const { return halo_; }
  const Supports& supports() const { return *supports_; }
  const particles::Particles<Device>& particles() const { return particles_; }
  /// (local element) whether the element holds a particle.
  Kokkos::View<std::uint8_t*, Device> filled_elements() const;

  /// Internal force [pN] at all owned unknowns, prescribed ones (reactions) included.
  std::int64_t internal_force(const grid::Vector& u, grid::Vector& force) const;
  /// Internal force with prescribed components cleared.
  std::int64_t residual(const grid::Vector& u, grid::Vector& r) const;
  /// Chooses how the tangent is stored, before it is first used; compressed rows otherwise. Another
  /// choice later gives up the operator that there is.
  void choose_tangent(TangentForm form);
  /// Assembles the tangent at u into the one operator that tangent() returns.
  std::int64_t assemble_tangent(const grid::Vector& u);
  /// The tangent's operator; built at the first call.
  grid::RCP<Tpetra::Operator<double>> tangent();
  /// The same as a matrix, when it is stored as compressed rows.
  grid::RCP<Matrix> tangent_matrix();
  /// product = K(u) v without forming K and without regard to what is prescribed.
  void tangent_times(const grid::Vector& u, const grid::Vector& v, grid::Vector& product) const;

  /// Results at this rank's particles.
  transfer::ParticleFields<Device> particle_fields(const grid::Vector& u) const;
  WorstParticle worst_particle(const grid::Vector& u) const;

 private:
  using Elements = transfer::ElementParticles<Shape, Device>;
  Elements elements(const grid::Vector& u) const;

  base::Communicator communicator_;
  grid::Halo halo_;
  particles::Particles<Device> particles_;
  transfer::ElementBox box_;
  Kokkos::View<const Law*, Device> law_;
  double typical_diagonal_;  // [pN/um]
  std::unique_ptr<Supports> supports_;
  TangentForm form_ = TangentForm::compressed_rows;
  std::unique_ptr<TangentMatrix> rows_;
  grid::RCP<StencilMatrix> stencil_;
};

}  // namespace stroma::mechanics
