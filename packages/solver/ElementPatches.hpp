#pragma once

/// \file
/// Local solves on elements that the body barely fills.

#include <array>
#include <vector>

#include "grid/BoxExchange.hpp"
#include "mechanics/Stencil.hpp"

namespace stroma::solver {

/// The additive Schwarz operator of chosen elements e,
///
///     z = sum_e R_e^T (R_e K R_e^T)^-1 R_e r,
///
/// R_e the restriction to the unknowns of the element's nodes. A particle at the corner of an
/// element resists 6 of its 24 unknowns, and not by one node alone: such modes are as local as they
/// are soft, no coarser grid sees them, and only a solve with all nodes of the element does.
///
/// Symmetric and positive definite whatever the stencil holds: each block's factors
/// L D L^T are kept as C = D^-1/2 L^-1, and pivots that rounding, or a particle that buckles, has
/// left without a sign are replaced. In single precision; 2,304 bytes an element. Nodes are added
/// to in an order that does not depend on the number of threads.
class ElementPatches {
 public:
  /// (local element of the rank's box, x fastest) not 0: chosen.
  using Chosen = Kokkos::View<const std::uint8_t*, grid::Device>;

  ElementPatches() = default;
  /// Collective.
  ElementPatches(const grid::BoxExchange& exchange, const Chosen& chosen);

  /// Whether no rank has chosen an element.
  bool empty() const { return is_empty_; }
  /// (node of the box) 1 where an element around it, of any rank, is chosen.
  const Kokkos::View<std::uint8_t*, grid::Device>& nodes() const { return patched_; }

  /// Factorises the blocks of a stencil. Collective.
  void compute(const mechanics::Stencil& stencil, const grid::BoxExchange& exchange);

  /// step += scale * z for r = b - y, x += scale * z. Without y: y = 0. Collective.
  void add_step(const grid::NodeField<float>& b, const grid::NodeField<float>* y, float scale,
                const grid::NodeField<float>& step, const grid::NodeField<float>& x,
                const grid::BoxExchange& exchange) const;

 private:
  static constexpr int size = 24;  // unknowns of an element; of four nodes, half are idle
  struct Patch {
    int line, node;  // of the element's first node
  };

  float* factor(std::size_t patch) const { return factor_.data() + patch * size * size; }
  int line_of(const Patch& patch, int a) const;
  void gather_blocks(const mechanics::Stencil& stencil, const grid::BoxExchange& exchange) const;

  int nodes_[3] = {0, 0, 0};
  int corners_ = 8;  // nodes of an element; 4 in plane strain
  bool is_empty_ = true;
  std::vector<Patch> patches_;           // sorted by colour
  std::array<std::size_t, 9> colour_{};  // first patch of each
  Kokkos::View<float*, grid::Device> factor_;
  Kokkos::View<std::uint8_t*, grid::Device> patched_;
  grid::NodeField<float> sum_;
};

}  // namespace stroma::solver
