// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Phantoms: shapes against their formulas, vessel networks against the fraction asked for.

#include <gtest/gtest.h>

#include <cmath>

#include "WriteFiles.hpp"
#include "commands/PhantomCommand.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/labels/Segmentation.hpp"
#include "stroma/image/phantom/Phantom.hpp"

namespace stroma::test {
namespace {

using image::ShapeParameters;

const base::Communicator& world() {
  static const base::Communicator instance = base::Communicator::world();
  return instance;
}

voxels::LabelVolume shapes(const std::vector<ShapeParameters>& list) {
  image::ShapeList named;
  for (const ShapeParameters& shape : list) named.shapes.emplace_back("shape", shape);
  return image::make_shapes(world(), {40, 36, 30}, {0.5, 0.6, 0.8}, named);
}

/// Fraction of a label times the volume of the block, 20 x 21.6 x 24 um.
double volume_of(const voxels::LabelVolume& labels, std::int32_t label) {
  const auto fractions = image::volume_fractions(world(), labels);
  return fractions.count(label) ? fractions.at(label) * 20.0 * 21.6 * 24.0 : 0.0;
}

TEST(Shapes, VolumesAreThoseOfGeometry) {
  constexpr double pi = 3.14159265358979;
  ShapeParameters ball;
  ball.center = {10.0, 10.8, 12.0};
  ball.radius = 8.0;
  EXPECT_NEAR(volume_of(shapes({ball}), 1), 4.0 / 3.0 * pi * 512.0, 0.01 * 2144.0);
  ShapeParameters cylinder = ball;
  cylinder.kind = ShapeParameters::Kind::cylinder;
  cylinder.radius = 5.0;
  cylinder.axis = {{0.0, 0.0, 3.0}};
  EXPECT_NEAR(volume_of(shapes({cylinder}), 1), pi * 25.0 * 24.0, 0.01 * 1885.0);
  cylinder.length = 12.8;
  EXPECT_NEAR(volume_of(shapes({cylinder}), 1), pi * 25.0 * 12.8, 0.01 * 1005.0);
  const double volume = volume_of(shapes({cylinder}), 1);
  cylinder.axis = {{0.0, 0.0, 1e-200}};
  EXPECT_EQ(volume_of(shapes({cylinder}), 1), volume);
  ShapeParameters box = ball;
  box.kind = ShapeParameters::Kind::box;
  box.radius.reset();
  box.size = {{5.0, 6.0, 8.0}};
  EXPECT_NEAR(volume_of(shapes({box}), 1), 240.0, 1e-9);
}

// The condition of the reference cases: d.d (a.a) - (d.a)^2 < r^2 (a.a) at the voxel's centre.
TEST(Shapes, ASlantedCylinderIsItsFormulaVoxelByVoxel) {
  ShapeParameters cylinder;
  cylinder.kind = ShapeParameters::Kind::cylinder;
  cylinder.center = {7.0, 9.0, 11.0};
  cylinder.axis = {{1.0, 2.0, -0.5}};
  cylinder.radius = 3.0;
  cylinder.label = 2;
  const voxels::LabelVolume labels = shapes({cylinder});
  std::size_t voxel = 0;
  for (std::int64_t k = 0; k < labels.planes; ++k) {
    for (std::int64_t j = 0; j < 36; ++j) {
      for (std::int64_t i = 0; i < 40; ++i) {
        const double d[3] = {(i + 0.5) * 0.5 - 7.0, (j + 0.5) * 0.6 - 9.0,
                             (k + labels.first_plane + 0.5) * 0.8 - 11.0};
        const double dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2],
                     da = d[0] + 2.0 * d[1] - 0.5 * d[2];
        ASSERT_EQ(labels.values[voxel++], dd * 5.25 - da * da < 9.0 * 5.25 ? 2 : 0);
      }
    }
  }
}

TEST(Shapes, LaterOnesOverwriteEarlierOnes) {
  ShapeParameters large;
  large.center = {10.0, 10.8, 12.0};
  large.radius = 8.0;
  ShapeParameters hole = large;
  hole.radius = 4.0;
  hole.label = -1;
  EXPECT_GT(volume_of(shapes({large, hole}), -1), 0.0);
  EXPECT_EQ(volume_of(shapes({hole, large}), -1), 0.0);
}

image::VesselParameters small_network() {
  image::VesselParameters parameters;
  parameters.size = {128, 112, 24};
  return parameters;
}

TEST(Vessels, LabelsReachTheFraction) {
  for (const double fraction : {0.02, 0.104, 0.194, 0.4}) {
    image::VesselParameters parameters = small_network();
    parameters.fraction = fraction;
    const voxels::LabelVolume labels = image::make_vessels(world(), parameters);
    EXPECT_NEAR(image::volume_fractions(world(), labels).at(1), fraction, 5e-4);
  }
}

// A single slice, for plane strain, is cut from a thicker network.
TEST(Vessels, OneSliceReachesTheFractionToo) {
  image::VesselParameters parameters;
  parameters.size = {200, 180, 1};
  EXPECT_NEAR(image::volume_fractions(world(), image::make_vessels(world(), parameters)).at(1),
              0.194, 5e-4);
  EXPECT_NEAR(image::make_grey_vessels(world(), parameters).otsu_fraction, 0.194, 0.002);
}

TEST(Vessels, AFractionThatABoxCannotHoldIsRefused) {
  image::VesselParameters parameters;
  parameters.size = {2, 2, 2};
  EXPECT_THROW(image::make_vessels(world(), parameters), base::InputError);
}

// A network, not a heap of grains: few objects, and the largest holds much of it.
TEST(Vessels, AreConnectedTubes) {
  const voxels::LabelVolume labels = image::make_vessels(world(), small_network());
  const image::Objects objects(world(), labels, image::Connectivity::corners);
  EXPECT_LT(objects.count(), 25);
  EXPECT_GT(static_cast<double>(objects.largest()),
            0.3 * 0.194 * static_cast<double>(labels.voxels()));
  for (const double plane : image::plane_fractions(world(), labels, 1)) EXPECT_GT(plane, 0.05);
}

TEST(Vessels, AreTheSameForTheSameSeedOnAnyNumberOfRanks) {
  const base::Communicator self = base::Communicator::self();
  const image::VesselParameters parameters = small_network();
  const image::GreyVessels spread = image::make_grey_vessels(world(), parameters);
  const image::GreyVessels whole = image::make_grey_vessels(self, parameters);
  const std::int64_t first = spread.volume.first_plane * spread.volume.plane_voxels();
  for (std::size_t i = 0; i < spread.volume.values.size(); ++i)
    ASSERT_EQ(spread.volume.values[i], whole.volume.values[static_cast<std::size_t>(first) + i]);
  image::VesselParameters other = parameters;
  other.seed = 2;
  EXPECT_NE(image::make_grey_vessels(self, other).volume.values, whole.volume.values);
}

TEST(Vessels, GreyImageReachesTheFractionAboveItsOtsuThreshold) {
  for (const double fraction : {0.104, 0.194}) {
    PhantomOptions options;
    options.output = folder() + "/vessels.tif";
    options.size = {160, 144, 26};
    options.fraction = fraction;
    base::Log log(world(), true);
    EXPECT_EQ(phantom_command(world(), options, log), 0);

    image::ImageParameters parameters;
    parameters.file = options.output;
    image::ImageSummary summary;
    const voxels::LabelVolume labels = image::read_labels(world(), parameters, "", &summary);
    EXPECT_NEAR(image::volume_fractions(world(), labels).at(1), fraction, 0.002);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(summary.voxel_size.um[axis], options.voxel_size[axis], 1e-9);
    world().barrier();
  }
}

TEST(Vessels, OptionsThatMakeNoSenseAreRefused) {
  base::Log log(world(), true);
  PhantomOptions options;
  EXPECT_THROW(phantom_command(world(), options, log), base::InputError);
  options.output = folder() + "/no_such_folder/vessels.tif";
  EXPECT_THROW(phantom_command(world(), options, log), base::InputError);
  options.output = folder() + "/vessels.tif";
  options.fraction = 1.2;
  EXPECT_THROW(phantom_command(world(), options, log), base::InputError);
  options.fraction = 0.2;
  options.size = {16, 0, 16};
  EXPECT_THROW(phantom_command(world(), options, log), base::InputError);
}

TEST(Phantom, FromTheDeckWithARegion) {
  image::ImageParameters parameters;
  image::PhantomParameters& phantom = parameters.phantom.emplace();
  phantom.size = {8, 6, 10};
  phantom.voxel_size = {1.0, 2.0, 3.0};
  const voxels::LabelVolume uniform = image::read_labels(world(), parameters, "");
  EXPECT_EQ(image::volume_fractions(world(), uniform), (std::map<std::int32_t, double>{{0, 1.0}}));
  phantom.kind = image::PhantomParameters::Kind::shapes;
  ShapeParameters box;
  box.kind = ShapeParameters::Kind::box;
  box.center = {0.0, 0.0, 0.0};
  box.size = {{4.0, 8.0, 24.0}};  // of which the voxels 0-1, 0-1, 0-3 lie in the specimen
  phantom.shapes = image::ShapeList{{{"corner", box}}};
  parameters.region = {{1, 1, 2, 4, 4, 4}};
  const voxels::LabelVolume part = image::read_labels(world(), parameters, "");
  EXPECT_EQ(part.size, (std::array<std::int64_t, 3>{4, 4, 4}));
  EXPECT_DOUBLE_EQ(image::volume_fractions(world(), part).at(1), 2.0 / 64.0);
}

}  // namespace
}  // namespace stroma::test
