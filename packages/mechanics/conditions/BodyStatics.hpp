// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The statics of a body in pieces: which of them are solved, which are out of it, and what cannot
/// be solved at all.

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "stroma/grid/Halo.hpp"
#include "stroma/mechanics/body/Pieces.hpp"
#include "stroma/mechanics/conditions/PieceStatics.hpp"

namespace stroma::mechanics {

/// The pieces of a body in figures, the same on all ranks.
struct PiecesSummary {
  std::int64_t count = 0, elements = 0, particles = 0;  ///< of all pieces
  /// Pieces that nothing strains, while others are strained: they leave the system.
  std::int64_t carried = 0, carried_elements = 0, carried_particles = 0;
  std::string largest_carried;  ///< in words
};

/// A component that a condition holds at a place of a piece.
struct HeldComponent {
  int piece;
  NodeComponent at;
  int condition;       ///< index; negative: none of them
  double rate;         ///< displacement per load factor, at load 0 [um]
  bool turns = false;  ///< its displacement is not proportional to the load
};

/// Gets to know components that are held.
using HeldVisitor = std::function<void(const HeldComponent&)>;

/// Sums up what holds and what loads each piece, over all ranks. Each rank gets the sums over whole
/// pieces for those of which it has a part, and none of the others.
class BodyStatics {
 public:
  /// \param halo    of the grid; it and the pieces must stay
  /// \param pieces  of the body
  /// \param body    the lattice of elements that fills its box
  /// \param loads   number of loads that are added (OtherActions::loads)
  BodyStatics(const grid::Halo& halo, const Pieces& pieces, const grid::Grid& body,
              std::size_t loads);

  // First, what there is on this rank.
  void add_element(int piece, std::int64_t particles, const std::array<double, 3>& lower,
                   const std::array<double, 3>& upper);
  void add_held(const HeldComponent& held);
  void add_load(int piece, const std::array<double, 3>& position,
                const std::array<double, 3>& force);
  void add_stress(int piece, double force) { sums(piece).stress_size += force; }
  /// Then all of it is brought together. Collective.
  void complete();

  /// \param conditions    their names, for messages
  /// \param with_moments  whether loads must have no resultant about free axes either
  /// \throws base::InputError when the loads on a piece have a resultant along a rigid motion that
  ///         nothing holds; or when a condition moves pieces about that nothing connects with the
  ///         other conditions, though it would strain the body in one piece. Collective.
  void refuse_what_moves(const std::vector<std::string>& conditions, bool with_moments) const;

  /// Whether a piece leaves the system, moved by translation() at full load [um].
  bool is_carried(int piece) const { return some_are_solved_ && verdict(piece).is_idle; }
  const std::array<double, 3>& translation(int piece) const { return verdict(piece).translation; }
  /// Labels of the pieces that are solved and have free rigid motions, ascending, on every rank.
  const std::vector<std::int64_t>& free_pieces() const { return free_pieces_; }
  const PiecesSummary& summary() const { return summary_; }

 private:
  PieceSums& sums(int piece) { return sums_[static_cast<std::size_t>(piece)]; }
  const PieceVerdict& verdict(int piece) const {
    return verdicts_[static_cast<std::size_t>(piece)];
  }
  void exchange_shared();
  void compare();
  void refuse_loads(bool with_moments) const;
  void refuse_gaps(const std::vector<std::string>& conditions) const;
  std::string other_pieces() const;

  const grid::Halo& halo_;
  const Pieces& pieces_;
  std::size_t loads_;
  RigidFrame frame_;
  std::vector<PieceSums> sums_;          // (piece)
  std::set<std::pair<int, int>> moved_;  // (condition, piece that it moves), on this rank
  std::vector<PieceVerdict> verdicts_;
  std::vector<std::int64_t> free_pieces_;
  bool some_are_solved_ = false;
  bool would_strain_whole_ = false;
  PiecesSummary summary_;
};

}  // namespace stroma::mechanics
