// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Force and tangent of particles on a grid: power, energy and derivative. Claims V-TRA-1 to
/// V-TRA-4, docs/verification.md.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "stroma/material/NeoHookean.hpp"
#include "stroma/shape/Linear.hpp"
#include "stroma/transfer/GridToParticles.hpp"
#include "stroma/transfer/InternalForce.hpp"

namespace stroma::transfer {
namespace {

using Space = Kokkos::DefaultHostExecutionSpace;
using Device = Kokkos::Device<Space, Kokkos::HostSpace>;
using Law = material::NeoHookean;
using Nodal = Kokkos::View<double* [3], Kokkos::LayoutRight, Device>;
using Elements = ElementParticles<shape::Linear, Device>;

constexpr int shape_of_box[3] = {4, 3, 2};
const double spacing[3] = {2.1, 1.7, 2.4};

/// A box of elements with particles at random places, some elements empty, two materials.
struct Body {
  ElementBox box;
  particles::Particles<Device> particles;
  Kokkos::View<Law*, Device> law{"law", 2};

  Body() {
    for (int d = 0; d < 3; ++d) {
      box.elements[d] = shape_of_box[d];
      box.corner[d] = -0.3 * (d + 1);
      box.spacing[d] = spacing[d];
      box.inverse_spacing[d] = 1.0 / spacing[d];
    }
    law(0) = {520.8, 2430.4};
    law(1) = {1041.6, 9000.0};
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(0.0, 1.0);
    const int elements = box.elements[0] * box.elements[1] * box.elements[2];
    particles.element_begin = Kokkos::View<int*, Device>("begin", elements + 1);
    for (int e = 0; e < elements; ++e)
      particles.element_begin(e + 1) = particles.element_begin(e) + (e % 5 == 2 ? 0 : 1 + e % 4);
    const int count = particles.element_begin(elements);
    particles.position = decltype(particles.position)("position", count);
    particles.volume = decltype(particles.volume)("volume", count);
    particles.material = decltype(particles.material)("material", count);
    for (int k = 0; k < box.elements[2]; ++k)
      for (int j = 0; j < box.elements[1]; ++j)
        for (int i = 0; i < box.elements[0]; ++i) {
          const int e = box.element(i, j, k);
          const int index[3] = {i, j, k};
          for (int p = particles.element_begin(e); p < particles.element_begin(e + 1); ++p) {
            for (int d = 0; d < 3; ++d)
              particles.position(p, d) = box.corner[d] + (index[d] + inside(random)) * spacing[d];
            particles.volume(p) = 0.5 + inside(random);
            particles.material(p) = static_cast<std::uint8_t>(p % 2);
          }
        }
  }

  Nodal nodal(const std::string& name) const {
    return Nodal(name, (box.elements[0] + 1) * (box.elements[1] + 1) * (box.elements[2] + 1));
  }

  /// v = G x + g at the nodes of the Cartesian grid.
  Nodal linear(const Tensor3& G) const {
    const Nodal v = nodal("linear");
    for (int k = 0; k <= box.elements[2]; ++k)
      for (int j = 0; j <= box.elements[1]; ++j)
        for (int i = 0; i <= box.elements[0]; ++i) {
          const int index[3] = {i, j, k};
          for (int c = 0; c < 3; ++c) {
            double sum = 0.1 * (c + 1);
            for (int d = 0; d < 3; ++d) sum += G(c, d) * (box.corner[d] + index[d] * spacing[d]);
            v(box.node(i, j, k), c) = sum;
          }
        }
    return v;
  }

  Nodal scattered(double size, unsigned seed) const {
    const Nodal v = nodal("scattered");
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> between(-size, size);
    for (std::size_t n = 0; n < v.extent(0); ++n)
      for (int c = 0; c < 3; ++c) v(n, c) = between(random);
    return v;
  }

  Nodal force(const Nodal& u) const {
    const Nodal f = nodal("force");
    const InternalForce<shape::Linear, Law, Device> kernel{{box, particles, u}, law, f};
    EXPECT_EQ((for_each_element<2, Space>("force", box, kernel)), 0);
    return f;
  }

  Nodal tangent_times(const Nodal& u, const Nodal& v) const {
    const Nodal product = nodal("product");
    const TangentTimes<shape::Linear, Law, Device> kernel{{box, particles, u}, law, v, product};
    EXPECT_EQ((for_each_element<2, Space>("tangent", box, kernel)), 0);
    return product;
  }

  ParticleFields<Device> fields(const Nodal& u) const {
    const ParticleFields<Device> result(particles.count());
    const GridToParticles<shape::Linear, Law, Device> kernel{{box, particles, u}, law, result};
    for_each_element<2, Space>("fields", box, kernel);
    return result;
  }

  double energy(const Nodal& u) const {
    const auto result = fields(u);
    double sum = 0.0;
    for (int p = 0; p < particles.count(); ++p) sum += particles.volume(p) * result.energy(p);
    return sum;
  }
};

double dot(const Nodal& a, const Nodal& b) {
  double sum = 0.0;
  for (std::size_t n = 0; n < a.extent(0); ++n)
    for (int c = 0; c < 3; ++c) sum += a(n, c) * b(n, c);
  return sum;
}

Nodal sum(const Nodal& a, double s, const Nodal& b) {
  const Nodal result("sum", a.extent(0));
  for (std::size_t n = 0; n < a.extent(0); ++n)
    for (int c = 0; c < 3; ++c) result(n, c) = a(n, c) + s * b(n, c);
  return result;
}

double norm(const Nodal& a) { return std::sqrt(dot(a, a)); }

const Tensor3 gradient{{{0.05, 0.20, -0.04}, {-0.10, 0.08, 0.06}, {0.03, -0.07, -0.05}}};
const Tensor3 L{{{0.7, -0.4, 0.2}, {0.5, 0.3, -0.6}, {-0.1, 0.8, 0.9}}};

// For every velocity that is linear in the CURRENT position, v = L x + c, the nodes' power f . v is
// the particles' power sum V0 tau : L. With u = G X + g, v is linear in X too, of gradient L (I +
// G).
TEST(InternalForce, NodalPowerIsParticlePower) {
  const Body body;
  const Nodal u = body.linear(gradient);
  const Nodal f = body.force(u);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Tensor3 one;
      one(i, j) = 1.0;
      double power = 0.0, size = 0.0;
      for (int p = 0; p < body.particles.count(); ++p) {
        const Tensor3 tau =
            material::kirchhoff_stress(body.law(body.particles.material(p)), gradient);
        power += body.particles.volume(p) * tensor::contract(tau, one);
        size += body.particles.volume(p) * tensor::von_mises(tau);
      }
      const Nodal v = body.linear(one * (tensor::identity() + gradient));
      EXPECT_NEAR(dot(f, v), power, 1e-12 * size) << "velocity gradient " << i << j;
    }
}

TEST(InternalForce, SumsToNothing) {
  const Body body;
  const Nodal f = body.force(body.scattered(0.15, 1));
  for (int c = 0; c < 3; ++c) {
    double sum = 0.0, size = 0.0;
    for (std::size_t n = 0; n < f.extent(0); ++n) {
      sum += f(n, c);
      size += std::abs(f(n, c));
    }
    EXPECT_NEAR(sum, 0.0, 1e-14 * size * 10);
  }
}

// V-TRA-2.
// The whole energy, differentiated along a direction that moves every node, is the force's power.
TEST(InternalForce, IsTheDerivativeOfTheEnergy) {
  const Body body;
  const Nodal u = body.scattered(0.15, 1), v = body.scattered(1.0, 2);
  const auto error = [&](double h) {
    return std::abs((body.energy(sum(u, h, v)) - body.energy(sum(u, -h, v))) / (2 * h) -
                    dot(body.force(u), v));
  };
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(error(h) / error(h / 2)), 2.0, 0.1) << "at h = " << h;
}

// V-TRA-3.
TEST(TangentTimes, IsTheDerivativeOfTheForce) {
  const Body body;
  const Nodal u = body.scattered(0.15, 1), v = body.scattered(1.0, 2);
  const Nodal product = body.tangent_times(u, v);
  const auto error = [&](double h) {
    const Nodal difference = sum(body.force(sum(u, h, v)), -1.0, body.force(sum(u, -h, v)));
    return norm(sum(product, -0.5 / h, difference));
  };
  for (const double h : {1e-2, 5e-3, 2.5e-3})
    EXPECT_NEAR(std::log2(error(h) / error(h / 2)), 2.0, 0.1) << "at h = " << h;
  EXPECT_LT(error(1e-5), 1e-7 * norm(product));
}

TEST(TangentTimes, IsSymmetric) {
  const Body body;
  const Nodal u = body.scattered(0.15, 1), v = body.scattered(1.0, 2), w = body.scattered(1.0, 3);
  const double vKw = dot(v, body.tangent_times(u, w)), wKv = dot(w, body.tangent_times(u, v));
  EXPECT_NEAR(vKw, wKv, 1e-12 * norm(v) * norm(body.tangent_times(u, w)));
}

// A grid that convects carries a linear displacement exactly: H at every particle is its gradient.
TEST(GridToParticles, LinearFieldsAreExact) {
  const Body body;
  const auto fields = body.fields(body.linear(gradient));
  const double j = tensor::det(tensor::identity() + gradient);
  for (int p = 0; p < body.particles.count(); ++p) {
    for (int c = 0; c < 3; ++c) {
      double u = 0.1 * (c + 1);
      for (int d = 0; d < 3; ++d) u += gradient(c, d) * body.particles.position(p, d);
      EXPECT_NEAR(fields.displacement(p, c), u, 1e-14 * 10);
    }
    EXPECT_NEAR(fields.jacobian(p), j, 1e-14 * 10);
    const Law& law = body.law(body.particles.material(p));
    const Tensor3 sigma = material::cauchy_stress(law, gradient);
    const double expected[6] = {sigma(0, 0), sigma(1, 1), sigma(2, 2),
                                sigma(0, 1), sigma(1, 2), sigma(2, 0)};
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(fields.stress(p, c), expected[c], 1e-13 * law.bulk_modulus);
    EXPECT_NEAR(fields.energy(p), material::energy(law, gradient), 1e-13 * law.bulk_modulus);
  }
}

TEST(ElementParticles, CountsParticlesTurnedInsideOut) {
  const Body body;
  const Tensor3 mirrored{{{0, 0, 0}, {0, -2.5, 0}, {0, 0, 0}}};
  const Nodal f = body.nodal("force");
  const InternalForce<shape::Linear, Law, Device> kernel{
      {body.box, body.particles, body.linear(mirrored)}, body.law, f};
  EXPECT_EQ((for_each_element<2, Space>("force", body.box, kernel)), body.particles.count());
}

// A base state (as after a grid reset) and the displacement since: F = f F_base.
TEST(ElementParticles, ABaseGradientIsCarriedOn) {
  Body body;
  const Tensor3 base{{{0.03, -0.10, 0.02}, {0.15, -0.04, 0.05}, {-0.02, 0.06, 0.09}}};
  body.particles.base_gradient =
      decltype(body.particles.base_gradient)("base", body.particles.count());
  for (int p = 0; p < body.particles.count(); ++p)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) body.particles.base_gradient(p, i, j) = base(i, j);
  const auto fields = body.fields(body.linear(gradient));
  const Tensor3 F = (tensor::identity() + gradient) * (tensor::identity() + base);
  const Tensor3 sigma = material::cauchy_stress(body.law(0), F - tensor::identity());
  EXPECT_NEAR(fields.jacobian(0), tensor::det(F), 1e-13);
  EXPECT_NEAR(fields.stress(0, 3), sigma(0, 1), 1e-12 * body.law(0).bulk_modulus);
}

}  // namespace
}  // namespace stroma::transfer
