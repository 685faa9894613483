// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/tables/WallTable.hpp"

#include "stroma/base/Error.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/tables/TableText.hpp"

namespace stroma::output {

std::uint16_t wall_group(double distance, double bin_width, std::size_t material,
                         std::size_t materials) {
  const double bin = distance / bin_width + 1e-6;  // distances have the digits of floats
  if (!(bin < static_cast<double>(wall_bins))) return Groups::none;
  return static_cast<std::uint16_t>(static_cast<std::size_t>(bin) * materials + material);
}

void write_wall_table(const base::Communicator& communicator, const RunFiles& files,
                      const std::vector<std::string>& materials, double bin_width,
                      const std::vector<WallParticles>& walls) {
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::string text =
        "label_material,material,low,high,volume,von_mises_mean,von_mises_p05,von_mises_p50,"
        "von_mises_p95,principal_stress_1_mean,principal_strain_1_mean\n";
    for (const WallParticles& wall : walls)
      for (std::size_t m = 0; m < materials.size(); ++m)
        for (std::size_t bin = 0; bin < wall_bins; ++bin) {
          const auto of = [&](Quantity quantity) -> const Distribution& {
            return wall.particles.found[quantity][bin * materials.size() + m];
          };
          const Distribution& stress = of(von_mises);
          if (stress.volume <= 0.0) continue;
          text += csv_field(materials[wall.material]) + "," + csv_field(materials[m]) +
                  csv_numbers({static_cast<double>(bin) * bin_width,
                               static_cast<double>(bin + 1) * bin_width, stress.volume, stress.mean,
                               stress.percentiles[0], stress.percentiles[2], stress.percentiles[4],
                               of(principal_stress_1).mean, of(principal_strain_1).mean}) +
                  "\n";
        }
    replace_file(files.file("wall_distance.csv"), text);
  });
}

}  // namespace stroma::output
