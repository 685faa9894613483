// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Principal values of eight tensors at once, against those of one.

#include <gtest/gtest.h>

#include <random>

#include "stroma/tensor/PrincipalBatch.hpp"
#include "stroma/tensor/PrincipalValues.hpp"

namespace stroma::tensor {
namespace {

TEST(PrincipalBatch, HasTheValuesOfEachTensor) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int round = 0; round < 1000; ++round) {
    SymmetricBatch batch;
    Tensor3 tensors[SymmetricBatch::size];
    for (int n = 0; n < SymmetricBatch::size; ++n) {
      Tensor3& a = tensors[n];
      const double size = round % 3 == 0 ? 1e-8 : round % 3 == 1 ? 1.0 : 1e6;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) a(i, j) = a(j, i) = size * any(random);
      if (n == 1) a = Tensor3{};          // nothing
      if (n == 2) a = size * identity();  // all the same
      if (n == 3) a(0, 1) = a(1, 0) = a(0, 2) = a(2, 0) = 0.0;
      if (n == 4) {  // two of three the same: a plane turned anyhow
        const double u[3] = {any(random), any(random), any(random)};
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) a(i, j) = size * (u[i] * u[j] + (i == j ? 0.5 : 0.0));
      }
      if (n == 5) a(2, 2) = a(1, 1) = a(0, 0);
      batch.set(n, a);
    }
    find_principal_values(batch);
    for (int n = 0; n < SymmetricBatch::size; ++n) {
      const PrincipalValues expected = principal_values(tensors[n]);
      const double size = std::abs(expected(0)) + std::abs(expected(2));
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(batch.entry[i][n], expected(i), 4e-15 * size) << n;
    }
  }
}

}  // namespace
}  // namespace stroma::tensor
