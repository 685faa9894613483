// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Local solves on elements that the body barely fills.

#include <array>
#include <vector>

#include "stroma/grid/BoxExchange.hpp"
#include "stroma/tangent/Stencil.hpp"

namespace stroma::multigrid {

/// The additive Schwarz operator of clusters e of chosen elements,
///
///     z = sum_e R_e^T (R_e K R_e^T)^-1 R_e r,
///
/// R_e the restriction to the unknowns of the cluster's nodes. A particle in the corner of an
/// element resists 6 of its 24 unknowns, and not by one node alone; a row of such elements along an
/// edge of the body bends as a whole. Such modes are as local as they are soft. No coarser grid
/// sees them, but a solve with all nodes of the cluster does. A cluster is what the nodes of chosen
/// elements join, in parts of 8 elements at most, within a rank.
///
/// Symmetric and positive definite whatever the stencil holds: each block's factors L D L^T are
/// kept as C = D^-1/2 L^-1, and pivots that rounding, or a particle that buckles, has left without
/// a sign are replaced. In single precision; 300 floats for one element, up to 14,706 for eight.
/// Nodes are added to in an order that does not depend on the number of threads.
class ElementPatches {
 public:
  /// (local element of the rank's box, x fastest) not 0: chosen.
  using Chosen = Kokkos::View<const std::uint8_t*, grid::Device>;

  ElementPatches() = default;
  /// Collective.
  ElementPatches(const grid::BoxExchange& exchange, const Chosen& chosen);

  /// Whether no rank has chosen an element.
  bool empty() const { return is_empty_; }
  /// (node of the box) 1 where it belongs to a patch, of any rank.
  const Kokkos::View<std::uint8_t*, grid::Device>& nodes() const { return patched_; }

  /// Factorises the blocks of a stencil. Collective.
  void compute(const tangent::Stencil& stencil, const grid::BoxExchange& exchange);

  /// step += scale * z for r = b - y, x += scale * z. Without y: y = 0. Collective.
  void add_step(const grid::NodeField<float>& b, const grid::NodeField<float>* y, float scale,
                const grid::NodeField<float>& step, const grid::NodeField<float>& x,
                const grid::BoxExchange& exchange) const;

 private:
  static constexpr int most_elements = 8;
  static constexpr int most = 3 * (7 * most_elements + 1);  // unknowns, where nodes alone join them

  struct Patch {
    std::vector<int> nodes;          // of the box, x fastest, ascending
    std::vector<int> unknown;        // (3 node + c) number among those with stiffness, or -1
    std::vector<std::size_t> place;  // (unknown) in a NodeField's values
    std::vector<float> C;            // column by column from the diagonal down; first, K there
    int size() const { return static_cast<int>(place.size()); }
  };

  void find_patches(const Chosen& chosen);
  void sort_by_colour();
  void find_unknowns(Patch& patch, const grid::NodeField<float> (&row)[3]) const;
  void add_entries(Patch& patch, const std::array<int, 3>& step,
                   const grid::NodeField<float> (&row)[3]) const;
  void solve(const Patch& patch, const float* b, const float* y) const;

  int nodes_[3] = {0, 0, 0};
  bool is_empty_ = true;
  std::vector<Patch> patches_;       // sorted by colour: those of one share no node
  std::vector<std::size_t> colour_;  // first patch of each, and the number of patches
  Kokkos::View<std::uint8_t*, grid::Device> patched_;
  grid::NodeField<float> sum_;
};

}  // namespace stroma::multigrid
