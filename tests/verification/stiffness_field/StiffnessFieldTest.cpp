// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Moduli per particle: two stiffnesses as one material with a field equal two materials
/// without, in force, tangent, results and with grid reset. Claims V-FIELD-1, V-FIELD-2,
/// docs/verification.md.

#include <gtest/gtest.h>

#include "stroma/base/Error.hpp"
#include "stroma/material/VaryingMaterial.hpp"
#include "stroma/particles/Fields.hpp"
#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"
#include "support/Specimen.hpp"
#include "support/World.hpp"

namespace stroma {
namespace {

using mechanics::LawList;
using particles::Particles;

constexpr double soft = 520.8, stiff = 1041.6;

/// All moduli in proportion.
material::AnyLaw stiffened(material::AnyLaw law) {
  int n = 0;
  law.for_each_number([&](const material::NumberName&, double& number) {
    if (n++ < 2) number *= stiff / soft;
  });
  return law;
}

/// One material of the law, whose particles are soft or, in the bars, stiff.
struct Body {
  test::Specimen specimen;
  Particles<grid::Device> particles;
  mechanics::Problem problem;

  std::unique_ptr<mechanics::MomentumBalance> balance() const {
    return std::make_unique<mechanics::MomentumBalance>(world(), specimen.partition(world()),
                                                        particles, problem);
  }
  mechanics::MovingBody moving_body() const {
    return {world(), specimen.partition(world()), particles, problem};
  }
};

Body with_two_materials(const test::Specimen& specimen, const material::AnyLaw& law) {
  Body body{specimen, specimen.particles(world()), specimen.problem()};
  body.problem.laws = LawList{{law, stiffened(law)}};
  return body;
}

Body with_a_field(const test::Specimen& specimen, const material::AnyLaw& law) {
  Body body = with_two_materials(specimen, law);
  auto& particles = body.particles;
  particles::allocate(particles.own_numbers, "own_numbers",
                      static_cast<std::size_t>(particles.count()), 2);
  // moduli come first
  const std::vector<double> of_soft = material::numbers_of(law),
                            of_stiff = material::numbers_of(stiffened(law));
  for (int p = 0; p < particles.count(); ++p) {
    for (int n = 0; n < 2; ++n)
      particles.own_numbers(p, n) =
          (particles.material(p) == 1 ? of_stiff : of_soft)[static_cast<std::size_t>(n)];
    particles.material(p) = 0;
  }
  material::AnyLaw varying = law;
  varying.let_vary({0, 1});
  body.problem.laws = LawList{{varying}};
  body.problem.laws.extremes = {law.small_strain(), stiffened(law).small_strain()};
  return body;
}

test::Specimen bars() {
  test::Specimen specimen;
  specimen.label = test::crossing_bars;
  specimen.conditions = test::clamped(0.1);
  return specimen;
}

/// What a balance gives at a displacement: force, tangent times a vector, and the particles'
/// stresses and energies, one after the other.
std::vector<double> answers(const mechanics::MomentumBalance& balance) {
  grid::Vector u(balance.owned_map()), v(balance.owned_map()), force(balance.owned_map()),
      product(balance.owned_map());
  test::fill(balance.halo(), u,
             [](const grid::Index3& n, int c) { return 0.1 * test::scatter(n, c, 1); });
  test::fill(balance.halo(), v,
             [](const grid::Index3& n, int c) { return test::scatter(n, c, 2); });
  EXPECT_EQ(balance.internal_force(u, force), 0);
  balance.tangent_times(u, v, product);
  std::vector<double> all;
  for (const grid::Vector* vector : {&force, &product})
    test::for_each_unknown(balance.halo(), *vector,
                           [&](const grid::Index3&, int, double value) { all.push_back(value); });
  const auto fields = balance.body().particle_fields(u);
  for (int p = 0; p < balance.body().particles().count(); ++p) {
    for (int c = 0; c < 6; ++c) all.push_back(fields.stress(p, c));
    all.push_back(fields.energy(p));
  }
  return all;
}

double largest(const std::vector<double>& values) {
  double size = 0.0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

// V-FIELD-1. With an elastic grid of any shape functions, mean dilatation and fictitious points.
// The moduli of the stiff particles are twice those of the soft ones, so that no bit is rounded
// away; neo-Hookean materials alone have kernels of their own, and another order of sums.
TEST(StiffnessField, IsTwoMaterials) {
  const material::AnyLaw coupled = material::CoupledNeoHookean{soft, 1500.0},
                         neo_hookean = material::NeoHookean{soft, 2430.4,
                                                            material::VolumetricEnergy::quadratic};
  for (const test::ShapeChoice& choice : test::shape_choices())
    for (const auto dilatation :
         {mechanics::Dilatation::pointwise, mechanics::Dilatation::element_mean}) {
      SCOPED_TRACE(choice.name);
      test::Specimen specimen = bars();
      choice.apply_to(specimen);
      specimen.dilatation = dilatation;
      specimen.stabilization = 0.01;
      specimen.label = [](const grid::Index3& voxel) {
        return voxel[0] > 5 && voxel[1] > 4 && voxel[2] > 4 ? -1 : test::crossing_bars(voxel);
      };
      EXPECT_EQ(answers(*with_a_field(specimen, coupled).balance()),
                answers(*with_two_materials(specimen, coupled).balance()));

      const auto field = answers(*with_a_field(specimen, neo_hookean).balance()),
                 materials = answers(*with_two_materials(specimen, neo_hookean).balance());
      ASSERT_EQ(field.size(), materials.size());
      for (std::size_t n = 0; n < field.size(); ++n)
        EXPECT_NEAR(field[n], materials[n], 1e-14 * largest(materials));
    }
}

// V-FIELD-2. With reset particles change their elements, and on two ranks their rank.
TEST(StiffnessField, MovesWithItsParticles) {
  test::Specimen specimen = bars();
  specimen.reset = true;
  specimen.conditions[1].second.strain.reset();
  specimen.conditions[1].second.displacement = {{0.9, 1.7, 1.3}};
  specimen.conditions[0].second.displacement = {{2.6, 2.2, 0.5}};
  specimen.stabilization = 0.01;
  auto parameters = test::to_rounding();
  parameters.newton_tolerance = 1e-10;
  const material::AnyLaw law = material::CoupledNeoHookean{soft, 1500.0};
  const auto forces_of = [&](mechanics::MovingBody body) {
    std::vector<double> forces;
    test::take_steps(body, 4, parameters, [&](double, const grid::Vector& u) {
      for (const auto& reaction : test::reactions(body, u))
        forces.insert(forces.end(), reaction.begin(), reaction.end());
    });
    const auto& particles = body.balance().body().particles();
    for (int p = 0; p < particles.count(); ++p)
      if (particles.own_numbers.extent(0) > 0) {
        EXPECT_TRUE(particles.own_numbers(p, 0) == soft || particles.own_numbers(p, 0) == stiff);
      }
    return forces;
  };
  EXPECT_EQ(forces_of(with_a_field(specimen, law).moving_body()),
            forces_of(with_two_materials(specimen, law).moving_body()));
}

TEST(StiffnessField, IsRefusedWhereNoLawReadsIt) {
  Body body = with_a_field(bars(), material::NeoHookean{soft, 2000.0});
  body.problem.laws = LawList{{material::NeoHookean{soft, 2000.0}}};
  EXPECT_THROW(body.balance(), base::InputError);
}

}  // namespace
}  // namespace stroma
