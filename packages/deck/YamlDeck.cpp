// SPDX-License-Identifier: BSD-3-Clause

#include <yaml-cpp/yaml.h>
// yaml.h leaves out the event interface, which alone tells anchors and duplicate keys.
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <sstream>

#include "stroma/deck/ReadTree.hpp"

namespace stroma::deck {
namespace {

/// What makes a YAML text no deck at all.
struct NoDeck {
  int line;
  std::string reason;
};

/// Builds the tree from yaml-cpp's events.
class YamlReader : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    throw NoDeck{mark.line + 1,
                 "anchors and aliases (&" + name + ", *" + name + ") have no place in a deck"};
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    throw NoDeck{mark.line + 1, "anchors and aliases (&name, *name) have no place in a deck"};
  }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    scalar(mark, tree::Form::nothing, "");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    refuse_tag(mark, tag);
    if (tag == quoted_tag) last_quoted_ = mark;
    scalar(mark, tag == quoted_tag ? tree::Form::quoted_text : tree::Form::plain_text, value);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    refuse_tag(mark, tag);
    require_map(mark);
    tree::Parameter& parameter = add_parameter(mark);
    parameter.form = tree::Form::sequence;
    sequence_ = &parameter;
  }
  void OnSequenceEnd() override { sequence_ = nullptr; }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    refuse_tag(mark, tag);
    if (sequence_ != nullptr) {
      throw NoDeck{mark.line + 1, "a map inside a list: \"" + sequence_->name +
                                      "\" can only hold values (or is its bracket not closed?)"};
    }
    if (sections_.size() > deepest_section)
      throw NoDeck{mark.line + 1, "sections are nested too deep"};
    if (sections_.empty()) {
      document_.line = mark.line + 1;
      sections_.push_back({&document_, "", 0, false});
      return;
    }
    require_map(mark);
    Section& parent = sections_.back();
    tree::List list;
    list.name = parent.key;
    list.line = parent.key_line;
    parent.has_key = false;
    // Only the open sections are pointed to, and an open section's siblings are complete.
    parent.list->lists.push_back(std::move(list));
    sections_.push_back({&parent.list->lists.back(), "", 0, false});
  }
  void OnMapEnd() override { sections_.pop_back(); }

  /// Where the last quoted text begins.
  const YAML::Mark& last_quoted() const { return last_quoted_; }

  /// The one map inside the outer map.
  tree::List root() {
    if (document_.parameters.empty() && document_.lists.size() == 1)
      return std::move(document_.lists[0]);
    const int line = std::max(1, document_.line);
    throw NoDeck{
        line,
        "a YAML deck is one outer key, the deck's name, with everything else indented under it"};
  }

 private:
  struct Section {
    tree::List* list;
    std::string key;
    int key_line;
    bool has_key;
  };
  static constexpr const char* quoted_tag = "!";

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == quoted_tag) return;
    throw NoDeck{mark.line + 1,
                 "YAML tags (!!type) have no place in a deck: the parameter has a type"};
  }

  /// A list or map can only be the value of a key.
  void require_map(const YAML::Mark& mark) const {
    if (sequence_ != nullptr) {
      throw NoDeck{mark.line + 1,
                   "a list inside a list: \"" + sequence_->name + "\" can only hold values"};
    }
    if (sections_.empty())
      throw NoDeck{mark.line + 1, "a YAML deck is a map: name, colon, content"};
    if (!sections_.back().has_key) throw NoDeck{mark.line + 1, "a name can only be a plain text"};
  }

  tree::Parameter& add_parameter(const YAML::Mark&) {
    Section& section = sections_.back();
    tree::Parameter parameter;
    parameter.name = section.key;
    parameter.line = section.key_line;
    section.has_key = false;
    section.list->parameters.push_back(std::move(parameter));
    return section.list->parameters.back();
  }

  void scalar(const YAML::Mark& mark, tree::Form form, const std::string& value) {
    if (sequence_ != nullptr) {
      sequence_->items.push_back(value);
      sequence_->quoted.push_back(form == tree::Form::quoted_text);
      return;
    }
    if (sections_.empty())
      throw NoDeck{mark.line + 1, "a YAML deck is a map: name, colon, content"};
    Section& section = sections_.back();
    if (!section.has_key) {
      if (value.empty()) throw NoDeck{mark.line + 1, "an empty name"};
      section.key = value;
      section.key_line = mark.line + 1;
      section.has_key = true;
      return;
    }
    tree::Parameter& parameter = add_parameter(mark);
    parameter.form = form;
    parameter.text = value;
  }

  tree::List document_;
  std::vector<Section> sections_;
  tree::Parameter* sequence_ = nullptr;  ///< the list that is open
  YAML::Mark last_quoted_ = YAML::Mark::null_mark();
};

/// yaml-cpp lets a quote that is never closed swallow the rest of the file without a word.
void refuse_open_quote(const std::string& text, const YAML::Mark& mark) {
  if (mark.is_null()) return;
  std::size_t at = 0;
  for (int line = 0; line < mark.line && at != std::string::npos; ++line) {
    const std::size_t line_end = text.find('\n', at);
    at = line_end == std::string::npos ? line_end : line_end + 1;
  }
  if (at == std::string::npos) return;
  at += static_cast<std::size_t>(mark.column);
  if (at >= text.size() || (text[at] != '"' && text[at] != '\''))
    return;  // a block of text: | or >
  const char quote = text[at];
  for (++at; at < text.size(); ++at) {
    const bool is_escape = quote == '"' ? text[at] == '\\' : text.compare(at, 2, "''") == 0;
    if (is_escape) {
      ++at;
    } else if (text[at] == quote) {
      return;
    }
  }
  throw NoDeck{mark.line + 1, "the quote that opens here is never closed"};
}

/// What often stands behind a message of the parser, which tells where it gave up.
std::string hint(const std::string& text, const std::string& message) {
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number)
    if (const std::size_t tab = line.find('\t');
        tab != std::string::npos && tab < line.find_first_not_of(" \t"))
      return "; line " + std::to_string(number) + " is indented by a tab; YAML takes blanks";
  const auto says = [&](const char* words) { return message.find(words) != std::string::npos; };
  if (says("map flow") || says("flow map")) return "; within { }, names with [ ] stand in quotes";
  if (says("illegal map value"))
    return "; \"name: value\" has a blank behind its colon, here and in the line before";
  return "";
}

}  // namespace

ParsedTree parse_yaml(const std::string& text, const std::string& path) {
  try {
    std::stringstream stream(text);
    YAML::Parser parser(stream);
    YamlReader reader;
    if (!parser.HandleNextDocument(reader)) throw NoDeck{1, "the deck is empty"};
    refuse_open_quote(text, reader.last_quoted());
    YamlReader second;
    if (parser.HandleNextDocument(second)) throw NoDeck{1, "several YAML documents in one file"};
    return {reader.root(), {}};
  } catch (const NoDeck& error) {
    throw malformed(path, error.line, error.reason);
  } catch (const YAML::Exception& error) {
    throw malformed(path, std::max(1, error.mark.line + 1),
                    "not well-formed YAML: " + error.msg + hint(text, error.msg));
  }
}

}  // namespace stroma::deck
