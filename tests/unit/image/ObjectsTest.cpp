// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Connected objects, counted over slabs, against a flood fill of the whole volume.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "stroma/image/labels/Fragments.hpp"
#include "stroma/image/labels/NumberedObjects.hpp"
#include "stroma/image/labels/Objects.hpp"
#include "stroma/image/phantom/CounterRandom.hpp"

namespace stroma::test {
namespace {

using Size = std::array<std::int64_t, 3>;

template <class Label>
voxels::LabelVolume volume_of(const Size& size, Label&& label) {
  voxels::LabelVolume volume(base::Communicator::world(), size, {1.0, 1.0, 1.0});
  const std::int64_t first = volume.first_plane * volume.plane_voxels();
  for (std::size_t i = 0; i < volume.values.size(); ++i)
    volume.values[i] = label(first + static_cast<std::int64_t>(i));
  return volume;
}

/// (voxel of a whole volume) The number of its object in the order of first voxels, or 0, by flood
/// fill.
template <class Label>
std::vector<std::int64_t> flood_fill(const Size& size, Label&& label, bool corners,
                                     std::int32_t ground = 0) {
  const std::int64_t voxels = size[0] * size[1] * size[2];
  std::vector<std::int64_t> number(static_cast<std::size_t>(voxels), 0);
  std::int64_t objects = 0;
  for (std::int64_t start = 0; start < voxels; ++start) {
    if (number[static_cast<std::size_t>(start)] > 0 || label(start) < 0 || label(start) == ground)
      continue;
    std::vector<std::int64_t> front{start};
    number[static_cast<std::size_t>(start)] = ++objects;
    while (!front.empty()) {
      const std::int64_t v = front.back();
      front.pop_back();
      const Size at{v % size[0], v / size[0] % size[1], v / (size[0] * size[1])};
      for (int n = 0; n < 27; ++n) {
        const Size d{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        if (!corners && std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) > 1) continue;
        const Size to{at[0] + d[0], at[1] + d[1], at[2] + d[2]};
        if (to[0] < 0 || to[1] < 0 || to[2] < 0 || to[0] >= size[0] || to[1] >= size[1] ||
            to[2] >= size[2])
          continue;
        const std::int64_t w = to[0] + size[0] * (to[1] + size[1] * to[2]);
        if (number[static_cast<std::size_t>(w)] > 0 || label(w) != label(v)) continue;
        number[static_cast<std::size_t>(w)] = objects;
        front.push_back(w);
      }
    }
  }
  return number;
}

/// Sizes of objects, largest first.
std::vector<std::int64_t> sizes_of(const std::vector<std::int64_t>& number) {
  std::vector<std::int64_t> sizes;
  for (const std::int64_t object : number) {
    if (object == 0) continue;
    sizes.resize(std::max(sizes.size(), static_cast<std::size_t>(object)), 0);
    ++sizes[static_cast<std::size_t>(object - 1)];
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

template <class Label>
void expect_same(const Size& size, Label&& label) {
  const voxels::LabelVolume volume = volume_of(size, label);
  for (const bool corners : {false, true}) {
    const std::vector<std::int64_t> expected = sizes_of(flood_fill(size, label, corners));
    const image::Objects objects(
        base::Communicator::world(), volume,
        corners ? image::Connectivity::corners : image::Connectivity::faces);
    SCOPED_TRACE(corners ? "26 neighbours" : "6 neighbours");
    EXPECT_EQ(objects.count(), static_cast<std::int64_t>(expected.size()));
    EXPECT_EQ(objects.largest(), expected.empty() ? 0 : expected.front());
    for (const std::int64_t smallest : {2, 5, 27}) {
      EXPECT_EQ(objects.count(smallest), std::count_if(expected.begin(), expected.end(),
                                                       [&](auto n) { return n >= smallest; }));
    }
  }
}

TEST(Objects, RandomVoxelsNearPercolation) {
  const Size size{19, 17, 13};
  for (const double density : {0.05, 0.25, 0.32}) {
    expect_same(size, [&](std::int64_t v) {
      return image::random_uniform(5, static_cast<std::uint64_t>(v)) < density ? 1 : 0;
    });
  }
}

// A thread that runs up and down through all slabs: 7 columns joined in turns at the top and the
// bottom.
TEST(Objects, AThreadThatCrossesEverySlabManyTimes) {
  const Size size{13, 1, 12};
  const auto thread = [&](std::int64_t v) {
    const std::int64_t x = v % 13, z = v / 13;
    if (x % 2 == 0) return 1;
    return z == ((x / 2) % 2 == 0 ? 11 : 0) ? 1 : 0;
  };
  expect_same(size, thread);
  const image::Objects objects(base::Communicator::world(), volume_of(size, thread),
                               image::Connectivity::faces);
  EXPECT_EQ(objects.count(), 1);
  EXPECT_EQ(objects.largest(), 7 * 12 + 6);
}

TEST(Objects, DifferentLabelsAreDifferentObjectsAndEmptySpaceIsNone) {
  const Size size{6, 5, 8};
  expect_same(size, [](std::int64_t v) { return static_cast<std::int32_t>(v / 60 % 4) - 1; });
}

/// Numbers and moments, against those of the flood fill.
template <class Label>
void expect_numbered(const Size& size, Label&& label, std::int32_t ground) {
  const base::Communicator world = base::Communicator::world();
  const std::vector<std::int64_t> number = flood_fill(size, label, true, ground);
  std::vector<image::ObjectMoments> expected(
      static_cast<std::size_t>(*std::max_element(number.begin(), number.end())));
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    image::ObjectMoments& object = expected[static_cast<std::size_t>(number[v] - 1)];
    const auto voxel = static_cast<std::int64_t>(v);
    const Size at{voxel % size[0], voxel / size[0] % size[1], voxel / (size[0] * size[1])};
    object.label = label(voxel);
    ++object.voxels;
    for (std::size_t d = 0; d < 3; ++d) {
      object.sum[d] += at[d];
      object.products[d] += at[d] * at[d];
      object.products[3 + d] += at[d] * at[(d + 1) % 3];
    }
  }
  const image::NumberedObjects found = image::number_objects(world, volume_of(size, label), ground);
  EXPECT_EQ(found.count, static_cast<std::int64_t>(expected.size()));
  EXPECT_EQ(world.sum(static_cast<std::int64_t>(found.moments.size())), found.count);
  const auto first = static_cast<std::size_t>(found.number.first_plane * size[0] * size[1]);
  for (std::size_t v = 0; v < found.number.values.size(); ++v)
    ASSERT_EQ(found.number.values[v], number[first + v]);
  for (std::size_t n = 0; n < found.moments.size(); ++n) {
    const image::ObjectMoments &is = found.moments[n],
                               &was = expected[static_cast<std::size_t>(found.first) - 1 + n];
    EXPECT_EQ(is.label, was.label);
    EXPECT_EQ(is.voxels, was.voxels);
    EXPECT_EQ(is.sum, was.sum);
    EXPECT_EQ(is.products, was.products);
  }
}

// V-TABLE-3.
TEST(Objects, HaveNumbersAndMoments) {
  const Size size{11, 9, 12};
  const auto noise = [](std::int64_t v) {
    return static_cast<std::int32_t>(5.0 *
                                     image::random_uniform(5, static_cast<std::uint64_t>(v))) -
           1;
  };
  for (const std::int32_t ground : {-1, 0, 2}) expect_numbered(size, noise, ground);
  expect_numbered(
      {13, 1, 12}, [](std::int64_t v) { return v % 2 == 0 ? 1 : 0; }, 0);
  expect_numbered(
      {4, 4, 3}, [](std::int64_t) { return 0; }, -1);
}

TEST(Objects, FewerPlanesThanRanks) {
  expect_same({7, 6, 1}, [](std::int64_t v) { return v % 3 == 0 ? 1 : 0; });
  expect_same({7, 6, 2}, [](std::int64_t v) { return v % 5 < 2 ? 1 : 0; });
}

TEST(Objects, SmallOnesBecomeLabelZero) {
  const base::Communicator world = base::Communicator::world();
  const Size size{8, 8, 8};
  // A bar of 8 voxels along z, one of 7, and a loose voxel that touches the second by a corner.
  const auto bars = [&](std::int64_t v) {
    const std::int64_t x = v % 8, y = v / 8 % 8, z = v / 64;
    if (x == 1 && y == 1) return 1;
    if (x == 5 && y == 5 && z < 7) return 2;
    return x == 7 && y == 2 && z == 3 ? 1 : 0;
  };
  voxels::LabelVolume volume = volume_of(size, bars);
  EXPECT_EQ(image::remove_small_objects(world, volume, 8), 2);
  std::int64_t left = 0;
  for (const std::int32_t label : volume.values) {
    EXPECT_NE(label, 2);
    left += label;
  }
  EXPECT_EQ(world.sum(left), 8);
}

/// A column from bottom to top, a speck beside it that touches it along an edge only, another on
/// the floor and one that hangs from the ceiling.
std::int32_t label_with_specks(std::int64_t voxel) {
  const std::int64_t x = voxel % 6, y = voxel / 6 % 5, z = voxel / 30;
  if (x < 2 && y < 2) return 0;
  if (x == 2 && y == 2 && (z == 3 || z == 4)) return 1;
  if (x == 5 && y == 4) return z < 2 || z == 6 ? 0 : -1;
  return -1;
}

TEST(Fragments, AreWhatNoFaceJoinsToAConditionsReach) {
  const auto world = base::Communicator::world();
  const Size size{6, 5, 7};
  const auto filled = [&](const voxels::LabelVolume& labels) {
    return world.sum<std::int64_t>(std::count_if(labels.values.begin(), labels.values.end(),
                                                 [](auto label) { return label >= 0; }));
  };
  voxels::LabelVolume labels = volume_of(size, label_with_specks);
  EXPECT_EQ(filled(labels), 28 + 2 + 3);
  const auto expect_left = [&](const std::optional<image::FaceReach>& reach, std::int64_t bodies,
                               std::int64_t voxels, const std::string& note) {
    const image::Bodies left = image::leave_out_fragments(world, labels, reach);
    EXPECT_EQ(left.count, bodies);
    EXPECT_EQ(left.note.substr(0, note.size()), note);
    EXPECT_EQ(left.note.empty(), note.empty()) << left.note;
    EXPECT_EQ(filled(labels), voxels);
  };
  expect_left(std::nullopt, 4, 28 + 2 + 3, "");
  expect_left({{{{0, 0}, {0, 0}, {2, 1}}}}, 3, 28 + 3,
              "1 fragment of the body, 2 voxels or 6.1 % of it, is left out: ");
  expect_left({{{{0, 0}, {0, 0}, {0, 0}}}}, 3, 28 + 3, "");  // nothing is held
  expect_left({{{{1, 0}, {0, 0}, {0, 0}}}}, 1, 28,
              "2 fragments of the body, 3 voxels in all (the largest: 2) or 9.7 % of it, ");
  expect_left({{{{1, 0}, {0, 0}, {0, 0}}}}, 1, 28, "");
}

}  // namespace
}  // namespace stroma::test
