// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/conditions/RigidModes.hpp"

#include <Teuchos_LAPACK.hpp>

#include "stroma/base/Error.hpp"

namespace stroma::mechanics {

double dot(const RigidMode& a, const RigidMode& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}

RigidMode RigidFrame::motion(const NodeComponent& at) const {
  std::array<double, 3> r;
  for (std::size_t d = 0; d < 3; ++d) r[d] = (at.position[d] - centre[d]) / length;
  RigidMode m{};
  const auto c = static_cast<std::size_t>(at.component);
  m[c] = 1.0;
  // (e_axis x r)_c for the two axes other than c
  m[3 + (c + 1) % 3] = r[(c + 2) % 3];
  m[3 + (c + 2) % 3] = -r[(c + 1) % 3];
  return m;
}

// A motion (t', w') of the other frame is w = w' length / length', t = t' - w' x s, with
// s = (centre' - centre) / length'. Sums go with the transpose: F' = F and
// M' = M length / length' - s x F.
RigidMode RigidFrame::sums_in(const RigidFrame& other, const RigidMode& m) const {
  const double scale = length / other.length;
  std::array<double, 3> s;
  for (std::size_t d = 0; d < 3; ++d) s[d] = (other.centre[d] - centre[d]) / other.length;
  RigidMode result = m;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
    result[3 + d] = m[3 + d] * scale - (s[e] * m[f] - s[f] * m[e]);
  }
  return result;
}

RigidGram RigidFrame::sums_in(const RigidFrame& other, const RigidGram& gram) const {
  RigidGram result{};
  for (int pass = 0; pass < 2; ++pass) {  // columns, then rows
    const RigidGram& from = pass == 0 ? gram : result;
    RigidGram to{};
    for (std::size_t j = 0; j < 6; ++j) {
      RigidMode line;
      for (std::size_t i = 0; i < 6; ++i) line[i] = pass == 0 ? from[6 * i + j] : from[6 * j + i];
      line = sums_in(other, line);
      for (std::size_t i = 0; i < 6; ++i) (pass == 0 ? to[6 * i + j] : to[6 * j + i]) = line[i];
    }
    result = to;
  }
  return result;
}

void add_product(RigidGram& gram, const RigidMode& m) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) gram[6 * i + j] += m[i] * m[j];
}

HeldMotions::HeldMotions(const RigidGram& gram) {
  RigidGram vectors = gram;
  for (std::size_t i = 0; i < 6; ++i) trace_ += gram[7 * i];
  double work[64];
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', 6, vectors.data(), 6, eigenvalue_.data(), work, 64,
                                      &info);
  if (info != 0) throw base::RunError("eigenvalues of the rigid motions: LAPACK dsyev failed");
  for (std::size_t v = 0; v < 6; ++v)
    for (std::size_t i = 0; i < 6; ++i) mode_[v][i] = vectors[6 * v + i];
}

std::vector<RigidMode> HeldMotions::free() const {
  std::vector<RigidMode> basis;
  for (std::size_t v = 0; v < 6; ++v)
    if (is_free(v)) basis.push_back(mode_[v]);
  return basis;
}

double HeldMotions::misfit(const RigidMode& forced, double squares) const {
  double rest = squares;
  for (std::size_t v = 0; v < 6; ++v)
    if (!is_free(v)) rest -= dot(mode_[v], forced) * dot(mode_[v], forced) / eigenvalue_[v];
  return rest > 0.0 ? rest : 0.0;
}

}  // namespace stroma::mechanics
