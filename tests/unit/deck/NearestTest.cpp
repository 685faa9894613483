// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "stroma/deck/Nearest.hpp"

namespace stroma::deck {
namespace {

const std::vector<std::string> known = {"Element Size [um]", "Shear Modulus [Pa]",
                                        "Bulk Modulus [Pa]", "Poisson Ratio",
                                        "Per Voxel",         "Per Element"};

TEST(DeckNearest, SlipsOfTheFinger) {
  EXPECT_EQ(nearest("Element Sise [um]", known), "Element Size [um]");
  EXPECT_EQ(nearest("Elemnt Size [um]", known), "Element Size [um]");
  EXPECT_EQ(nearest("Element Szie [um]", known), "Element Size [um]");
  EXPECT_EQ(nearest("Poisson's Ratio", known), "Poisson Ratio");
  EXPECT_EQ(nearest("Poison Ratio", known), "Poisson Ratio");
  EXPECT_EQ(nearest("y_", {"y-", "y+"}), "y-");
}

TEST(DeckNearest, TheUnitForgottenOrWrong) {
  EXPECT_EQ(nearest("Shear Modulus", known), "Shear Modulus [Pa]");
  EXPECT_EQ(nearest("Shear Modulus [kPa]", known), "Shear Modulus [Pa]");
  EXPECT_EQ(nearest("bulk modulus", known), "Bulk Modulus [Pa]");
}

TEST(DeckNearest, CapitalsAndBlanks) {
  EXPECT_EQ(nearest("element size [um]", known), "Element Size [um]");
  EXPECT_EQ(nearest("ELEMENT_SIZE", known), "Element Size [um]");
  EXPECT_EQ(nearest("per  voxel", known), "Per Voxel");
}

TEST(DeckNearest, TheNearestOfSeveral) {
  EXPECT_EQ(nearest("Per Elment", known), "Per Element");
  EXPECT_EQ(nearest("Bulk Modulos", known), "Bulk Modulus [Pa]");
}

TEST(DeckNearest, NothingIsNear) {
  EXPECT_EQ(nearest("Temperature", known), "");
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest("q", {"a", "b"}), "");
  EXPECT_EQ(nearest("Reset", {}), "");
  EXPECT_EQ(nearest(std::string(100000, 'x'), known), "");
  EXPECT_EQ(suggestion("q", {"alpha", "beta"}), "known here: \"alpha\", \"beta\"");
  EXPECT_EQ(suggestion("alpah", {"alpha", "beta"}), "did you mean \"alpha\"?");
}

}  // namespace
}  // namespace stroma::deck
