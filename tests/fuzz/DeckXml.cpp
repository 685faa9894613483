// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Fuzz target: any bytes, read as a deck in XML.

#include "AnyDeck.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  stroma::fuzz::read_any(bytes, size, stroma::deck::Format::xml);
  return 0;
}
