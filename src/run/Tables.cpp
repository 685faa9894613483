// SPDX-License-Identifier: BSD-3-Clause

#include "run/Tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "run/MovingSupports.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/image/labels/WallDistance.hpp"
#include "stroma/output/tables/MaterialTables.hpp"
#include "stroma/particles/Fields.hpp"
#include "stroma/particles/Seeding.hpp"
#include "stroma/particles/Shares.hpp"

namespace stroma {
namespace {

constexpr std::size_t most_walls = 8;

/// The labels of the volume, those with the most voxels first. Collective.
std::vector<std::int32_t> labels_by_size(const base::Communicator& communicator,
                                         const material::NamedMaterials& materials,
                                         const voxels::LabelVolume& labels) {
  std::map<std::int32_t, std::size_t> place;
  for (const auto& named : materials) place.emplace(named.second.label, place.size());
  std::vector<std::int64_t> voxels(place.size(), 0);
  std::int32_t last = -1;
  std::size_t at = place.size();  // of no material: no particle is there
  for (const std::int32_t label : labels.values) {
    if (label != last) at = place.count(label) == 0 ? place.size() : place.at(label);
    last = label;
    if (at < place.size()) ++voxels[at];
  }
  communicator.sum_all(voxels.data(), voxels.size());
  std::vector<std::int32_t> found;
  for (const auto& [label, place_of_label] : place)
    if (voxels[place_of_label] > 0) found.push_back(label);
  std::stable_sort(found.begin(), found.end(), [&](std::int32_t a, std::int32_t b) {
    return voxels[place.at(a)] > voxels[place.at(b)];
  });
  return found;
}

/// The voxels that the specimen's particles lie in.
particles::ParticleVoxels voxels_of(const Deck& deck, const Specimen& specimen) {
  const particles::HostParticles particles = particles::on_host(specimen.particles);
  const std::array<std::int64_t, 3>& size = specimen.image.size;
  const std::array<double, 3>& voxel_size = specimen.image.voxel_size.um;
  particles::ParticleVoxels where;
  if (particles.count() == 0) return where;
  for (std::size_t d = 0; d < 3; ++d) {  // a box of them, with a voxel around for rounding
    double low = particles.position(0, d), high = low;
    for (int p = 0; p < particles.count(); ++p) {
      low = std::min(low, particles.position(p, d));
      high = std::max(high, particles.position(p, d));
    }
    const auto voxel = [&](double x, std::int64_t around) {
      const double place = std::floor((x - specimen.body.origin[d]) / voxel_size[d]);
      return std::clamp<std::int64_t>(static_cast<std::int64_t>(place) + around, 0, size[d] - 1);
    };
    where.box.first[d] = voxel(low, -1);
    where.box.count[d] = voxel(high, 1) - where.box.first[d] + 1;
  }
  const particles::Shares shares(deck.parameters.particles, specimen.body, size, voxel_size);
  where.number.reserve(static_cast<std::size_t>(particles.count()));
  for (int p = 0; p < particles.count(); ++p) {
    std::array<std::int64_t, 3> voxel = shares.of(particles.id(p)).voxel;
    for (std::size_t d = 0; d < 3; ++d) voxel[d] -= where.box.first[d];
    where.number.push_back(static_cast<std::size_t>(
        voxel[0] + where.box.count[0] * (voxel[1] + where.box.count[1] * voxel[2])));
  }
  return where;
}

double bin_width(const output::ObjectLattice& lattice) {
  return *std::min_element(lattice.voxel_size.begin(), lattice.voxel_size.end());
}

}  // namespace

Tables::Tables(const base::Communicator& communicator, const Deck& deck, const Specimen& specimen,
               const voxels::LabelVolume& labels)
    : communicator_(communicator),
      are_wanted_(deck.parameters.output.tables),
      materials_(names(deck.parameters.materials.materials)),
      lattice_{labels.voxel_size, {}} {
  if (!are_wanted_) return;
  const base::Stage stage("objects and walls");
  const material::NamedMaterials& materials = deck.parameters.materials.materials;
  for (const auto& [name, material] : materials) material_of_label_[material.label] = name;
  for (std::size_t d = 0; d < 3; ++d) lattice_.origin[d] = specimen.body.origin[d];
  const std::vector<std::int32_t> by_size = labels_by_size(communicator, materials, labels);
  const bool has_ground = by_size.size() > 1;
  if (has_ground) ground_ = material_of_label_.at(by_size.front());
  const particles::ParticleVoxels where = voxels_of(deck, specimen);
  find_objects(where, labels, has_ground ? by_size.front() : -1);
  for (std::size_t n = has_ground ? 1 : 0; n < by_size.size() && walls_.size() < most_walls; ++n)
    find_walls(where, specimen, labels, by_size[n]);
}

void Tables::find_objects(const particles::ParticleVoxels& where, const voxels::LabelVolume& labels,
                          std::int32_t ground) {
  objects_ = image::number_objects(communicator_, labels, ground);
  object_ = particles::at_particles(communicator_, where, objects_.number);
  objects_.number = {};
}

void Tables::find_walls(const particles::ParticleVoxels& where, const Specimen& specimen,
                        const voxels::LabelVolume& labels, std::int32_t label) {
  const double width = bin_width(lattice_);
  const std::vector<float> distance = particles::at_particles(
      communicator_, where,
      image::wall_distance(communicator_, labels, label, width * output::wall_bins));
  const auto material =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), specimen.particles.material);
  const auto named = std::find(materials_.begin(), materials_.end(), material_of_label_.at(label));
  output::WallParticles wall{static_cast<std::size_t>(named - materials_.begin()), {}};
  wall.particles.quantities = {output::von_mises, output::principal_stress_1,
                               output::principal_strain_1};
  wall.particles.groups.count = output::wall_bins * materials_.size();
  for (std::size_t p = 0; p < distance.size(); ++p)
    wall.particles.groups.of.push_back(
        output::wall_group(distance[p], width, material(p), materials_.size()));
  walls_.push_back(std::move(wall));
}

std::string Tables::write(const output::RunFolder& folder, const output::HistoryRow& row,
                          const output::ParticleSet& particles, const output::StatePieces& states,
                          double room) {
  if (!are_wanted_) return "";
  const base::Stage stage("tables");
  output::GroupedParticles materials = output::by_material(particles, materials_.size());
  std::vector<output::GroupedParticles*> all{&materials};
  for (output::WallParticles& wall : walls_) all.push_back(&wall.particles);
  output::ObjectSums sums(object_);
  const double numbers =
      room / (8.0 * static_cast<double>(std::max<std::int64_t>(particles.count, 1)));
  const auto at_once =
      static_cast<std::size_t>(communicator_.min(std::clamp(numbers - 2.0, 2.0, 8.0)));
  output::find_distributions(communicator_, particles, states, all, at_once,
                             [&](std::int64_t p, const output::ParticleAt& particle,
                                 double volume) { sums.add(p, particle, volume); });
  output::write_material_tables(communicator_, folder, row.step, row.time, materials_, materials);
  output::write_wall_table(communicator_, folder, materials_, bin_width(lattice_), walls_);
  const output::MostStressed most = output::write_object_table(
      communicator_, folder, material_of_label_, lattice_, objects_, sums);
  if (most.object == 0 || most.stress == 0.0) return "";
  return base::format(
      "objects    %lld%s; the largest principal value of a mean stress, %.4g Pa, is that of number "
      "%lld (%s, %lld voxel%s)",
      static_cast<long long>(objects_.count),
      ground_.empty() ? "" : (" that are not " + ground_).c_str(), most.stress,
      static_cast<long long>(most.object), most.material.c_str(),
      static_cast<long long>(most.voxels), most.voxels == 1 ? "" : "s");
}

}  // namespace stroma
