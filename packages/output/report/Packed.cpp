// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/report/Packed.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <cmath>

#include "stroma/base/Error.hpp"

namespace stroma::output {

std::string packed(const std::vector<std::uint8_t>& bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> deflated(size);
  if (compress2(deflated.data(), &size, bytes.data(), bytes.size(), 6) != Z_OK)
    throw base::RunError("the report's maps could not be compressed: memory is short");
  std::string text(4 * ((size + 2) / 3) + 1, '\0');  // and a zero, which OpenSSL writes
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), deflated.data(),
                                     static_cast<int>(size));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::vector<std::uint8_t> quantised(const std::vector<float>& values, double low, double high) {
  constexpr double most = 65534.0;
  const double scale = high > low ? most / (high - low) : 0.0;
  std::vector<std::uint8_t> bytes(2 * values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto q = std::isfinite(values[i])
                       ? static_cast<std::uint16_t>(std::lround((values[i] - low) * scale))
                       : std::uint16_t{65535};
    bytes[i] = static_cast<std::uint8_t>(q & 255u);
    bytes[values.size() + i] = static_cast<std::uint8_t>(q >> 8u);
  }
  return bytes;
}

}  // namespace stroma::output
