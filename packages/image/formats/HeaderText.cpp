// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/HeaderText.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace stroma::image {
namespace {

template <class Number>
std::optional<Number> whole_word(const std::string& word) {
  const char* first = word.data();
  const char* const last = first + word.size();
  if (first != last && *first == '+' && word.size() > 1 && word[1] != '-') ++first;
  Number number{};
  const auto [end, trouble] = std::from_chars(first, last, number);
  if (trouble != std::errc() || end != last) return std::nullopt;
  return number;
}

}  // namespace

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> found;
  for (std::string word; stream >> word;) found.push_back(word);
  return found;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::optional<std::int64_t> to_integer(const std::string& word) {
  return whole_word<std::int64_t>(word);
}

std::optional<double> to_real(const std::string& word) { return whole_word<double>(word); }

std::string printable(const std::string& text) {
  std::string shown = text.substr(0, 100);
  for (char& c : shown)
    if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
  return text.size() > shown.size() ? shown + " ..." : shown;
}

bool next_line(const std::string& text, std::size_t& at, std::string& line) {
  if (at >= text.size()) return false;
  const std::size_t end = std::min(text.find('\n', at), text.size());
  line = text.substr(at, end - at);
  at = end + 1;
  return true;
}

void HeaderFields::add(const std::string& name, const std::string& value) {
  if (!fields_.emplace(name, value).second)
    refuse(path_, "its " + format_ + " header says " + name + " twice");
}

std::string HeaderFields::text(const std::string& name) const {
  const auto found = fields_.find(name);
  return found == fields_.end() ? "" : found->second;
}

std::string HeaderFields::required(const std::string& name) const {
  if (!has(name)) refuse(path_, "is no whole " + format_ + " file: its header has no " + name);
  return text(name);
}

void HeaderFields::refuse_field(const std::string& name, const std::string& admissible) const {
  refuse(path_, "its " + format_ + " header says " + name + " \"" + printable(text(name)) +
                    "\"; admissible: " + admissible);
}

std::int64_t HeaderFields::integer(const std::string& name, std::int64_t lowest,
                                   std::int64_t highest) const {
  const auto number = to_integer(required(name));
  if (!number || *number < lowest || *number > highest) {
    refuse_field(name,
                 base::format("a whole number from %lld to %lld", static_cast<long long>(lowest),
                              static_cast<long long>(highest)));
  }
  return *number;
}

std::vector<std::int64_t> HeaderFields::sizes(const std::string& name, std::size_t count) const {
  std::vector<std::int64_t> numbers;
  for (const std::string& word : words(required(name)))
    numbers.push_back(to_integer(word).value_or(0));
  const bool all_good =
      std::all_of(numbers.begin(), numbers.end(), [](std::int64_t n) { return n >= 1; });
  if (numbers.size() != count || !all_good)
    refuse_field(name, base::format("%zu whole numbers, at least 1 each", count));
  return numbers;
}

std::vector<double> HeaderFields::reals(const std::string& name, std::size_t count) const {
  std::vector<double> numbers;
  bool all_good = true;
  for (const std::string& word : words(required(name))) {
    const auto number = to_real(word);
    all_good = all_good && number;
    numbers.push_back(number.value_or(0.0));
  }
  if (numbers.size() != count || !all_good) refuse_field(name, base::format("%zu numbers", count));
  return numbers;
}

bool HeaderFields::truth(const std::string& name, bool if_absent) const {
  if (!has(name)) return if_absent;
  const std::string value = lower_case(text(name));
  if (value == "true" || value == "t" || value == "1") return true;
  if (value == "false" || value == "f" || value == "0") return false;
  refuse_field(name, "True or False");
}

std::vector<std::string> numbered_files(const std::string& path, const std::string& pattern,
                                        std::int64_t first, std::int64_t step, std::int64_t count) {
  const std::size_t percent = pattern.find('%');
  std::size_t at = percent == std::string::npos ? pattern.size() : percent + 1;
  const auto is = [&](auto condition) { return at < pattern.size() && condition(pattern[at]); };
  const bool zeros = is([](char c) { return c == '0'; });
  std::size_t width = 0;
  while (is([](char c) { return c >= '0' && c <= '9'; }) && width < 100)
    width = 10 * width + static_cast<std::size_t>(pattern[at++] - '0');
  if (!is([](char c) { return c == 'd'; }) || width >= 100 ||
      pattern.find('%', at) != std::string::npos) {
    refuse(path, "names its files by the pattern \"" + printable(pattern) +
                     "\"; admissible: exactly one %d, such as slice%03d.raw");
  }
  constexpr std::int64_t largest = 1000000000;
  if (count < 1 || count > most_files || std::abs(first) > largest || std::abs(step) > largest) {
    refuse(path,
           base::format("names %lld files, from number %lld on by %lld; admissible: 1 to %lld",
                        static_cast<long long>(count), static_cast<long long>(first),
                        static_cast<long long>(step), static_cast<long long>(most_files)));
  }
  std::vector<std::string> names;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t number = first + i * step;
    const std::string sign = number < 0 ? "-" : "", digits = std::to_string(std::abs(number));
    const std::size_t length = sign.size() + digits.size();
    const std::string fill(width > length ? width - length : 0, zeros ? '0' : ' ');
    names.push_back(pattern.substr(0, percent) + (zeros ? sign + fill : fill + sign) + digits +
                    pattern.substr(at + 1));
  }
  return names;
}

std::string beside(const std::string& header, const std::string& name) {
  return (std::filesystem::path(header).parent_path() / name).string();
}

}  // namespace stroma::image
