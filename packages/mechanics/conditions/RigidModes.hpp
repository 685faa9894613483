// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The six rigid motions of a body, small: how they move single components, and which of them a set
/// of held components leaves free.

#include <array>
#include <cstdint>
#include <vector>

namespace stroma::mechanics {

/// One displacement component of a node of this rank.
struct NodeComponent {
  std::int64_t node;               ///< number of the node, the same on all ranks
  std::array<double, 3> position;  ///< [um]
  int component;
};

/// Shares of three translations t and three rotations w:  u = t + w x (x - centre) / length.
using RigidMode = std::array<double, 6>;
/// (i, j) Sum of products of rigid motions, row by row.
using RigidGram = std::array<double, 36>;

double dot(const RigidMode& a, const RigidMode& b);

/// A frame in which rotations about the centre move the body's ends by about 1.
struct RigidFrame {
  std::array<double, 3> centre{};  ///< [um]
  double length = 1.0;             ///< [um]

  /// How much each rigid motion moves one component of one node.
  RigidMode motion(const NodeComponent& at) const;

  /// The sums m of rigid motions that were taken in this frame, as another frame has them.
  RigidMode sums_in(const RigidFrame& other, const RigidMode& m) const;
  RigidGram sums_in(const RigidFrame& other, const RigidGram& gram) const;
};

/// Adds m m^T.
void add_product(RigidGram& gram, const RigidMode& m);

/// Eigenvalues and eigenvectors of a Gram matrix of held components. A motion is free when its
/// eigenvalue is below 1e-10 of the trace.
class HeldMotions {
 public:
  explicit HeldMotions(const RigidGram& gram);

  /// Orthonormal basis of the motions that are free.
  std::vector<RigidMode> free() const;
  /// min over rigid motions a of sum (m.a - u)^2, m the motions of the held components and u what
  /// they are moved by: how far that is from a rigid motion.
  /// \param forced   sum of m u
  /// \param squares  sum of u^2
  double misfit(const RigidMode& forced, double squares) const;

 private:
  bool is_free(std::size_t v) const { return eigenvalue_[v] <= 1e-10 * trace_; }

  double trace_ = 0.0;
  std::array<double, 6> eigenvalue_{};
  std::array<RigidMode, 6> mode_{};
};

}  // namespace stroma::mechanics
