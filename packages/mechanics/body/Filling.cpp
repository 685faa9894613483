// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/body/Filling.hpp"

#include <cmath>

#include "stroma/tensor/SmallDifference.hpp"
#include "stroma/tensor/Tensor3.hpp"

namespace stroma::mechanics {

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

namespace {

/// An element that holds its share to within this is full enough: ranks add parts up in orders of
/// their own, and what is filled by a half exactly must be so on any number of them.
constexpr double rounding = 1e-9;

/// Deformation gradient less the identity, at the base configuration.
KOKKOS_INLINE_FUNCTION tensor::Tensor3 base_gradient(
    const particles::Particles<grid::Device>& particles, int p) {
  tensor::Tensor3 H;
  if (particles.base_gradient.extent(0) != 0)
    for (int c = 0; c < 3; ++c)
      for (int d = 0; d < 3; ++d) H(c, d) = particles.base_gradient(p, c, d);
  return H;
}

/// Volume at the base configuration [um^3].
KOKKOS_INLINE_FUNCTION double base_volume(const particles::Particles<grid::Device>& particles,
                                          int p, const tensor::Tensor3& H) {
  return particles.volume(p) * (1.0 + tensor::det_minus_one(H));
}

/// Parts of an interval, in all 1, below 0, from 0 to 1, and above.
KOKKOS_INLINE_FUNCTION void parts_of(double centre, double half, double part[3]) {
  const double lower = centre - half, upper = centre + half, length = 2.0 * half;
  part[0] = lower < 0.0 ? (upper < 0.0 ? 1.0 : -lower / length) : 0.0;
  part[2] = upper > 1.0 ? (lower > 1.0 ? 1.0 : (upper - 1.0) / length) : 0.0;
  part[1] = 1.0 - part[0] - part[2];
}

/// (local element) volume of the particles that lie in it.
Kokkos::View<double*, grid::Device> volume_inside(
    const particles::Particles<grid::Device>& particles) {
  const std::size_t count = particles.element_begin.extent(0) - 1;
  const Kokkos::View<double*, grid::Device> filled("filled volume", count);
  Kokkos::parallel_for(
      "filled volume", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) {
        for (int p = particles.element_begin(e); p < particles.element_begin(e + 1); ++p)
          filled(e) += base_volume(particles, p, base_gradient(particles, p));
      });
  return filled;
}

/// (local element) volume of the parts of domains that lie in it. Ranks add them up at the second of
/// the nodes that an element sees along each axis, which is its own.
Kokkos::View<double*, grid::Device> volume_of_parts(
    const grid::Halo& halo, const transfer::ElementBox& box,
    const particles::Particles<grid::Device>& particles,
    const transfer::ParticleDomains<grid::Device>& domains) {
  constexpr int reach = 3;  // elements that a domain lies in, along each axis
  const grid::NodeView parts = halo.contributions();
  transfer::for_each_element<reach, grid::ExecutionSpace>(
      "parts of domains", box, KOKKOS_LAMBDA(const int i, const int j, const int k, std::int64_t&) {
        const int e = box.element(i, j, k), index[3] = {i, j, k};
        for (int p = particles.element_begin(e); p < particles.element_begin(e + 1); ++p) {
          const tensor::Tensor3 H = base_gradient(particles, p);
          const double volume = base_volume(particles, p, H);
          double edges[3], part[3][reach];
          domains.half_edges(particles.id, p, edges);
          for (int d = 0; d < 3; ++d) {
            double half = 0.0;
            for (int c = 0; c < 3; ++c) half += fabs((c == d ? 1.0 : 0.0) + H(d, c)) * edges[c];
            const double at = (particles.position(p, d) - box.corner[d]) * box.inverse_spacing[d];
            parts_of(at - index[d], half * box.inverse_spacing[d], part[d]);
          }
          for (int c = 0; c < (box.flat ? 1 : reach); ++c)
            for (int b = 0; b < reach; ++b)
              for (int a = 0; a < reach; ++a)
                parts(box.node(i + a, j + b, k + c), 0) +=
                    volume * part[0][a] * part[1][b] * (box.flat ? 1.0 : part[2][c]);
        }
      });
  grid::Vector all(halo.owned_map());
  halo.sum_to_owner(all);
  const grid::ConstNodeView whole = halo.gather(all);
  const std::size_t count = particles.element_begin.extent(0) - 1;
  const Kokkos::View<double*, grid::Device> filled("filled volume", count);
  Kokkos::parallel_for(
      "filled volume", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) {
        const int i = e % box.elements[0], j = e / box.elements[0] % box.elements[1],
                  k = e / (box.elements[0] * box.elements[1]);
        filled(e) = whole(box.node(i + 1, j + 1, k + 1), 0);
      });
  return filled;
}

}  // namespace

Kokkos::View<double*, grid::Device> missing_volume(
    const grid::Halo& halo, const transfer::ElementBox& box,
    const particles::Particles<grid::Device>& particles,
    const transfer::ParticleDomains<grid::Device>& domains, double share) {
  const auto filled =
      box.centered ? volume_of_parts(halo, box, particles, domains) : volume_inside(particles);
  const std::size_t count = particles.element_begin.extent(0) - 1;
  const Kokkos::View<double*, grid::Device> missing("missing volume", count);
  Kokkos::parallel_for(
      "missing volume", Kokkos::RangePolicy<grid::ExecutionSpace>(0, static_cast<int>(count)),
      KOKKOS_LAMBDA(const int e) {
        if (particles.element_begin(e) == particles.element_begin(e + 1)) return;
        const int index[3] = {e % box.elements[0], e / box.elements[0] % box.elements[1],
                              e / (box.elements[0] * box.elements[1])};
        double element_volume = 1.0;
        for (int d = 0; d < 3; ++d) {
          double lower, upper;
          box.within_ends(d, index[d], lower, upper);
          element_volume *= (upper - lower) * box.spacing[d];
        }
        if (filled(e) < (1.0 - rounding) * share * element_volume)
          missing(e) = element_volume - filled(e);
      });
  return missing;
}

}  // namespace stroma::mechanics
