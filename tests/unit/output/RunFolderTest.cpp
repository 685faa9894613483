// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The output folder: made, refused, and cleared of an earlier run's results only.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/Manifest.hpp"
#include "stroma/output/files/RunFolder.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;

TEST(RunFolder, IsMadeWithItsParentsAndMayExist) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  for (int time = 0; time < 2; ++time) {
    const output::RunFolder run(world, folder / "a/b/", {});
    EXPECT_TRUE(fs::is_directory(folder / "a/b"));
    EXPECT_EQ(run.history(), folder / "a/b/history.csv");
    world.barrier();
    if (time == 1 && world.is_root()) std::ofstream(folder / "a/notes") << "mine";
  }
  world.barrier();
  EXPECT_FALSE(fs::exists(folder / "a/b")) << "nothing was written";
}

TEST(RunFolder, AFileInTheWayIsAnInputErrorOnEveryRank) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  if (world.is_root()) std::ofstream(folder / "out") << "not a folder";
  const std::string message =
      message_of<base::InputError>([&] { output::RunFolder(world, folder / "out", {}); });
  EXPECT_EQ(message,
            "cannot make the output folder '" + (folder / "out") + "': a file of that name exists");
  EXPECT_THROW(output::RunFolder(world, folder / "out/deeper", {}), base::InputError);
}

TEST(RunFolder, AFolderThatCannotBeWrittenIsAnInputError) {
  // /proc cannot be written even by root.
  const std::string message = message_of<base::InputError>(
      [&] { output::RunFolder(base::Communicator::world(), "/proc/stroma", {}); });
  EXPECT_NE(message.find("cannot make the output folder '/proc/stroma'"), std::string::npos);
  EXPECT_THROW(output::RunFolder(base::Communicator::world(), "/proc", {}), base::InputError);
}

// V-FOLDER.
TEST(RunFolder, RemovesWhatARunLeftAndNothingElse) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const std::vector<std::string> names = output::run_files(true, true, true);
  const std::vector<std::string> old = {"deck.xml", "history.csv", "pictures/force.dat"};
  const std::vector<std::string> other = {"notes.txt", "particles.e.old", "my_particles.e"};
  base::Log log(world, true);
  {
    const output::RunFolder run(world, folder.path(), names);
    run.refuse_foreign_files({});
    run.remove_old_results(log);
    if (world.is_root()) {
      fs::create_directory(folder / "pictures");
      for (const auto& name : old) std::ofstream(folder / name) << "old";
      for (const auto& name : other) std::ofstream(folder / name) << "mine";
    }
    world.barrier();
    run.finish();
  }
  if (world.is_root()) std::ofstream(folder / "grid.e") << "mine";
  world.barrier();
  const output::RunFolder run(world, folder.path(), names);
  if (world.size() == 1) {
    EXPECT_NE(message_of<base::InputError>([&] { run.refuse_foreign_files({}); }).find("'grid.e'"),
              std::string::npos);
  }
  run.remove_old_results(log);
  for (const auto& name : old) EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const auto& name : other) EXPECT_EQ(content_of(folder / name), "mine") << name;
  EXPECT_EQ(content_of(folder / "grid.e"), "mine");
}

TEST(Manifest, KnowsWhatAKilledRunLeftByHowItBegins) {
  const TemporaryFolder folder;
  if (!base::Communicator::world().is_root()) return;
  output::Manifest manifest(folder.path());
  manifest.begin({"history.csv", "grid.e", "log.txt"});
  const auto is_own = [&](const std::string& name, const std::string& content) {
    std::ofstream(folder / name, std::ios::binary) << content;
    return output::Manifest(folder.path()).is_own(name);
  };
  EXPECT_TRUE(is_own("history.csv", "step,load,newton"));
  EXPECT_FALSE(is_own("history.csv", "my,own,table"));
  EXPECT_TRUE(is_own("grid.e-s002.16.03", "\x89HDF"));
  EXPECT_FALSE(is_own("grid.e.2.0", "mine"));
  EXPECT_FALSE(is_own("notes.txt", ""));
  const std::string note = "note: the lock of an earlier run was taken over\n";
  for (const std::string first :
       {"image      8 x 8 x 8 voxels", "removed     3 files", "goes on    after step 2",
        "title       gel", "study       study.yaml: 2 members", "fit         fit.yaml: 1 number"}) {
    EXPECT_TRUE(is_own("log.txt", first + "\n"));
    EXPECT_TRUE(is_own("log.txt", note + first + "\n"));
  }
  EXPECT_TRUE(is_own("log.txt", ""));
  EXPECT_FALSE(is_own("log.txt", "my own lab notes\nimage      8 x 8 x 8 voxels"));
  EXPECT_FALSE(is_own("log.txt", note));
}

}  // namespace
}  // namespace stroma
