// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/multigrid/ChebyshevSmoother.hpp"

#include <cmath>
#include <cstdint>

namespace stroma::multigrid {
namespace {

using grid::NodeField;

constexpr int power_iterations = 12;
constexpr int patched_power_iterations = 40;  // overlapping patches crowd their largest eigenvalues
constexpr double margin = 1.1;

/// A number between -1 and 1 that follows from a node's place in the whole grid.
float scattered(std::int64_t i, std::int64_t j, std::int64_t k, int c) {
  auto n = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15u +
           static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4Fu +
           static_cast<std::uint64_t>(k) * 0x165667B19E3779F9u + static_cast<std::uint64_t>(c);
  n = (n ^ (n >> 30)) * 0xBF58476D1CE4E5B9u;
  n = (n ^ (n >> 27)) * 0x94D049BB133111EBu;
  return static_cast<float>(static_cast<double>(n >> 11) * 0x1p-52 - 1.0);
}

double dot(const NodeField<float>& a, const NodeField<float>& b,
           const grid::BoxExchange& exchange) {
  return exchange.owned_sum([&](int line, int n) {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) {
      const float *p = a.line(c, line), *q = b.line(c, line);
      for (int i = 0; i < n; ++i) sum += double(p[i]) * double(q[i]);
    }
    return sum;
  });
}

}  // namespace

void ChebyshevSmoother::patch(const grid::BoxExchange& exchange,
                              const ElementPatches::Chosen& chosen, int degree) {
  patches_ = ElementPatches(exchange, chosen);
  if (!patches_.empty()) degree_ = degree;
}

void ChebyshevSmoother::add_step(const NodeField<float>& b, const NodeField<float>* y, float keep,
                                 float scale, const NodeField<float>& step,
                                 const NodeField<float>& x,
                                 const grid::BoxExchange& exchange) const {
  diagonal_.add_step(b, y, keep, scale, step, x);
  if (!patches_.empty()) patches_.add_step(b, y, scale, step, x, exchange);
}

void ChebyshevSmoother::compute(const tangent::Stencil& stencil, const grid::BoxExchange& exchange,
                                const LevelFields& fields) {
  diagonal_.compute(stencil, exchange);
  if (!patches_.empty()) {
    patches_.compute(stencil, exchange);
    diagonal_.leave_out(patches_.nodes());
  }
  const auto &v = fields.x, &w = fields.step, &y = fields.y, &scratch = fields.b;
  const grid::LevelGrid& grid = exchange.grid();
  const std::int64_t first[3] = {grid.first_node(0), grid.first_node(1), grid.first_node(2)};
  scratch.zero();
  grid::for_each_line("start", v.nodes, [&](const int line, const int j, const int k) {
    for (int c = 0; c < 3; ++c) {
      float* const value = v.line(c, line);
      for (int i = 0; i < v.nodes[0]; ++i)
        value[i] = scattered(first[0] + i, first[1] + j, first[2] + k, c);
    }
  });
  double largest = 0.0;
  for (int n = 0; n < (patches_.empty() ? power_iterations : patched_power_iterations); ++n) {
    stencil.multiply(v, y);
    exchange.sum(y);
    add_step(y, nullptr, 0.0f, 1.0f, w, scratch, exchange);
    const double energy = dot(v, y, exchange);
    if (!(energy > 0.0)) break;  // nothing here but prescribed components, or an indefinite tangent
    largest = std::max(largest, dot(w, y, exchange) / energy);
    const auto scale = static_cast<float>(1.0 / std::sqrt(dot(w, w, exchange)));
    grid::for_each_line("scale", v.nodes, [&](const int line, int, int) {
      for (int c = 0; c < 3; ++c)
        for (int i = 0; i < v.nodes[0]; ++i) v.line(c, line)[i] = scale * w.line(c, line)[i];
    });
  }
  bound_ = largest > 0.0 ? margin * largest : 1.0;
}

void ChebyshevSmoother::smooth_from_zero(const tangent::Stencil& stencil,
                                         const grid::BoxExchange& exchange,
                                         const LevelFields& fields) const {
  fields.x.zero();
  fields.step.zero();
  add_step(fields.b, nullptr, 0.0f, static_cast<float>(4.0 / 3.0 / bound_), fields.step, fields.x,
           exchange);
  steps(2, stencil, exchange, fields);
}

void ChebyshevSmoother::smooth(const tangent::Stencil& stencil, const grid::BoxExchange& exchange,
                               const LevelFields& fields) const {
  fields.step.zero();
  steps(1, stencil, exchange, fields);
}

void ChebyshevSmoother::steps(int first, const tangent::Stencil& stencil,
                              const grid::BoxExchange& exchange, const LevelFields& fields) const {
  for (int k = first; k <= degree_; ++k) {
    stencil.multiply(fields.x, fields.y);
    exchange.sum(fields.y);
    add_step(fields.b, &fields.y, static_cast<float>((2.0 * k - 3) / (2 * k + 1)),
             static_cast<float>((8.0 * k - 4) / (2 * k + 1) / bound_), fields.step, fields.x,
             exchange);
  }
}

}  // namespace stroma::multigrid
