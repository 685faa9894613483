// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/StructureTensor.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "stroma/image/labels/Smoothing.hpp"

namespace stroma::image {

void structure_tensor(const base::Communicator& communicator, const voxels::IntensityVolume& image,
                      const StructureTensorScales& scales,
                      const std::function<void(int, const voxels::Volume<float>&)>& take) {
  std::array<double, 3> sigma{}, window{};
  std::array<std::int64_t, 3> margin{};
  for (std::size_t d = 0; d < 3; ++d) {
    sigma[d] = scales.gradient / image.voxel_size[d];
    window[d] = scales.window / image.voxel_size[d];
    margin[d] = static_cast<std::int64_t>(std::floor(2.0 * sigma[d] + 0.5));
    if (4 * margin[d] > image.size[d]) margin[d] = 0;
  }
  std::array<voxels::Volume<float>, 3> gradient;
  for (std::size_t d = 0; d < 3; ++d) {
    gradient[d] = voxels::Volume<float>(communicator, image.size, image.voxel_size);
    std::copy(image.values.begin(), image.values.end(), gradient[d].values.begin());
    differentiate(communicator, gradient[d], static_cast<int>(d), sigma);
    for (float& value : gradient[d].values) value /= static_cast<float>(image.voxel_size[d]);
  }
  constexpr std::size_t first[] = {0, 1, 2, 0, 1, 2}, second[] = {0, 1, 2, 1, 2, 0};
  voxels::Volume<float> product(communicator, image.size, image.voxel_size);
  for (std::size_t c = 0; c < 6; ++c) {
    std::transform(gradient[first[c]].values.begin(), gradient[first[c]].values.end(),
                   gradient[second[c]].values.begin(), product.values.begin(),
                   [](float a, float b) { return a * b; });
    average_inside(communicator, product, window, margin);
    take(static_cast<int>(c), product);
  }
}

Orientation orientation_of(const SymmetricTensor& tensor, bool is_flat) {
  const auto& [xx, yy, zz, xy, yz, zx] = tensor;
  const double trace = xx + yy + zz;
  double a[9] = {xx, xy, zx, xy, yy, yz, zx, yz, zz};
  if (is_flat) {  // across the plane it varies most of all
    a[2] = a[5] = a[6] = a[7] = 0.0;
    a[8] = 2.0 * trace;
  }
  for (double& entry : a) entry /= trace;
  double eigenvalue[3], work[16];
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', 3, a, 3, eigenvalue, work, 16, &info);
  const double least = std::max(eigenvalue[0], 0.0), next = std::max(eigenvalue[1], 0.0);
  return {{a[0], a[1], a[2]}, next > 0.0 ? (next - least) / (next + least) : 0.0};
}

}  // namespace stroma::image
