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

template <class View>
auto on_host(const View& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
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
    const Extent extent = extent_of(layer);
    of_layer_[static_cast<std::size_t>(layer)] = extent;
    of_rank_.include(extent.low, extent.high);
  }
  for (std::size_t d = 0; d < 3; ++d) {
    of_body_.low[d] = communicator.min(of_rank_.low[d]);
    of_body_.high[d] = communicator.max(of_rank_.high[d]);
  }
}

Extent PlacedParticles::extent_of(int layer) {
  const auto id = on_host(body_->particles().id);
  const int first = layers_.first_particle(layer), end = layers_.first_particle(layer + 1);
  const output::ParticleState none;
  const output::ParticleState& state = is_deformed_ ? state_of_layer(layer) : none;
  Extent extent;
  for (int p = first; p < end; ++p) {
    const FilledBox box = box_of(id(p), {state, p - first});
    extent.include(box.low, box.high);
  }
  return extent;
}

void PlacedParticles::visit(std::int64_t first_plane, std::int64_t planes, const Use& use) {
  const auto id = on_host(body_->particles().id);
  const auto material = on_host(body_->particles().material);
  for (int layer = 0; layer < layers_.count(); ++layer) {
    if (!of_layer_[static_cast<std::size_t>(layer)].reaches(first_plane, planes)) continue;
    const int first = layers_.first_particle(layer), end = layers_.first_particle(layer + 1);
    const output::ParticleState& state = state_of_layer(layer);
    for (int p = first; p < end; ++p) {
      const output::ParticleAt particle(state, p - first);
      use(box_of(id(p), particle), particle, material(p));
    }
  }
}

const output::ParticleState& PlacedParticles::state_of_layer(int layer) {
  if (layer != kept_layer_) {
    kept_ = mechanics::FieldLayers::Fields(0);  // so that no two are there
    layers_.visit(layer,
                  [&](int, const mechanics::FieldLayers::Fields& fields) { kept_ = fields; });
    kept_state_ = state_of(kept_);
    kept_layer_ = layer;
  }
  return kept_state_;
}

FilledBox PlacedParticles::box_of(std::int64_t id, const output::ParticleAt& particle) const {
  const particles::Share share = shares_->of(id);
  FilledBox box = is_deformed_ ? deformed(share, particle) : FilledBox{share.low, share.high};
  for (std::size_t d = 0; d < 3; ++d) {
    box.low[d] /= voxel_size_[d];
    box.high[d] /= voxel_size_[d];
  }
  return box;
}

}  // namespace stroma
