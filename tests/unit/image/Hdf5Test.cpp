// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// HDF5 as programs write it: stated axes, Imaris, BigDataViewer, masks, sparse and unsupported
/// storage.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>

#include "ReadBack.hpp"
#include "WriteFiles.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/image/ReadVolume.hpp"
#include "stroma/image/formats/Hdf5Axes.hpp"
#include "support/Places.hpp"

namespace stroma::test {
namespace {

using Size = std::array<std::int64_t, 3>;
using Extents = std::vector<hsize_t>;

/// The volume that all of these files hold: x + 14 y + 140 z, and 1000 a channel, 10000 a frame.
const Size size{14, 10, 6};
double value_at(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t c = 0,
                std::int64_t t = 0) {
  return static_cast<double>(x + 14 * y + 140 * z + 1000 * c + 10000 * t);
}

/// An HDF5 file that is being written by rank 0.
class File {
 public:
  explicit File(const std::string& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)),
        links_(H5Pcreate(H5P_LINK_CREATE)) {
    H5Pset_create_intermediate_group(links_, 1);
  }
  ~File() {
    H5Pclose(links_);
    H5Fclose(file_);
  }
  hid_t get() const { return file_; }

  /// A dataset of doubles, converted to its type; closed by the caller.
  hid_t dataset(const std::string& name, const Extents& extents, hid_t type,
                const std::vector<double>& values, hid_t properties = H5P_DEFAULT) const {
    const hid_t space = H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
    const hid_t set = H5Dcreate2(file_, name.c_str(), type, space, links_, properties, H5P_DEFAULT);
    if (!values.empty())
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    return set;
  }
  hid_t group(const std::string& name) const {
    return H5Gcreate2(file_, name.c_str(), links_, H5P_DEFAULT, H5P_DEFAULT);
  }

 private:
  hid_t file_, links_;
};

/// A text of fixed length; as single characters, the way Imaris writes it.
void write_text(hid_t object, const char* name, const std::string& text, bool apart = false) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, apart ? 1 : text.size());
  const hsize_t count = apart ? text.size() : 1;
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, text.data());
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

/// Texts of variable length, as h5py writes them.
void write_texts(hid_t object, const char* name, const std::vector<const char*>& texts) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  const hsize_t count = texts.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, type, texts.data());
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

std::string axistags(const std::string& keys) {
  std::string json = "{\"axes\": [";
  for (const char key : keys) {
    json += std::string(json.back() == '[' ? "" : ", ") + "{\"key\": \"" + key +
            "\", \"typeFlags\": 2, \"resolution\": 0, \"description\": \"the \\\"key\\\": \"}";
  }
  return json + "]}";
}

/// A dataset whose dimensions mean these letters: 2 channels, 3 frames.
void write_axes(const std::string& path, const std::string& keys, const char* attribute) {
  Extents extents;
  for (const char key : keys) {
    const std::size_t axis = std::string("xyz").find(key);
    extents.push_back(axis < 3 ? static_cast<hsize_t>(size[axis]) : key == 'c' ? 2 : 3);
  }
  std::vector<double> values;
  std::vector<hsize_t> at(extents.size(), 0);
  for (bool more = true; more;) {
    std::array<std::int64_t, 5> place{};
    for (std::size_t d = 0; d < keys.size(); ++d)
      place[std::string("xyzct").find(keys[d])] = static_cast<std::int64_t>(at[d]);
    values.push_back(value_at(place[0], place[1], place[2], place[3], place[4]));
    more = false;
    for (std::size_t d = keys.size(); d-- > 0 && !more;) {
      more = ++at[d] < extents[d];
      if (!more) at[d] = 0;
    }
  }
  const File file(path);
  const hid_t set = file.dataset("exported_data", extents, H5T_STD_U16LE, values);
  if (std::string(attribute) == "axistags") write_text(set, attribute, axistags(keys));
  if (std::string(attribute) == "DIMENSION_LABELS") {
    std::vector<std::string> labels;
    for (const char key : keys) labels.emplace_back(1, key);
    std::vector<const char*> pointers;
    for (const std::string& label : labels) pointers.push_back(label.c_str());
    write_texts(set, attribute, pointers);
  }
  H5Dclose(set);
}

image::ImageSummary summary;

image::ImageParameters parameters_of(const std::string& path) {
  image::ImageParameters parameters;
  parameters.file = path;
  return parameters;
}

voxels::IntensityVolume read(const image::ImageParameters& parameters) {
  return image::read_volume(base::Communicator::world(), parameters, "", summary);
}

std::string refusal(const image::ImageParameters& parameters) {
  try {
    read(parameters);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool noted(const std::string& words) {
  return std::any_of(summary.notes.begin(), summary.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

void expect_values(const voxels::IntensityVolume& volume, std::int64_t c = 0, std::int64_t t = 0,
                   const Size& first = {0, 0, 0}, const Size& count = size) {
  ASSERT_EQ(volume.size, count);
  std::size_t voxel = 0;
  for (std::int64_t z = 0; z < volume.planes; ++z) {
    for (std::int64_t y = 0; y < count[1]; ++y) {
      for (std::int64_t x = 0; x < count[0]; ++x, ++voxel) {
        ASSERT_EQ(volume.values[voxel],
                  value_at(first[0] + x, first[1] + y, first[2] + volume.first_plane + z, c, t));
      }
    }
  }
}

std::string case_file(const std::string& name) {
  return clone_folder().string() + "/tests/data/cases/" + name;
}

TEST(Hdf5, AxesAreReadAsTheyAreStated) {
  for (const char* attribute : {"axistags", "DIMENSION_LABELS"}) {
    for (const std::string keys :
         {"zyx", "xyz", "yxz", "zyxc", "czyx", "xyzc", "tczyx", "tzyxc", "cxzyt"}) {
      SCOPED_TRACE(keys + std::string(" by ") + attribute);
      const std::string path = folder() + "/axes.h5";
      on_root([&] { write_axes(path, keys, attribute); });
      image::ImageParameters parameters = parameters_of(path);
      const bool has_c = keys.find('c') != std::string::npos;
      const bool has_t = keys.find('t') != std::string::npos;
      parameters.channel = has_c ? 1 : 0;
      parameters.frame = has_t ? 2 : 0;
      expect_values(read(parameters), parameters.channel, parameters.frame);
      EXPECT_EQ(summary.channels, has_c ? 2 : 1);
      EXPECT_EQ(summary.frames, has_t ? 3 : 1);
      parameters.region = {{3, 2, 1, 7, 5, 4}};
      expect_values(read(parameters), parameters.channel, parameters.frame, {3, 2, 1}, {7, 5, 4});
      base::Communicator::world().barrier();
    }
  }
}

/// As MATLAB 7.3 writes it.
TEST(Hdf5, AUsersBlockInFrontIsPassedOver) {
  const std::string path = folder() + "/behind.h5";
  Hdf5Dataset dataset;
  dataset.name = "data";
  on_root([&] {
    write_hdf5(path, {dataset});
    write_bytes(path, "MATLAB 7.3 MAT-file" + std::string(493, ' ') + read_bytes(path));
  });
  image::ImageParameters parameters;
  parameters.file = "behind.h5";
  expect_pattern(read_back(parameters, summary), {5, 4, 3}, pattern_for(dataset.type));
}

TEST(Hdf5, FilesOfIlastik) {
  for (const char* name : {"zyxc.h5", "xyz.h5"}) {
    expect_values(read(parameters_of(case_file(std::string("ilastik_axes/") + name))));
    EXPECT_EQ(summary.channels, 1);
    EXPECT_TRUE(noted("as axistags say"));
  }
}

TEST(Hdf5, KeysOfAxistags) {
  EXPECT_EQ(image::keys_of_axistags(axistags("tzyxc")), "tzyxc");
  EXPECT_EQ(image::keys_of_axistags("{\"axes\":[{\"key\":\"X\"},{\"key\":\"width\"}]}"), "x?");
  for (const char* broken : {"", "{", "\"key\"", "{\"axes\": [{\"key\": 3}]}", "\"key\": \"", "\\"})
    EXPECT_LE(image::keys_of_axistags(broken).size(), 1u) << broken;
}

TEST(Hdf5, AxesThatContradictTheDatasetAreRefused) {
  const auto refused = [](const std::string& tags) {
    const std::string path = folder() + "/contradiction.h5";
    on_root([&] {
      const File file(path);
      const hid_t set = file.dataset("raw", {6, 10, 14}, H5T_STD_U16LE, std::vector<double>(840));
      write_text(set, "axistags", tags);
      H5Dclose(set);
    });
    const std::string said = refusal(parameters_of(path));
    base::Communicator::world().barrier();
    return said;
  };
  EXPECT_NE(refused(axistags("zyxc")).find("do not fit its 6 x 10 x 14"), std::string::npos);
  EXPECT_NE(refused(axistags("zyy")).find("name an axis twice"), std::string::npos);
  EXPECT_NE(refused(axistags("eyx")).find("an axis of 6 entries"), std::string::npos);
  EXPECT_NE(refused(axistags("cyt")).find("no x or no y"), std::string::npos);
  EXPECT_NE(refused("{}").find("do not fit"), std::string::npos);
}

TEST(Hdf5, AShortLastAxisWithoutTagsIsSaid) {
  const std::string path = folder() + "/short.h5";
  for (const Extents& extents : {Extents{6, 10, 14, 3}, Extents{10, 14, 3}}) {
    on_root([&] {
      const File file(path);
      H5Dclose(file.dataset("raw", extents, H5T_STD_U8LE, std::vector<double>(6 * 10 * 14 * 3)));
    });
    read(parameters_of(path));
    EXPECT_TRUE(noted("the last has only 3 entries"));
    base::Communicator::world().barrier();
  }
  on_root([&] {
    const File file(path);
    H5Dclose(file.dataset("raw", {1, 2, 6, 10, 14}, H5T_STD_U16LE, std::vector<double>(1680)));
  });
  read(parameters_of(path));
  EXPECT_EQ(summary.file_size, size);
  EXPECT_EQ(summary.channels, 2);
  EXPECT_TRUE(noted("read as [t][c][z][y][x]"));
}

TEST(Hdf5, ImarisIsCutToItsSizeAndMeasuredByItsExtents) {
  read(parameters_of(case_file("imaris/a.ims")));
  EXPECT_EQ(summary.format, "HDF5, Imaris");
  EXPECT_EQ(summary.file_size, size);
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 2.0}));
  EXPECT_EQ(summary.voxel_size.source(), "Imaris extents");
}

TEST(Hdf5, ImarisChannelsAndTimePoints) {
  const std::string path = folder() + "/two.ims";
  on_root([&] {
    const File file(path);
    for (int t = 0; t < 3; ++t) {
      for (int c = 0; c < 2; ++c) {
        for (int level = 0; level < 2; ++level) {
          const std::string name = "DataSet/ResolutionLevel " + std::to_string(level) +
                                   "/TimePoint " + std::to_string(t) + "/Channel " +
                                   std::to_string(c);
          std::vector<double> values(8 * 16 * 16, 65535.0);
          for (std::size_t v = 0; v < values.size(); ++v) {
            const auto x = static_cast<std::int64_t>(v % 16),
                       y = static_cast<std::int64_t>(v / 16 % 16),
                       z = static_cast<std::int64_t>(v / 256);
            if (x < 14 && y < 10 && z < 6) values[v] = value_at(x, y, z, c, t);
          }
          H5Dclose(file.dataset(name + "/Data", {8, 16, 16}, H5T_STD_U16LE, values));
          const hid_t group = H5Gopen2(file.get(), name.c_str(), H5P_DEFAULT);
          write_text(group, "ImageSizeX", "14", true);
          write_text(group, "ImageSizeY", "10", true);
          write_text(group, "ImageSizeZ", "6", true);
          H5Gclose(group);
        }
      }
    }
    const hid_t info = file.group("DataSetInfo/Image");
    for (const char* axis : {"0", "1", "2"}) {
      write_text(info, (std::string("ExtMin") + axis).c_str(), "-0.0035", true);
      write_text(info, (std::string("ExtMax") + axis).c_str(), "0.0105", true);
    }
    write_text(info, "Unit", "mm", true);
    H5Gclose(info);
  });
  image::ImageParameters parameters = parameters_of(path);
  for (const int c : {0, 1}) {
    for (const int t : {0, 2}) {
      parameters.channel = c;
      parameters.frame = t;
      expect_values(read(parameters), c, t);
    }
  }
  EXPECT_EQ(summary.channels, 2);
  EXPECT_EQ(summary.frames, 3);
  EXPECT_NEAR(summary.voxel_size.um[0], 1.0, 1e-12);
  EXPECT_NEAR(summary.voxel_size.um[2], 14.0 / 6.0, 1e-12);
  parameters.channel = 2;
  EXPECT_NE(refusal(parameters).find("has no channel 2"), std::string::npos);
  parameters.channel = 0;
  parameters.frame = 3;
  EXPECT_NE(refusal(parameters).find("has no frame 3"), std::string::npos);
  parameters.frame = 0;
  parameters.dataset = "/DataSet/ResolutionLevel 0/TimePoint 1/Channel 1/Data";
  expect_values(read(parameters), 1, 1);
}

TEST(Hdf5, BigDataViewerIsUnsignedAndItsVoxelSizeIsInItsXml) {
  const std::string path = folder() + "/view.h5";
  on_root([&] {
    const File file(path);
    for (const char* name : {"t00000/s00/0/cells", "t00000/s01/0/cells", "t00000/s01/1/cells"}) {
      std::vector<double> values;
      for (std::int64_t v = 0; v < 840; ++v)  // 60000 and more, in 16 bits with a sign
        values.push_back(60000.0 + static_cast<double>(v) - (v % 2 == 0 ? 65536.0 : 60000.0));
      H5Dclose(file.dataset(name, {6, 10, 14}, H5T_STD_I16LE, values));
    }
    write_bytes(folder() + "/view.xml",
                "<SpimData><SequenceDescription><ViewSetups><ViewSetup><id>0</id></ViewSetup>"
                "<ViewSetup><id>1</id><name>b</name><voxelSize><unit>\xC2\xB5m</unit>"
                "<size>0.5 0.25 2.0</size></voxelSize></ViewSetup></ViewSetups>"
                "</SequenceDescription></SpimData>");
  });
  image::ImageParameters parameters = parameters_of(path);
  parameters.channel = 1;
  const voxels::IntensityVolume volume = read(parameters);
  ASSERT_EQ(volume.size, size);
  for (std::size_t i = 0; i < volume.values.size(); ++i) {
    const std::int64_t v = static_cast<std::int64_t>(i) + 140 * volume.first_plane;
    ASSERT_EQ(volume.values[i], static_cast<double>(v) + (v % 2 == 0 ? 60000.0 : 0.0));
  }
  EXPECT_EQ(summary.format, "HDF5, BigDataViewer");
  EXPECT_EQ(summary.files, (std::vector<std::string>{path, folder() + "/view.xml"}));
  EXPECT_EQ(summary.type.name(), "16-bit unsigned integer");
  EXPECT_TRUE(noted("stand for unsigned ones"));
  EXPECT_TRUE(noted("view setup 1, resolution level 0"));
  EXPECT_EQ(summary.voxel_size.um, (std::array<double, 3>{0.5, 0.25, 2.0}));
  parameters.channel = 0;
  read(parameters);
  EXPECT_TRUE(noted("no voxel size in a known unit for view setup 0"));
  EXPECT_FALSE(summary.voxel_size.known(0));
}

// V-TRACE-2.
TEST(Hdf5, ALinkIntoAnotherFileIsNotFollowed) {
  const std::string path = folder() + "/link.h5";
  on_root([&] {
    const File linked(folder() + "/linked.h5"), file(path);
    for (const File* one : {&linked, &file})
      H5Dclose(one->dataset("own", {2, 2, 2}, H5T_STD_U8LE, std::vector<double>(8, 1.0)));
    H5Lcreate_external("linked.h5", "own", file.get(), "other", H5P_DEFAULT, H5P_DEFAULT);
  });
  image::ImageParameters parameters = parameters_of(path);
  read(parameters);
  EXPECT_EQ(summary.files, std::vector<std::string>{path});
  parameters.dataset = "other";
  EXPECT_THROW(read(parameters), base::InputError);
}

TEST(Hdf5, LinksWithinAFileAreFollowed) {
  const std::string path = folder() + "/links.h5";
  on_root([&] {
    const File file(path);
    for (const double value : {1.0, 2.0}) {
      const std::string name = value == 1.0 ? "one" : "two";
      H5Dclose(file.dataset(name.c_str(), {2, 3, 4}, H5T_STD_U8LE, std::vector<double>(24, value)));
    }
    H5Lcreate_soft("/two", file.get(), "soft", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_hard(file.get(), "two", file.get(), "unlike", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/nothing", file.get(), "dangling", H5P_DEFAULT, H5P_DEFAULT);
  });
  image::ImageParameters parameters = parameters_of(path);
  for (const char* name : {"two", "soft", "/unlike"}) {
    parameters.dataset = name;
    expect_pattern(read(parameters), {4, 3, 2}, [](auto, auto, auto, auto) { return 2.0; });
  }
  for (const char* name : {"dangling", "/", "three"}) {
    parameters.dataset = name;
    EXPECT_THROW(read(parameters), base::InputError) << name;
  }
}

// MATLAB's A(row, column, plane) comes as [plane][column][row].
TEST(Hdf5, MatlabsOrderIsSaid) {
  const std::string path = folder() + "/matlab.mat";
  on_root([&] {
    const File file(path);
    const hid_t set = file.dataset("A", {3, 4, 5}, H5T_STD_U8LE, std::vector<double>(60, 1.0));
    const hid_t text = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(text, 6);
    const hid_t attribute = H5Acreate2(set, "MATLAB_class", text, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, text, "double");
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(text);
    H5Dclose(set);
  });
  read(parameters_of(path));
  EXPECT_TRUE(has_note(summary, "its rows are counted along x, its columns along y"));
}

TEST(Hdf5, MasksOfEveryType) {
  const auto ones = [](const voxels::IntensityVolume& volume) {
    double sum = 0.0;
    for (const double value : volume.values) sum += value;
    return base::Communicator::world().sum(sum);
  };
  EXPECT_EQ(ones(read(parameters_of(case_file("mask_types/bool.h5")))), 2.0 * 4.0 * 5.0);
  EXPECT_EQ(summary.type.name(), "8-bit signed integer");
  const std::string path = folder() + "/masks.h5";
  std::vector<unsigned char> bits(840, 0);
  std::vector<double> halves(840, 0.0);
  for (std::size_t v = 0; v < 840; v += 3) {
    bits[v] = 1;
    halves[v] = 0.5;
  }
  on_root([&] {
    const File file(path);
    const hid_t set = file.dataset("bits", {6, 10, 14}, H5T_STD_B8LE, {});
    H5Dwrite(set, H5T_NATIVE_B8, H5S_ALL, H5S_ALL, H5P_DEFAULT, bits.data());
    H5Dclose(set);
    const hid_t half = H5Tcopy(H5T_IEEE_F32LE);  // IEEE's half precision
    H5Tset_fields(half, 15, 10, 5, 0, 10);
    H5Tset_size(half, 2);
    H5Tset_ebias(half, 15);
    H5Dclose(file.dataset("half", {6, 10, 14}, half, halves));
    H5Dclose(file.dataset("int64", {6, 10, 14}, H5T_STD_I64LE, halves));
    H5Tclose(half);
    const hid_t pair = H5Tcreate(H5T_COMPOUND, 16);
    H5Tinsert(pair, "re", 0, H5T_NATIVE_DOUBLE);
    H5Tinsert(pair, "im", 8, H5T_NATIVE_DOUBLE);
    H5Dclose(file.dataset("pair", {6, 10, 14}, pair, {}));
    H5Tclose(pair);
  });
  image::ImageParameters parameters = parameters_of(path);
  parameters.dataset = "bits";
  EXPECT_EQ(ones(read(parameters)), 280.0);
  parameters.dataset = "half";
  EXPECT_EQ(ones(read(parameters)), 140.0);
  EXPECT_EQ(summary.type.name(), "16-bit float");
  parameters.dataset = "int64";
  read(parameters);
  EXPECT_EQ(summary.type.name(), "64-bit signed integer");
  parameters.dataset = "pair";
  EXPECT_NE(refusal(parameters).find("holds compound values"), std::string::npos);
}

TEST(Hdf5, AnEnumKeepsValuesWithoutAName) {
  const std::string path = folder() + "/enum.h5";
  on_root([&] {
    const File file(path);
    const hid_t one = H5Tenum_create(H5T_STD_I16BE);
    const unsigned char name_of_1[2] = {0, 1};
    H5Tenum_insert(one, "gel", name_of_1);
    std::vector<unsigned char> stored;
    for (int v = 0; v < 60; ++v) stored.insert(stored.end(), {1, static_cast<unsigned char>(v)});
    const hid_t set = file.dataset("labels", {3, 4, 5}, one, {});
    H5Dwrite(set, one, H5S_ALL, H5S_ALL, H5P_DEFAULT, stored.data());
    H5Dclose(set);
    H5Tclose(one);
  });
  const voxels::IntensityVolume volume = read(parameters_of(path));
  for (std::int64_t k = 0; k < volume.planes; ++k)
    for (std::int64_t v = 0; v < 20; ++v)
      EXPECT_EQ(volume.plane(k)[v], 256.0 + static_cast<double>(20 * (k + volume.first_plane) + v));
}

TEST(Hdf5, DimensionScalesAreNotReadAndThatIsSaid) {
  const std::string path = folder() + "/scales.h5";
  on_root([&] {
    const File file(path);
    const hid_t set = file.dataset("data", {3, 4, 5}, H5T_STD_U8LE, std::vector<double>(60, 1.0));
    const hid_t space = H5Screate(H5S_SCALAR);
    for (const char* name : {"DIMENSION_LIST", "scale_factor"}) {
      const hid_t attribute =
          H5Acreate2(set, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
      const double two = 2.0;
      H5Awrite(attribute, H5T_NATIVE_DOUBLE, &two);
      H5Aclose(attribute);
    }
    H5Sclose(space);
    H5Dclose(set);
  });
  read(parameters_of(path));
  EXPECT_TRUE(has_note(summary, "its dimension scales, which may name the axes, are not read"));
  EXPECT_TRUE(has_note(summary, "its attribute scale_factor is not applied"));
}

TEST(Hdf5, ASparseDatasetIsReadAndWhatWasNeverWrittenIsSaid) {
  const std::string path = folder() + "/sparse.h5";
  const std::vector<unsigned char> bright(16 * 16 * 16, 255);
  on_root([&] {
    const File file(path);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t chunk[3] = {16, 16, 16};
    H5Pset_chunk(properties, 3, chunk);
    H5Pset_deflate(properties, 9);
    for (const char* name : {"some", "none"}) {
      const hid_t set = file.dataset(name, {160, 512, 512}, H5T_STD_U8LE, {}, properties);
      if (name[0] == 's') {
        const hid_t in_file = H5Dget_space(set), in_memory = H5Screate_simple(3, chunk, nullptr);
        const hsize_t first[3] = {32, 64, 480};
        H5Sselect_hyperslab(in_file, H5S_SELECT_SET, first, nullptr, chunk, nullptr);
        H5Dwrite(set, H5T_NATIVE_UCHAR, in_memory, in_file, H5P_DEFAULT, bright.data());
        H5Sclose(in_file);
        H5Sclose(in_memory);
      }
      H5Dclose(set);
    }
    H5Pclose(properties);
  });
  image::ImageParameters parameters = parameters_of(path);
  parameters.dataset = "some";
  parameters.region = {{470, 60, 30, 42, 30, 20}};
  const voxels::IntensityVolume volume = read(parameters);
  const auto found = std::count(volume.values.begin(), volume.values.end(), 255.0);
  EXPECT_EQ(base::Communicator::world().sum(static_cast<std::int64_t>(found)), 16 * 16 * 16);
  EXPECT_TRUE(noted("10239 of the dataset's 10240 chunks were never written"));
  parameters.dataset = "none";
  EXPECT_NE(refusal(parameters).find("none was ever written"), std::string::npos);
}

TEST(Hdf5, WhatCannotBeReadIsCalledSo) {
  const std::string path = folder() + "/filters.h5";
  on_root([&] {
    const File file(path);
    const hsize_t chunk[3] = {6, 10, 14};
    for (const int filter : {32000, 32001, 32004, 32015, 307, 31999}) {
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(properties, 3, chunk);
      H5Pset_filter(properties, filter, H5Z_FLAG_OPTIONAL, 0, nullptr);
      H5Dclose(file.dataset("f" + std::to_string(filter), {6, 10, 14}, H5T_STD_U8LE,
                            std::vector<double>(840), properties));
      H5Pclose(properties);
    }
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, "elsewhere.raw", 0, 840);
    H5Dclose(file.dataset("external", {6, 10, 14}, H5T_STD_U8LE, {}, properties));
    H5Pclose(properties);
  });
  image::ImageParameters parameters = parameters_of(path);
  const auto refused = [&](const std::string& dataset) {
    parameters.dataset = dataset;
    return refusal(parameters);
  };
  const std::pair<const char*, const char*> names[] = {
      {"f32000", "compressed by lzf (HDF5 filter 32000)"},
      {"f32001", "compressed by blosc (HDF5 filter 32001)"},
      {"f32004", "compressed by lz4 (HDF5 filter 32004)"},
      {"f32015", "compressed by zstd (HDF5 filter 32015)"},
      {"f307", "compressed by bzip2 (HDF5 filter 307)"},
      {"f31999", "a filter of unknown name (HDF5 filter 31999)"},
      {"external", "values in other files"}};
  for (const auto& [dataset, words] : names) {
    const std::string said = refused(dataset);
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_EQ(said.find("broken"), std::string::npos) << said;
  }
}

TEST(Hdf5, VoxelSizesWithoutAUnitAreSaidAndNotUsed) {
  const std::string path = folder() + "/spacing.h5";
  on_root([&] {
    const File file(path);
    const hid_t set = file.dataset("raw", {6, 10, 14}, H5T_STD_U8LE, std::vector<double>(840));
    const hsize_t three = 3;
    const hid_t line = H5Screate_simple(1, &three, nullptr);
    const hid_t attribute =
        H5Acreate2(set, "spacing", H5T_IEEE_F64LE, line, H5P_DEFAULT, H5P_DEFAULT);
    const double spacing[3] = {2.0, 0.5, 0.5};
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, spacing);
    H5Aclose(attribute);
    H5Sclose(line);
    H5Dclose(set);
  });
  read(parameters_of(path));
  EXPECT_FALSE(summary.voxel_size.known(2));
  EXPECT_TRUE(noted("the attribute spacing (2, 0.5, 0.5) says neither its unit nor its order"));
}

}  // namespace
}  // namespace stroma::test
