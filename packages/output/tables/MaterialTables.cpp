// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/tables/MaterialTables.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/tables/TableText.hpp"

namespace stroma::output {
namespace {

/// What stands at the head of each row of a quantity.
std::string names_of(const std::string& material, const TableQuantity& quantity) {
  return csv_field(material) + "," + quantity.name + "," + quantity.unit;
}

/// The rows of one material and quantity.
/// \param names     at the head of each
/// \param of        the distribution
/// \param rounding  by which values of this unit may differ and be the same
std::string histogram_rows(const std::string& names, const Distribution& of, double rounding) {
  const double range = of.maximum - of.minimum;
  if (range <= rounding) return names + csv_numbers({of.minimum, of.maximum, of.volume}) + "\n";
  const auto edge = [&](std::size_t n) {
    return n == of.bins.size()
               ? of.maximum
               : of.minimum + range * static_cast<double>(n) / static_cast<double>(of.bins.size());
  };
  std::string rows;
  for (std::size_t bin = 0; bin < of.bins.size(); ++bin)
    rows += names + csv_numbers({edge(bin), edge(bin + 1), of.bins[bin]}) + "\n";
  return rows;
}

}  // namespace

GroupedParticles by_material(const ParticleSet& set, std::size_t materials) {
  GroupedParticles particles;
  particles.groups.of.assign(set.material, set.material + set.count);
  particles.groups.count = materials;
  for (std::size_t q = 0; q < table_quantities().size(); ++q)
    particles.quantities.push_back(static_cast<Quantity>(q));
  return particles;
}

void write_material_tables(const base::Communicator& communicator, const RunFiles& files,
                           std::int64_t step, double time,
                           const std::vector<std::string>& materials,
                           const GroupedParticles& particles) {
  std::map<std::string, double> largest;  // (unit)
  for (const Quantity q : particles.quantities)
    for (const Distribution& of : particles.found[q]) {
      double& size = largest[table_quantities()[q].unit];
      size = std::max({size, std::abs(of.minimum), std::abs(of.maximum)});
    }
  base::collectively(communicator, [&] {
    if (!communicator.is_root()) return;
    std::string summary =
        "step,time,material,quantity,unit,volume,mean,minimum,p05,p25,p50,p75,p95,maximum\n";
    std::string histograms = "material,quantity,unit,low,high,volume\n";
    for (std::size_t m = 0; m < materials.size(); ++m)
      for (const Quantity q : particles.quantities) {
        const Distribution& of = particles.found[q][m];
        if (of.volume <= 0.0) continue;
        const TableQuantity& quantity = table_quantities()[q];
        const std::string names = names_of(materials[m], quantity);
        summary += std::to_string(step) + "," + csv_number(time) + "," + names +
                   csv_numbers({of.volume, of.mean, of.minimum}) + csv_numbers(of.percentiles) +
                   csv_numbers({of.maximum}) + "\n";
        histograms += histogram_rows(names, of, 1e-9 * largest[quantity.unit]);
      }
    replace_file(files.file("materials.csv"), summary);
    replace_file(files.file("histograms.csv"), histograms);
  });
}

}  // namespace stroma::output
