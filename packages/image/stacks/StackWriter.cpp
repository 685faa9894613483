// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/stacks/StackWriter.hpp"

namespace stroma::image {

std::int64_t planes_of_band(const StackHeader& header) {
  constexpr std::int64_t most_values = std::int64_t{1} << 22, most_planes = 32;
  const auto quantities = static_cast<std::int64_t>(header.channels.size()) + 1;
  std::int64_t planes = 1;
  while (planes < most_planes &&
         2 * planes * quantities * header.size[0] * header.size[1] <= most_values)
    planes *= 2;
  return planes;
}

}  // namespace stroma::image
