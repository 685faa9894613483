// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Symmetries, moduli and axes of stiffness tensors. Claim V-STIFF-5, docs/verification.md.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "stiffness/ElasticTensor.hpp"

namespace stroma {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

double norm(const Matrix6& stiffness) { return to_kelvin(stiffness).norm(); }
double product(const Matrix6& a, const Matrix6& b) {
  return to_kelvin(a).cwiseProduct(to_kelvin(b)).sum();
}

/// Any stiffness, positive definite.
Matrix6 any_stiffness(unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Matrix6 a;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) a(i, j) = normal(generator);
  return to_voigt(a * a.transpose() + 5.0 * Matrix6::Identity());
}

Matrix3d any_axes(unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const double w = normal(generator), x = normal(generator), y = normal(generator),
               z = normal(generator);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

/// By its nine moduli: E 10, 20, 40; nu_12 0.2, nu_13 0.1, nu_23 0.3; G_23 7, G_13 5, G_12 3.
Matrix6 orthotropic_compliance() {
  Matrix6 S = Matrix6::Zero();
  S.diagonal() << 1.0 / 10, 1.0 / 20, 1.0 / 40, 1.0 / 7, 1.0 / 5, 1.0 / 3;
  S(0, 1) = S(1, 0) = -0.2 / 10;
  S(0, 2) = S(2, 0) = -0.1 / 10;
  S(1, 2) = S(2, 1) = -0.3 / 20;
  return S;
}

TEST(ElasticTensor, HasTheModuliOfItsCompliance) {
  const Matrix6 stiffness = orthotropic_compliance().inverse();
  const auto compliance = compliance_of(stiffness);
  ASSERT_TRUE(compliance);
  const EngineeringModuli moduli = engineering_moduli(*compliance);
  EXPECT_LT((moduli.young - Vector3d(10, 20, 40)).norm(), 1e-12);
  EXPECT_LT((moduli.shear - Vector3d(7, 5, 3)).norm(), 1e-12);
  EXPECT_NEAR(moduli.nu(0, 1), 0.2, 1e-14);
  EXPECT_NEAR(moduli.nu(1, 0), 0.2 * 20 / 10, 1e-14);  // nu_ij / E_i = nu_ji / E_j
  EXPECT_NEAR(moduli.nu(2, 1), 0.3 * 40 / 20, 1e-14);
  EXPECT_FALSE(compliance_of(isotropic_stiffness(1.0, 0.0)));
}

TEST(ElasticTensor, OfAnIsotropicMaterialIsTheSameAlongAllAxes) {
  const Matrix6 stiffness = isotropic_stiffness(500.0, 200.0);
  EXPECT_LT(norm(in_frame(stiffness, any_axes(1)) - stiffness), 1e-12 * norm(stiffness));
  const EngineeringModuli moduli = engineering_moduli(*compliance_of(stiffness));
  const double young = 9.0 * 500.0 * 200.0 / (3.0 * 500.0 + 200.0);
  EXPECT_NEAR(moduli.young(2), young, 1e-12 * young);
  EXPECT_NEAR(moduli.nu(0, 2), young / 400.0 - 1.0, 1e-14);
  EXPECT_NEAR(bulk_modulus(stiffness), 500.0, 1e-12);
  for (const auto& [name, symmetry] : symmetries()) {
    const ClosestTensor tensor = closest(stiffness, symmetry);
    EXPECT_LT(tensor.distance, 1e-14) << name;
    EXPECT_EQ(tensor.frame, Matrix3d::Identity()) << name;  // no axes are better
  }
}

// Turning a tensor keeps its energy: sigma.eps with both turned by hand.
TEST(ElasticTensor, IsTurnedAsATensor) {
  const Matrix6 C = any_stiffness(3);
  const Matrix3d axes = any_axes(4);
  Matrix3d strain;
  strain << 0.3, 0.1, -0.2, 0.1, -0.5, 0.4, -0.2, 0.4, 0.7;
  const auto voigt = [](const Matrix3d& e) {
    Eigen::Matrix<double, 6, 1> v;
    v << e(0, 0), e(1, 1), e(2, 2), 2 * e(1, 2), 2 * e(0, 2), 2 * e(0, 1);
    return v;
  };
  const auto turned = voigt(axes * strain * axes.transpose()), plain = voigt(strain);
  const double energy = plain.dot(C * plain);
  EXPECT_NEAR(turned.dot(in_frame(C, axes) * turned), energy, 1e-12 * energy);
}

// A projection is orthogonal: what it leaves is orthogonal to what it gives, nothing is taken from a
// tensor that has the symmetry, and more symmetry is never closer.
TEST(ElasticTensor, ProjectionsAreOrthogonal) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Matrix6 C = any_stiffness(seed);
    double before = 1.0;
    for (const auto& [name, symmetry] : symmetries()) {
      const ClosestTensor tensor = closest(C, symmetry);
      EXPECT_NEAR(product(C - tensor.stiffness, tensor.stiffness), 0.0, 1e-12 * norm(C) * norm(C));
      EXPECT_NEAR(norm(C - tensor.stiffness) / norm(C), tensor.distance, 1e-12);
      EXPECT_LT(closest(tensor.stiffness, symmetry).distance, 1e-12) << name;
      EXPECT_LE(tensor.distance, tensor.along_specimen + 1e-14) << name;
      if (symmetry == Symmetry::isotropic) before = tensor.distance;
      EXPECT_LE(tensor.distance, before + 1e-14) << name;  // each holds the isotropic ones
    }
    EXPECT_LE(closest(C, Symmetry::orthotropic).distance,
              closest(C, Symmetry::transversely_isotropic).distance + 1e-14);
  }
}

// The mean over many turns about the axis is the closest transversely isotropic tensor, and the mean
// over the cube's turns and mirrors the closest cubic one.
TEST(ElasticTensor, TransverseIsotropyIsAMeanOverTurns) {
  const Matrix6 C = any_stiffness(6);
  const ClosestTensor tensor = closest(C, Symmetry::transversely_isotropic);
  const Vector3d axis = tensor.frame.row(2);
  Matrix6 mean = Matrix6::Zero();
  constexpr int turns = 12;
  for (int n = 0; n < turns; ++n)
    mean += in_frame(C, Eigen::AngleAxisd(2.0 * M_PI * n / turns, axis).toRotationMatrix()) / turns;
  EXPECT_LT(norm(mean - tensor.stiffness), 1e-12 * norm(C));
}

// No axes on a fine net over all turns are closer.
TEST(ElasticTensor, FindsTheClosestAxes) {
  for (unsigned seed = 11; seed <= 13; ++seed) {
    const Matrix6 C = any_stiffness(seed);
    for (const Symmetry symmetry :
         {Symmetry::cubic, Symmetry::transversely_isotropic, Symmetry::orthotropic}) {
      const double found = closest(C, symmetry).distance;
      for (unsigned n = 0; n < 2000; ++n)
        ASSERT_GE(closest_along(in_frame(C, any_axes(n)), symmetry), found - 1e-12);
    }
  }
}

TEST(ElasticTensor, FindsTheAxesOfATurnedTensor) {
  const Matrix6 orthotropic = orthotropic_compliance().inverse();
  Matrix6 transverse = Matrix6::Zero(), cubic = Matrix6::Zero();
  transverse << 20, 6, 5, 0, 0, 0, 6, 20, 5, 0, 0, 0, 5, 5, 50, 0, 0, 0,  //
      0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 7;
  cubic << 20, 6, 6, 0, 0, 0, 6, 20, 6, 0, 0, 0, 6, 6, 20, 0, 0, 0,  //
      0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 2;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Matrix3d axes = any_axes(seed);  // C turned so that its axes are the rows of these
    const auto turned = [&](const Matrix6& C) { return in_frame(C, axes.transpose()); };
    const ClosestTensor a = closest(turned(orthotropic), Symmetry::orthotropic);
    EXPECT_LT(a.distance, 1e-13);
    EXPECT_LT(norm(in_frame(turned(orthotropic), a.frame) - a.in_frame), 1e-12 * norm(orthotropic));
    EXPECT_GT(a.along_specimen, 1e-3);
    const ClosestTensor b = closest(turned(transverse), Symmetry::transversely_isotropic);
    EXPECT_LT(b.distance, 1e-13);
    EXPECT_NEAR(std::abs(b.frame.row(2).dot(axes.row(2))), 1.0, 1e-13);
    EXPECT_LT(norm(b.in_frame - transverse), 1e-11 * norm(transverse));
    const ClosestTensor c = closest(turned(cubic), Symmetry::cubic);
    EXPECT_LT(c.distance, 1e-13);
    EXPECT_LT(norm(c.in_frame - cubic), 1e-11 * norm(cubic));
    EXPECT_NEAR(c.frame.determinant(), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace stroma
