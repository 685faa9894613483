// SPDX-License-Identifier: BSD-3-Clause

#include "run/SpecimenSlices.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "run/MovingSupports.hpp"
#include "run/Specimen.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/output/report/Packed.hpp"

namespace stroma {
namespace {

using nlohmann::json;

constexpr std::size_t most_image_values = 3'000'000, most_label_values = 9'000'000;

template <class T>
output::MapLattice merged_voxels(const voxels::Volume<T>& volume, std::size_t most) {
  output::MapLattice voxels;
  voxels.cell = volume.voxel_size;
  voxels.count = volume.size;
  for (std::size_t d = 0; d < 3; ++d) {
    voxels.origin[d] = volume.voxel_size[d] * static_cast<double>(volume.first_in_file[d]);
    voxels.length[d] = volume.voxel_size[d] * static_cast<double>(volume.size[d]);
  }
  return output::merged(voxels, most);
}

/// The materials of a segmented image, in cells of several voxels where they are many: that of the
/// middle one. On rank 0. Collective.
output::ParticleMaps maps_of(const base::Communicator& communicator, const Deck& deck,
                             const voxels::LabelVolume& labels) {
  const material::NamedMaterials& materials = deck.parameters.materials.materials;
  const auto material = material::material_of_label(materials);
  output::ParticleMaps maps;
  maps.lattice = merged_voxels(labels, most_label_values);
  maps.materials = names(materials);
  const std::array<std::int64_t, 3>&size = labels.size, merged = maps.lattice.merged,
                                 count = maps.lattice.count;
  const auto middle = [&](std::int64_t cell, std::size_t d) {
    return std::min(cell * merged[d] + merged[d] / 2, size[d] - 1);
  };
  for (std::int64_t k = 0; k < count[2]; ++k) {
    const voxels::Box plane{{0, 0, middle(k, 2)}, {size[0], size[1], 1}};
    const std::vector<std::int32_t> found =
        voxels::extract(communicator, labels, communicator.is_root() ? plane : voxels::Box());
    if (!communicator.is_root()) continue;
    for (std::int64_t j = 0; j < count[1]; ++j)
      for (std::int64_t i = 0; i < count[0]; ++i) {
        const auto at =
            material.find(found[static_cast<std::size_t>(middle(i, 0) + size[0] * middle(j, 1))]);
        maps.material.push_back(
            at == material.end() ? 0 : static_cast<std::uint8_t>(std::min(at->second + 1, 255)));
      }
  }
  return maps;
}

}  // namespace

json image_slices(const base::Communicator& communicator, const Deck& deck,
                  std::vector<output::PageArray>& arrays) {
  const image::ImageParameters& parameters = deck.parameters.image;
  if (!parameters.file) return "The specimen is a phantom: there is no image.";
  image::ImageSummary summary;
  std::optional<voxels::IntensityVolume> volume;
  try {
    volume = image::read_volume(communicator, parameters, deck.document.folder(), summary,
                                image::require_voxel_size);
  } catch (const base::InputError& error) {
    return std::string("The image cannot be read any more: ") + error.what();
  }
  const auto [least, most] = std::minmax_element(volume->values.begin(), volume->values.end());
  const bool has_any = !volume->values.empty();
  const double low = communicator.min(has_any ? *least : HUGE_VAL),
               high = communicator.max(has_any ? *most : -HUGE_VAL);
  const double scale = high > low ? 255.0 / (high - low) : 0.0;
  const output::MapLattice cells = merged_voxels(*volume, most_image_values);
  const std::array<std::int64_t, 3>&size = volume->size, merged = cells.merged;
  const std::int64_t nx = cells.count[0], ny = cells.count[1];
  std::vector<std::uint8_t> bytes;
  std::vector<double> sum, voxels;
  for (std::int64_t k = merged[2] / 2; k < size[2]; k += merged[2]) {
    const voxels::Box plane{{0, 0, k}, {size[0], size[1], 1}};
    const std::vector<double> values =
        voxels::extract(communicator, *volume, communicator.is_root() ? plane : voxels::Box());
    if (!communicator.is_root()) continue;
    sum.assign(static_cast<std::size_t>(nx * ny), 0.0);
    voxels.assign(sum.size(), 0.0);
    for (std::size_t v = 0; v < values.size(); ++v) {
      const auto i = static_cast<std::int64_t>(v) % size[0],
                 j = static_cast<std::int64_t>(v) / size[0];
      const auto cell = static_cast<std::size_t>(j / merged[1] * nx + i / merged[0]);
      sum[cell] += values[v];
      voxels[cell] += 1.0;
    }
    for (std::size_t c = 0; c < sum.size(); ++c)
      bytes.push_back(static_cast<std::uint8_t>(std::lround((sum[c] / voxels[c] - low) * scale)));
  }
  if (!communicator.is_root()) return nullptr;
  json image{{"low", low},         {"high", high},
             {"merged", merged},   {"format", summary.format},
             {"cell", cells.cell}, {"origin", cells.origin}};
  image["count"] = {nx, ny, static_cast<std::int64_t>(bytes.size()) / (nx * ny)};
  arrays.emplace_back("image", output::packed(bytes));
  return image;
}

json material_slices(const base::Communicator& communicator, const Deck& deck,
                     std::vector<output::PageArray>& arrays) {
  std::optional<SpecimenImage> image;
  try {
    image = read_image(communicator, deck);
  } catch (const base::InputError&) {  // image_slices() says so
    return nullptr;
  }
  const output::ParticleMaps maps = maps_of(communicator, deck, image->labels);
  return communicator.is_root() ? output::describe(maps, {}, {}, {}, arrays) : json();
}

}  // namespace stroma
