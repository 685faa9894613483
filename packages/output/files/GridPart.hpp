// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The elements and nodes of the background grid that one rank writes.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace stroma::output {

/// The box of elements that one rank holds of a structured Cartesian grid. Elements and nodes are
/// numbered x fastest, then y, then z: within the box for arrays, over the whole grid for the
/// numbers in the file.
struct GridPart {
  std::array<std::int64_t, 3> elements{};       ///< of the whole grid, in x, y, z
  std::array<std::int64_t, 3> first_element{};  ///< of this rank's box
  std::array<std::int64_t, 3> element_count{};  ///< of this rank's box; any may be 0: nothing here
  std::array<double, 3> origin{};               ///< of the whole grid's first node [um]
  std::array<double, 3> spacing{};              ///< of the nodes [um]
  /// (element of this rank's box) not 0: write it. Null: write all.
  const std::uint8_t* active = nullptr;
};

using Index3 = std::array<std::int64_t, 3>;

/// A box of nodes or elements, numbered x fastest; end is one past the last.
struct IndexBox {
  Index3 begin{};
  Index3 end{};

  bool empty() const { return begin[0] >= end[0] || begin[1] >= end[1] || begin[2] >= end[2]; }
  std::int64_t size() const {
    return empty() ? 0 : (end[0] - begin[0]) * (end[1] - begin[1]) * (end[2] - begin[2]);
  }
  std::int64_t index(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return i - begin[0] +
           (end[0] - begin[0]) * (j - begin[1] + (end[1] - begin[1]) * (k - begin[2]));
  }
  /// Where the n-th lies in the whole grid.
  Index3 place(std::int64_t n) const {
    const std::int64_t width = end[0] - begin[0], height = end[1] - begin[1];
    return {begin[0] + n % width, begin[1] + n / width % height, begin[2] + n / (width * height)};
  }
  template <class Use>
  void for_each(const Use& use) const {
    if (empty()) return;
    for (std::int64_t k = begin[2]; k < end[2]; ++k)
      for (std::int64_t j = begin[1]; j < end[1]; ++j)
        for (std::int64_t i = begin[0]; i < end[0]; ++i) use(i, j, k);
  }
};

/// The elements of a part, and their nodes.
IndexBox element_box(const GridPart& part);
IndexBox node_box(const GridPart& part);

/// Calls use(i, j, k) for the active elements of the box, in order.
template <class Use>
void for_each_active(const GridPart& part, const Use& use) {
  const IndexBox box = element_box(part);
  box.for_each([&](std::int64_t i, std::int64_t j, std::int64_t k) {
    if (part.active == nullptr || part.active[box.index(i, j, k)] != 0) use(i, j, k);
  });
}

/// Index in a box of nodes of the corners of an element, in the order of HEX8 and of VTK.
std::array<std::int64_t, 8> corners(const IndexBox& nodes, std::int64_t i, std::int64_t j,
                                    std::int64_t k);

/// (node of the box) 1: an active element has this corner.
std::vector<std::uint8_t> used_nodes(const GridPart& part);

/// Calls next() for consecutive used nodes and gives their index in the box.
class UsedNodes {
 public:
  explicit UsedNodes(const std::vector<std::uint8_t>& used) : used_(used) {}
  std::int64_t next() {
    while (used_[static_cast<std::size_t>(index_)] == 0) ++index_;
    return index_++;
  }

 private:
  const std::vector<std::uint8_t>& used_;
  std::int64_t index_ = 0;
};

/// Number of a node of the whole grid, from 1.
std::int64_t node_id(const GridPart& part, const Index3& node);

/// Where a node of the undeformed grid stands [um].
double coordinate(const GridPart& part, const Index3& node, std::size_t axis);

/// A vector at the nodes of a rank's box (element_count + 1 in each direction, x fastest).
struct NodalVector {
  std::string name, unit;
  const double* values;  ///< (node of the box, xyz), complete on every rank that shares the node
};

}  // namespace stroma::output
