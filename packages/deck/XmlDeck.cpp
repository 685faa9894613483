// SPDX-License-Identifier: BSD-3-Clause

#include <expat.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "stroma/deck/Nearest.hpp"
#include "stroma/deck/ReadTree.hpp"

namespace stroma::deck {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// Builds the tree from expat's calls. Nothing here may throw, for expat is C.
class XmlReader {
 public:
  explicit XmlReader(XML_Parser parser) : parser_(parser) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* self, const XML_Char* name, const XML_Char** attributes) {
          static_cast<XmlReader*>(self)->start(name, attributes);
        },
        [](void* self, const XML_Char*) { static_cast<XmlReader*>(self)->end(); });
    XML_SetCharacterDataHandler(parser, [](void* self, const XML_Char* text, int length) {
      static_cast<XmlReader*>(self)->characters(
          std::string(text, static_cast<std::size_t>(length)));
    });
    XML_SetStartDoctypeDeclHandler(
        parser, [](void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
          static_cast<XmlReader*>(self)->stop(
              "a document type (<!DOCTYPE ...>) has no place in a deck");
        });
  }

  ParsedTree take() { return std::move(result_); }
  /// Why the reader itself stopped expat; empty if it did not.
  const std::string& stopped_because() const { return stopped_because_; }
  /// The section that is open, for the message about a tag that does not match.
  std::string open_section() const {
    if (lists_.empty()) return "";
    return "; the section \"" + lists_.back()->name + "\" of line " +
           std::to_string(lists_.back()->line) + " is still open";
  }

 private:
  enum class Element { list, parameter, validators, skipped };

  int line() const { return static_cast<int>(XML_GetCurrentLineNumber(parser_)); }

  std::string path() const {
    std::string path;
    for (std::size_t i = 1; i < lists_.size(); ++i) path += (i > 1 ? "|" : "") + lists_[i]->name;
    return path;
  }

  void add(const std::string& name, const std::string& message) {
    const std::string section = path();
    result_.mistakes.push_back(
        {line(), section.empty() || name.empty() ? section + name : section + "|" + name, message});
  }

  void stop(const std::string& reason) {
    if (stopped_because_.empty()) stopped_because_ = reason;
    XML_StopParser(parser_, XML_FALSE);
  }

  void start(const std::string& element, const XML_Char** raw) {
    if (!stopped_because_.empty()) return;  // expat ends the event it is in: <a/> has two calls
    Attributes attributes;
    if (!elements_.empty()) report_stray_text();
    for (; *raw != nullptr; raw += 2) attributes.emplace_back(raw[0], raw[1]);
    if (elements_.size() > deepest_section) return stop("sections are nested too deep");

    if (elements_.empty() && element != "ParameterList") {
      return stop("the outer element is <" + element +
                  ">; a deck begins with <ParameterList name=\"Stroma\">");
    }
    const Element parent = elements_.empty() ? Element::list : elements_.back();
    if (parent == Element::skipped) {
      elements_.push_back(Element::skipped);
    } else if (parent != Element::list) {
      add("",
          parent == Element::parameter
              ? "<" + element +
                    "> inside a <Parameter>; a parameter is written <Parameter name= type= value=/>"
              : "<Validators> must be empty: a deck cannot bring its own rules");
      elements_.push_back(Element::skipped);
    } else if (element == "ParameterList") {
      start_list(attributes);
    } else if (element == "Parameter") {
      start_parameter(attributes);
    } else if (element == "Validators" && elements_.size() == 1) {
      elements_.push_back(
          Element::validators);  // Teuchos ends every list it writes with an empty one
    } else {
      add("", "no such element: <" + element + ">; " +
                  suggestion(element, {"Parameter", "ParameterList"}));
      elements_.push_back(Element::skipped);
    }
  }

  void end() {
    if (!stopped_because_.empty()) return;
    report_stray_text();
    if (elements_.back() == Element::list) lists_.pop_back();
    elements_.pop_back();
  }

  /// Expat hands over text in pieces; they are joined until the next tag.
  void characters(const std::string& piece) {
    if (piece.find_first_not_of(blanks) == std::string::npos && stray_text_.empty()) return;
    if (stray_text_.empty()) stray_line_ = line();
    stray_text_ += piece;
  }

  void report_stray_text() {
    const std::string text = std::exchange(stray_text_, "");
    if (text.empty() || elements_.back() == Element::skipped) return;
    const std::size_t first = text.find_first_not_of(blanks);
    const std::size_t last = text.find_last_not_of(blanks);
    result_.mistakes.push_back({stray_line_, path(),
                                "text between the elements: \"" +
                                    text.substr(first, last - first + 1) +
                                    "\"; a value is written value=\"...\""});
  }

  void start_list(const Attributes& attributes) {
    tree::List list;
    list.line = line();
    bool has_name = false;
    for (const auto& [key, value] : attributes) {
      if (key == "name") {
        list.name = value;
        has_name = true;
      } else if (key != "id") {
        unknown_attribute(key, lists_.empty() ? "" : list.name, {"name"});
      }
    }
    elements_.push_back(Element::list);
    if (lists_.empty()) {
      result_.root = std::move(list);
      lists_.push_back(&result_.root);
      return;
    }
    if (!has_name || list.name.empty()) {
      add("", "a <ParameterList> without a name");
      elements_.back() = Element::skipped;
      return;
    }
    // Only the open sections are pointed to, and an open section's siblings are complete.
    lists_.back()->lists.push_back(std::move(list));
    lists_.push_back(&lists_.back()->lists.back());
  }

  void start_parameter(const Attributes& attributes) {
    elements_.push_back(Element::parameter);
    tree::Parameter parameter;
    parameter.line = line();
    parameter.form = tree::Form::typed_text;
    bool has_type = false;
    bool has_value = false;
    for (const auto& [key, value] : attributes) {
      if (key == "name") {
        parameter.name = value;
      } else if (key == "type") {
        parameter.type = value;
        has_type = true;
      } else if (key == "value") {
        parameter.text = value;
        has_value = true;
      }
    }
    if (parameter.name.empty()) return add("", "a <Parameter> without a name");
    for (const auto& [key, value] : attributes) {
      static const std::vector<std::string> ignored = {"name",      "type",      "value", "id",
                                                       "docString", "isDefault", "isUsed"};
      if (std::find(ignored.begin(), ignored.end(), key) != ignored.end()) continue;
      unknown_attribute(key, parameter.name, {"name", "type", "value"});
      parameter.broken = parameter.broken || !has_type || !has_value;
    }
    if (!parameter.broken && !has_type) {
      add(parameter.name,
          "has no type; write type=\"double\", \"int\", \"bool\", \"string\" or \"Array(...)\"");
      parameter.broken = true;
    }
    if (!parameter.broken && !has_value) {
      add(parameter.name, "has no value; write value=\"...\"");
      parameter.broken = true;
    }
    lists_.back()->parameters.push_back(std::move(parameter));
  }

  void unknown_attribute(const std::string& key, const std::string& owner,
                         const std::vector<std::string>& known) {
    add(owner, "no such XML attribute: " + key + "; " + suggestion(key, known));
  }

  static constexpr const char* blanks = " \t\r\n";

  XML_Parser parser_;
  ParsedTree result_;
  std::vector<Element> elements_;
  std::vector<tree::List*> lists_;
  std::string stopped_because_;
  std::string stray_text_;
  int stray_line_ = not_in_file;
};

}  // namespace

ParsedTree parse_xml(const std::string& text, const std::string& path) {
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                       XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  XmlReader reader(parser.get());
  const XML_Status status =
      XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
  if (status == XML_STATUS_OK) return reader.take();

  const int line = static_cast<int>(XML_GetCurrentLineNumber(parser.get()));
  if (!reader.stopped_because().empty()) throw malformed(path, line, reader.stopped_because());
  throw malformed(path, line,
                  std::string("not well-formed XML: ") +
                      XML_ErrorString(XML_GetErrorCode(parser.get())) + reader.open_section());
}

}  // namespace stroma::deck
