// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/body/Filling.hpp"

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

}  // namespace stroma::mechanics
