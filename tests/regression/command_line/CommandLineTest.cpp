// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Mistakes made on the command line: exit status 2, nothing written, and a message that says what
/// was meant or what is admissible.

#include <gtest/gtest.h>

#include "support/Places.hpp"
#include "support/Program.hpp"

namespace stroma::test {
namespace {

struct Mistake {
  std::string arguments;
  std::string told;  ///< standard error contains it
};

const Mistake mistakes[] = {
    {"rnu deck.xml", "no such command: \"rnu\"; did you mean \"run\"?"},
    {"run deck.xml --quite", "run has no option --quite; did you mean \"--quiet\"?"},
    {"run", "DECK is required"},
    {"", "subcommand is required"},
    {"run nowhere.xml", "cannot read the deck 'nowhere.xml'"},
    {"run deck.txt", "admissible: .xml, .yaml or .yml"},
    {"image nowhere.tif", "no such file"},
    {"image nowhere.tif --voxel 1,1,-1", "--voxel: admissible: three lengths in um, each above 0"},
    {"image " + quoted(clone_folder() / "tests/data/cases/mask_types/bool.h5") + " --dataset a",
     "holds no dataset \"a\" (--dataset); admissible: mask"},
    {"phantom -o vessels.png --size 8,8,8", "ends in .tif or .tiff"},
    {"phantom -o vessels.tif --size 8,8,0", "--size: admissible: three numbers of voxels"},
    {"phantom -o nowhere/vessels.tif --size 8,8,8", "there is no folder nowhere"},
    {"phantom -o " + std::string(300, 'a') + ".tif --size 8,8,8", "File name too long"},
    {"phantom -o " + std::string(300, 'a') + "/b.tif --size 8,8,8", "there is no folder"},
    {"reference 'Image|Segmentaton'", "did you mean \"Image|Segmentation\"?"},
};

TEST(CommandLine, EveryMistakeIsExplained) {
  for (const Mistake& mistake : mistakes) {
    const TemporaryFolder folder;
    const Outcome outcome = run_stroma(folder.path(), mistake.arguments);
    EXPECT_EQ(outcome.status, 2) << mistake.arguments;
    EXPECT_NE(outcome.standard_error.find(mistake.told), std::string::npos)
        << "stroma " << mistake.arguments << "\nnot told: " << mistake.told << "\n"
        << outcome.standard_error;
    EXPECT_TRUE(fs::is_empty(folder.path())) << "something was written: " << mistake.arguments;
  }
}

TEST(CommandLine, AWordThatIsKnownAsksForNoSuggestion) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_stroma(folder.path(), "run nowhere.xml --quiet --set='Loading|Steps=2'");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.standard_error.find("cannot read the deck"), std::string::npos)
      << outcome.standard_error;
}

}  // namespace
}  // namespace stroma::test
