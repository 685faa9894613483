// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/PlainText.hpp"

#include <cstdint>
#include <cstdio>

namespace stroma::deck {
namespace {

/// Bytes of the character of XML 1.0 in UTF-8 that begins here, but for line breaks and tabs; 0 if
/// there is none.
std::size_t length_of_character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const unsigned first = byte(at);
  if (first < 0x80) return first < 0x20 ? 0 : 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  std::uint32_t code = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0u) != 0x80u) return 0;
    code = code << 6 | (byte(at + i) & 0x3Fu);
  }
  const std::uint32_t smallest[] = {0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < smallest[length - 2] || code > 0x10FFFF || is_surrogate) return 0;
  return code == 0xFFFE || code == 0xFFFF ? 0 : length;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of_character(text, at);
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(text[at]));
    result += length == 0 ? code : text.substr(at, length);
    at += length == 0 ? 1 : length;
  }
  return result;
}

std::string unwritable(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of_character(text, at);
    if (length == 0) {
      const auto byte = static_cast<unsigned char>(text[at]);
      const bool is_no_character = text.compare(at, 3, "\xEF\xBF\xBE") == 0 ||
                                   text.compare(at, 3, "\xEF\xBF\xBF") == 0;  // U+FFFE, U+FFFF
      const char* const what = byte == '\n' || byte == '\r' ? "a line break"
                               : byte < 0x20                ? "a control character"
                               : is_no_character            ? "a character that XML does not admit"
                                                            : "bytes that are not UTF-8";
      return "\"" + printable(text) + "\" holds " + what +
             "; admissible: one line of text, in UTF-8";
    }
    at += length;
  }
  return "";
}

void refuse_unwritable(tree::List& list, const std::string& path, std::vector<Mistake>& mistakes) {
  const auto refuse = [&](const std::string& text, int line, const std::string& where) {
    const std::string problem = unwritable(text);
    if (!problem.empty()) mistakes.push_back({line, where, problem});
    return !problem.empty();
  };
  const std::string inside = path.empty() ? "" : path + "|";
  for (tree::Parameter& parameter : list.parameters) {
    const std::string where = inside + parameter.name;
    bool is_bad = refuse(parameter.name, parameter.line, path);
    is_bad = refuse(parameter.text, parameter.line, where) || is_bad;
    for (const std::string& item : parameter.items)
      is_bad = refuse(item, parameter.line, where) || is_bad;
    parameter.broken = parameter.broken || is_bad;
  }
  for (tree::List& sub : list.lists) {
    refuse(sub.name, sub.line, path);
    refuse_unwritable(sub, inside + sub.name, mistakes);
  }
}

}  // namespace stroma::deck
