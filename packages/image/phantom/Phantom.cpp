// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/phantom/Phantom.hpp"

#include <cmath>

#include "stroma/base/Error.hpp"
#include "stroma/tensor/UnitSize.hpp"

namespace stroma::image {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Whether the point center + d lies in the shape.
bool contains(const ShapeParameters& shape, const Vector& d) {
  using Kind = ShapeParameters::Kind;
  if (shape.kind == Kind::box) {
    const Vector& size = shape.size.value();
    return std::abs(d[0]) < 0.5 * size[0] && std::abs(d[1]) < 0.5 * size[1] &&
           std::abs(d[2]) < 0.5 * size[2];
  }
  const double r = shape.radius.value();
  if (shape.kind == Kind::ball) return dot(d, d) < r * r;
  const Vector a = tensor::of_unit_size(shape.axis.value());
  const double d_along_a = dot(d, a);
  if (shape.length && std::abs(d_along_a) >= 0.5 * *shape.length * std::sqrt(dot(a, a)))
    return false;
  return dot(d, d) * dot(a, a) - d_along_a * d_along_a < r * r * dot(a, a);
}

}  // namespace

voxels::LabelVolume make_shapes(const base::Communicator& communicator,
                                const std::array<std::int64_t, 3>& size,
                                const std::array<double, 3>& voxel_size, const ShapeList& shapes) {
  voxels::LabelVolume labels(communicator, size, voxel_size);
  std::size_t voxel = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k) {
    for (std::int64_t j = 0; j < size[1]; ++j) {
      for (std::int64_t i = 0; i < size[0]; ++i, ++voxel) {
        const Vector x{(static_cast<double>(i) + 0.5) * voxel_size[0],
                       (static_cast<double>(j) + 0.5) * voxel_size[1],
                       (static_cast<double>(labels.first_plane + k) + 0.5) * voxel_size[2]};
        for (const auto& [name, shape] : shapes.shapes) {
          const Vector& c = shape.center;
          if (contains(shape, {x[0] - c[0], x[1] - c[1], x[2] - c[2]}))
            labels.values[voxel] = shape.label;
        }
      }
    }
  }
  return labels;
}

voxels::LabelVolume make_phantom(const base::Communicator& communicator,
                                 const PhantomParameters& parameters) {
  using Kind = PhantomParameters::Kind;
  const std::array<std::int64_t, 3> size{parameters.size[0], parameters.size[1],
                                         parameters.size[2]};
  if (parameters.kind == Kind::shapes)
    return make_shapes(communicator, size, parameters.voxel_size,
                       parameters.shapes.value_or(ShapeList{}));
  if (parameters.kind == Kind::uniform)
    return voxels::LabelVolume(communicator, size, parameters.voxel_size);
  VesselParameters vessels;
  vessels.size = size;
  vessels.voxel_size = parameters.voxel_size;
  vessels.fraction = parameters.fraction.value_or(vessels.fraction);
  vessels.seed = parameters.seed.value_or(static_cast<int>(vessels.seed));
  return make_vessels(communicator, vessels);
}

}  // namespace stroma::image
