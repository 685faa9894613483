// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// What holds and what loads a piece of a body, and what follows from it.

#include <array>
#include <cstdint>
#include <string>

#include "stroma/mechanics/conditions/RigidModes.hpp"

namespace stroma::mechanics {

/// Sums over a piece that tell its statics, in one frame for all pieces of a body. Plain data:
/// ranks send them to each other.
struct PieceSums {
  std::int64_t label = 0;
  std::int64_t elements = 0, particles = 0;
  std::array<double, 3> lower{1e300, 1e300, 1e300};     ///< box of its elements [um]
  std::array<double, 3> upper{-1e300, -1e300, -1e300};  ///< [um]
  RigidGram held{};                 ///< sum of m m^T, m the motions of prescribed components
  RigidMode forced{};               ///< sum of m u, u what they are moved by at full load [um]
  std::array<double, 3> squares{};  ///< (component) sum of u^2 [um^2]
  RigidMode load{};                 ///< resultant of the external force at full load [pN]
  double load_size = 0.0;           ///< sum of the sizes of its nodal forces [pN]
  double stress_size = 0.0;         ///< the same of the internal force at the base [pN]
  double turned = 0.0;              ///< components that conditions turn, not push

  void add_held(const RigidFrame& frame, const NodeComponent& at, double u);
  void add_load(const RigidFrame& frame, const std::array<double, 3>& position,
                const std::array<double, 3>& force);
  /// Takes in the sums over another part of the same piece.
  void add(const PieceSums& other);
  /// The middle of the piece, and half its longest edge.
  RigidFrame own_frame() const;
};

/// What the sums say of a piece.
struct PieceVerdict {
  /// Nothing strains it: no force acts in it or on it, and what is prescribed fits a translation.
  bool is_idle = false;
  std::array<double, 3>
      translation{};             ///< of an idle piece at full load [um]; 0 where none is asked
  bool has_free_motion = false;  ///< what is prescribed leaves a rigid motion free
  bool is_strained = false;      ///< what is prescribed is no rigid motion
};
/// Whether displacements miss a motion that they are fitted by, more than by rounding.
/// \param misfit   sum of squares of what is left [um^2]
/// \param squares  sum of squares of the displacements [um^2]
bool is_misfit(double misfit, double squares);

PieceVerdict judge(const PieceSums& piece, const RigidFrame& frame);

/// The resultant of a piece's loads along the rigid motions that are free, in words, such as "along
/// x: 512 pN"; "" where there is none, to 1e-6 of the loads' size.
///
/// \param piece         sums over the piece
/// \param frame         its rigid motions, with what is free
/// \param with_moments  whether resultants about axes count as well
/// \param with_size     whether it says how large the resultant is
std::string free_resultant(const PieceSums& piece, const RigidFrame& frame, bool with_moments,
                           bool with_size = true);

/// "8 elements with 64 particles around (6, 6, 6) um, 4 x 4 x 4 um large".
std::string describe(const PieceSums& piece);

}  // namespace stroma::mechanics
