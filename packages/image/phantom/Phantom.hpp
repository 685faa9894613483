// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Specimens without an image file: a uniform block, shapes given one by one, or a microvessel
/// network.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stroma/voxels/Volume.hpp"

namespace stroma::image {

/// A ball, a cylinder or a box. Coordinates have their origin at the corner of the specimen.
struct ShapeParameters {
  enum class Kind { ball, cylinder, box };
  Kind kind = Kind::ball;
  int label = 1;                                ///< -1: empty space
  std::array<double, 3> center{0.0, 0.0, 0.0};  ///< [um]
  std::optional<double> radius;                 ///< [um], ball and cylinder
  std::optional<std::array<double, 3>> axis;    ///< direction of a cylinder, of any length but 0
  std::optional<double> length;  ///< [um] of a cylinder, half to each side; absent: without end
  std::optional<std::array<double, 3>> size;  ///< [um] of a box along x, y, z
};

/// Shapes by the names that the deck gives them. Later ones overwrite earlier ones.
struct ShapeList {
  std::vector<std::pair<std::string, ShapeParameters>> shapes;
};

/// A microvessel network: branching tubes with tapering radii in a box (see VesselNetwork.hpp).
struct VesselParameters {
  std::array<std::int64_t, 3> size{512, 512, 52};     ///< voxels
  std::array<double, 3> voxel_size{1.05, 1.05, 1.0};  ///< [um]
  double fraction = 0.194;                            ///< volume fraction of the vessels
  std::int64_t seed = 1;
};

/// The deck's sublist "Phantom" of "Image".
struct PhantomParameters {
  enum class Kind { uniform, vessels, shapes };
  Kind kind = Kind::uniform;
  std::array<int, 3> size{0, 0, 0};                 ///< voxels: x, y, z
  std::array<double, 3> voxel_size{0.0, 0.0, 0.0};  ///< [um]: x, y, z
  std::optional<double> fraction;                   ///< vessels only; absent: 0.194
  std::optional<int> seed;                          ///< vessels only; absent: 1
  std::optional<ShapeList> shapes;                  ///< shapes only
};

/// The labels of a phantom: label 0, and what its kind puts into it. Collective.
voxels::LabelVolume make_phantom(const base::Communicator& communicator,
                                 const PhantomParameters& parameters);

/// Shapes in a block of label 0. A voxel belongs to a shape when its centre x does, with d = x -
/// center:
///
///     ball:      d.d < r^2
///     cylinder:  d.d (a.a) - (d.a)^2 < r^2 (a.a),  and, unless it is without end, |d.a| < (length / 2) |a|
///     box:       |d_i| < size_i / 2
///
/// Later shapes overwrite earlier ones. No communication.
voxels::LabelVolume make_shapes(const base::Communicator& communicator,
                                const std::array<std::int64_t, 3>& size,
                                const std::array<double, 3>& voxel_size, const ShapeList& shapes);

/// A vessel network as labels: 1 vessel, 0 gel; the fraction is met to a voxel or so. The same
/// network for the same seed on any number of ranks. Collective.
/// \throws base::InputError when the fraction cannot be reached in a box of this size
voxels::LabelVolume make_vessels(const base::Communicator& communicator,
                                 const VesselParameters& parameters);

/// A vessel network as a confocal microscope would show it, 8 bit, and what was reached.
struct GreyVessels {
  voxels::Volume<std::uint8_t> volume;
  double drawn_fraction = 0.0;  ///< of the tubes before blur and noise
  double otsu_fraction = 0.0;  ///< above Otsu's threshold of the grey image: this meets the request
  int otsu_threshold = 0;
};

/// The network of make_vessels, blurred by a Gaussian point spread function (0.4 um in the plane,
/// 1.2 um along z) and with the noise of a detector (Poisson, then Gaussian read noise). Blur and
/// noise shift the edge of thin tubes under any threshold; the radii of the tubes are therefore
/// scaled by a common factor until the fraction above Otsu's threshold meets the request to 0.02 %
/// of the volume. Collective.
/// \throws base::InputError as make_vessels
GreyVessels make_grey_vessels(const base::Communicator& communicator,
                              const VesselParameters& parameters);

}  // namespace stroma::image
