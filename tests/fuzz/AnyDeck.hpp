// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Reads any bytes as a deck that has every kind of entry.

#include <cstddef>
#include <cstdint>
#include <string>

#include "stroma/base/Error.hpp"
#include "unit/deck/SampleDeck.hpp"

namespace stroma::fuzz {

/// Any exception but InputError, and any fault of memory, ends the fuzzer. What follows the last
/// NUL byte is laid over the deck, as by --set.
inline void read_any(const std::uint8_t* bytes, std::size_t size, deck::Format format) {
  static const auto declaration = deck::sample::declaration();
  std::string text(reinterpret_cast<const char*>(bytes), size);
  std::vector<std::string> overrides;
  if (const std::size_t end = text.rfind('\0'); end != std::string::npos) {
    overrides.push_back(text.substr(end + 1));
    text.resize(end);
  }
  try {
    const deck::Document document = deck::parse(text, format, "deck", overrides);
    deck::filled(declaration, deck::read(document, declaration));
  } catch (const base::InputError&) {
  }
}

}  // namespace stroma::fuzz
