/// \file
/// A slender cantilever under a tip load, bent far, on a grid that is reset. Claim V-CANT-1,
/// docs/verification.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/LoadSteps.hpp"
#include "support/ShapeChoices.hpp"

namespace stroma {
namespace {

using mechanics::Face;
using mechanics::ImposedBy;
using test::Specimen;

int env(const char* name, int fallback) {
  const char* v = std::getenv(name);
  return v ? std::atoi(v) : fallback;
}

/// w / L and u / L of the tip: down, and back towards the clamp.
struct Tip {
  double w, u;
};

TEST(Cantilever, Explore) {
  const auto choice = test::shape_choices()[static_cast<std::size_t>(env("SHAPE", 1))];
  const bool reset = env("RESET", 1);
  const int across = env("ACROSS", 4), slender = env("SLENDER", 40), steps = env("STEPS", 40);
  const double thickness = 1.0, L = thickness * slender;
  const double mu = 1000.0;
  const material::NeoHookean law{mu, 2.0 / 3.0 * mu};  // nu = 0, E = E' = 2 mu
  const double EI = 2.0 * mu * std::pow(thickness, 3) / 12.0;
  Specimen specimen;
  choice.apply_to(specimen);
  specimen.reset = reset;
  specimen.stabilization = reset ? 0.0001 * env("STAB", 100) : 0.0;
  specimen.plane_strain = true;
  specimen.elements = {across * slender, across, 1};
  const double h = thickness / across;
  specimen.spacing = {h, h, 1.0};
  specimen.layout = {particles::Layout::per_element, 1, env("PPE", 3)};
  specimen.laws = {law};
  mechanics::ExternalForce load;
  load.traction = std::array<double, 3>{0.0, -10.0 * EI / (L * L) / thickness, 0.0};
  load.face = Face::x_upper;
  specimen.forces = {{"tip", load}};
  specimen.conditions = {{"clamp", test::hold(Face::x_lower, "xyz")}};
  specimen.conditions[0].second.imposed_by = ImposedBy::nodes;
  mechanics::MovingBody body = specimen.moving_body(base::Communicator::self());
  solver::SolverParameters parameters = test::to_rounding();
  parameters.newton_tolerance = 1e-6;
  parameters.newton_iterations = 30;
  parameters.linear_tolerance = 1e-10;
  solver::NewtonSolver newton(parameters, body.balance());
  double load_now = 0.0, step_size = 1.0 / steps;
  int total = 0;
  while (load_now < 1.0 - 1e-9) {
    solver::begin_step(body, newton);
    grid::Vector u(body.balance().owned_map());
    const double next = load_now + step_size;
    try {
      const auto r = solver::solve_step(body, newton, next, u);
      total += r.iterations;
    } catch (const std::exception& e) {
      std::printf("load %.4f: %s\n", next, e.what());
      body.reject();
      step_size *= 0.5;
      if (step_size < 1e-4) return;
      continue;
    }
    const auto& particles = body.balance().particles();
    const auto fields = body.balance().particle_fields(u);
    const auto moved = body.balance().moved_particles(u);
    double sums[3] = {};
    double worst = 1, best = 1;
    for (int p = 0; p < particles.count(); ++p) {
      worst = std::min(worst, fields.jacobian(p));
      best = std::max(best, fields.jacobian(p));
      const double X = particles.undeformed_position(p, 0);
      if (X < L - h / env("PPE", 3)) continue;
      sums[0] += 1.0;
      for (int d = 0; d < 2; ++d)
        sums[1 + d] += fields.displacement(p, d) + moved.base_gradient(p, d, 0) * (L - X);
    }
    body.accept(next, u);
    load_now = next;
    std::printf("load %.4f alpha %.3f w/L %.5f u/L %.5f  its %d  J %.3f %.3f\n", next, 10 * next,
                -sums[2] / sums[0] / L, -sums[1] / sums[0] / L, total, worst, best);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace stroma
