#include "solver/GalerkinProduct.hpp"

#include <algorithm>
#include <vector>

namespace stroma::solver {
namespace {

// A plane of blocks couples a plane of nodes to itself or to the next: nine blocks a node, q = (dx
// + 1) + 3 (dy + 1), of nine entries each. A line of nodes holds its 81 rows one after the other.
constexpr int plane_rows = 81;
constexpr int own_rows = 45;  // of a stencil's line: what couples a plane to itself, q = 4 to 8

using Floats = std::vector<float>;

std::size_t size(int n) { return static_cast<std::size_t>(n); }

template <class F>
void for_each(int count, const F& f) {
  Kokkos::parallel_for("galerkin product", Kokkos::RangePolicy<grid::ExecutionSpace>(0, count), f);
}

/// to += weight * transpose of a block of nine rows, `shift` nodes further on, for n nodes.
void add_transposed(int n, float weight, int shift, const float* from, std::size_t from_pitch,
                    float* to, std::size_t to_pitch) {
  const int begin = std::max(0, -shift), end = std::min(n, n - shift);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const float* __restrict source = from + size(3 * k + i) * from_pitch;
      float* __restrict target = to + size(3 * i + k) * to_pitch;
      for (int m = begin; m < end; ++m) target[m] += weight * source[m + shift];
    }
}

/// The nine blocks of a plane's lines with itself, of which the stencil holds five.
void complete_plane(const transfer::StencilLines& lines, const float* values, int k,
                    Floats& plane) {
  const int n = lines.nodes[0];
  const std::size_t pitch = size(n);
  for_each(lines.nodes[1], [&](const int j) {
    float* const to = plane.data() + size(j) * plane_rows * pitch;
    const int line = j + lines.nodes[1] * k;
    std::fill(to, to + 36 * pitch, 0.0f);
    std::copy_n(values + lines.row(line, 0), own_rows * pitch, to + 36 * pitch);
    for (int q = 0; q < 4; ++q) {
      const int dx = q % 3 - 1, dy = q / 3 - 1;
      if (j + dy < 0) continue;
      add_transposed(n, 1.0f, dx, values + lines.row(line + dy, 9 * (8 - q - 4)), pitch,
                     to + size(9 * q) * pitch, pitch);
    }
  });
}

/// A term of a transformed line: coarse block at (I, I + to) += weight * fine block (i, i + from).
struct Term {
  int coarse, to, fine, from;
  float weight;
};

std::vector<Term> terms(const LineTransfer& along) {
  std::vector<Term> all;
  for (int I = 0; I < along.coarse; ++I)
    along.for_each_child(I, [&](int i, float weight) {
      for (int step = -1; step <= 1; ++step) {
        if (i + step < 0 || i + step >= along.fine) continue;
        along.for_each_parent(i + step, [&](int other, float other_weight) {
          all.push_back({I, other - I, i, step, weight * other_weight});
        });
      }
    });
  return all;
}

/// Transforms a plane of blocks along y, then along x.
///
/// \param line_of  (fine line) its 81 rows
/// \param result   (coarse line, 81 rows, coarse node)
template <class LineOf>
void transform_plane(const LevelTransfer& transfer, const std::vector<Term>& y_terms,
                     const std::vector<Term>& x_terms, const LineOf& line_of, Floats& result) {
  const LineTransfer &x = transfer.along(0), &y = transfer.along(1);
  const std::size_t fine = size(x.fine), coarse = size(x.coarse);
  for_each(y.coarse, [&](const int J) {
    Floats along_y(plane_rows * fine, 0.0f);
    const auto first = std::lower_bound(y_terms.begin(), y_terms.end(), J,
                                        [](const Term& t, int line) { return t.coarse < line; });
    for (auto term = first; term != y_terms.end() && term->coarse == J; ++term) {
      // The three blocks of one dy stand together.
      const float* __restrict from = line_of(term->fine) + size(27 * (term->from + 1)) * fine;
      float* __restrict to = along_y.data() + size(27 * (term->to + 1)) * fine;
      const float weight = term->weight;
      for (std::size_t n = 0; n < 27 * fine; ++n) to[n] += weight * from[n];
    }
    float* const line = result.data() + size(J) * plane_rows * coarse;
    std::fill(line, line + plane_rows * coarse, 0.0f);
    for (int dy = 0; dy < 3; ++dy)
      for (const Term& term : x_terms) {
        const float* from =
            along_y.data() + size(27 * dy + 9 * (term.from + 1)) * fine + size(term.fine);
        float* to = line + size(27 * dy + 9 * (term.to + 1)) * coarse + size(term.coarse);
        for (std::size_t entry = 0; entry < 9; ++entry)
          to[entry * coarse] += term.weight * from[entry * fine];
      }
  });
}

/// Adds weight * plane to a coarse plane's coupling with itself or with the next.
class CoarsePlanes {
 public:
  explicit CoarsePlanes(const mechanics::Stencil& coarse)
      : lines_(coarse.lines()), values_(coarse.values().data()), pitch_(size(lines_.nodes[0])) {}

  void add_to_self(int K, float weight, const Floats& plane) const {
    add(K, weight, plane, 36, own_rows, 0);
  }
  void add_to_next(int K, float weight, const Floats& plane) const {
    add(K, weight, plane, 0, plane_rows, own_rows);
  }
  /// The same as add_to_self() for the transpose of a plane.
  void add_transposed_to_self(int K, float weight, const Floats& plane) const {
    for_each(lines_.nodes[1], [&](const int J) {
      for (int q = 4; q < 9; ++q) {
        const int dx = q % 3 - 1, dy = q / 3 - 1;
        if (J + dy >= lines_.nodes[1]) continue;
        add_transposed(lines_.nodes[0], weight, dx,
                       plane.data() + (size(J + dy) * plane_rows + size(9 * (8 - q))) * pitch_,
                       pitch_, values_ + lines_.row(J + lines_.nodes[1] * K, 9 * (q - 4)), pitch_);
      }
    });
  }

 private:
  void add(int K, float weight, const Floats& plane, int first, int rows, int entry) const {
    for_each(lines_.nodes[1], [&](const int J) {
      const float* __restrict from = plane.data() + (size(J) * plane_rows + size(first)) * pitch_;
      float* __restrict to = values_ + lines_.row(J + lines_.nodes[1] * K, entry);
      for (std::size_t n = 0; n < size(rows) * pitch_; ++n) to[n] += weight * from[n];
    });
  }

  transfer::StencilLines lines_;
  float* values_;
  std::size_t pitch_;
};

}  // namespace

void galerkin_product(const mechanics::Stencil& fine, const LevelTransfer& transfer,
                      const mechanics::Stencil& coarse) {
  const transfer::StencilLines& lines = fine.lines();
  const float* const values = fine.values().data();
  const LineTransfer& z = transfer.along(2);
  const auto x_terms = terms(transfer.along(0)), y_terms = terms(transfer.along(1));
  coarse.zero();
  const CoarsePlanes planes(coarse);
  Floats complete(size(lines.nodes[1]) * plane_rows * size(lines.nodes[0]));
  Floats transformed(size(transfer.along(1).coarse) * plane_rows * size(transfer.along(0).coarse));
  for (int k = 0; k < lines.nodes[2]; ++k) {
    complete_plane(lines, values, k, complete);
    const auto completed_line = [&](int j) {
      return complete.data() + size(j) * plane_rows * size(lines.nodes[0]);
    };
    transform_plane(transfer, y_terms, x_terms, completed_line, transformed);
    z.for_each_parent(k, [&](int K, float weight) {
      z.for_each_parent(k, [&](int other, float other_weight) {
        if (other == K) planes.add_to_self(K, weight * other_weight, transformed);
        if (other == K + 1) planes.add_to_next(K, weight * other_weight, transformed);
      });
    });
    if (k + 1 == lines.nodes[2]) continue;
    const auto line_to_next = [&](int j) {
      return values + lines.row(j + lines.nodes[1] * k, own_rows);
    };
    transform_plane(transfer, y_terms, x_terms, line_to_next, transformed);
    z.for_each_parent(k, [&](int K, float weight) {
      z.for_each_parent(k + 1, [&](int other, float other_weight) {
        if (other == K) {
          planes.add_to_self(K, weight * other_weight, transformed);
          planes.add_transposed_to_self(K, weight * other_weight, transformed);
        }
        if (other == K + 1) planes.add_to_next(K, weight * other_weight, transformed);
      });
    });
  }
}

}  // namespace stroma::solver
