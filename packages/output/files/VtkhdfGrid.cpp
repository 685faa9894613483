// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/VtkhdfGrid.hpp"

#include <algorithm>

namespace stroma::output {
namespace {

/// A column of width numbers a node, as value(node of the box, component).
template <class Value, class Put>
void put_nodes(const std::vector<std::uint8_t>& used, std::int64_t count, int width,
               const Value& value, const Put& put) {
  UsedNodes nodes(used);
  std::vector<double> values;
  for (std::int64_t first = 0; first < count; first += ExodusFile::piece) {
    const std::int64_t size = std::min(ExodusFile::piece, count - first);
    values.clear();
    for (std::int64_t n = 0; n < size; ++n) {
      const std::int64_t node = nodes.next();
      for (int c = 0; c < width; ++c) values.push_back(value(node, c));
    }
    put(first, size, values.data());
  }
}

void put_cells(const VtkhdfPieces& file, const GridPart& part,
               const std::vector<std::uint8_t>& used) {
  std::vector<std::int64_t> number(used.size()), points;
  std::int64_t next = 0, first = 0;
  for (std::size_t n = 0; n < used.size(); ++n) number[n] = used[n] != 0 ? next++ : -1;
  const auto hand_over = [&] {
    const auto count = static_cast<std::int64_t>(points.size() / 8);
    file.cells(first, count, points.data());
    first += count;
    points.clear();
  };
  const IndexBox box = node_box(part);
  for_each_active(part, [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    for (const std::int64_t node : corners(box, i, j, k))
      points.push_back(number[static_cast<std::size_t>(node)]);
    if (static_cast<std::int64_t>(points.size()) == 8 * ExodusFile::piece) hand_over();
  });
  hand_over();
}

}  // namespace

void write_vtkhdf_grid(const base::Communicator& communicator, const std::string& path,
                       const GridPart& part, const std::vector<NodalVector>& vectors,
                       const std::vector<VtkhdfNumber>& numbers, Precision precision) {
  const std::vector<std::uint8_t> used = used_nodes(part);
  const IndexBox box = node_box(part);
  VtkhdfPart sizes;
  sizes.cell = VtkCell::hexahedron;
  sizes.points = std::count(used.begin(), used.end(), 1);
  for_each_active(part, [&](std::int64_t, std::int64_t, std::int64_t) { ++sizes.cells; });
  std::vector<VtkhdfColumn> columns;
  for (const NodalVector& vector : vectors) columns.push_back({vector.name, vector.unit, 3});
  columns.push_back({"id", "-", 1, VtkhdfColumn::Number::integer});
  write_vtkhdf(
      communicator, path, sizes, columns, numbers, precision, [&](const VtkhdfPieces& file) {
        const auto put_column = [&](std::size_t column, int width, const auto& value) {
          put_nodes(used, sizes.points, width, value, [&](auto first, auto count, auto values) {
            file.column(column, first, count, values);
          });
        };
        put_nodes(
            used, sizes.points, 3,
            [&](std::int64_t node, int axis) {
              return coordinate(part, box.place(node), static_cast<std::size_t>(axis));
            },
            [&](auto first, auto count, auto values) { file.points(first, count, values); });
        put_cells(file, part, used);
        for (std::size_t v = 0; v < vectors.size(); ++v)
          put_column(v, 3,
                     [&](std::int64_t node, int c) { return vectors[v].values[3 * node + c]; });
        put_column(vectors.size(), 1, [&](std::int64_t node, int) {
          return static_cast<double>(node_id(part, box.place(node)));
        });
      });
}

}  // namespace stroma::output
