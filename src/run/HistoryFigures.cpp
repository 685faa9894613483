// SPDX-License-Identifier: BSD-3-Clause

#include "run/HistoryFigures.hpp"

#include <algorithm>

#include "stroma/tensor/Tensor3.hpp"

namespace stroma {

output::HistoryRow with_figures(output::HistoryRow row, const base::Communicator& communicator,
                                const mechanics::Body& body, const grid::Vector& u) {
  const auto& particles = body.particles();
  const std::size_t materials = body.problem().laws.size();
  std::vector<double> sums(2 * materials + 1, 0.0);  // volume, stress * volume; energy
  std::vector<double> largest(materials, 0.0);
  body.field_layers(u)([&](int first, const transfer::ParticleFields<grid::Device>& fields) {
    const auto count = static_cast<int>(fields.jacobian.extent(0));
    for (int n = 0; n < count; ++n) {
      const int p = first + n;
      const std::size_t m = particles.material(p);
      const double volume = fields.jacobian(n) * particles.volume(p);
      const auto s = [&](int c) { return fields.stress(n, c); };
      const double von_mises =
          tensor::von_mises({{{s(0), s(3), s(5)}, {s(3), s(1), s(4)}, {s(5), s(4), s(2)}}});
      sums[2 * m] += volume;
      sums[2 * m + 1] += von_mises * volume;
      sums.back() += fields.energy(n) * particles.volume(p);
      largest[m] = std::max(largest[m], von_mises);
    }
  });
  communicator.sum_all(sums.data(), sums.size());
  row.strain_energy = sums.back();
  for (std::size_t m = 0; m < materials; ++m) {
    const double volume = sums[2 * m];
    row.materials.push_back(
        {volume, volume > 0.0 ? sums[2 * m + 1] / volume : 0.0, communicator.max(largest[m])});
  }
  return row;
}

}  // namespace stroma
