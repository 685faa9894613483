/// \file
/// Every deck of tests/decks/bad holds one mistake. The program must end with exit status 2, name
/// the mistake on standard error in a few plain lines, and leave nothing behind.
///
/// Beside NAME.xml or NAME.yaml stands NAME.expected: each line a text that standard error must
/// contain; a line 'command: check' asks for another subcommand than run.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace stroma {
namespace {

namespace fs = std::filesystem;

const fs::path corpus = fs::path(STROMA_SOURCE_DIR) / "tests" / "decks" / "bad";

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool is_deck(const fs::path& path) {
  return path.extension() == ".xml" || path.extension() == ".yaml" || path.extension() == ".yml";
}

std::vector<fs::path> all_decks() {
  std::vector<fs::path> decks;
  for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) {
    if (is_deck(entry.path())) decks.push_back(entry.path());
  }
  std::sort(decks.begin(), decks.end());
  return decks;
}

struct Expected {
  std::string command = "run";
  std::vector<std::string> texts;
};

Expected expected_of(fs::path deck) {
  Expected expected;
  std::stringstream lines(content_of(deck.replace_extension(".expected")));
  const std::string command = "command: ";
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(command, 0) == 0) {
      expected.command = line.substr(command.size());
    } else if (!line.empty()) {
      expected.texts.push_back(line);
    }
  }
  return expected;
}

/// An empty folder that goes away with the test.
class EmptyFolder {
 public:
  EmptyFolder() {
    std::string pattern = (fs::temp_directory_path() / "stroma_bad_deck_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~EmptyFolder() { fs::remove_all(path_); }
  EmptyFolder(const EmptyFolder&) = delete;
  EmptyFolder& operator=(const EmptyFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Outcome {
  int status;
  std::string standard_output;
  std::string standard_error;
};

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// Runs the program as a user does: alone, not as a rank of the MPI job that runs this test, whose
/// environment it must therefore not see.
Outcome run_program(const std::string& command, const fs::path& deck,
                    const fs::path& working_folder, const fs::path& capture_folder) {
  const fs::path output = capture_folder / "output";
  const fs::path error = capture_folder / "error";
  const std::string environment =
      "env -i PATH=\"$PATH\" HOME=\"$HOME\" LD_LIBRARY_PATH=\"$LD_LIBRARY_PATH\" OMP_NUM_THREADS=1 "
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
      // One rank needs no daemon and no network: a quarter of the time.
      "OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_orte_create_session_dirs=0 OMPI_MCA_pml=ob1 "
      "OMPI_MCA_btl=self ";
  const std::string line = "cd " + quoted(working_folder) + " && " + environment +
                           quoted(STROMA_EXECUTABLE) + " " + command + " " + quoted(deck) + " > " +
                           quoted(output) + " 2> " + quoted(error);
  const int result = std::system(line.c_str());
  const int status = WIFEXITED(result) ? WEXITSTATUS(result) : -1;
  return {status, content_of(output), content_of(error)};
}

class BadDeck : public ::testing::TestWithParam<fs::path> {};

TEST_P(BadDeck, EndsWithAPlainMessage) {
  const fs::path deck = GetParam();
  const Expected expected = expected_of(deck);
  ASSERT_FALSE(expected.texts.empty()) << "no " << deck.stem() << ".expected, or an empty one";

  const EmptyFolder working_folder;
  const EmptyFolder capture_folder;
  const Outcome outcome =
      run_program(expected.command, deck, working_folder.path(), capture_folder.path());
  const std::string told = "standard error:\n" + outcome.standard_error;

  EXPECT_EQ(outcome.status, 2) << told;
  for (const std::string& text : expected.texts) {
    EXPECT_NE(outcome.standard_error.find(text), std::string::npos) << "not told: " << text << "\n"
                                                                    << told;
  }

  const std::ptrdiff_t lines =
      std::count(outcome.standard_error.begin(), outcome.standard_error.end(), '\n');
  EXPECT_LE(lines, 6) << "one mistake needs a few lines only\n" << told;
  for (const char* banner :
       {"MPI_ABORT", "MPI_Abort", "mpirun", "terminate called", "received signal",
        "Kokkos::", "Teuchos::", "std::", "Throw number", "core dumped"}) {
    EXPECT_EQ(outcome.standard_error.find(banner), std::string::npos) << banner << "\n" << told;
    EXPECT_EQ(outcome.standard_output.find(banner), std::string::npos) << banner;
  }

  EXPECT_TRUE(fs::is_empty(working_folder.path())) << "something was written";
  EXPECT_FALSE(fs::exists(corpus / deck.stem())) << "an output folder was made beside the deck";
}

std::string test_name(const ::testing::TestParamInfo<fs::path>& deck) {
  return deck.param.stem().string() + "_" + deck.param.extension().string().substr(1);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadDeck, ::testing::ValuesIn(all_decks()), test_name);

TEST(BadDeckCorpus, IsCompleteAndHasNoOrphans) {
  const std::vector<fs::path> decks = all_decks();
  EXPECT_GE(decks.size(), 40u);
  std::set<fs::path> stems;
  for (const fs::path& deck : decks) {
    EXPECT_TRUE(stems.insert(deck.stem()).second) << deck << ": two decks share one .expected";
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) {
    if (entry.path().extension() != ".expected") continue;
    EXPECT_EQ(stems.count(entry.path().stem()), 1u) << entry.path() << " has no deck";
  }
}

}  // namespace
}  // namespace stroma
