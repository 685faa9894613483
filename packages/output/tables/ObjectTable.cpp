// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/tables/ObjectTable.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stroma/base/Error.hpp"
#include "stroma/output/files/WriteFile.hpp"
#include "stroma/output/tables/TableText.hpp"
#include "stroma/tensor/PrincipalValues.hpp"

namespace stroma::output {
namespace {

constexpr std::int64_t objects_at_once = 4096;

const char* const columns =
    "object,material,voxels,volume,centroid_x,centroid_y,centroid_z,axis_1,axis_2,axis_3,axis_1_x,"
    "axis_1_y,axis_1_z,von_mises_mean,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx,"
    "principal_stress_1,principal_direction_x,principal_direction_y,principal_direction_z,"
    "strain_xx,strain_yy,strain_zz,strain_xy,strain_yz,strain_zx,dipole_xx,dipole_yy,dipole_zz,"
    "dipole_xy,dipole_yz,dipole_zx,deformed_volume\n";

/// Principal values, descending, and the axis of the largest, whose largest component is positive.
struct Principal {
  std::array<double, 3> value, axis;
};

Principal principal_of(const tensor::Tensor3& a) {
  const tensor::PrincipalAxes found = tensor::principal_axes(a);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](int m, int n) { return found.value[m] > found.value[n]; });
  Principal principal{};
  double largest = 0.0;
  for (int n = 0; n < 3; ++n) {
    const auto i = static_cast<std::size_t>(n);
    principal.value[i] = found.value[order[i]];
    principal.axis[i] = found.axes(n, order[0]);
    if (std::abs(principal.axis[i]) > std::abs(largest)) largest = principal.axis[i];
  }
  for (double& component : principal.axis) component *= largest < 0.0 ? -1.0 : 1.0;
  return principal;
}

/// The mean of (x - centroid) (x - centroid)^T over the voxels, as boxes [um^2], and the centroid
/// [um]. Sums are taken about the voxel next to the centroid, so that integers lose no digits.
tensor::Tensor3 spread_of(const image::ObjectMoments& object, const ObjectLattice& lattice,
                          std::array<double, 3>& centroid) {
  const auto n = static_cast<double>(object.voxels);
  std::array<std::int64_t, 3> middle{};
  std::array<double, 3> off{};  // the centroid from there [voxels]
  for (std::size_t d = 0; d < 3; ++d) {
    middle[d] = (2 * object.sum[d] + object.voxels) / (2 * object.voxels);
    off[d] = static_cast<double>(object.sum[d] - object.voxels * middle[d]) / n;
    centroid[d] =
        lattice.origin[d] + (static_cast<double>(middle[d]) + 0.5 + off[d]) * lattice.voxel_size[d];
  }
  std::array<double, 6> spread{};
  for (std::size_t c = 0; c < 6; ++c) {
    const std::size_t a = c % 3, b = c < 3 ? a : (a + 1) % 3;
    const std::int64_t product = object.products[c] - middle[a] * object.sum[b] -
                                 middle[b] * object.sum[a] + object.voxels * middle[a] * middle[b];
    spread[c] = (static_cast<double>(product) / n - off[a] * off[b] + (c < 3 ? 1.0 / 12.0 : 0.0)) *
                lattice.voxel_size[a] * lattice.voxel_size[b];
  }
  return tensor::symmetric(spread.data());
}

std::vector<double> list(const double* values, std::size_t count) {
  return {values, values + count};
}

/// Size, place and shape.
std::string geometry(const image::ObjectMoments& object, const ObjectLattice& lattice) {
  std::array<double, 3> centroid{};
  const Principal spread = principal_of(spread_of(object, lattice, centroid));
  const double voxel = lattice.voxel_size[0] * lattice.voxel_size[1] * lattice.voxel_size[2];
  std::array<double, 3> axes{};
  for (std::size_t d = 0; d < 3; ++d) axes[d] = 2.0 * std::sqrt(5.0 * spread.value[d]);
  return csv_numbers({static_cast<double>(object.voxels) * voxel}) +
         csv_numbers(list(centroid.data(), 3)) + csv_numbers(list(axes.data(), 3)) +
         csv_numbers(list(spread.axis.data(), 3));
}

/// Means over the deformed volume, and their products with it; empty fields where no particle is.
/// \param stress  gets the largest principal value of the mean stress
std::string mechanics(const double* sums, double& stress) {
  const double volume = sums[0];
  if (volume <= 0.0) {
    stress = -HUGE_VAL;
    return std::string(1 + 6 + 1 + 3 + 6 + 6, ',') + ",0";
  }
  std::array<double, ObjectSums::count> mean{};
  for (std::size_t n = 1; n < mean.size(); ++n) mean[n] = sums[n] / volume;
  const Principal principal = principal_of(tensor::symmetric(&mean[2]));
  stress = principal.value[0];
  return csv_numbers({mean[1]}) + csv_numbers(list(&mean[2], 6)) + csv_numbers({stress}) +
         csv_numbers(list(principal.axis.data(), 3)) + csv_numbers(list(&mean[8], 6)) +
         csv_numbers(list(&sums[2], 6)) + csv_numbers({volume});
}

/// Objects of consecutive numbers, whose sums all ranks have.
struct Block {
  static constexpr std::size_t integers = 11;
  std::int64_t first, count;
  std::vector<std::int64_t> moments;  // (object, label voxels sum products)
  std::vector<double> sums;           // (object, sum)

  Block(const base::Communicator& communicator, std::int64_t first_number, std::int64_t number,
        const image::NumberedObjects& objects, const ObjectSums& of_particles)
      : first(first_number),
        count(number),
        moments(static_cast<std::size_t>(count) * integers, 0),
        sums(static_cast<std::size_t>(count) * ObjectSums::count, 0.0) {
    const auto kept = static_cast<std::int64_t>(objects.moments.size());
    for (std::int64_t n = std::max(first, objects.first);
         n < std::min(first + count, objects.first + kept); ++n) {
      const image::ObjectMoments& of = objects.moments[static_cast<std::size_t>(n - objects.first)];
      std::int64_t* row = &moments[static_cast<std::size_t>(n - first) * integers];
      *row++ = of.label;
      *row++ = of.voxels;
      row = std::copy(of.sum.begin(), of.sum.end(), row);
      std::copy(of.products.begin(), of.products.end(), row);
    }
    const auto& all = of_particles.sums();
    for (auto found = all.lower_bound(static_cast<std::int32_t>(first));
         found != all.end() && found->first < first + count; ++found)
      std::copy(found->second.begin(), found->second.end(),
                &sums[static_cast<std::size_t>(found->first - first) * ObjectSums::count]);
    communicator.sum_all(moments.data(), moments.size());
    communicator.sum_all(sums.data(), sums.size());
  }

  image::ObjectMoments moments_of(std::int64_t n) const {
    const std::int64_t* row = &moments[static_cast<std::size_t>(n) * integers];
    return {row[0],
            row[1],
            {row[2], row[3], row[4]},
            {row[5], row[6], row[7], row[8], row[9], row[10]}};
  }
};

}  // namespace

void ObjectSums::add(std::int64_t p, const ParticleAt& particle, double volume) {
  const std::int32_t object = (*object_)[static_cast<std::size_t>(p)];
  if (object == 0) return;
  if (object != last_object_) {
    last_ = &sums_[object];
    last_object_ = object;
  }
  Sums& sums = *last_;
  const tensor::Tensor3 strain = particle.strain();
  sums[0] += volume;
  sums[1] += volume * tensor::von_mises(particle.stress());
  for (int c = 0; c < 6; ++c) {
    const int a = c % 3, b = c < 3 ? a : (a + 1) % 3;
    sums[static_cast<std::size_t>(2 + c)] += volume * particle.stress_component(c);
    sums[static_cast<std::size_t>(8 + c)] += volume * strain(a, b);
  }
}

MostStressed write_object_table(const base::Communicator& communicator, const RunFiles& files,
                                const std::map<std::int64_t, std::string>& materials,
                                const ObjectLattice& lattice, const image::NumberedObjects& objects,
                                const ObjectSums& sums) {
  std::optional<Draft> draft;
  MostStressed most;
  for (std::int64_t first = 1; first == 1 || first <= objects.count; first += objects_at_once) {
    const Block block(communicator, first, std::min(objects_at_once, objects.count + 1 - first),
                      objects, sums);
    std::string rows = first == 1 ? columns : "";
    for (std::int64_t n = 0; n < block.count; ++n) {
      const image::ObjectMoments object = block.moments_of(n);
      const auto named = materials.find(object.label);
      const std::string material = named == materials.end() ? "" : named->second;
      double stress = 0.0;
      const std::string of_particles =
          mechanics(&block.sums[static_cast<std::size_t>(n) * ObjectSums::count], stress);
      if (std::isfinite(stress) && (most.object == 0 || stress > most.stress))
        most = {first + n, object.voxels, material, stress};
      if (communicator.is_root())
        rows += std::to_string(first + n) + "," + csv_field(material) + "," +
                std::to_string(object.voxels) + geometry(object, lattice) + of_particles + "\n";
    }
    base::collectively(communicator, [&] {
      if (!communicator.is_root()) return;
      if (!draft) draft.emplace(files.file("objects.csv"));
      draft->add(rows);
      if (first + objects_at_once > objects.count) draft->finish();
    });
  }
  return most;
}

}  // namespace stroma::output
