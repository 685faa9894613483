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
  collagen.numbers = {{"Shear Modulus [Pa]", 520.8}, {"Poisson Ratio", 0.4}};
  vessel.label = 0;
  vessel.numbers = {{"Shear Modulus [Pa]", 1041.6}, {"Bulk Modulus [Pa]", 9000.0}};
  vessel.volumetric_energy = VolumetricEnergy::quadratic;
  const NamedMaterials materials{{"collagen", collagen}, {"vessel", vessel}};
  const auto of_material = laws_of(materials).laws;
  ASSERT_EQ(of_material.size(), 2u);
  EXPECT_NEAR(of_material[0].matrix().as<NeoHookean>().bulk_modulus, 2430.4, 1e-10);
  EXPECT_EQ(of_material[1].matrix().as<NeoHookean>().bulk_modulus, 9000.0);
  EXPECT_EQ(of_material[1].matrix().as<NeoHookean>().shear_modulus, 1041.6);
  EXPECT_EQ(of_material[0].matrix().as<NeoHookean>().volumetric_energy,
            VolumetricEnergy::logarithmic);
  EXPECT_EQ(of_material[1].matrix().as<NeoHookean>().volumetric_energy,
            VolumetricEnergy::quadratic);
  EXPECT_NEAR(compressibility(materials).largest_poisson_ratio, 24916.8 / 56083.2, 1e-15);
  const auto index = material_of_label(materials);
  EXPECT_EQ(index.at(4), 0);
  EXPECT_EQ(index.at(0), 1);
  EXPECT_EQ(index.size(), 2u);
}

}  // namespace
}  // namespace stroma::material
