/// \file
/// What microscopes and ImageJ put into TIFF files beside plain pages.

#include <gtest/gtest.h>

#include "ReadBack.hpp"

namespace stroma::test {
namespace {

const ValueType u8{Kind::unsigned_integer, 1};

image::ImageSummary summary;

image::ImageParameters file(const std::string& name) {
  image::ImageParameters parameters;
  parameters.file = name;
  return parameters;
}

/// A pattern of planes that follow one another as pages: (z, c, t) is page z of a stack.
Pattern frame_of(const Pattern& pages, std::int64_t z_step, std::int64_t c_step,
                 std::int64_t offset) {
  return [=](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t c) {
    return pages(x, y, offset + z * z_step + c * c_step, 0);
  };
}

TEST(TiffDialects, FramesOfAnImageJHyperstack) {
  TiffOptions options;
  options.size = {5, 4, 24};  // 2 channels, 3 slices, 4 frames
  options.description = "ImageJ=1.53t\nimages=24\nchannels=2\nslices=3\nframes=4\n";
  on_root([&] { write_tiff_file(folder() + "/frames.tif", options, pattern_for(u8)); });
  image::ImageParameters parameters = file("frames.tif");
  for (const int frame : {0, 2, 3}) {
    for (const int channel : {0, 1}) {
      parameters.frame = frame;
      parameters.channel = channel;
      expect_pattern(read_back(parameters, summary), {5, 4, 3},
                     frame_of(pattern_for(u8), 2, 1, 6 * frame), channel);
    }
  }
  EXPECT_EQ(summary.frames, 4);
  EXPECT_TRUE(has_note(summary, "time series of 4 frames; frame 3 is read"));
  parameters.frame = 4;
  expect_refused(parameters, "has no frame 4 (Image|Frame); admissible: 0 to 3");
}

TEST(TiffDialects, FramesOfAnImageJStackInOnePiece) {
  on_root([&] {
    std::string bytes = tiff_head(5, 4, 400, "ImageJ=1.53t\nimages=6\nslices=3\nframes=2\n", true);
    write_bytes(folder() + "/one_piece.tif", bytes + encode({5, 4, 6}, u8, true, pattern_for(u8)));
  });
  image::ImageParameters parameters = file("one_piece.tif");
  for (const int frame : {0, 1}) {
    parameters.frame = frame;
    expect_pattern(read_back(parameters, summary), {5, 4, 3},
                   frame_of(pattern_for(u8), 1, 0, 3 * frame));
  }
}

TEST(TiffDialects, FramesOfAnOmeTiffInEveryOrder) {
  const std::int64_t sizes[3] = {3, 2, 4};  // z, c, t
  for (const std::string order : {"XYZCT", "XYZTC", "XYCZT", "XYCTZ", "XYTZC", "XYTCZ"}) {
    SCOPED_TRACE(order);
    std::int64_t step[3], next = 1;  // of z, c and t from page to page
    for (const char axis : order.substr(2)) {
      const std::size_t a = std::string("ZCT").find(axis);
      step[a] = next;
      next *= sizes[a];
    }
    TiffOptions options;
    options.size = {5, 4, 24};
    options.description = "<OME><Image><Pixels DimensionOrder=\"" + order +
                          "\" SizeX=\"5\" SizeY=\"4\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"4\">"
                          "<TiffData/></Pixels></Image></OME>";
    on_root([&] { write_tiff_file(folder() + "/frames.ome.tif", options, pattern_for(u8)); });
    image::ImageParameters parameters = file("frames.ome.tif");
    parameters.channel = 1;
    for (const int frame : {0, 3}) {
      parameters.frame = frame;
      expect_pattern(read_back(parameters, summary), {5, 4, 3},
                     frame_of(pattern_for(u8), step[0], step[1], frame * step[2]), 1);
    }
    EXPECT_EQ(summary.frames, 4);
    base::Communicator::world().barrier();
  }
}

}  // namespace
}  // namespace stroma::test
