// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/BarelyFilled.hpp"

#include "stroma/base/Log.hpp"

namespace stroma::mechanics {
namespace {

/// With so much of it or more, barely filled elements are no harder to solve for than others.
constexpr double firm_stabilization = 1e-3;
/// Beside barely filled elements, those filled by so much or less are solved for together with
/// them.
constexpr double soft_share = 0.7;

/// The share of fictitious points in u . force(balance).
template <class Force>
double share_in_work(const MomentumBalance& balance, const grid::Vector& u, const Force& force) {
  Problem problem = balance.problem();
  problem.method.stabilization = 0.0;
  MomentumBalance particles_alone(balance.halo().communicator(), balance.halo().partition(),
                                  balance.body().particles(), problem, 0.0, false);
  particles_alone.set_load(balance.load());
  particles_alone.follow(balance);
  grid::Vector whole(balance.owned_map()), of_particles(balance.owned_map());
  force(balance, whole);
  force(particles_alone, of_particles);
  const double work = u.dot(whole);
  return work == 0.0 ? 0.0 : 1.0 - u.dot(of_particles) / work;
}

}  // namespace

std::int64_t count_barely_filled(const MomentumBalance& balance) {
  const auto missing = balance.body().missing_volume(0.5);
  std::int64_t count = 0;
  Kokkos::parallel_reduce(
      "barely filled",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(missing.extent(0))),
      KOKKOS_LAMBDA(const int e, std::int64_t& sum) { sum += missing(e) > 0.0 ? 1 : 0; }, count);
  return balance.halo().communicator().sum(count);
}

std::string barely_filled_note(const MomentumBalance& balance) {
  const std::int64_t count = count_barely_filled(balance);
  if (count == 0) return "";
  const double stabilization = balance.problem().method.stabilization;
  return base::format("%lld element%s filled by less than half; ", static_cast<long long>(count),
                      count == 1 ? " is" : "s are") +
         (stabilization > 0.0
              ? base::format("Grid|Stabilization = %g keeps their nodes in place", stabilization)
              : "with Grid|Stabilization = 0 some of their nodes may be held by nothing");
}

Kokkos::View<std::uint8_t*, grid::Device> barely_held_elements(const MomentumBalance& balance) {
  if (balance.problem().method.stabilization >= firm_stabilization ||
      count_barely_filled(balance) == 0)
    return {};
  const auto missing = balance.body().missing_volume(soft_share);
  const Kokkos::View<std::uint8_t*, grid::Device> held("barely held", missing.extent(0));
  Kokkos::parallel_for(
      "barely held",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(missing.extent(0))),
      KOKKOS_LAMBDA(const int e) { held(e) = missing(e) > 0.0 ? 1 : 0; });
  return held;
}

double stabilization_share(const MomentumBalance& balance, const grid::Vector& u) {
  return share_in_work(balance, u, [&](const MomentumBalance& of, grid::Vector& force) {
    of.internal_force(u, force);
  });
}

double small_stabilization_share(const MomentumBalance& balance, const grid::Vector& v) {
  const grid::Vector base(balance.owned_map());
  return share_in_work(balance, v, [&](const MomentumBalance& of, grid::Vector& force) {
    of.tangent_times(base, v, force);
  });
}

}  // namespace stroma::mechanics
