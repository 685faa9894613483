// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/mechanics/problem/VectorField.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"

namespace stroma::mechanics {

std::int64_t VoxelLattice::voxel_below(std::size_t axis, double coordinate) const {
  const double place = (coordinate - corner[axis]) / voxel_size[axis] - 0.5;
  const auto last = static_cast<double>(std::max<std::int64_t>(0, size[axis] - 2));
  return static_cast<std::int64_t>(std::clamp(std::floor(place), 0.0, last));
}

voxels::Box VoxelLattice::around(const std::array<double, 3>& lower,
                                 const std::array<double, 3>& upper) const {
  voxels::Box box;
  for (std::size_t d = 0; d < 3; ++d) {
    box.first[d] = voxel_below(d, lower[d]);
    const std::int64_t last = std::min(voxel_below(d, upper[d]) + 1, size[d] - 1);
    box.count[d] = last - box.first[d] + 1;
  }
  return box;
}

VectorField::VectorField(std::string name, const VoxelLattice& lattice, std::vector<Block> blocks,
                         double largest)
    : name_(std::move(name)), lattice_(lattice), blocks_(std::move(blocks)), largest_(largest) {}

double VectorField::value(int component, const std::array<std::int64_t, 3>& voxel,
                          const std::array<double, 3>& X) const {
  for (const Block& block : blocks_) {
    std::int64_t number = 0;
    bool is_inside = true;
    for (std::size_t d = 3; d-- > 0;) {
      const std::int64_t i = voxel[d] - block.box.first[d];
      is_inside = is_inside && i >= 0 && i < block.box.count[d];
      number = number * block.box.count[d] + i;
    }
    if (!is_inside) continue;
    const double found =
        block.values[static_cast<std::size_t>(component)].at(static_cast<std::size_t>(number));
    if (!std::isfinite(found))
      throw base::InputError(base::format(
          "%s: component %c at (%g, %g, %g) um needs %s, which is no finite number; "
          "admissible: numbers in all voxels around what is asked for",
          name_.c_str(), "xyz"[component], X[0], X[1], X[2], voxels::name_of_voxel(voxel).c_str()));
    return found;
  }
  throw std::logic_error("a vector was asked for where no voxels are held");
}

double VectorField::at(int component, const std::array<double, 3>& X) const {
  std::array<std::int64_t, 3> first;
  std::array<double, 3> share;
  for (std::size_t d = 0; d < 3; ++d) {
    first[d] = lattice_.voxel_below(d, X[d]);
    share[d] =
        (X[d] - lattice_.corner[d]) / lattice_.voxel_size[d] - 0.5 - static_cast<double>(first[d]);
    if (lattice_.size[d] == 1) share[d] = 0.0;
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    std::array<std::int64_t, 3> voxel = first;
    double weight = 1.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const bool is_next = (corner >> d & 1) != 0;
      voxel[d] += is_next ? 1 : 0;
      weight *= is_next ? share[d] : 1.0 - share[d];
    }
    if (weight != 0.0) sum += weight * value(component, voxel, X);
  }
  return sum;
}

}  // namespace stroma::mechanics
