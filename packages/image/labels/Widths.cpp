// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/labels/Widths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stroma::image {
namespace {

/// Of one label.
struct Counts {
  std::int64_t voxels = 0;
  std::array<std::int64_t, 3> ends{0, 0, 0};  ///< of the ways along x, y, z, at their upper end
  std::array<std::int64_t, 3> crossings{0, 0, 0};  ///< of the surface, along x, y, z
};

/// Counts of the labels asked for, and one more entry for all others.
class Counting {
 public:
  explicit Counting(const std::vector<std::int32_t>& wanted)
      : wanted_(&wanted), counts_(wanted.size() + 1), current_(wanted.size()) {}

  void add(std::int32_t label) { ++of(label).voxels; }
  /// A way that ends at an axis' upper side, at a face of the image.
  void end(std::int32_t label, std::size_t axis) { ++of(label).ends[axis]; }
  /// A pair of different neighbours along an axis.
  void change(std::int32_t label, std::int32_t next, std::size_t axis) {
    ++of(next).crossings[axis];
    Counts& counts = of(label);
    ++counts.ends[axis];
    ++counts.crossings[axis];
  }
  std::vector<Counts> sum(const base::Communicator& communicator) {
    counts_.resize(wanted_->size());
    static_assert(sizeof(Counts) == 7 * sizeof(std::int64_t));
    if (!counts_.empty()) communicator.sum_all(&counts_.front().voxels, 7 * counts_.size());
    return counts_;
  }

 private:
  Counts& of(std::int32_t label) {
    if (label != label_ || !is_known_) {  // neighbours mostly have the same
      current_ = static_cast<std::size_t>(std::find(wanted_->begin(), wanted_->end(), label) -
                                          wanted_->begin());
      label_ = label;
      is_known_ = true;
    }
    return counts_[current_];
  }

  const std::vector<std::int32_t>* wanted_;
  std::vector<Counts> counts_;
  std::size_t current_;
  std::int32_t label_ = 0;
  bool is_known_ = false;
};

std::vector<Counts> counted(const base::Communicator& communicator,
                            const voxels::LabelVolume& labels,
                            const std::vector<std::int32_t>& wanted) {
  const std::int64_t nx = labels.size[0], ny = labels.size[1];
  // The plane above this slab, whose owner is some later rank.
  voxels::Box above{{0, 0, labels.first_plane + labels.planes}, {nx, ny, 1}};
  if (labels.planes == 0 || above.first[2] >= labels.size[2]) above.count = {0, 0, 0};
  const std::vector<std::int32_t> next = voxels::extract(communicator, labels, above);

  Counting counting(wanted);
  for (std::int64_t k = 0; k < labels.planes; ++k) {
    const std::int32_t* plane = labels.plane(k);
    const std::int32_t* upper = k + 1 < labels.planes ? labels.plane(k + 1)
                                : next.empty()        ? nullptr
                                                      : next.data();
    for (std::int64_t j = 0, v = 0; j < ny; ++j)
      for (std::int64_t i = 0; i < nx; ++i, ++v) {
        const std::int32_t label = plane[v];
        counting.add(label);
        const auto look = [&](std::size_t axis, const std::int32_t* neighbour) {
          if (!neighbour)
            counting.end(label, axis);
          else if (*neighbour != label)
            counting.change(label, *neighbour, axis);
        };
        look(0, i + 1 < nx ? plane + v + 1 : nullptr);
        look(1, j + 1 < ny ? plane + v + nx : nullptr);
        look(2, upper ? upper + v : nullptr);
      }
  }
  return counting.sum(communicator);
}

}  // namespace

std::vector<Widths> widths(const base::Communicator& communicator,
                           const voxels::LabelVolume& labels,
                           const std::vector<std::int32_t>& wanted) {
  const std::size_t directions = labels.size[2] > 1 ? 3 : 2;
  const double surface_of_crossings = directions == 3 ? 2.0 : std::acos(-1.0) / 2.0;
  std::vector<Widths> found;
  for (const Counts& counts : counted(communicator, labels, wanted)) {
    Widths& widths = found.emplace_back();
    if (counts.voxels == 0) continue;
    const auto voxels = static_cast<double>(counts.voxels);
    double crossings = 0.0;  // times the volume of the image, in voxels, per length
    for (std::size_t d = 0; d < 3; ++d) {
      widths.chords[d] = labels.voxel_size[d] * voxels / static_cast<double>(counts.ends[d]);
      widths.has_surface[d] = counts.crossings[d] > 0;
      if (d < directions)
        crossings += static_cast<double>(counts.crossings[d]) / labels.voxel_size[d] /
                     static_cast<double>(directions);
    }
    widths.tubes = crossings > 0.0 ? 4.0 * voxels / (surface_of_crossings * crossings)
                                   : std::numeric_limits<double>::infinity();
  }
  return found;
}

}  // namespace stroma::image
