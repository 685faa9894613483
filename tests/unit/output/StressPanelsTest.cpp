// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// A picture's raster is read back as it was drawn, and panels of several stand on one scale.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "TemporaryFolder.hpp"
#include "stroma/output/pictures/PictureFile.hpp"
#include "stroma/output/pictures/RasterPlot.hpp"
#include "stroma/output/pictures/StressPanels.hpp"

namespace stroma::output {
namespace {

/// A map of values that grow along x up to `largest`; complete on rank 0, as rasters are.
Raster map_of(int columns, int rows, double first_x, float largest) {
  Raster raster{columns, rows, {first_x, 0.25}, {1.05, 0.5}, {}};
  if (!base::Communicator::world().is_root()) return raster;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      raster.value.push_back(largest * static_cast<float>(i + 1) / static_cast<float>(columns));
  raster.value[0] = std::numeric_limits<float>::quiet_NaN();
  return raster;
}

/// The numbers that follow a word in each line of a script that holds it.
std::vector<std::string> lines_with(const std::string& script, const std::string& word) {
  std::vector<std::string> lines;
  std::istringstream stream(script);
  for (std::string line; std::getline(stream, line);)
    if (line.rfind(word, 0) == 0) lines.push_back(line.substr(word.size()));
  return lines;
}

// V-STUDY-PICTURES.
TEST(RasterPlot, IsReadBackAsItWasDrawn) {
  const auto world = base::Communicator::world();
  const TemporaryFolder folder;
  const Raster raster = map_of(7, 5, -3.25, 200.0f);
  draw_picture(world, folder.path(), "von_mises", raster_bytes(raster), "raw",
               "set view map\nplot " + raster_clause(raster, "von_mises") + "\n");
  const StoredRaster stored = read_raster(folder / "pictures", "von_mises");
  ASSERT_TRUE(stored.raster) << stored.missing_because;
  EXPECT_EQ(stored.raster->columns, 7);
  EXPECT_EQ(stored.raster->rows, 5);
  EXPECT_EQ(stored.raster->first, raster.first);
  EXPECT_EQ(stored.raster->pixel, raster.pixel);
  if (world.is_root()) {
    EXPECT_EQ(raster_bytes(*stored.raster), raster_bytes(raster));
    EXPECT_EQ(stored.raster->value[6], 200.0f);
  }
}

TEST(RasterPlot, SaysWhyARasterCannotBeRead) {
  const auto world = base::Communicator::world();
  const TemporaryFolder folder;
  const auto reason = [&] { return read_raster(folder / "pictures", "von_mises").missing_because; };
  EXPECT_NE(reason().find("there is no "), std::string::npos) << reason();
  world.barrier();  // all have looked
  const Raster raster = map_of(7, 5, 0.0, 1.0f);
  const std::string clause = "plot " + raster_clause(raster, "von_mises") + "\n";
  draw_picture(world, folder.path(), "von_mises", raster_bytes(raster).substr(0, 4 * 7 * 5 - 8),
               "raw", clause);
  EXPECT_NE(reason().find("do not go together"), std::string::npos) << reason();
  world.barrier();
  draw_picture(world, folder.path(), "von_mises", raster_bytes(raster), "raw", "plot x\n");
  EXPECT_NE(reason().find("does not tell the pixels"), std::string::npos) << reason();
}

TEST(StressPanels, StandOnOneScale) {
  const auto world = base::Communicator::world();
  const TemporaryFolder folder;
  std::vector<StressPanel> panels{
      {"8 px", map_of(60, 80, 0.0, 100.0f)},
      {"a rather long name of a member that takes several lines", map_of(60, 80, 2.0, 300.0f)},
      {"2 px", map_of(120, 90, -4.0, 200.0f)}};
  const std::string note =
      draw_stress_panels(world, folder.path(), "A study", "collagen only", panels, Origin::Top);
  if (std::system("gnuplot --version > /dev/null 2>&1") == 0) {
    EXPECT_EQ(note, "");
    EXPECT_EQ(content_of(folder / "von_mises.png").substr(1, 3), "PNG");
  }
  const std::string script = content_of(folder / "pictures/von_mises.gp");
  EXPECT_EQ(lines_with(script, "plot ").size(), 3u);
  EXPECT_EQ(lines_with(script, "set cbrange "), (std::vector<std::string>{"[0:300]"}));
  EXPECT_EQ(lines_with(script, "set colorbox ").size(), 1u);
  EXPECT_EQ(lines_with(script, "set xrange ").size(), 1u);
  EXPECT_EQ(lines_with(script, "set yrange ").size(), 1u);
  for (const char* text : {"(a) 8 px", "(b) a rather long", "(c) 2 px", "collagen only"})
    EXPECT_NE(script.find(text), std::string::npos) << text;
  // All in one file, one after the other; the window holds the widest of them.
  EXPECT_EQ(content_of(folder / "pictures/von_mises.raw").size(), 4u * (4800 + 4800 + 10800));
  EXPECT_NE(script.find(" skip=19200 "), std::string::npos) << script;
  EXPECT_NE(script.find(" skip=38400 "), std::string::npos) << script;
  double low = 0.0, high = 0.0;
  ASSERT_EQ(std::sscanf(lines_with(script, "set xrange ")[0].c_str(), "[%lf:%lf]", &low, &high), 2);
  EXPECT_LT(low, -4.0 - 0.525);
  EXPECT_GT(high, -4.0 - 0.525 + 120 * 1.05);
  // The first row of the image is at the top: y falls on the way up.
  ASSERT_EQ(std::sscanf(lines_with(script, "set yrange ")[0].c_str(), "[%lf:%lf]", &low, &high), 2);
  EXPECT_GT(low, 0.25 + 89.5 * 0.5);
  EXPECT_LT(high, 0.25 - 0.25);
  // The panels' edges: the same width in every column, and none reaches into the next.
  const auto left = lines_with(script, "set lmargin at screen "),
             right = lines_with(script, "set rmargin at screen ");
  ASSERT_EQ(left.size(), 3u);
  const double width = std::stod(right[0]) - std::stod(left[0]);
  for (std::size_t p = 1; p < 3; ++p) {
    EXPECT_NEAR(std::stod(right[p]) - std::stod(left[p]), width, 2e-5);
    if (std::stod(left[p]) > std::stod(left[p - 1])) {
      EXPECT_GT(std::stod(left[p]), std::stod(right[p - 1]));
    }
  }
}

TEST(ColourScale, CutsOffRarePeaksOnly) {
  std::vector<float> values(1000, 100.0f);
  values[0] = 130.0f;
  EXPECT_EQ(colour_scale(values).end, 130.0);
  values[0] = 900.0f;
  values[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(colour_scale(values).end, 100.0);
  EXPECT_EQ(colour_scale(values).largest, 900.0);
}

}  // namespace
}  // namespace stroma::output
