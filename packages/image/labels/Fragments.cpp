// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Fragments.hpp"

#include <algorithm>
#include <vector>

#include "stroma/base/Log.hpp"
#include "stroma/image/labels/Objects.hpp"

namespace stroma::image {
namespace {

bool is_within_reach(const voxels::LabelVolume& labels, const FaceReach& reach,
                     const std::array<std::int64_t, 3>& voxel) {
  for (std::size_t d = 0; d < 3; ++d)
    if (voxel[d] < reach[d][0] || labels.size[d] - voxel[d] <= reach[d][1]) return true;
  return false;
}

/// (piece) Voxels of its whole object that are within reach. Collective.
std::vector<std::int64_t> voxels_within_reach(const voxels::LabelVolume& labels,
                                              const FaceReach& reach, const Objects& body) {
  std::vector<std::int64_t> count(body.pieces(), 0);
  std::size_t v = 0;
  for (std::int64_t k = labels.first_plane; k < labels.first_plane + labels.planes; ++k)
    for (std::int64_t j = 0; j < labels.size[1]; ++j)
      for (std::int64_t i = 0; i < labels.size[0]; ++i, ++v)
        if (labels.values[v] >= 0 && is_within_reach(labels, reach, {i, j, k}))
          ++count[body.piece_at(v)];
  return body.sum_over_pieces(std::move(count));
}

}  // namespace

Bodies leave_out_fragments(const base::Communicator& communicator, voxels::LabelVolume& labels,
                           const std::optional<FaceReach>& reach) {
  const auto filled = static_cast<std::int64_t>(std::count_if(
      labels.values.begin(), labels.values.end(), [](std::int32_t label) { return label >= 0; }));
  const std::int64_t all_filled = communicator.sum(filled);
  if (all_filled == labels.voxels()) return {};

  voxels::LabelVolume is_filled(communicator, labels.size, labels.voxel_size);
  std::transform(labels.values.begin(), labels.values.end(), is_filled.values.begin(),
                 [](std::int32_t label) { return label >= 0 ? 1 : 0; });
  const Objects body(communicator, is_filled, Connectivity::faces);
  if (!reach) return {body.count(), ""};
  const std::vector<std::int64_t> held = voxels_within_reach(labels, *reach, body);
  std::int64_t held_objects = 0;
  for (std::size_t piece = 0; piece < body.pieces(); ++piece)
    if (held[piece] > 0 && body.is_first(piece)) ++held_objects;
  held_objects = communicator.sum(held_objects);
  const std::int64_t fragments = body.count() - held_objects;
  if (fragments == 0 || held_objects == 0) return {body.count(), ""};

  std::int64_t left_out = 0, largest = 0;
  for (std::size_t v = 0; v < labels.values.size(); ++v) {
    if (labels.values[v] < 0 || held[body.piece_at(v)] > 0) continue;
    labels.values[v] = -1;
    ++left_out;
    largest = std::max(largest, body.size_at(v));
  }
  left_out = communicator.sum(left_out);
  largest = communicator.max(largest);
  const bool one = fragments == 1;
  const std::string note = base::format(
      "%lld fragment%s of the body, %lld voxel%s%s or %.2g %% of it, %s left out: no face of a "
      "voxel joins %s to what the conditions on the body's faces hold or load",
      static_cast<long long>(fragments), one ? "" : "s", static_cast<long long>(left_out),
      left_out == 1 ? "" : "s",
      one ? ""
          : base::format(" in all (the largest: %lld)", static_cast<long long>(largest)).c_str(),
      100.0 * static_cast<double>(left_out) / static_cast<double>(all_filled), one ? "is" : "are",
      one ? "it" : "them");
  return {held_objects, note};
}

}  // namespace stroma::image
