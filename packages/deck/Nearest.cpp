// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/Nearest.hpp"

#include <algorithm>
#include <cctype>

namespace stroma::deck {
namespace {

/// Small letters, single blanks, no unit.
std::string plain(const std::string& name) {
  std::string result;
  for (const char letter : name.substr(0, name.find('['))) {
    const bool blank = letter == ' ' || letter == '_' || letter == '-';
    if (blank && (result.empty() || result.back() == ' ')) continue;
    result += blank ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result.empty() ? name : result;
}

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal
/// string alignment: Damerau 1964).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
  if (word.size() > 200) return "";  // nobody mistypes a name by that much
  const std::string typed = plain(word);
  std::string best;
  std::size_t best_distance = 0;
  for (const std::string& name : known) {
    const std::string candidate = plain(name);
    const std::size_t apart = distance(typed, candidate);
    const std::size_t tolerated =
        std::max<std::size_t>(1, std::max(typed.size(), candidate.size()) / 3);
    const bool shares_nothing = apart >= std::max(typed.size(), candidate.size());
    if (apart > tolerated || shares_nothing) continue;
    if (best.empty() || apart < best_distance) {
      best = name;
      best_distance = apart;
    }
  }
  return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  if (known.empty()) return "none is known here";
  const std::string meant = nearest(word, known);
  if (!meant.empty()) return "did you mean \"" + meant + "\"?";
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "\"" : ", \"") + name + "\"";
  return "known here: " + list;
}

}  // namespace stroma::deck
