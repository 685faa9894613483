// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// SHA-256 of texts and files, against the examples of FIPS 180.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "stroma/base/Error.hpp"
#include "stroma/base/Sha256.hpp"

namespace stroma {
namespace {

const std::string million_a(1'000'000, 'a');
constexpr const char* of_nothing =
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* of_two_blocks =
    "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1";
constexpr const char* of_million_a =
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

/// A file of this process with a content, gone at the end.
class Content {
 public:
  explicit Content(const std::string& content)
      : path_(std::filesystem::temp_directory_path() /
              ("stroma_sha256_" + std::to_string(getpid()))) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~Content() { std::filesystem::remove(path_); }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

// V-TRACE-1.
TEST(Sha256, OfBytesIsThatOfTheStandard) {
  EXPECT_EQ(base::sha256(""), of_nothing);
  EXPECT_EQ(base::sha256("abc"), of_abc);
  EXPECT_EQ(base::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            of_two_blocks);
  EXPECT_EQ(base::sha256(million_a), of_million_a);
}

TEST(Sha256, OfAFileIsThatOfItsContent) {
  EXPECT_EQ(base::sha256_of_file(Content("").path()), of_nothing);
  EXPECT_EQ(base::sha256_of_file(Content("abc").path()), of_abc);
  EXPECT_EQ(base::sha256_of_file(Content(million_a).path()), of_million_a);
  const std::string bytes("\0\r\n\x1a\xff", 5);
  EXPECT_EQ(base::sha256_of_file(Content(bytes).path()), base::sha256(bytes));
}

TEST(Sha256, OfSamplesIsThatOfPiecesFromTheFirstToTheLast) {
  std::string text;
  for (int n = 0; n < 1000; ++n) text += static_cast<char>('a' + n % 26);
  const Content file(text);
  const std::string seen = text.substr(0, 10) + text.substr(495, 10) + text.substr(990, 10);
  EXPECT_EQ(base::sha256_of_samples(file.path(), 1000, 3, 10), base::sha256(seen));
}

TEST(Sha256, AFileThatCannotBeReadIsNamedWithTheReason) {
  const auto message = [](const std::string& path) -> std::string {
    try {
      return base::sha256_of_file(path);
    } catch (const base::RunError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message("/nowhere/image.tif"),
            "cannot read '/nowhere/image.tif': No such file or directory");
  EXPECT_EQ(message("/"), "cannot read '/': Is a directory");
}

}  // namespace
}  // namespace stroma
