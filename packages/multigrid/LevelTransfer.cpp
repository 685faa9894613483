// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/LevelTransfer.hpp"

#include <algorithm>

namespace stroma::multigrid {

using grid::NodeField;

LineTransfer::LineTransfer(int fine_nodes, bool is_coarsened) : fine(fine_nodes) {
  const int elements = fine_nodes - 1;
  coarse = (is_coarsened ? (elements + 1) / 2 : elements) + 1;
  for (int n = 0; n < fine; ++n) {
    const bool is_last = n == elements;
    below.push_back(!is_coarsened ? n : is_last ? coarse - 1 : n / 2);
    between.push_back(is_coarsened && !is_last && n % 2 == 1 ? 1 : 0);
    if (!between.back()) at.push_back(n);
  }
}

LevelTransfer::LevelTransfer(const grid::LevelGrid& fine, const std::array<bool, 3>& directions)
    : along_{LineTransfer(fine.nodes(0), directions[0]), LineTransfer(fine.nodes(1), directions[1]),
             LineTransfer(fine.nodes(2), directions[2])} {}

void LevelTransfer::add_interpolated(const NodeField<float>& coarse,
                                     const NodeField<float>& fine) const {
  const LineTransfer &x = along_[0], &y = along_[1], &z = along_[2];
  grid::for_each_line("interpolate", fine.nodes, [&](const int line, const int j, const int k) {
    std::vector<float> mean(static_cast<std::size_t>(x.coarse) + 1);
    for (int c = 0; c < 3; ++c) {
      std::fill(mean.begin(), mean.end(), 0.0f);
      z.for_each_parent(k, [&](int K, float z_weight) {
        y.for_each_parent(j, [&](int J, float y_weight) {
          const float weight = z_weight * y_weight;
          const float* from = coarse.line(c, J + y.coarse * K);
          for (int I = 0; I < x.coarse; ++I) mean[static_cast<std::size_t>(I)] += weight * from[I];
        });
      });
      float* const to = fine.line(c, line);
      const int* const below = x.below.data();
      const std::uint8_t* const between = x.between.data();
      for (int i = 0; i < x.fine; ++i) {
        const float* at = mean.data() + below[i];
        to[i] += between[i] ? 0.5f * (at[0] + at[1]) : at[0];
      }
    }
  });
}

void LevelTransfer::restrict_to(const NodeField<float>& fine,
                                const NodeField<float>& coarse) const {
  const LineTransfer &x = along_[0], &y = along_[1], &z = along_[2];
  grid::for_each_line("restrict", coarse.nodes, [&](const int line, const int J, const int K) {
    std::vector<float> sum(static_cast<std::size_t>(x.fine));
    for (int c = 0; c < 3; ++c) {
      std::fill(sum.begin(), sum.end(), 0.0f);
      z.for_each_child(K, [&](int k, float z_weight) {
        y.for_each_child(J, [&](int j, float y_weight) {
          const float weight = z_weight * y_weight;
          const float* from = fine.line(c, j + y.fine * k);
          for (int i = 0; i < x.fine; ++i) sum[static_cast<std::size_t>(i)] += weight * from[i];
        });
      });
      float* const to = coarse.line(c, line);
      for (int I = 0; I < x.coarse; ++I) {
        float total = 0.0f;
        x.for_each_child(
            I, [&](int i, float weight) { total += weight * sum[static_cast<std::size_t>(i)]; });
        to[I] = total;
      }
    }
  });
}

}  // namespace stroma::multigrid
