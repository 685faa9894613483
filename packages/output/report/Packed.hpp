// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Arrays as text that a browser unpacks.

#include <cstdint>
#include <string>
#include <vector>

namespace stroma::output {

/// Bytes, deflated with a zlib header (RFC 1950), in base64 (RFC 4648) without line breaks.
/// \throws base::RunError when memory is short
std::string packed(const std::vector<std::uint8_t>& bytes);

/// Numbers as 16 bits each: first the low bytes of all, then the high ones, for so they deflate
/// better. 65535 is not a number, q else the value low + q (high - low) / 65534.
std::vector<std::uint8_t> quantised(const std::vector<float>& values, double low, double high);

}  // namespace stroma::output
