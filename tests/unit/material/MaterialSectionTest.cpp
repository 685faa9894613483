// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// From the deck's materials to laws.

#include <gtest/gtest.h>

#include "stroma/material/Material.hpp"

namespace stroma::material {
namespace {

TEST(Material, BulkModulusFollowsFromPoissonRatio) {
  EXPECT_NEAR(bulk_modulus(520.8, 0.4), 2430.4, 1e-10);
  EXPECT_NEAR(bulk_modulus(520.8, 2.0 / 7.0), 2.0 * 520.8, 1e-10);  // K = 2 mu
  // nu = (3 K - 2 mu) / (6 K + 2 mu) leads back.
  for (const double nu : {-0.9, 0.0, 0.3, 0.495}) {
    const double mu = 7.0, k = bulk_modulus(mu, nu);
    EXPECT_NEAR((3 * k - 2 * mu) / (6 * k + 2 * mu), nu, 1e-12);
  }
}

TEST(Material, LawsAndLabelsKeepTheUsersOrder) {
  MaterialParameters collagen, vessel;
  collagen.label = 4;
  collagen.shear_modulus = 520.8;
  collagen.poisson_ratio = 0.4;
  vessel.label = 0;
  vessel.shear_modulus = 1041.6;
  vessel.bulk_modulus = 9000.0;
  vessel.volumetric_energy = VolumetricEnergy::quadratic;
  const NamedMaterials materials{{"collagen", collagen}, {"vessel", vessel}};
  const auto of_material = laws(materials);
  ASSERT_EQ(of_material.size(), 2u);
  EXPECT_NEAR(of_material[0].bulk_modulus, 2430.4, 1e-10);
  EXPECT_EQ(of_material[1].bulk_modulus, 9000.0);
  EXPECT_EQ(of_material[1].shear_modulus, 1041.6);
  EXPECT_EQ(of_material[0].volumetric_energy, VolumetricEnergy::logarithmic);
  EXPECT_EQ(of_material[1].volumetric_energy, VolumetricEnergy::quadratic);
  const auto index = material_of_label(materials);
  EXPECT_EQ(index.at(4), 0);
  EXPECT_EQ(index.at(0), 1);
  EXPECT_EQ(index.size(), 2u);
}

}  // namespace
}  // namespace stroma::material
