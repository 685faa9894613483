#include "image/HeaderUnits.hpp"

#include <algorithm>
#include <fstream>
#include <vector>

#include "image/LengthUnit.hpp"

namespace stroma::image {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The quoted words of a line that are not empty.
std::vector<std::string> quoted_words(const std::string& text) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while ((at = text.find('"', at)) != std::string::npos) {
    const std::size_t end = text.find('"', at + 1);
    if (end == std::string::npos) break;
    if (end > at + 1) words.push_back(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return words;
}

/// Calls field(name, value) for each "name SEPARATOR value" line until it returns false, a line is
/// empty or the text has gone on for too long to be a header.
template <class Field>
void each_field(const std::string& path, char separator, Field&& field) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  for (int lines = 0; lines < 1000 && std::getline(file, line) && line.size() < 10000; ++lines) {
    if (trimmed(line).empty()) return;
    const std::size_t at = line.find(separator);
    if (at == std::string::npos) continue;
    if (!field(trimmed(line.substr(0, at)), trimmed(line.substr(at + 1)))) return;
  }
}

}  // namespace

HeaderUnits nrrd_units(const std::string& path) {
  HeaderUnits units;
  each_field(path, ':', [&](const std::string& name, const std::string& value) {
    if (name == "spacings" || name == "space directions") units.has_spacing = true;
    if (name == "space units" || name == "units") {
      const std::vector<std::string> words = quoted_words(value);
      const bool one =
          !words.empty() && std::all_of(words.begin(), words.end(),
                                        [&](const auto& word) { return word == words[0]; });
      if (one) units.micrometres = micrometres_per(words[0]);
    }
    return true;
  });
  return units;
}

HeaderUnits metaimage_units(const std::string& path) {
  HeaderUnits units;
  each_field(path, '=', [&](const std::string& name, const std::string& value) {
    if (name == "ElementSpacing" || name == "ElementSize") units.has_spacing = true;
    if (name == "DistanceUnits") units.micrometres = micrometres_per(value);
    return name != "ElementDataFile";
  });
  return units;
}

}  // namespace stroma::image
