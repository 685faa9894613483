#pragma once

/// \file
/// Whether the values that a header announces are all in the file, for the formats where ITK does
/// not notice.

#include <cstdint>
#include <string>

namespace stroma::image {

/// MetaImage (raw values in the file itself or in one other file) and NIfTI (plain or gzip, one
/// file or two).
/// \param format  "MetaImage" or "NIfTI"; any other is left to ITK
/// \param bytes  of all values together
/// \throws base::InputError when the file is too short
void require_all_values(const std::string& path, const std::string& format, std::uint64_t bytes);

}  // namespace stroma::image
