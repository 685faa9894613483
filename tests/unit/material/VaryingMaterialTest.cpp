// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Laws whose numbers differ from particle to particle. Claim V-FIELD-6, docs/verification.md.

#include <gtest/gtest.h>

#include "stroma/material/VaryingMaterial.hpp"
#include "support/NamedMaterial.hpp"

namespace stroma::material {
namespace {

/// All that a material may have.
MaterialParameters tissue() {
  MaterialParameters material = test::material_of("Ogden", {{"Poisson Ratio", 0.4}},
                                                  {{"C [Pa]", {700.0, 300.0}}, {"M", {2.0, 6.0}}});
  material.fibers.emplace();
  material.fibers->families = {
      {"collagen",
       test::fibers_of("Exponential-Power", {{"Xi [Pa]", 300.0}, {"Alpha", 2.0}, {"Beta", 2.5}},
                       {1.0, 3.0, 1.0})},
      {"elastin",
       test::fibers_of("Exponential-Linear",
                       {{"C3 [Pa]", 20.0}, {"C4", 40.0}, {"C5 [Pa]", 5000.0}, {"Lambda Max", 1.05}},
                       {0.0, 0.0, 1.0})}};
  material.viscosity.emplace();
  material.viscosity->moduli = {0.6, 0.3};
  material.viscosity->times = {0.5, 5.0};
  material.active_stress.emplace();
  material.active_stress->kind = ActiveStress::Kind::fiber;
  material.active_stress->t0 = 200.0;
  material.growth.emplace();
  material.growth->kind = Growth::Kind::fiber;
  material.growth->ratio = 1.5;
  return material;
}

/// Places in which two laws differ.
std::vector<int> differences(const AnyLaw& a, const AnyLaw& b) {
  const std::vector<double> of_a = numbers_of(a), of_b = numbers_of(b);
  EXPECT_EQ(of_a.size(), of_b.size());
  std::vector<int> places;
  for (std::size_t n = 0; n < of_a.size(); ++n)
    if (of_a[n] != of_b[n]) places.push_back(static_cast<int>(n));
  return places;
}

// V-FIELD-6. Every number may be a field; its law is that of the deck with the other number, and
// what differs is handed over whole.
TEST(VaryingMaterial, IsTheMaterialWithAnotherNumber) {
  MaterialParameters material = tissue();
  const std::vector<VaryingNumber> numbers = numbers_that_may_vary(material);
  std::vector<std::string> names;
  for (const VaryingNumber& number : numbers) names.push_back(number.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{
                "C [Pa]|1", "C [Pa]|2", "M|1", "M|2", "Poisson Ratio", "Fibers|collagen|Xi [Pa]",
                "Fibers|collagen|Alpha", "Fibers|collagen|Beta", "Fibers|elastin|C3 [Pa]",
                "Fibers|elastin|C4", "Fibers|elastin|C5 [Pa]", "Fibers|elastin|Lambda Max",
                "Viscosity|Moduli|1", "Viscosity|Moduli|2", "Viscosity|Relaxation Times [s]|1",
                "Viscosity|Relaxation Times [s]|2", "Active Stress|T0 [Pa]", "Growth|Ratio"}));
  const AnyLaw own = law_at_rest(material);
  for (const VaryingNumber& number : numbers) {
    SCOPED_TRACE(number.name);
    MaterialParameters with_field = material, other = material;
    const double value = number.in(other) *= 1.0625;
    with_field.fields.emplace();
    FieldParameters field;
    field.parameter = number.name;
    with_field.fields->fields = {{"one", field}};
    VaryingMaterial varying(with_field);
    varying.set(0, value);
    const AnyLaw expected = law_at_rest(other), found = varying.law();
    EXPECT_TRUE(differences(found, expected).empty());
    const std::vector<int> which = differences(own, found);
    EXPECT_FALSE(which.empty());

    AnyLaw law = own;
    law.let_vary(which);
    ASSERT_EQ(law.own_numbers(), static_cast<int>(which.size()));
    std::vector<double> taken;
    for (const int place : which)
      taken.push_back(numbers_of(found)[static_cast<std::size_t>(place)]);
    law.take(taken.data());
    EXPECT_TRUE(differences(law, found).empty());
  }
}

// A modulus that follows from a number by Poisson's ratio follows from the particle's.
TEST(VaryingMaterial, KeepsPoissonsRatio) {
  MaterialParameters material = tissue();
  material.fields.emplace();
  FieldParameters field;
  field.parameter = "C [Pa]|1";
  material.fields->fields = {{"one", field}};
  VaryingMaterial varying(material);
  for (const double c : {10.0, 700.0, 9000.0}) {
    varying.set(0, c);
    EXPECT_NEAR(varying.law().matrix().small_strain().poisson_ratio(), 0.4, 1e-14);
  }
}

// A direction that particles give turns the family, and what follows its direction.
TEST(VaryingMaterial, TurnsItsFibresAndDrives) {
  VaryingMaterial varying(tissue());
  const std::array<double, 3> n{0.6, 0.0, -0.8};
  varying.point(0, n, 0.5);
  AnyLaw law = varying.law();
  int seen = 0;
  law.for_each_number([&](const NumberName& name, double& number) {
    const std::string text = name.name;
    if (text.find("Direction") != std::string::npos && name.family <= 0) {
      EXPECT_EQ(number, normalised(n)[static_cast<std::size_t>(name.entry)]) << text;
      ++seen;
    }
    if (text == "Share") {
      EXPECT_EQ(number, name.family == 0 ? 0.5 : 1.0);
    }
  });
  EXPECT_EQ(seen, 9);
}

}  // namespace
}  // namespace stroma::material
