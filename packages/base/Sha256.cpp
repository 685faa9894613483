// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/base/Sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "stroma/base/Error.hpp"

namespace stroma::base {
namespace {

/// A digest that grows with each piece.
class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    require(context_ != nullptr && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }

  void add(const char* bytes, std::size_t count) {
    require(EVP_DigestUpdate(context_.get(), bytes, count) == 1);
  }

  std::string hexadecimal() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned count = 0;
    require(EVP_DigestFinal_ex(context_.get(), bytes.data(), &count) == 1);
    std::string digits;
    for (unsigned n = 0; n < count; ++n) {
      digits += "0123456789abcdef"[bytes[n] >> 4];
      digits += "0123456789abcdef"[bytes[n] & 15];
    }
    return digits;
  }

 private:
  static void require(bool done) {
    if (!done) throw RunError("the OpenSSL of this machine cannot compute a SHA-256");
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail_to_read(const std::string& path) {
  throw RunError("cannot read '" + path + "': " + std::strerror(errno));
}

File opened(const std::string& path) {
  File file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (file == nullptr) fail_to_read(path);
  return file;
}

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes.data(), bytes.size());
  return digest.hexadecimal();
}

std::string sha256_of_file(const std::string& path) {
  const File file = opened(path);
  Digest digest;
  std::vector<char> piece(1 << 18);
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file.get()))
    digest.add(piece.data(), count);
  if (std::ferror(file.get()) != 0) fail_to_read(path);
  return digest.hexadecimal();
}

std::string sha256_of_samples(const std::string& path, std::uintmax_t size, int pieces,
                              std::size_t length) {
  const File file = opened(path);
  Digest digest;
  std::vector<char> piece(length);
  for (int n = 0; n < pieces; ++n) {
    const auto share = static_cast<double>(n) / (pieces - 1);
    const auto place = static_cast<std::int64_t>(share * static_cast<double>(size - length));
    if (::fseeko(file.get(), place, SEEK_SET) != 0) fail_to_read(path);
    digest.add(piece.data(), std::fread(piece.data(), 1, length, file.get()));
    if (std::ferror(file.get()) != 0) fail_to_read(path);
  }
  return digest.hexadecimal();
}

std::string sha256_of_files(const std::string& folder, const std::vector<std::string>& files) {
  std::string list;
  for (const std::string& file : files)
    list += sha256_of_file(folder + "/" + file) + "  " + file + "\n";
  return sha256(list);
}

}  // namespace stroma::base
