// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// What lies in an output folder: nobody's files are removed or overwritten but those that a run of
/// Stroma left, and one run at a time writes there.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/Places.hpp"
#include "support/SmallDeck.hpp"

namespace stroma::test {
namespace {

const std::string fast = " --quiet --set 'Output|Pictures=false'";

class OutputFolder : public ::testing::Test {
 protected:
  void SetUp() override { folder_.write("gel.yaml", small_deck()); }

  Outcome run(const std::string& out, const std::string& deck = "gel.yaml",
              const std::string& more = "", int ranks = 1) const {
    return run_stroma(folder_.path(), "run " + deck + " -o " + out + fast + more, ranks);
  }
  void expect_refused(const Outcome& outcome, const std::string& told) const {
    EXPECT_EQ(outcome.status, 2) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find(told), std::string::npos) << outcome.standard_error;
  }

  const TemporaryFolder folder_;
};

// V-FOLDER.
TEST_F(OutputFolder, TheUsersFilesStay) {
  ASSERT_EQ(run("first").status, 0);
  fs::copy(folder_ / "first/deck.xml", folder_ / "deck.xml");
  const std::string deck = content_of(folder_ / "deck.xml");
  expect_refused(run(".", "deck.xml"), "holds 'deck.xml' as 'deck.xml'");
  for (const char* name : {"log.txt", "history.csv", "particles.e", "grid.e"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder other;
    other.write(name, "mine");
    expect_refused(run(quoted(other.path())), std::string("holds '") + name + "'");
    EXPECT_EQ(content_of(other / name), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(other.path()), {}), 1);
  }
  EXPECT_EQ(content_of(folder_ / "deck.xml"), deck);
}

TEST_F(OutputFolder, OnTwoRanksTheSameNamesAreInTheWayAndThoseOfOneRankAreNot) {
  fs::create_directory(folder_ / "out");
  folder_.write("out/particles.e", "mine");
  folder_.write("out/history.csv", "mine");
  expect_refused(run("out", "gel.yaml", "", 2), "holds 'history.csv', which");
  fs::remove(folder_ / "out/history.csv");
  for (int time = 0; time < 2; ++time) EXPECT_EQ(run("out", "gel.yaml", "", 2).status, 0);
  EXPECT_EQ(content_of(folder_ / "out/particles.e"), "mine");
}

// The deck by a soft link, by a second name, and by a roundabout path.
TEST_F(OutputFolder, TheDeckIsNotOverwrittenByWhateverPath) {
  ASSERT_EQ(run("first").status, 0);
  fs::copy(folder_ / "first/deck.xml", folder_ / "gel.xml");
  fs::create_directory(folder_ / "soft");
  fs::create_symlink("../gel.xml", folder_ / "soft/deck.xml");
  fs::create_directory(folder_ / "hard");
  fs::create_hard_link(folder_ / "gel.xml", folder_ / "hard/deck.xml");
  for (const std::string out : {"soft", "hard", "soft/../hard"})
    expect_refused(run(out, "gel.xml"), "holds 'gel.xml' as 'deck.xml'");
  expect_refused(run("first", "first/deck.xml"), "holds 'first/deck.xml' as 'deck.xml'");
  // A link to anything else is not followed either.
  fs::create_directory(folder_ / "linked");
  const fs::path notes = folder_.write("notes.txt", "mine");
  fs::create_symlink("../notes.txt", folder_ / "linked/log.txt");
  expect_refused(run("linked"), "holds 'log.txt'");
  EXPECT_EQ(content_of(notes), "mine");
}

TEST_F(OutputFolder, AnEarlierRunsFilesGoAndTheLogSaysSo) {
  ASSERT_EQ(run("out", "gel.yaml", "", 2).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/particles.e.2.1"));
  folder_.write("out/notes.txt", "mine");
  fs::copy(folder_ / "out", folder_ / "copy", fs::copy_options::recursive);
  for (const char* out : {"out", "copy"}) {
    SCOPED_TRACE(out);
    const Outcome again = run(out);
    ASSERT_EQ(again.status, 0) << again.standard_error;
    EXPECT_FALSE(fs::exists(folder_ / out / "particles.e.2.1"));
    EXPECT_TRUE(fs::exists(folder_ / out / "particles.e"));
    EXPECT_EQ(content_of(folder_ / out / "notes.txt"), "mine");
    EXPECT_NE(content_of(folder_ / out / "log.txt").find("files of an earlier run"),
              std::string::npos);
  }
}

TEST_F(OutputFolder, WhatWasChangedSinceIsTheUsers) {
  ASSERT_EQ(run("out").status, 0);
  for (const char* name : {"deck.xml", "history.csv", "grid.e"}) {
    SCOPED_TRACE(name);
    const std::string before = content_of(folder_ / "out" / name);
    std::ofstream(folder_ / "out" / name, std::ios::app) << " ";
    expect_refused(run("out"), std::string("holds '") + name + "'");
    EXPECT_EQ(content_of(folder_ / "out" / name), before + " ");
    std::ofstream(folder_ / "out" / name, std::ios::binary) << before;
  }
  EXPECT_EQ(run("out").status, 0);
}

// V-FOLDER.
TEST_F(OutputFolder, NotesUnderTheNameOfTheLogStay) {
  ASSERT_EQ(run("out").status, 0);
  const std::string log = content_of(folder_ / "out/log.txt"), notes = "my own lab notes\n";
  for (const bool is_killed : {false, true}) {
    SCOPED_TRACE(is_killed);
    if (is_killed) leave_as_killed(folder_ / "out");
    folder_.write("out/log.txt", notes);
    for (const std::string more : {"", " --restart"})
      expect_refused(run("out", "gel.yaml", more), "holds 'log.txt', which");
    EXPECT_EQ(content_of(folder_ / "out/log.txt"), notes);
    EXPECT_TRUE(fs::exists(folder_ / "out/history.csv"));
  }
  folder_.write("out/log.txt", log);
  EXPECT_EQ(run("out").status, 0);
  // The log that tells what was removed, too.
  leave_as_killed(folder_ / "out");
  EXPECT_EQ(run("out").status, 0);
}

// V-FOLDER.
TEST_F(OutputFolder, ALogOfARunThatEndedStaysIfItWasAddedTo) {
  ASSERT_EQ(run("out").status, 0);
  const std::string log = content_of(folder_ / "out/log.txt");
  folder_.write("out/log.txt", log + "look at step 2 again\n");
  expect_refused(run("out"), "holds 'log.txt', which");
  EXPECT_EQ(content_of(folder_ / "out/log.txt"), log + "look at step 2 again\n");
  // Earlier versions took no checksum of the log.
  const std::string files = content_of(folder_ / "out/.stroma_files");
  folder_.write("out/.stroma_files",
                std::regex_replace(files, std::regex("log.txt\t[0-9].*\n"), ""));
  EXPECT_EQ(run("out").status, 0);
}

TEST_F(OutputFolder, ARefusedRunRemovesNothingAndLeavesNothing) {
  ASSERT_EQ(run("out").status, 0);
  const std::string history = content_of(folder_ / "out/history.csv");
  const std::string wrong = " --set 'Materials|ball|Label=7'";
  EXPECT_EQ(run("out", "gel.yaml", wrong).status, 2);
  EXPECT_EQ(content_of(folder_ / "out/history.csv"), history);
  EXPECT_EQ(run("a/b", "gel.yaml", wrong).status, 2);
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST_F(OutputFolder, WhatCannotBeMadeIsRefusedWithTheReason) {
  expect_refused(run("a/" + std::string(300, 'b')), "File name too long");
  EXPECT_FALSE(fs::exists(folder_ / "a"));
  fs::create_symlink("loop", folder_ / "loop");
  expect_refused(run("loop"), "cannot make the output folder 'loop': ");
  expect_refused(run("gel.yaml/out"),
                 "cannot make the output folder 'gel.yaml/out': Not a directory");
}

std::string host() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

TEST_F(OutputFolder, OneRunAtATime) {
  fs::create_directory(folder_ / "out");
  const fs::path lock = folder_ / "out/.stroma_lock";
  std::ofstream(lock) << host() << " " << getpid() << " ?\n";
  expect_refused(run("out"), "another run, process " + std::to_string(getpid()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 1)
      << "something was written";

  std::ofstream(lock) << "elsewhere " << getpid() << " ?\n";
  expect_refused(run("out"),
                 "on the machine 'elsewhere'; if that run is gone, remove 'out/.stroma_lock'");
  std::ofstream(lock) << "";
  expect_refused(run("out"), "does not say by whom");
  EXPECT_TRUE(fs::exists(lock));
}

TEST_F(OutputFolder, TheLockOfAProcessThatIsGoneIsTakenOver) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  fs::create_directory(folder_ / "out");
  // The first process is gone; the second one is another than the one that made the lock.
  for (const std::string& process :
       {std::to_string(child) + " ?", std::to_string(getpid()) + " 1"}) {
    std::ofstream(folder_ / "out/.stroma_lock") << host() << " " << process << "\n";
    const Outcome outcome = run("out");
    EXPECT_EQ(outcome.status, 0) << outcome.standard_error;
    EXPECT_NE(content_of(folder_ / "out/log.txt").find("note: the lock of an earlier run"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "out/.stroma_lock"));
  }
}

TEST_F(OutputFolder, OfManyRunsAtOnceOneWrites) {
  const Outcome outcome = run_script(folder_, R"(
for i in 1 2 3 4; do
  ("$stroma" run gel.yaml -o out --quiet --set Loading\|Steps=1000 --set Output\|Pictures=false 2>>errors; echo $? >>status) &
done
wait
sort status | tr -d '\n'
)");
  // Those that came while the first one ran: at least one, for a run takes longer than a start.
  EXPECT_NE(outcome.standard_output.find('0'), std::string::npos) << outcome.standard_output;
  EXPECT_NE(outcome.standard_output.find('2'), std::string::npos) << outcome.standard_output;
  EXPECT_EQ(outcome.standard_output.find('1'), std::string::npos) << outcome.standard_output;
  EXPECT_EQ(History(folder_ / "out/history.csv").rows(), 1001U);
}

TEST(PhantomFile, OnlyAPhantomIsOverwritten) {
  const TemporaryFolder folder;
  const std::string command = "phantom -o a.tif --size 32,32,8 --seed ";
  ASSERT_EQ(run_stroma(folder.path(), command + "1").status, 0);
  const std::string first = content_of(folder / "a.tif");
  ASSERT_EQ(run_stroma(folder.path(), command + "2").status, 0);
  EXPECT_NE(content_of(folder / "a.tif"), first);
  const fs::path image = clone_folder() / "tests" / "data" / "images" / "slice25_vessels.tif";
  fs::copy_file(image, folder / "a.tif", fs::copy_options::overwrite_existing);
  const Outcome refused = run_stroma(folder.path(), command + "3");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.standard_error.find("is no phantom that Stroma wrote"), std::string::npos);
  EXPECT_EQ(content_of(folder / "a.tif"), content_of(image));
}

}  // namespace
}  // namespace stroma::test
