// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/solver/Advice.hpp"

#include <algorithm>
#include <limits>

#include "stroma/base/Log.hpp"
#include "stroma/mechanics/BarelyFilled.hpp"
#include "stroma/solver/Preconditioner.hpp"

namespace stroma::solver {

using base::format;

namespace {

constexpr double resolved = 1e6;  // by single precision, measured: docs/theory.md

constexpr double nearly_incompressible = 1e5;  // bulk over shear modulus: nu = 0.499995

/// What the moduli of the particles of all ranks tell.
void find_contrasts(const mechanics::MomentumBalance& balance, Circumstances& known) {
  const particles::HostParticles particles = particles::on_host(balance.body().particles());
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (int p = 0; p < particles.count(); ++p) {
    const material::SmallStrainModuli moduli = balance.body().stress()->moduli_of(particles, p);
    least = std::min(least, moduli.shear);
    most = std::max(most, moduli.shear);
    known.incompressibility = std::max(known.incompressibility, moduli.bulk / moduli.shear);
  }
  const base::Communicator& communicator = balance.halo().communicator();
  known.contrast = communicator.max(most) / communicator.min(least);
  known.incompressibility = communicator.max(known.incompressibility);
}

}  // namespace

Circumstances circumstances(const SolverParameters& solver, const mechanics::GridParameters& grid,
                            const material::Compressibility& of_volume,
                            const mechanics::MomentumBalance& balance) {
  Circumstances known;
  find_contrasts(balance, known);
  known.is_single_precision =
      takes_stencil(solver.preconditioner, balance.halo().partition().grid());
  known.barely_filled = mechanics::count_barely_filled(balance);
  known.stabilization = balance.problem().method.stabilization;
  known.locking = mechanics::locking_note(grid, of_volume);
  const mechanics::Supports& supports = balance.supports();
  known.pieces = supports.pieces().count - supports.pieces().carried;
  known.has_free_motion = !supports.rigid_holds().empty();
  return known;
}

std::string contrast_note(const Circumstances& known) {
  if (!known.is_single_precision || known.contrast <= resolved) return "";
  return format(
      "the stiffest material is %.2g times stiffer than the softest, and the tangent of "
      "Preconditioner = Geometric Multigrid is in single precision: where stiff parts lie in the "
      "soft ones and steps fail, Solver|Preconditioner = Multigrid, in double precision, helps",
      known.contrast);
}

std::vector<std::string> advice(const Circumstances& known) {
  std::vector<std::string> all;
  if (known.barely_filled > 0)
    all.push_back(format("%lld elements are filled by less than half: ",
                         static_cast<long long>(known.barely_filled)) +
                  (known.stabilization > 0.0
                       ? format("a larger Grid|Stabilization (now %g)", known.stabilization)
                       : std::string("Grid|Stabilization = 1e-4 keeps their nodes in place")));
  const bool is_steep = known.contrast > resolved;
  if (is_steep)
    all.push_back(format("the stiffest material is %.2g times stiffer than the softest, and errors "
                         "of rounding grow with that: ",
                         known.contrast) +
                  (known.is_single_precision
                       ? "Solver|Preconditioner = Multigrid, whose tangent is "
                         "in double precision, or a lower modulus"
                       : "a lower modulus") +
                  "; from 1e6 times on, what is stiffer still changes forces by 1e-4 or less");
  if (known.incompressibility > nearly_incompressible)
    all.push_back(format(
        "a bulk modulus is %.2g times the shear modulus (Poisson's ratio %.9g), and errors of "
        "rounding grow with that: a Poisson Ratio of 0.4999 changes forces by 1e-4 or less",
        known.incompressibility,
        material::SmallStrainModuli{1.0, known.incompressibility}.poisson_ratio()));
  if (!known.locking.empty()) all.push_back(known.locking);
  if (known.has_free_motion)
    all.push_back("the boundary conditions leave a rigid motion free: " +
                  (known.pieces > 1
                       ? format("a support for each of the body's %lld pieces that carry load",
                                static_cast<long long>(known.pieces))
                       : std::string("a support against it")));
  if (known.is_single_precision && !is_steep)
    all.push_back(
        "slender bodies, and parts that hang on the rest by an edge or a corner: Solver|Preconditioner = Multigrid, "
        "whose tangent is in double precision");
  all.push_back("a smaller load, a smaller Loading|Smallest Step, or a finer grid there");
  return all;
}

}  // namespace stroma::solver
