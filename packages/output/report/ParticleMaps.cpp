// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/report/ParticleMaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stroma/tensor/PrincipalValues.hpp"

namespace stroma::output {
namespace {

/// A field of a map, and how it follows from a cell's means of variables of the file.
struct MappedField {
  std::string name, unit;
  std::vector<std::string> variables;
  double (*value)(const double* means);
};

double as_it_is(const double* means) { return *means; }

double length_of(const double* means) { return std::hypot(means[0], means[1], means[2]); }

/// Of the components xx yy zz xy yz zx.
double largest_principal(const double* e) {
  return tensor::principal_values({{{e[0], e[3], e[5]}, {e[3], e[1], e[4]}, {e[5], e[4], e[2]}}})(
      0);
}

/// Those whose variables the file has.
std::vector<MappedField> fields_of(const std::vector<std::string>& variables) {
  std::vector<MappedField> fields{
      {"von_mises", "Pa", {"von_mises"}, as_it_is},
      {"principal_stress_1", "Pa", {"principal_stress_1"}, as_it_is},
      {"principal_strain_1",
       "-",
       {"strain_xx", "strain_yy", "strain_zz", "strain_xy", "strain_yz", "strain_zx"},
       largest_principal},
      {"displacement", "um", {"displacement_x", "displacement_y", "displacement_z"}, length_of}};
  const auto lacks = [&](const MappedField& field) {
    return !std::all_of(field.variables.begin(), field.variables.end(), [&](const auto& name) {
      return std::count(variables.begin(), variables.end(), name) > 0;
    });
  };
  fields.erase(std::remove_if(fields.begin(), fields.end(), lacks), fields.end());
  return fields;
}

std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> steps;
  if (count <= most)
    for (std::size_t s = 0; s < count; ++s) steps.push_back(s);
  else
    for (std::size_t s = 0; s < most; ++s) steps.push_back(s * (count - 1) / (most - 1));
  return steps;
}

template <class Use>
void for_cells(const MapLattice& lattice, const ParticlePiece& piece, const Use& use) {
  for (std::size_t p = 0; p < piece.count; ++p)
    use(p, lattice.cell_of(piece.position[0][p], piece.position[1][p], piece.position[2][p]));
}

/// The material of each cell, and its volume [um^3]. A vote by volume in one pass: a material that
/// has more than half of a cell wins it.
std::vector<float> volumes(const ParticleReader& particles, ParticleMaps& maps) {
  std::vector<float> volume(maps.lattice.cells()), lead(maps.lattice.cells());
  maps.material.assign(maps.lattice.cells(), 0);
  particles.for_pieces(0, {}, [&](const ParticlePiece& piece) {
    const auto material = static_cast<std::uint8_t>(std::min<std::size_t>(piece.material + 1, 255));
    for_cells(maps.lattice, piece, [&](std::size_t p, std::size_t cell) {
      const auto weight = static_cast<float>(piece.volume[p]);
      volume[cell] += weight;
      lead[cell] += maps.material[cell] == material ? weight : -weight;
      if (lead[cell] >= 0.0f) return;
      maps.material[cell] = material;
      lead[cell] = -lead[cell];
    });
  });
  return volume;
}

}  // namespace

ParticleMaps particle_maps(const ParticleReader& particles, std::size_t most_steps,
                           std::size_t most_values) {
  const std::vector<MappedField> fields = fields_of(particles.variables());
  ParticleMaps maps;
  maps.materials = particles.materials();
  maps.steps_in_file = particles.steps();
  maps.steps = evenly(particles.steps(), most_steps);
  maps.lattice = merged(lattice_of(particles),
                        most_values / std::max<std::size_t>(maps.steps.size() * fields.size(), 1));
  const std::vector<float> volume = volumes(particles, maps);

  std::vector<std::string> variables;
  for (const MappedField& field : fields) {
    maps.fields.push_back({field.name, field.unit, {}});
    variables.insert(variables.end(), field.variables.begin(), field.variables.end());
  }
  std::vector<std::vector<float>> sums(variables.size());
  std::vector<double> means(variables.size());
  for (const std::size_t step : maps.steps) {
    for (std::vector<float>& sum : sums) sum.assign(volume.size(), 0.0f);
    particles.for_pieces(step, variables, [&](const ParticlePiece& piece) {
      for_cells(maps.lattice, piece, [&](std::size_t p, std::size_t cell) {
        for (std::size_t v = 0; v < variables.size(); ++v)
          sums[v][cell] += static_cast<float>(piece.values[v][p] * piece.volume[p]);
      });
    });
    for (FieldMap& field : maps.fields)
      field.values.emplace_back(volume.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t cell = 0; cell < volume.size(); ++cell) {
      if (!(volume[cell] > 0.0f)) continue;
      for (std::size_t v = 0; v < variables.size(); ++v)
        means[v] = static_cast<double>(sums[v][cell]) / static_cast<double>(volume[cell]);
      const double* first = means.data();
      for (std::size_t f = 0; f < fields.size(); ++f) {
        maps.fields[f].values.back()[cell] = static_cast<float>(fields[f].value(first));
        first += fields[f].variables.size();
      }
    }
  }
  return maps;
}

}  // namespace stroma::output
