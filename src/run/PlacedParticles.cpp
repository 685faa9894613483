// SPDX-License-Identifier: BSD-3-Clause

#include "run/PlacedParticles.hpp"

#include <algorithm>
#include <cmath>

#include "run/ShownFields.hpp"

namespace stroma {
namespace {

using voxels::FilledBox;

/// The box around what a deformation makes of a share; both [um].
FilledBox deformed(const particles::Share& share, const output::ParticleAt& particle) {
  const tensor::Tensor3 F = tensor::identity() + particle.gradient();
  FilledBox box;
  double before = 1.0, after = 1.0;
  for (std::size_t d = 0; d < 3; ++d) {
    const int i = static_cast<int>(d);
    double middle = share.point[d] + particle.displacement(i), half = 0.0;
    for (std::size_t e = 0; e < 3; ++e) {
      const int j = static_cast<int>(e);
      middle += F(i, j) * (0.5 * (share.low[e] + share.high[e]) - share.point[e]);
      half += std::abs(F(i, j)) * 0.5 * (share.high[e] - share.low[e]);
    }
    box.low[d] = middle - half;
    box.high[d] = middle + half;
    before *= share.high[d] - share.low[d];
    after *= 2.0 * half;
  }
  box.filling = particle.jacobian() * before / after;
  return box;
}

}  // namespace

void Extent::include(const std::array<double, 3>& other_low,
                     const std::array<double, 3>& other_high) {
  for (std::size_t d = 0; d < 3; ++d) {
    low[d] = std::min(low[d], other_low[d]);
    high[d] = std::max(high[d], other_high[d]);
  }
}

voxels::Box Extent::voxels(double least) const {
  voxels::Box box;
  if (low[0] > high[0]) return box;
  for (std::size_t d = 0; d < 3; ++d) {
    box.first[d] = static_cast<std::int64_t>(std::floor(low[d] + least));
    const auto end = static_cast<std::int64_t>(std::ceil(high[d] - least));
    box.count[d] = std::max<std::int64_t>(end - box.first[d], 1);
  }
  return box;
}

PlacedParticles::PlacedParticles(const base::Communicator& communicator,
                                 const mechanics::Body& body, const grid::Vector& u,
                                 const particles::Shares& shares,
                                 const std::array<double, 3>& voxel_size, bool is_deformed)
    : body_(&body),
      layers_(body.field_layers(u)),
      shares_(&shares),
      voxel_size_(voxel_size),
      is_deformed_(is_deformed),
      of_layer_(static_cast<std::size_t>(layers_.count())) {
  for (int layer = 0; layer < layers_.count(); ++layer) {
    Extent& extent = of_layer_[static_cast<std::size_t>(layer)];
    visit_layer(layer, [&](const FilledBox& box, const output::ParticleAt&, std::size_t) {
      extent.include(box.low, box.high);
    });
    of_rank_.include(extent.low, extent.high);
  }
  for (std::size_t d = 0; d < 3; ++d) {
    of_body_.low[d] = communicator.min(of_rank_.low[d]);
    of_body_.high[d] = communicator.max(of_rank_.high[d]);
  }
}

void PlacedParticles::visit(std::int64_t first_plane, std::int64_t planes, const Use& use) const {
  for (int layer = 0; layer < layers_.count(); ++layer)
    if (of_layer_[static_cast<std::size_t>(layer)].reaches(first_plane, planes))
      visit_layer(layer, use);
}

void PlacedParticles::visit_layer(int layer, const Use& use) const {
  const auto id = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body_->particles().id);
  const auto material =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), body_->particles().material);
  layers_.visit(layer, [&](int first, const mechanics::FieldLayers::Fields& fields) {
    const output::ParticleState state = state_of(fields);
    const int count = static_cast<int>(fields.jacobian.extent(0));
    for (int p = 0; p < count; ++p) {
      const output::ParticleAt particle(state, p);
      const particles::Share share = shares_->of(id(first + p));
      FilledBox box = is_deformed_ ? deformed(share, particle) : FilledBox{share.low, share.high};
      for (std::size_t d = 0; d < 3; ++d) {
        box.low[d] /= voxel_size_[d];
        box.high[d] /= voxel_size_[d];
      }
      use(box, particle, material(first + p));
    }
  });
}

}  // namespace stroma
