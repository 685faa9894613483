// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Sets that grow together (union-find).

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace stroma::base {

/// Members 0, 1, ... in disjoint sets; the root of a set is its smallest member.
class DisjointSets {
 public:
  /// So many sets of one member.
  explicit DisjointSets(std::size_t count = 0) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  /// A new member, a set of its own.
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }
  std::int32_t root(std::int32_t n) {
    while (parent(n) != n) n = parent(n) = parent(parent(n));
    return n;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    parent(std::max(a, b)) = std::min(a, b);
  }
  std::size_t size() const { return parent_.size(); }

 private:
  std::int32_t& parent(std::int32_t n) { return parent_[static_cast<std::size_t>(n)]; }
  std::vector<std::int32_t> parent_;
};

}  // namespace stroma::base
