// SPDX-License-Identifier: BSD-3-Clause

#include "run/MeasuredDisplacements.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/ReadVolume.hpp"

namespace stroma {
namespace {

using base::format;
using mechanics::BoundaryCondition;
using mechanics::DisplacementField;
using mechanics::DisplacementImages;
using mechanics::Face;
using mechanics::VoxelLattice;
using Vector = std::array<double, 3>;

/// A box in the undeformed body [um].
struct Extent {
  Vector lower, upper;
};

bool is_on(const BoundaryCondition& condition, Face face) {
  return *condition.face == face || *condition.face == Face::all;
}

/// Part of a face of the body's box, and of what lies beside it as deep as particles in the
/// outermost elements touch nodes.
/// \param within    where a rank's nodes are
/// \param elements  that the layer is deep, to both sides
Extent layer_at(Face face, const grid::Grid& body, const Extent& within, int elements) {
  const auto d = static_cast<std::size_t>(mechanics::axis_of(face));
  const double plane =
      body.origin[d] + (mechanics::is_upper(face) ? body.length(static_cast<int>(d)) : 0.0);
  Extent layer = within;
  layer.lower[d] = std::max(within.lower[d], plane - elements * body.spacing[d]);
  layer.upper[d] = std::min(within.upper[d], plane + elements * body.spacing[d]);
  return layer;
}

Extent nodes_of_rank(const grid::Partition& partition, int rank) {
  const grid::Box nodes = partition.touched_nodes(rank);
  grid::Index3 last = nodes.end;
  for (auto& index : last) --index;
  return {partition.grid().node_position(nodes.begin), partition.grid().node_position(last)};
}

/// Refuses images that end before the condition's faces do.
void require_reach(const std::string& where, const BoundaryCondition& condition,
                   const grid::Grid& body, const VoxelLattice& lattice) {
  for (std::size_t d = 0; d < 3; ++d) {
    const double tolerance = 1e-6 * lattice.voxel_size[d];
    const double low = lattice.corner[d],
                 high = low + static_cast<double>(lattice.size[d]) * lattice.voxel_size[d];
    const double begin = body.origin[d], end = begin + body.length(static_cast<int>(d));
    const auto at = static_cast<int>(d);
    const bool needs_begin = mechanics::axis_of(*condition.face) != at ||
                             !mechanics::is_upper(*condition.face),
               needs_end = mechanics::axis_of(*condition.face) != at ||
                           mechanics::is_upper(*condition.face);
    if ((!needs_begin || low <= begin + tolerance) && (!needs_end || high >= end - tolerance) &&
        low <= end && high >= begin)
      continue;
    throw base::InputError(
        format("%s: the images reach from %.8g to %.8g um along %c, and the body from %.8g to %.8g "
               "um; admissible: images that hold all of the face (Corner [um] says where they lie)",
               where.c_str(), low, high, "xyz"[d], begin, end));
  }
}

/// Reads one condition's images.
class Reader {
 public:
  Reader(const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
         const grid::Partition& partition, std::string where, const BoundaryCondition& condition)
      : communicator_(communicator),
        deck_(&deck),
        body_(&body),
        nodes_(nodes_of_rank(partition, communicator.rank())),
        depth_(partition.grid().width - 1),
        where_(std::move(where)),
        condition_(&condition) {}

  std::shared_ptr<const DisplacementField> read(std::vector<std::string>& files) {
    for (int component = 0; component < 3; ++component)
      if (condition_->prescribes(component)) read(component, files);
    double largest = 0.0;
    for (const DisplacementField::Block& block : blocks_)
      for (const std::vector<double>& values : block.values)
        for (const double value : values)
          if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return std::make_shared<const DisplacementField>(where_, lattice_, std::move(blocks_),
                                                     communicator_.max(largest));
  }

 private:
  void read(int component, std::vector<std::string>& files) {
    const DisplacementImages& images = *condition_->images;
    image::ImageParameters file;
    file.file = images.images[images.file_of(component)];
    file.dataset = images.dataset;
    file.channel = images.channel_of(component);
    file.frame = images.frame;
    file.voxel_size = images.voxel_size;
    image::ImageSummary found;
    voxels::IntensityVolume volume;
    try {
      volume = image::read_volume(communicator_, file, deck_->document.folder(), found,
                                  [&](const image::ImageSummary& summary) { place(summary); });
    } catch (const base::InputError& error) {  // thrown on all ranks alike
      const std::string what = error.what();
      throw base::InputError(what.rfind(where_, 0) == 0 ? what : where_ + ": " + what);
    }
    for (const std::string& name : found.files)
      if (std::find(files.begin(), files.end(), name) == files.end()) files.push_back(name);
    for (DisplacementField::Block& block : blocks_)
      block.values[static_cast<std::size_t>(component)] =
          voxels::extract(communicator_, volume, block.box);
  }

  /// Takes the lattice of the first image, to which the others must be equal.
  void place(const image::ImageSummary& summary) {
    if (!summary.voxel_size.complete())
      throw base::InputError(where_ + "|Voxel Size [um]: missing; " + summary.path +
                             " does not state it along every axis");
    const VoxelLattice lattice{summary.size, summary.voxel_size.um, condition_->images->corner};
    if (!blocks_.empty()) {
      if (lattice.size != lattice_.size || lattice.voxel_size != lattice_.voxel_size)
        throw base::InputError(where_ + ": " + summary.path +
                               " has other voxels than the image of the component before; "
                               "admissible: images of the same voxels");
      return;
    }
    lattice_ = lattice;
    require_reach(where_, *condition_, *body_, lattice);
    for (int face = 0; face < 6; ++face) {
      if (!is_on(*condition_, static_cast<Face>(face))) continue;
      const Extent layer = layer_at(static_cast<Face>(face), *body_, nodes_, depth_);
      const auto d = static_cast<std::size_t>(face / 2);
      const bool is_here = layer.lower[d] <= layer.upper[d];
      blocks_.push_back({is_here ? lattice.around(layer.lower, layer.upper) : voxels::Box(), {}});
    }
  }

  base::Communicator communicator_;
  const Deck* deck_;
  const grid::Grid* body_;
  Extent nodes_;
  int depth_;
  std::string where_;
  const BoundaryCondition* condition_;
  VoxelLattice lattice_{};
  std::vector<DisplacementField::Block> blocks_{};
};

}  // namespace

std::vector<std::shared_ptr<const DisplacementField>> measured_displacements(
    const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
    const grid::Partition& partition, std::vector<std::string>& files) {
  std::vector<std::shared_ptr<const DisplacementField>> fields;
  for (const auto& [name, condition] : deck.parameters.boundary_conditions.conditions) {
    fields.emplace_back();
    if (condition.images)
      fields.back() = Reader(communicator, deck, body, partition,
                             "Boundary Conditions|" + name + "|Displacement Images", condition)
                          .read(files);
  }
  return fields;
}

}  // namespace stroma
