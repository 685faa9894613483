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

Kokkos::View<double*, grid::Device> missing_in(const MomentumBalance& balance, double share = 0.5) {
  const grid::Halo& halo = balance.halo();
  return missing_volume(element_box(halo.partition(), halo.communicator().rank()),
                        balance.particles(), share);
}

}  // namespace

transfer::ElementBox element_box(const grid::Partition& partition, int rank) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(rank);
  transfer::ElementBox box;
  box.flat = grid.flat;
  box.beyond = grid.width - 1;
  box.centered = grid.centered;
  for (int d = 0; d < 3; ++d) {
    box.elements[d] = static_cast<int>(elements.extent(d));
    box.first[d] = static_cast<int>(elements.begin[d]);
    box.all[d] = static_cast<int>(grid.elements[d]);
    box.corner[d] = grid.origin[d] + static_cast<double>(elements.begin[d]) * grid.spacing[d];
    box.spacing[d] = grid.spacing[d];
    box.inverse_spacing[d] = 1.0 / grid.spacing[d];
  }
  return box;
}

Kokkos::View<double*, grid::Device> missing_volume(
    const transfer::ElementBox& box, const particles::Particles<grid::Device>& particles,
    double share) {
  const std::size_t count = particles.element_begin.extent(0) - 1;
  const Kokkos::View<double*, grid::Device> missing("missing volume", count);
  Kokkos::parallel_for(
      "missing volume", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) {
        double filled = 0.0;
        for (int p = particles.element_begin(e); p < particles.element_begin(e + 1); ++p) {
          tensor::Tensor3 H;
          if (particles.base_gradient.extent(0) != 0)
            for (int c = 0; c < 3; ++c)
              for (int d = 0; d < 3; ++d) H(c, d) = particles.base_gradient(p, c, d);
          filled += particles.volume(p) * (1.0 + tensor::det_minus_one(H));
        }
        const int index[3] = {e % box.elements[0], e / box.elements[0] % box.elements[1],
                              e / (box.elements[0] * box.elements[1])};
        double element_volume = 1.0;
        for (int d = 0; d < 3; ++d) {
          double lower, upper;
          box.within_ends(d, index[d], lower, upper);
          element_volume *= (upper - lower) * box.spacing[d];
        }
        if (filled > 0.0 && filled < share * element_volume) missing(e) = element_volume - filled;
      });
  return missing;
}

std::int64_t count_barely_filled(const MomentumBalance& balance) {
  const auto missing = missing_in(balance);
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
  const double stabilization = balance.problem().stabilization;
  return base::format("%lld elements are filled by less than half; ",
                      static_cast<long long>(count)) +
         (stabilization > 0.0
              ? base::format("Grid|Stabilization = %g keeps their nodes in place", stabilization)
              : "with Grid|Stabilization = 0 some of their nodes may be held by nothing");
}

Kokkos::View<std::uint8_t*, grid::Device> barely_held_elements(const MomentumBalance& balance) {
  if (balance.problem().stabilization >= firm_stabilization || count_barely_filled(balance) == 0)
    return {};
  const auto missing = missing_in(balance, soft_share);
  const Kokkos::View<std::uint8_t*, grid::Device> held("barely held", missing.extent(0));
  Kokkos::parallel_for(
      "barely held",
      Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(missing.extent(0))),
      KOKKOS_LAMBDA(const int e) { held(e) = missing(e) > 0.0 ? 1 : 0; });
  return held;
}

double stabilization_share(const MomentumBalance& balance, const grid::Vector& u) {
  Problem problem = balance.problem();
  problem.stabilization = 0.0;
  const MomentumBalance particles_alone(balance.halo().communicator(), balance.halo().partition(),
                                        balance.particles(), problem, 0.0, false);
  grid::Vector whole(balance.owned_map()), of_particles(balance.owned_map());
  balance.internal_force(u, whole);
  particles_alone.internal_force(u, of_particles);
  const double work = u.dot(whole);
  return work == 0.0 ? 0.0 : 1.0 - u.dot(of_particles) / work;
}

}  // namespace stroma::mechanics
