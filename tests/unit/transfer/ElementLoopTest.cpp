// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The coloured loop over elements: each once, and no two neighbours at the same time.

#include <gtest/gtest.h>

#include <array>

#include "stroma/transfer/ElementLoop.hpp"

namespace stroma::transfer {
namespace {

using Space = Kokkos::DefaultHostExecutionSpace;
using Counts = Kokkos::View<int*, Space>;

ElementBox box_of(int nx, int ny, int nz) {
  return {{nx, ny, nz}, {0, 0, 0}, {1, 1, 1}, {1, 1, 1}};
}

/// Counts the visits to each element, and the visits to the nodes of its support.
struct CountVisits {
  ElementBox box;
  Counts visits;
  Counts node_visits;

  KOKKOS_FUNCTION void operator()(int i, int j, int k, std::int64_t& bad) const {
    ++visits(box.element(i, j, k));
    for (int a = 0; a < 8; ++a)
      ++node_visits(box.node(i + (a & 1), j + (a >> 1 & 1), k + (a >> 2)));
    bad += box.element(i, j, k) + 1;
  }
};

TEST(ElementLoop, VisitsEachElementOnceAndSumsWhatItCounts) {
  for (const std::array<int, 3>& n :
       {std::array<int, 3>{1, 1, 1}, std::array<int, 3>{5, 1, 3}, std::array<int, 3>{4, 4, 4},
        std::array<int, 3>{1, 7, 2}, std::array<int, 3>{3, 2, 1}}) {
    const ElementBox box = box_of(n[0], n[1], n[2]);
    const int elements = n[0] * n[1] * n[2];
    const int nodes = (n[0] + 1) * (n[1] + 1) * (n[2] + 1);
    const CountVisits count{box, Counts("visits", elements), Counts("node visits", nodes)};
    const std::int64_t bad = for_each_element<2, Space>("count", box, count);
    for (int e = 0; e < elements; ++e) EXPECT_EQ(count.visits(e), 1) << "element " << e;
    EXPECT_EQ(bad, static_cast<std::int64_t>(elements) * (elements + 1) / 2);
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i) {
          const int expected =
              ((i > 0) + (i < n[0])) * ((j > 0) + (j < n[1])) * ((k > 0) + (k < n[2]));
          EXPECT_EQ(count.node_visits(box.node(i, j, k)), expected);
        }
  }
}

}  // namespace
}  // namespace stroma::transfer
