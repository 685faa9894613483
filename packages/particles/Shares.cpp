// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/particles/Shares.hpp"

namespace stroma::particles {

Shares::Shares(const ParticleParameters& parameters, const grid::Grid& body,
               const std::array<std::int64_t, 3>& voxels, const std::array<double, 3>& voxel_size) {
  for (std::size_t d = 0; d < 3; ++d) {
    const AxisLayout layout = axis_layout(parameters, body, static_cast<int>(d), 0,
                                          body.elements[d], voxels[d], voxel_size[d]);
    Axis& axis = axes_[d];
    axis.voxel = layout.voxel;
    axis.face.push_back(0.0);
    for (std::size_t n = 0; n < layout.position.size(); ++n) {
      axis.point.push_back(layout.position[n] - body.origin[d]);
      axis.face.push_back(axis.face.back() + layout.length[n]);
    }
  }
}

Share Shares::of(std::int64_t id) const {
  Share share;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto along = static_cast<std::int64_t>(axes_[d].point.size());
    const auto n = static_cast<std::size_t>(id % along);
    id /= along;
    share.low[d] = axes_[d].face[n];
    share.high[d] = axes_[d].face[n + 1];
    share.point[d] = axes_[d].point[n];
    share.voxel[d] = axes_[d].voxel[n];
  }
  return share;
}

}  // namespace stroma::particles
