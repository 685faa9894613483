// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The pictures exist, are PNG files of the size that the scripts ask for, and can be drawn again.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>

#include "TemporaryFolder.hpp"
#include "stroma/base/Signals.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"
#include "stroma/output/pictures/Pictures.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;

/// A gel of 60 x 40 x 3 particles with a vessel through it, stretched by 10 %.
struct Gel {
  Gel() {
    const auto world = base::Communicator::world();
    int n = 0;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 60; ++i, ++n) {
          if (n % world.size() != world.rank()) continue;
          const double x = i + 0.5, y = j + 0.5;
          const bool vessel = std::abs(y - 20.0 - 8.0 * std::sin(0.1 * x)) < 4.0;
          for (const double value : {x, y, k + 0.5}) position.push_back(value);
          material.push_back(vessel ? 1 : 0);
          for (const double value : {0.0, 0.1 * y, 0.0}) displacement.push_back(value);
          for (const double value : {0.0, vessel ? 200.0 : 110.0, 0.0, 0.0, 0.0, 0.0})
            stress.push_back(value);
        }
    set.count = static_cast<std::int64_t>(material.size());
    set.position = position.data();
    set.material = material.data();
    state.displacement = displacement.data();
    state.stress = stress.data();
  }
  std::vector<double> position, displacement, stress;
  std::vector<std::uint8_t> material;
  output::ParticleSet set;
  output::ParticleState state;
};

struct PngSize {
  unsigned width = 0;
  unsigned height = 0;
};

/// Width and height from a PNG file's header; 0 when it is none.
PngSize png_size(const std::string& path) {
  const std::string bytes = content_of(path);
  if (bytes.size() < 24 || bytes.substr(0, 8) != "\x89PNG\r\n\x1a\n") return {};
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

/// Whether a process has ended, though perhaps nobody has asked for its status yet.
bool is_gone(pid_t process) {
  for (int tries = 0; tries < 200; ++tries) {
    const std::string status = content_of("/proc/" + std::to_string(process) + "/stat");
    if (status.empty() || status.find(") Z") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

bool gnuplot_is_there() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

TEST(Pictures, AreDrawnAndCanBeDrawnAgain) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const Gel gel;
  const output::Pictures pictures(world, folder.path(), "A gel's title, \"quoted\" & 10 %",
                                  {1.0, 1.0, 1.0}, output::Origin::Top);
  EXPECT_EQ(pictures.draw_materials(gel.set, {"collagen_I", "vessel's wall"}), "");
  EXPECT_EQ(pictures.draw_von_mises(gel.set, in_one_piece(gel.set.count, gel.state), 1.0), "");
  std::vector<output::HistoryRow> history(3);
  for (std::size_t n = 0; n < 3; ++n) {
    history[n].load = 0.5 * static_cast<double>(n);
    history[n].reactions = {{0, -4000.0 * static_cast<double>(n), 0},
                            {0, 4000.0 * static_cast<double>(n), 0}};
  }
  EXPECT_EQ(pictures.draw_force({{"top", 1, {0, 4.0, 0}, 0.1}}, history), "");

  for (const char* name : {"vessels", "von_mises", "force"}) {
    const PngSize size = png_size(folder / (std::string(name) + ".png"));
    EXPECT_GE(size.width, 600U) << name;
    EXPECT_GE(size.height, 400U) << name;
    const std::string script = content_of(folder / (std::string("pictures/") + name + ".gp"));
    EXPECT_NE(script.find("size " + std::to_string(size.width) + "," + std::to_string(size.height)),
              std::string::npos)
        << name;
  }
  world.barrier();
  if (world.is_root()) {
    fs::remove(folder / "von_mises.png");
    EXPECT_EQ(output::run_gnuplot(folder / "pictures", "von_mises.gp"), "");
    EXPECT_GT(png_size(folder / "von_mises.png").width, 0U);
  }
}

TEST(Pictures, TheRasterFileHoldsTheStressOfThePixels) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const Gel gel;
  output::Pictures(world, folder.path(), "gel", {1.0, 1.0, 1.0}, output::Origin::Top)
      .draw_von_mises(gel.set, in_one_piece(gel.set.count, gel.state), 1.0);
  const std::string bytes = content_of(folder / "pictures/von_mises.raw");
  ASSERT_EQ(bytes.size(), 60 * 40 * sizeof(float));
  std::vector<float> value(60 * 40);
  std::memcpy(value.data(), bytes.data(), bytes.size());
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 60; ++i) {
      const bool vessel = std::abs(j + 0.5 - 20.0 - 8.0 * std::sin(0.1 * (i + 0.5))) < 4.0;
      EXPECT_FLOAT_EQ(value[static_cast<std::size_t>(60 * j + i)], vessel ? 200.0F : 110.0F);
    }
}

// Row 0 of the image, where y is smallest, is drawn where image viewers show it: at the top.
TEST(Pictures, DrawTheFirstRowAtTheTopUnlessToldOtherwise) {
  const auto world = base::Communicator::world();
  const Gel gel;
  for (const auto& [origin, range] : {std::pair(output::Origin::Top, "set yrange [40:0]\n"),
                                      std::pair(output::Origin::Bottom, "set yrange [0:40]\n")}) {
    const TemporaryFolder folder;
    const output::Pictures pictures(world, folder.path(), "gel", {1.0, 1.0, 1.0}, origin);
    pictures.draw_materials(gel.set, {"collagen", "vessel"});
    pictures.draw_von_mises(gel.set, in_one_piece(gel.set.count, gel.state), 1.0);
    EXPECT_NE(content_of(folder / "pictures/vessels.gp").find(range), std::string::npos);
    world.barrier();
  }
}

TEST(Pictures, ForceIsTheReactionAlongTheDisplacement) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  std::vector<output::HistoryRow> history(2);
  history[0].reactions = {{0, 0, 0}};
  history[1].load = 1.0;
  history[1].reactions = {{30.0, 40.0, 5.0}};
  const output::Pictures pictures(world, folder.path(), "gel", {1.0, 1.0, 1.0},
                                  output::Origin::Top);
  pictures.draw_force({{"side", 0, {3.0, 4.0, 0.0}, 0.0}}, history);
  EXPECT_EQ(content_of(folder / "pictures/force.dat"),
            "# load\tside: displacement [um]\tside: force [pN]\n0\t0\t0\n1\t5\t50\n");
  EXPECT_NE(content_of(folder / "pictures/force.gp").find("force (pN)"), std::string::npos);
  world.barrier();  // the next picture overwrites these files
  history[1].reactions = {{3e6, 4e6, 0.0}};
  pictures.draw_force({{"side", 0, {3.0, 4.0, 0.0}, 0.0}}, history);
  EXPECT_NE(content_of(folder / "pictures/force.gp").find("force (µN)"), std::string::npos);
}

// A run does not fail for a picture: every rank gets the same note, and data and script stay.
TEST(Pictures, WithoutGnuplotANoteSaysHowToDrawThem) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const Gel gel;
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder / "missing").c_str(), 1);
  const std::string note =
      output::Pictures(world, folder.path(), "gel", {1.0, 1.0, 1.0}, output::Origin::Top)
          .draw_von_mises(gel.set, in_one_piece(gel.set.count, gel.state), 1.0);
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(note.rfind("von_mises.png was not drawn: gnuplot is not installed", 0), 0U) << note;
  EXPECT_TRUE(fs::exists(folder / "pictures/von_mises.gp"));
  EXPECT_TRUE(fs::exists(folder / "pictures/von_mises.raw"));
}

// What is lost is an error: gnuplot itself does not tell of a full disk.
TEST(Pictures, WhatCannotBeWrittenIsARunErrorOnEveryRank) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const Gel gel;
  const auto draw = [&](const std::string& where) {
    return message_of<base::RunError>([&] {
      output::Pictures(world, where, "gel", {1.0, 1.0, 1.0}, output::Origin::Top)
          .draw_materials(gel.set, {"collagen", "vessel"});
    });
  };
  if (world.is_root()) std::ofstream(folder / "file") << "in the way";
  world.barrier();
  EXPECT_EQ(draw(folder / "file").rfind("cannot write '" + (folder / "file/pictures/vessels."), 0),
            0U);
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  output::Pictures(world, folder.path(), "gel", {1.0, 1.0, 1.0}, output::Origin::Top)
      .draw_materials(gel.set, {"collagen", "vessel"});
  const auto size = fs::file_size(folder / "vessels.png") - 100;
  for (const auto& entry : fs::directory_iterator(folder / "pictures"))
    ASSERT_LT(fs::file_size(entry.path()), size) << "data and script can still be written";
  base::let_writes_fail();
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{size, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = draw(folder.path());
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(message, "cannot write '" + (folder / "vessels.png") + "': the picture is cut short");
}

TEST(Pictures, NothingToDrawIsANoteToo) {
  const auto world = base::Communicator::world();
  const TemporaryFolder folder;
  const output::Pictures nowhere(world, folder.path(), "gel", {1.0, 1.0, 1.0}, output::Origin::Top);
  EXPECT_EQ(nowhere.draw_materials({}, {"collagen"}),
            "vessels.png was not drawn: there are no particles");
  EXPECT_EQ(nowhere.draw_force({}, {}), "force.png was not drawn: no boundary condition moves");
}

TEST(Gnuplot, AFailureIsToldInOneLine) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder folder;
  if (!base::Communicator::world().is_root()) return;
  std::ofstream(folder / "bad.gp") << "plot 'missing.dat'\n";
  const std::string failure = output::run_gnuplot(folder.path(), "bad.gp");
  EXPECT_NE(failure.find("missing.dat"), std::string::npos) << failure;
  EXPECT_EQ(failure.find('\n'), std::string::npos);
}

// V-SIGNALS.
// A program of that name that hangs, in a child of its own at that.
TEST(Gnuplot, OneThatHangsIsGivenUp) {
  const TemporaryFolder folder;
  if (!base::Communicator::world().is_root()) return;
  std::ofstream(folder / "gnuplot") << "#!/bin/sh\nsleep 300 &\necho $! > child\nwait\n";
  fs::permissions(folder / "gnuplot", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  EXPECT_EQ(output::gnuplot_patience(), std::chrono::minutes(1));
  setenv("PATH", (folder.path() + ":" + path).c_str(), 1);
  const std::string failure =
      output::run_gnuplot(folder.path(), "any.gp", std::chrono::milliseconds(500));
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(failure, "gnuplot did not come to an end in 0.5 s");
  const pid_t child = std::atoi(content_of(folder / "child").c_str());
  ASSERT_GT(child, 0);
  EXPECT_TRUE(is_gone(child));
  EXPECT_EQ(output::gnuplot_patience(), std::chrono::seconds(5)) << "a minute for each picture";
}

}  // namespace
}  // namespace stroma
