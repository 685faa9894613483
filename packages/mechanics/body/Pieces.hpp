// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The connected pieces of a body on its grid.

#include <vector>

#include "stroma/grid/Halo.hpp"
#include "stroma/transfer/ElementLoop.hpp"
#include "stroma/transfer/Touch.hpp"

namespace stroma::mechanics {

/// Elements whose particles touch a common node belong to one piece, on whichever ranks they are.
/// Pieces share no node: no force goes from one to another. Every rank knows of the pieces of which
/// it has a part, elements or nodes that it owns, and of no others.
///
/// Each rank joins its own elements (union-find); then labels, the largest number of a piece's
/// nodes, go from rank to rank over the halo until none grows any more.
class Pieces {
 public:
  static constexpr int none = -1;

  /// Collective.
  /// \param halo     this rank's nodes and their owners
  /// \param box      this rank's elements
  /// \param touched  the nodes that the particles of each element touch
  Pieces(const grid::Halo& halo, const transfer::ElementBox& box,
         const transfer::TouchedNodes<grid::Device>& touched);

  /// Pieces of which this rank has a part; they are numbered from 0, by ascending label.
  int count() const { return static_cast<int>(label_.size()); }
  /// Name of a piece, the same on all ranks: the largest number of its nodes.
  std::int64_t label(int piece) const { return label_[static_cast<std::size_t>(piece)]; }
  /// The piece with a label; `none` if this rank has no part of it.
  int find(std::int64_t label) const;
  /// Whether other ranks may have a part of it.
  bool is_shared(int piece) const { return is_shared_[static_cast<std::size_t>(piece)] != 0; }

  /// The piece of a local element; `none`: it holds no particle.
  int of_element(std::int64_t element) const {
    return of_element_[static_cast<std::size_t>(element)];
  }
  /// The piece of a touched node (grid::Partition::touched_nodes); `none`: no particle touches it,
  /// or only particles of other ranks touch it, and one of them owns it.
  int of_node(std::int64_t node) const { return of_node_[static_cast<std::size_t>(node)]; }

 private:
  std::vector<std::int64_t> label_;
  std::vector<char> is_shared_;
  std::vector<int> of_element_, of_node_;
};

}  // namespace stroma::mechanics
