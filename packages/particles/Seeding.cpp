// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/particles/Seeding.hpp"

#include <algorithm>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/particles/Fields.hpp"

namespace stroma::particles {

std::array<std::vector<double>, 3> layer_weights(const base::Communicator& communicator,
                                                 const grid::Grid& grid,
                                                 const voxels::LabelVolume& labels) {
  std::array<std::vector<double>, 3> filled;  // voxels of each plane of voxels
  for (std::size_t d = 0; d < 3; ++d)
    filled[d].assign(static_cast<std::size_t>(labels.size[d]), 0.0);
  std::size_t position = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k)
    for (std::size_t j = 0; j < filled[1].size(); ++j)
      for (std::size_t i = 0; i < filled[0].size(); ++i, ++position) {
        if (labels.values[position] < 0) continue;
        filled[0][i] += 1.0;
        filled[1][j] += 1.0;
        filled[2][static_cast<std::size_t>(labels.first_plane + k)] += 1.0;
      }
  std::array<std::vector<double>, 3> weights;
  for (std::size_t d = 0; d < 3; ++d) {
    communicator.sum_all(filled[d].data(), filled[d].size());
    const std::int64_t elements = grid.elements[d];
    for (std::int64_t e = 0; e < elements; ++e) {
      double weight = 0.0;
      for_each_piece(e, elements, labels.size[d],
                     [&](std::int64_t voxel, std::int64_t begin, std::int64_t end) {
                       const double share =
                           static_cast<double>(end - begin) / static_cast<double>(2 * elements);
                       weight += filled[d][static_cast<std::size_t>(voxel)] * share;
                     });
      weights[d].push_back(weight);
    }
  }
  return weights;
}

Particles<grid::Device> seed(const base::Communicator& communicator,
                             const ParticleParameters& parameters, const grid::Partition& partition,
                             const voxels::LabelVolume& labels,
                             const std::map<std::int32_t, int>& material_of_label,
                             ParticleVoxels* where) {
  const grid::Grid& grid = partition.grid();
  const grid::Box elements = partition.elements(communicator.rank());

  std::array<AxisLayout, 3> axis;
  voxels::Box voxels{};
  for (int d = 0; d < 3; ++d) {
    axis[d] = axis_layout(parameters, grid, d, elements.begin[d], elements.end[d], labels.size[d],
                          labels.voxel_size[d]);
    if (axis[d].voxel.empty()) continue;
    voxels.first[d] = axis[d].voxel.front();
    voxels.count[d] = axis[d].voxel.back() - axis[d].voxel.front() + 1;
  }
  const std::vector<std::int32_t> label_of_voxel = voxels::extract(communicator, labels, voxels);

  // Visits every point of the rank, element by element: f(ix, iy, iz, voxel).
  const auto for_each_point = [&](const grid::Index3& element, const auto& f) {
    const std::size_t e[3] = {static_cast<std::size_t>(element[0] - elements.begin[0]),
                              static_cast<std::size_t>(element[1] - elements.begin[1]),
                              static_cast<std::size_t>(element[2] - elements.begin[2])};
    for (int iz = axis[2].element_begin[e[2]]; iz < axis[2].element_begin[e[2] + 1]; ++iz)
      for (int iy = axis[1].element_begin[e[1]]; iy < axis[1].element_begin[e[1] + 1]; ++iy)
        for (int ix = axis[0].element_begin[e[0]]; ix < axis[0].element_begin[e[0] + 1]; ++ix) {
          const auto voxel = [&](int d, int point) {
            return axis[d].voxel[static_cast<std::size_t>(point)] - voxels.first[d];
          };
          const std::int64_t position =
              voxel(0, ix) + voxels.count[0] * (voxel(1, iy) + voxels.count[1] * voxel(2, iz));
          f(ix, iy, iz, static_cast<std::size_t>(position));
        }
  };

  std::int64_t count = 0;
  base::collectively(communicator, [&] {
    std::map<std::int32_t, std::int64_t> homeless;
    std::int32_t last = -1;
    grid::for_each_index(elements, [&](const grid::Index3& element) {
      for_each_point(element, [&](int, int, int, std::size_t voxel) {
        const std::int32_t label = label_of_voxel[voxel];
        if (label < 0) return;
        ++count;
        if (label == last) return;
        if (material_of_label.count(label) == 0) {
          ++homeless[label];
        } else {
          last = label;
        }
      });
    });
    if (!homeless.empty()) {
      std::string known;
      for (const auto& entry : material_of_label)
        known += (known.empty() ? "" : ", ") + std::to_string(entry.first);
      std::string missing;
      for (const auto& entry : homeless) {
        if (missing.size() > 60) {
          missing += ", ...";
          break;
        }
        missing += (missing.empty() ? "" : ", ") + std::to_string(entry.first);
      }
      throw base::InputError("Materials: the image holds label " + missing +
                             ", for which there is no material; labels with a material: " + known +
                             "; -1 is empty space");
    }
    if (count > std::numeric_limits<int>::max())
      throw base::InputError("more than 2^31 particles on one rank; run with more ranks");
  });

  Particles<grid::Device> particles;
  for_each_field(
      [&](const Field& field, auto& view) {
        if (field.presence == Presence::always)
          allocate(view, field.name, static_cast<std::size_t>(count));
      },
      particles);
  allocate(particles.element_begin, "element_begin",
           static_cast<std::size_t>(elements.count() + 1));
  const auto position = Kokkos::create_mirror_view(particles.position);
  const auto volume = Kokkos::create_mirror_view(particles.volume);
  const auto material = Kokkos::create_mirror_view(particles.material);
  const auto id = Kokkos::create_mirror_view(particles.id);
  const auto element_begin = Kokkos::create_mirror_view(particles.element_begin);

  if (where != nullptr) *where = {voxels, {}};
  int p = 0;
  grid::for_each_index(elements, [&](const grid::Index3& element) {
    element_begin(elements.local(element)) = p;
    for_each_point(element, [&](int ix, int iy, int iz, std::size_t voxel) {
      const std::int32_t label = label_of_voxel[voxel];
      if (label < 0) return;
      const std::size_t point[3] = {static_cast<std::size_t>(ix), static_cast<std::size_t>(iy),
                                    static_cast<std::size_t>(iz)};
      double share = 1.0;
      for (int d = 0; d < 3; ++d) {
        position(p, d) = axis[d].position[point[d]];
        share *= axis[d].length[point[d]];
      }
      volume(p) = share;
      material(p) = static_cast<std::uint8_t>(material_of_label.at(label));
      if (where != nullptr) where->number.push_back(voxel);
      id(p) = (axis[0].first + ix) +
              axis[0].total * ((axis[1].first + iy) + axis[1].total * (axis[2].first + iz));
      ++p;
    });
  });
  element_begin(elements.count()) = p;

  Kokkos::deep_copy(particles.position, position);
  Kokkos::deep_copy(particles.volume, volume);
  Kokkos::deep_copy(particles.material, material);
  Kokkos::deep_copy(particles.id, id);
  Kokkos::deep_copy(particles.element_begin, element_begin);
  return particles;
}

}  // namespace stroma::particles
