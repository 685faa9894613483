// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/LengthUnit.hpp"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace stroma::image {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

}  // namespace

std::optional<double> micrometres_per(const std::string& unit) {
  std::string name = unit;
  replace_all(name, "\\u00B5", "u");
  replace_all(name, "\\u00b5", "u");
  replace_all(name, "\xC2\xB5", "u");  // micro sign, UTF-8
  replace_all(name, "\xCE\xBC", "u");  // Greek mu, UTF-8
  replace_all(name, "\xC3\x85", "angstrom");
  replace_all(name, "\xE2\x84\xAB", "angstrom");
  replace_all(name, "\xB5", "u");                         // micro sign, Latin-1
  if (name == "Mm" || name == "Pm") return std::nullopt;  // mega-, petametres
  std::string key;
  for (const char c : name) {
    if (!std::isspace(static_cast<unsigned char>(c)) && c != '\0')
      key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  static const std::map<std::string, double> known = {
      {"um", 1.0},          {"micron", 1.0},      {"microns", 1.0},     {"micrometer", 1.0},
      {"micrometers", 1.0}, {"micrometre", 1.0},  {"micrometres", 1.0}, {"nm", 1e-3},
      {"nanometer", 1e-3},  {"nanometers", 1e-3}, {"nanometre", 1e-3},  {"nanometres", 1e-3},
      {"pm", 1e-6},         {"angstrom", 1e-4},   {"mm", 1e3},          {"millimeter", 1e3},
      {"millimeters", 1e3}, {"millimetre", 1e3},  {"millimetres", 1e3}, {"cm", 1e4},
      {"centimeter", 1e4},  {"centimetre", 1e4},  {"centimeters", 1e4}, {"centimetres", 1e4},
      {"m", 1e6},           {"meter", 1e6},       {"metre", 1e6},       {"meters", 1e6},
      {"metres", 1e6},      {"inch", 25400.0},    {"inches", 25400.0},  {"in", 25400.0},
      {"\"", 25400.0}};
  const auto found = known.find(key);
  if (found == known.end()) return std::nullopt;
  return found->second;
}

double shortest_decimal(float value) {
  for (int digits = 1; digits < 10; ++digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
    if (std::strtof(text, nullptr) == value) return std::strtod(text, nullptr);
  }
  return static_cast<double>(value);
}

}  // namespace stroma::image
