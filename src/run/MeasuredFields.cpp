// SPDX-License-Identifier: BSD-3-Clause

#include "run/MeasuredFields.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/image/ReadVolume.hpp"

namespace stroma {
namespace {

using base::format;
using mechanics::BoundaryCondition;
using mechanics::Face;
using mechanics::VectorField;
using mechanics::VectorImages;
using mechanics::VoxelLattice;
using Vector = std::array<double, 3>;

/// A box in the undeformed body [um].
struct Extent {
  Vector lower, upper;
};

bool is_empty(const Extent& extent) {
  for (std::size_t d = 0; d < 3; ++d)
    if (extent.lower[d] > extent.upper[d]) return true;
  return false;
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

Extent extent_of_nodes(const grid::Partition& partition, const grid::Box& nodes) {
  grid::Index3 last = nodes.end;
  for (auto& index : last) --index;
  return {partition.grid().node_position(nodes.begin), partition.grid().node_position(last)};
}

/// What a field is asked for: which components, and where.
struct Wanted {
  std::string where;  ///< the deck's section of the images
  const VectorImages& images;
  std::array<bool, 3> components;
  Extent all;                 ///< what the images must reach to, on all ranks [um]
  std::vector<Extent> parts;  ///< what this rank asks for; empty ones have lower > upper
};

/// Refuses images that end before what they are asked for does.
void require_reach(const Wanted& wanted, const grid::Grid& body, const VoxelLattice& lattice) {
  for (std::size_t d = 0; d < 3; ++d) {
    const double tolerance = 1e-6 * lattice.voxel_size[d];
    const double low = lattice.corner[d],
                 high = low + static_cast<double>(lattice.size[d]) * lattice.voxel_size[d];
    if (low <= wanted.all.lower[d] + tolerance && high >= wanted.all.upper[d] - tolerance) continue;
    const double begin = body.origin[d], end = begin + body.length(static_cast<int>(d));
    throw base::InputError(
        format("%s: the images reach from %.8g to %.8g um along %c, and the body from %.8g to %.8g "
               "um; admissible: images that hold all of the body, or of the face (Corner [um] says "
               "where they lie)",
               wanted.where.c_str(), low, high, "xyz"[d], begin, end));
  }
}

/// Reads one set of images.
class Reader {
 public:
  Reader(const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
         Wanted wanted)
      : communicator_(communicator), deck_(&deck), body_(&body), wanted_(std::move(wanted)) {}

  std::shared_ptr<const VectorField> read(ReadImages& seen) {
    for (int component = 0; component < 3; ++component)
      if (wanted_.components[static_cast<std::size_t>(component)]) read(component, seen);
    double largest = 0.0;
    for (const VectorField::Block& block : blocks_)
      for (const std::vector<double>& values : block.values)
        for (const double value : values)
          if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return std::make_shared<const VectorField>(wanted_.where, lattice_, std::move(blocks_),
                                               communicator_.max(largest));
  }

 private:
  void read(int component, ReadImages& seen) {
    const VectorImages& images = wanted_.images;
    const std::string& where = wanted_.where;
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
      throw base::InputError(what.rfind(where, 0) == 0 ? what : where + ": " + what);
    }
    seen.add(where, found);
    for (VectorField::Block& block : blocks_)
      block.values[static_cast<std::size_t>(component)] =
          voxels::extract(communicator_, volume, block.box);
  }

  /// Takes the lattice of the first image, to which the others must be equal.
  void place(const image::ImageSummary& summary) {
    const std::string& where = wanted_.where;
    if (!summary.voxel_size.complete())
      throw base::InputError(where + "|Voxel Size [um]: missing; " + summary.path +
                             " does not state it along every axis");
    const VoxelLattice lattice{summary.size, summary.voxel_size.um, wanted_.images.corner};
    if (!blocks_.empty()) {
      if (lattice.size != lattice_.size || lattice.voxel_size != lattice_.voxel_size)
        throw base::InputError(where + ": " + summary.path +
                               " has other voxels than the image of the component before; "
                               "admissible: images of the same voxels");
      return;
    }
    lattice_ = lattice;
    require_reach(wanted_, *body_, lattice);
    for (const Extent& part : wanted_.parts)
      blocks_.push_back(
          {is_empty(part) ? voxels::Box() : lattice.around(part.lower, part.upper), {}});
  }

  base::Communicator communicator_;
  const Deck* deck_;
  const grid::Grid* body_;
  Wanted wanted_;
  VoxelLattice lattice_{};
  std::vector<VectorField::Block> blocks_{};
};

Extent extent_of(const grid::Grid& body) {
  Extent box{body.origin, body.origin};
  for (std::size_t d = 0; d < 3; ++d) box.upper[d] += body.length(static_cast<int>(d));
  return box;
}

/// What a condition asks for: its faces, and a layer beside them.
/// \param part  what this rank may have of the body
Wanted wanted_by(const std::string& name, const BoundaryCondition& condition,
                 const grid::Grid& body, const Extent& part, int elements) {
  Wanted wanted{"Boundary Conditions|" + name + "|Displacement Images",
                *condition.images,
                {condition.prescribes(0), condition.prescribes(1), condition.prescribes(2)},
                extent_of(body),
                {}};
  if (*condition.face != Face::all) {
    const auto d = static_cast<std::size_t>(mechanics::axis_of(*condition.face));
    Extent& all = wanted.all;
    (mechanics::is_upper(*condition.face) ? all.lower[d] : all.upper[d]) =
        mechanics::is_upper(*condition.face) ? all.upper[d] : all.lower[d];
  }
  for (int face = 0; face < 6; ++face)
    if (condition.applies_to(static_cast<Face>(face)))
      wanted.parts.push_back(layer_at(static_cast<Face>(face), body, part, elements));
  return wanted;
}

/// What a motion of the body asks for: all that this rank has of it, and elements around.
Wanted wanted_by(const std::string& name, const mechanics::InitialCondition& condition,
                 const grid::Grid& body, Extent part, int elements) {
  for (std::size_t d = 0; d < 3; ++d) {
    part.lower[d] -= elements * body.spacing[d];
    part.upper[d] += elements * body.spacing[d];
  }
  return {"Initial Conditions|" + name + "|Velocity Images",
          *condition.images,
          {true, true, true},
          extent_of(body),
          {part}};
}

/// The field of each condition that has images, null of the others. Collective.
/// \param nodes     what this rank may have of the body
/// \param elements  how far beyond it the rank looks
template <class Condition>
std::vector<std::shared_ptr<const VectorField>> fields_of(
    const std::vector<std::pair<std::string, Condition>>& conditions,
    const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
    const Extent& nodes, int elements, ReadImages& seen) {
  std::vector<std::shared_ptr<const VectorField>> fields;
  for (const auto& [name, condition] : conditions) {
    fields.emplace_back();
    if (condition.images)
      fields.back() =
          Reader(communicator, deck, body, wanted_by(name, condition, body, nodes, elements))
              .read(seen);
  }
  return fields;
}

}  // namespace

std::vector<std::shared_ptr<const VectorField>> measured_displacements(
    const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
    const grid::Partition& partition, ReadImages& seen) {
  // On a grid that is reset, a rank's particles may become those of any other part of the body.
  const grid::Box nodes = deck.parameters.grid.reset ? partition.grid().all_nodes()
                                                     : partition.touched_nodes(communicator.rank());
  return fields_of(deck.parameters.boundary_conditions.conditions, communicator, deck, body,
                   extent_of_nodes(partition, nodes), partition.grid().width - 1, seen);
}

std::vector<std::shared_ptr<const VectorField>> measured_velocities(
    const base::Communicator& communicator, const Deck& deck, const grid::Grid& body,
    const grid::Partition& partition, ReadImages& seen) {
  const grid::Box nodes = partition.touched_nodes(communicator.rank());
  return fields_of(deck.parameters.initial_conditions.conditions, communicator, deck, body,
                   extent_of_nodes(partition, nodes), 1, seen);
}

}  // namespace stroma
