// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Stresses of each law in plain states of strain against its energy, written down a second time as
/// in the literature and differentiated by complex steps, which are exact to rounding. Claim
/// V-MAT-8, docs/verification.md.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <functional>

#include "stroma/material/AnyLaw.hpp"

namespace stroma::material {
namespace {

using Number = std::complex<double>;
using Gradient = std::array<std::array<Number, 3>, 3>;

/// Invariants of C = F^T F.
struct Invariants {
  Number j, i1, i2;

  explicit Invariants(const Gradient& F) {
    j = F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) -
        F[0][1] * (F[1][0] * F[2][2] - F[1][2] * F[2][0]) +
        F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
    Number square = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        Number c = 0.0;
        for (std::size_t k = 0; k < 3; ++k) c += F[k][a] * F[k][b];
        if (a == b) i1 += c;
        square += c * c;
      }
    i2 = 0.5 * (i1 * i1 - square);
  }
  Number bar1() const { return std::pow(j, -2.0 / 3.0) * i1; }
  Number bar2() const { return std::pow(j, -4.0 / 3.0) * i2; }
  Number of_volume(double bulk_modulus) const {
    return 0.5 * bulk_modulus * std::log(j) * std::log(j);
  }
};

struct WrittenLaw {
  const char* name;
  AnyLaw law;
  std::function<Number(const Invariants&)> energy;
};

const double K = 2430.4;
const WrittenLaw laws[] = {
    {"NeoHookean", NeoHookean{520.8, K},
     [](const Invariants& at) { return 260.4 * (at.bar1() - 3.0) + at.of_volume(K); }},
    {"CoupledNeoHookean", CoupledNeoHookean{520.8, 700.0},
     [](const Invariants& at) {
       const Number log_j = std::log(at.j);
       return 260.4 * (at.i1 - 3.0) - 520.8 * log_j + 350.0 * log_j * log_j;
     }},
    {"MooneyRivlin", MooneyRivlin{{K}, 200.0, 60.4},
     [](const Invariants& at) {
       return 200.0 * (at.bar1() - 3.0) + 60.4 * (at.bar2() - 3.0) + at.of_volume(K);
     }},
    {"Yeoh", Yeoh{{K}, 3, {260.4, -30.0, 55.0}},
     [](const Invariants& at) {
       const Number x = at.bar1() - 3.0;
       return 260.4 * x - 30.0 * x * x + 55.0 * x * x * x + at.of_volume(K);
     }},
    {"VerondaWestmann", VerondaWestmann{{K}, 100.0, 4.0},
     [](const Invariants& at) {
       return 100.0 * (std::exp(4.0 * (at.bar1() - 3.0)) - 1.0) - 200.0 * (at.bar2() - 3.0) +
              at.of_volume(K);
     }},
    {"HolmesMow", HolmesMow{400.0, 500.0, 0.8},
     [](const Invariants& at) {
       const Number q =
           0.8 / 1300.0 * (300.0 * (at.i1 - 3.0) + 500.0 * (at.i2 - 3.0) - 2600.0 * std::log(at.j));
       return 1300.0 / 3.2 * (std::exp(q) - 1.0);
     }},
    {"ArrudaBoyce", ArrudaBoyce{{K}, 450.0, 6.5},
     [](const Invariants& at) {
       const Number i = at.bar1();
       const double n = 6.5;
       return 450.0 * ((i - 3.0) / 2.0 + (i * i - 9.0) / (20.0 * n) +
                       11.0 * (i * i * i - 27.0) / (1050.0 * n * n) +
                       19.0 * (i * i * i * i - 81.0) / (7000.0 * n * n * n) +
                       519.0 * (i * i * i * i * i - 243.0) / (673750.0 * n * n * n * n)) +
              at.of_volume(K);
     }},
    // lbar^2 and lbar^-2 sum to Ibar1 and Ibar2: the solid of Mooney and Rivlin again.
    {"OgdenAsMooneyRivlin", Ogden{{K}, 2, {800.0, 241.6}, {2.0, -2.0}},
     [](const Invariants& at) {
       return 200.0 * (at.bar1() - 3.0) + 60.4 * (at.bar2() - 3.0) + at.of_volume(K);
     }},
    // lbar^4 sum to Ibar1^2 - 2 Ibar2.
    {"OgdenOfFourthPowers", Ogden{{K}, 1, {1041.6}, {4.0}},
     [](const Invariants& at) {
       return 65.1 * (at.bar1() * at.bar1() - 2.0 * at.bar2() - 3.0) + at.of_volume(K);
     }},
};

class WrittenLaws : public ::testing::TestWithParam<WrittenLaw> {};
INSTANTIATE_TEST_SUITE_P(Laws, WrittenLaws, ::testing::ValuesIn(laws),
                         [](const auto& instance) { return instance.param.name; });

/// Uniaxial stretch and compression, with and without sideways contraction; shear; all at once.
const Tensor3 states[] = {
    {{{0.3, 0, 0}, {0, -0.1, 0}, {0, 0, -0.1}}},
    {{{-0.3, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
    {{{0, 0.4, 0}, {0, 0, 0}, {0, 0, 0}}},
    {{{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}}},
    {{{0.10, 0.30, -0.05}, {-0.20, 0.05, 0.15}, {0.08, -0.12, 0.02}}},
};

// V-MAT-8. tau = dW/dF F^T.
TEST_P(WrittenLaws, HaveTheStressOfTheirEnergyAsItIsWritten) {
  const AnyLaw& law = GetParam().law;
  const double mu = law.small_strain().shear, h = 1e-30;
  for (const Tensor3& H : states) {
    Tensor3 piola, F = tensor::identity() + H;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Gradient at;
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l)
            at[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] = {
                F(k, l), i == k && j == l ? h : 0.0};
        piola(i, j) = GetParam().energy(Invariants(at)).imag() / h;
      }
    const Tensor3 expected = piola * tensor::transpose(F), found = kirchhoff_stress(law, H);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(found(i, j), expected(i, j), 1e-10 * mu);
    Gradient here;
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        here[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] = F(k, l);
    EXPECT_NEAR(energy(law, H), GetParam().energy(Invariants(here)).real(), 1e-11 * mu);
  }
}

}  // namespace
}  // namespace stroma::material
