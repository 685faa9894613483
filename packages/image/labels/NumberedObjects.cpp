// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/NumberedObjects.hpp"

#include "stroma/image/labels/Objects.hpp"

namespace stroma::image {
namespace {

constexpr std::size_t moments = 10;  // voxels, sum, products

/// (moment, piece) of what of each object lies in this slab.
std::array<std::vector<std::int64_t>, moments> moments_of_pieces(const voxels::LabelVolume& labels,
                                                                 const Objects& objects) {
  std::array<std::vector<std::int64_t>, moments> of;
  of.fill(std::vector<std::int64_t>(objects.pieces(), 0));
  std::size_t voxel = 0;
  for (std::int64_t k = labels.first_plane; k < labels.first_plane + labels.planes; ++k)
    for (std::int64_t j = 0; j < labels.size[1]; ++j)
      for (std::int64_t i = 0; i < labels.size[0]; ++i, ++voxel) {
        if (objects.size_at(voxel) == 0) continue;
        const std::size_t piece = objects.piece_at(voxel);
        const std::int64_t values[moments] = {1, i, j, k, i * i, j * j, k * k, i * j, j * k, k * i};
        for (std::size_t m = 0; m < moments; ++m) of[m][piece] += values[m];
      }
  return of;
}

}  // namespace

NumberedObjects number_objects(const base::Communicator& communicator,
                               const voxels::LabelVolume& labels, std::int32_t ground) {
  const Objects objects(communicator, labels, Connectivity::corners, ground);
  std::vector<std::int64_t> label(objects.pieces(), 0);
  for (std::size_t voxel = 0; voxel < labels.values.size(); ++voxel)
    if (objects.size_at(voxel) > 0) label[objects.piece_at(voxel)] = labels.values[voxel];
  auto of = moments_of_pieces(labels, objects);
  for (std::vector<std::int64_t>& moment : of) moment = objects.sum_over_pieces(std::move(moment));

  NumberedObjects found;
  std::vector<std::int64_t> number(objects.pieces(), 0);
  for (std::size_t piece = 0; piece < objects.pieces(); ++piece) {
    if (!objects.is_first(piece)) continue;
    found.moments.push_back(
        {label[piece],
         of[0][piece],
         {of[1][piece], of[2][piece], of[3][piece]},
         {of[4][piece], of[5][piece], of[6][piece], of[7][piece], of[8][piece], of[9][piece]}});
    number[piece] = static_cast<std::int64_t>(found.moments.size());
  }
  const auto kept = static_cast<std::int64_t>(found.moments.size());
  found.first = 1 + communicator.sum_before(kept);
  found.count = communicator.sum(kept);
  for (std::int64_t& one : number)
    if (one > 0) one += found.first - 1;
  number = objects.sum_over_pieces(std::move(number));  // of the others, the first one's
  found.number = voxels::LabelVolume(communicator, labels.size, labels.voxel_size);
  for (std::size_t voxel = 0; voxel < labels.values.size(); ++voxel)
    if (objects.size_at(voxel) > 0)
      found.number.values[voxel] = static_cast<std::int32_t>(number[objects.piece_at(voxel)]);
  return found;
}

}  // namespace stroma::image
