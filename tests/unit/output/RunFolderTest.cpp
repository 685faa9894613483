/// \file
/// The output folder: made, refused, and cleared of an earlier run's results only.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "TemporaryFolder.hpp"
#include "base/Error.hpp"
#include "output/RunFolder.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;

TEST(RunFolder, IsMadeWithItsParentsAndMayExist) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  for (int time = 0; time < 2; ++time) {
    const output::RunFolder run(world, folder / "a/b/");
    EXPECT_TRUE(fs::is_directory(folder / "a/b"));
    EXPECT_TRUE(fs::is_empty(folder / "a/b")) << "the trial file stayed";
    EXPECT_EQ(run.history(), folder / "a/b/history.csv");
    world.barrier();
  }
}

TEST(RunFolder, AFileInTheWayIsAnInputErrorOnEveryRank) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  if (world.is_root()) std::ofstream(folder / "out") << "not a folder";
  const std::string message =
      message_of<base::InputError>([&] { output::RunFolder(world, folder / "out"); });
  EXPECT_EQ(message,
            "cannot make the output folder '" + (folder / "out") + "': a file of that name exists");
  EXPECT_THROW(output::RunFolder(world, folder / "out/deeper"), base::InputError);
}

TEST(RunFolder, AFolderThatCannotBeWrittenIsAnInputError) {
  // /proc cannot be written even by root.
  const std::string message = message_of<base::InputError>(
      [&] { output::RunFolder(base::Communicator::world(), "/proc/stroma"); });
  EXPECT_NE(message.find("cannot make the output folder '/proc/stroma'"), std::string::npos);
  EXPECT_THROW(output::RunFolder(base::Communicator::world(), "/proc"), base::InputError);
}

TEST(RunFolder, RemovesOldResultsAndNothingElse) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const std::vector<std::string> old = {"particles.e", "particles.e.16.03", "grid.e.2.1",
                                        "history.csv", "checkpoint.h5",     "von_mises.png"};
  const std::vector<std::string> other = {"notes.txt", "particles.e.old", "my_particles.e",
                                          "gel.tif"};
  if (world.is_root()) {
    for (const auto& name : old) std::ofstream(folder / name) << "old";
    for (const auto& name : other) std::ofstream(folder / name) << "mine";
  }
  const output::RunFolder run(world, folder.path());
  run.remove_old_results();
  for (const auto& name : old) EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const auto& name : other) EXPECT_EQ(content_of(folder / name), "mine") << name;
}

}  // namespace
}  // namespace stroma
