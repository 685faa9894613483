// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/Findings.hpp"

#include <algorithm>
#include <limits>

#include "stroma/base/Error.hpp"
#include "stroma/deck/PlainText.hpp"

namespace stroma::deck {
namespace {

std::string joined(const std::string& section, const std::string& name) {
  if (section.empty()) return name;
  return name.empty() ? section : section + "|" + name;
}

/// Line of 'Sub|Parameter' inside a list, or of the innermost part of it that is there.
int line_inside(const tree::List& list, const std::string& path) {
  const std::size_t bar = path.find('|');
  const std::string name = path.substr(0, bar);
  if (const tree::List* sub = list.list(name)) {
    return bar == std::string::npos ? sub->line : line_inside(*sub, path.substr(bar + 1));
  }
  const tree::Parameter* parameter = list.parameter(name);
  return parameter != nullptr ? parameter->line : list.line;
}

/// What stands in the file first, by line; then what stands on the command line.
int order(const Mistake& mistake) {
  return mistake.line == not_in_file ? std::numeric_limits<int>::max() : mistake.line;
}

std::string text_of(const Mistake& mistake) {
  std::string text = mistake.line == not_in_file ? "--set" : "line " + std::to_string(mistake.line);
  if (!mistake.where.empty()) text += ", " + mistake.where;
  return printable(text + ": " + mistake.message);
}

}  // namespace

Findings::Findings(const Document& document)
    : deck_(document.path()),
      section_(&document.root()),
      line_(document.root().line),
      mistakes_(std::make_shared<std::vector<Mistake>>()) {}

void Findings::add(const std::string& parameter, const std::string& message) {
  add(section_ != nullptr ? line_inside(*section_, parameter) : line_, parameter, message);
}

void Findings::add(int line, const std::string& parameter, const std::string& message) {
  mistakes_->push_back({line, joined(where_, parameter), message});
}

void Findings::add(const std::vector<Mistake>& mistakes) {
  mistakes_->insert(mistakes_->end(), mistakes.begin(), mistakes.end());
}

Findings Findings::inside(const std::string& name, const tree::List* section) const {
  Findings result = *this;
  result.where_ = joined(where_, name);
  result.section_ = section;
  if (section != nullptr) result.line_ = section->line;
  return result;
}

Findings Findings::below(const std::string& name) const {
  return inside(name, section_ != nullptr ? section_->list(name) : nullptr);
}

void Findings::throw_if_any() const {
  if (mistakes_->empty()) return;
  std::vector<Mistake> sorted = *mistakes_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Mistake& a, const Mistake& b) { return order(a) < order(b); });
  std::string text = std::to_string(sorted.size()) +
                     (sorted.size() == 1 ? " mistake" : " mistakes") + " in " + deck_;
  for (const Mistake& mistake : sorted) text += "\n" + text_of(mistake);
  throw base::InputError(text);
}

}  // namespace stroma::deck
