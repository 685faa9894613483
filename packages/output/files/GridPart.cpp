// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/GridPart.hpp"

namespace stroma::output {

IndexBox element_box(const GridPart& part) {
  IndexBox box;
  for (std::size_t d = 0; d < 3; ++d) {
    box.begin[d] = part.first_element[d];
    box.end[d] = part.first_element[d] + part.element_count[d];
  }
  return box;
}

IndexBox node_box(const GridPart& part) {
  IndexBox box = element_box(part);
  if (box.empty()) return {};
  for (std::int64_t& end : box.end) ++end;
  return box;
}

std::array<std::int64_t, 8> corners(const IndexBox& nodes, std::int64_t i, std::int64_t j,
                                    std::int64_t k) {
  return {nodes.index(i, j, k),
          nodes.index(i + 1, j, k),
          nodes.index(i + 1, j + 1, k),
          nodes.index(i, j + 1, k),
          nodes.index(i, j, k + 1),
          nodes.index(i + 1, j, k + 1),
          nodes.index(i + 1, j + 1, k + 1),
          nodes.index(i, j + 1, k + 1)};
}

std::vector<std::uint8_t> used_nodes(const GridPart& part) {
  const IndexBox box = node_box(part);
  std::vector<std::uint8_t> used(static_cast<std::size_t>(box.size()), 0);
  for_each_active(part, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    for (const std::int64_t node : corners(box, i, j, k)) used[static_cast<std::size_t>(node)] = 1;
  });
  return used;
}

std::int64_t node_id(const GridPart& part, const Index3& node) {
  return 1 + node[0] + (part.elements[0] + 1) * (node[1] + (part.elements[1] + 1) * node[2]);
}

double coordinate(const GridPart& part, const Index3& node, std::size_t axis) {
  return part.origin[axis] + part.spacing[axis] * static_cast<double>(node[axis]);
}

}  // namespace stroma::output
