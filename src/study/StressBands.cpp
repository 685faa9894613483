// SPDX-License-Identifier: BSD-3-Clause

#include "study/StressBands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/image/formats/WriteTiff.hpp"
#include "stroma/output/files/ParticleReader.hpp"
#include "study/Bands.hpp"

namespace stroma {
namespace {

constexpr double budget = 128.0 * 1024.0 * 1024.0;  // bytes of values of all runs, on a rank
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

/// Some planes of the lattice.
struct Batch {
  std::int64_t first = 0, planes = 0;
};

/// The mean von Mises stress of a run in the voxels of a batch; NaN where it has no particle.
std::vector<float> stress_in(const std::string& run, const VoxelLattice& lattice,
                             const Batch& batch) {
  const std::int64_t per_plane = lattice.size[0] * lattice.size[1];
  const auto count = static_cast<std::size_t>(batch.planes * per_plane);
  std::vector<double> sum(count, 0.0), volume(count, 0.0);
  const output::ParticleReader reader(run + "/particles.e");
  if (reader.steps() == 0) throw base::RunError("'" + run + "/particles.e' has no step");
  reader.for_pieces(reader.steps() - 1, {"von_mises"}, [&](const output::ParticlePiece& piece) {
    for (std::size_t p = 0; p < piece.count; ++p) {
      std::array<std::int64_t, 3> voxel{};
      for (std::size_t d = 0; d < 3; ++d)
        voxel[d] = static_cast<std::int64_t>(
            std::floor((piece.position[d][p] - lattice.origin[d]) / lattice.voxel_size[d]));
      const std::int64_t plane = voxel[2] - batch.first;
      if (plane < 0 || plane >= batch.planes || voxel[0] < 0 || voxel[0] >= lattice.size[0] ||
          voxel[1] < 0 || voxel[1] >= lattice.size[1])
        continue;
      const auto v =
          static_cast<std::size_t>(plane * per_plane + voxel[1] * lattice.size[0] + voxel[0]);
      sum[v] += piece.values[0][p] * piece.volume[p];
      volume[v] += piece.volume[p];
    }
  });
  std::vector<float> mean(count, nothing);
  for (std::size_t v = 0; v < count; ++v)
    if (volume[v] > 0.0) mean[v] = static_cast<float>(sum[v] / volume[v]);
  return mean;
}

}  // namespace

void write_stress_bands(const base::Communicator& communicator,
                        const std::vector<std::string>& runs, const VoxelLattice& lattice,
                        const std::string& folder) {
  using Stresses = voxels::Volume<float>;
  std::array<Stresses, 3> bands;
  bands.fill(Stresses(communicator, lattice.size, lattice.voxel_size));
  const Stresses& slab = bands[0];
  const double plane_bytes =
      static_cast<double>(runs.size()) * static_cast<double>(slab.plane_voxels()) * sizeof(float);
  const std::int64_t most =
      std::max<std::int64_t>(1, static_cast<std::int64_t>(budget / plane_bytes));
  base::collectively(communicator, [&] {
    for (std::int64_t done = 0; done < slab.planes; done += most) {
      const Batch batch{slab.first_plane + done, std::min(most, slab.planes - done)};
      std::vector<std::vector<float>> stresses;
      for (const std::string& run : runs) stresses.push_back(stress_in(run, lattice, batch));
      const auto offset = static_cast<std::size_t>(done * slab.plane_voxels());
      for (std::size_t v = 0; v < stresses.front().size(); ++v) {
        std::vector<double> values;
        for (const std::vector<float>& run : stresses)
          if (!std::isnan(run[v])) values.push_back(static_cast<double>(run[v]));
        const Band band = values.empty() ? Band{nothing, nothing, nothing} : band_of(values);
        bands[0].values[offset + v] = static_cast<float>(band.low);
        bands[1].values[offset + v] = static_cast<float>(band.median);
        bands[2].values[offset + v] = static_cast<float>(band.high);
      }
    }
  });
  const std::array<const char*, 3> names{"05", "50", "95"};
  for (std::size_t b = 0; b < 3; ++b)
    image::write_tiff(communicator, folder + "/von_mises_" + names[b] + ".tif", bands[b]);
}

}  // namespace stroma
