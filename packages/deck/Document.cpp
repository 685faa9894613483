// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/deck/Document.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "stroma/base/Error.hpp"
#include "stroma/deck/Findings.hpp"
#include "stroma/deck/PlainText.hpp"
#include "stroma/deck/ReadTree.hpp"

namespace stroma::deck {
namespace {

namespace fs = std::filesystem;

const tree::List* list_at(const tree::List& root, const std::string& path, std::string& rest) {
  const tree::List* list = &root;
  rest = path;
  for (std::size_t bar = rest.find('|'); bar != std::string::npos; bar = rest.find('|')) {
    const tree::List* sub = list->list(rest.substr(0, bar));
    if (sub == nullptr) return list;
    list = sub;
    rest = rest.substr(bar + 1);
  }
  return list;
}

void find_duplicates(const tree::List& list, const std::string& path,
                     std::vector<Mistake>& mistakes) {
  std::map<std::string, int> first_line;
  const auto note = [&](const std::string& name, int line) {
    const auto [first, is_new] = first_line.emplace(name, line);
    if (is_new) return;
    const auto [earlier, later] = std::minmax(first->second, line);
    mistakes.push_back(
        {later, path + name, "given twice; first on line " + std::to_string(earlier)});
  };
  for (const tree::Parameter& parameter : list.parameters) note(parameter.name, parameter.line);
  for (const tree::List& sub : list.lists) note(sub.name, sub.line);
  for (const tree::List& sub : list.lists) find_duplicates(sub, path + sub.name + "|", mistakes);
}

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> parts;
  std::stringstream stream(path);
  for (std::string part; std::getline(stream, part, '|');) parts.push_back(part);
  if (path.empty() || path.back() == '|') parts.emplace_back();
  return parts;
}

tree::List& open_list(tree::List& parent, const std::string& name) {
  for (tree::List& sub : parent.lists) {
    if (sub.name == name) return sub;
  }
  tree::List made;
  made.name = name;
  parent.lists.push_back(std::move(made));
  return parent.lists.back();
}

std::string content_of(const std::string& path) {
  const auto cannot_read = [&path](const std::string& reason) {
    return base::InputError("cannot read the deck '" + path + "': " + reason);
  };
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) throw cannot_read(failure.message());
  if (fs::is_directory(status)) throw cannot_read("it is a folder");
  constexpr std::uintmax_t largest_deck = 16u << 20;  // bytes; an image given by mistake is larger
  const std::uintmax_t size = fs::file_size(path, failure);
  if (!failure && size > largest_deck)
    throw cannot_read("a file of " + std::to_string(size >> 20) + " MiB is no deck");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw cannot_read(std::strerror(errno));
  std::stringstream content;
  content << file.rdbuf();
  if (file.bad()) throw cannot_read(std::strerror(errno));
  return content.str();
}

}  // namespace

const tree::Parameter* tree::List::parameter(const std::string& wanted) const {
  for (const Parameter& candidate : parameters) {
    if (candidate.name == wanted) return &candidate;
  }
  return nullptr;
}

const tree::List* tree::List::list(const std::string& wanted) const {
  for (const List& candidate : lists) {
    if (candidate.name == wanted) return &candidate;
  }
  return nullptr;
}

Document::Document(std::string path, tree::List root, std::vector<Mistake> mistakes)
    : path_(std::move(path)), root_(std::move(root)), mistakes_(std::move(mistakes)) {
  find_duplicates(root_, "", mistakes_);
}

std::string Document::folder() const {
  const std::string parent = fs::path(path_).parent_path().string();
  return parent.empty() ? "." : parent;
}

std::string Document::resolve(const std::string& file) const {
  // An absolute file name replaces the folder.
  return (fs::path(path_).parent_path() / file).string();
}

int Document::line(const std::string& path) const {
  std::string name;
  const tree::List* list = list_at(root_, path, name);
  if (const tree::List* sub = list->list(name)) return sub->line;
  const tree::Parameter* parameter = list->parameter(name);
  return parameter != nullptr ? parameter->line : list->line;
}

void Document::set(const std::string& parameter, const std::string& value) {
  const auto refuse = [&](const std::string& message) {
    mistakes_.push_back({not_in_file, parameter, message});
  };
  const std::vector<std::string> parts = split_path(parameter);
  for (const std::string& part : parts) {
    if (part.empty()) {
      return refuse(
          "a part of the name is empty; write Section|Parameter=value, without blanks around '|'");
    }
  }
  tree::List* list = &root_;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    if (list->parameter(parts[i]) != nullptr)
      return refuse("\"" + parts[i] + "\" is a parameter, not a section");
    list = &open_list(*list, parts[i]);
  }
  if (list->list(parts.back()) != nullptr) return refuse("is a section; name a parameter in it");

  tree::Parameter laid_over;
  laid_over.name = parts.back();
  laid_over.text = value;
  for (tree::Parameter& present : list->parameters) {
    if (present.name == laid_over.name) {
      present = laid_over;
      return;
    }
  }
  list->parameters.push_back(laid_over);
}

void Document::override_with(const std::vector<std::string>& overrides) {
  std::set<std::string> seen;
  for (const std::string& text : overrides) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    if (equals == std::string::npos) {
      mistakes_.push_back(
          {not_in_file, "", "\"" + text + "\" has no '='; write Section|Parameter=value"});
    } else if (!seen.insert(name).second) {
      mistakes_.push_back({not_in_file, name, "given twice on the command line"});
    } else {
      set(name, text.substr(equals + 1));
    }
  }
}

Document parse(const std::string& text, Format format, const std::string& path,
               const std::vector<std::string>& overrides) {
  ParsedTree parsed = format == Format::yaml ? parse_yaml(text, path) : parse_xml(text, path);
  Document document(path, std::move(parsed.root), std::move(parsed.mistakes));
  document.override_with(overrides);
  refuse_unwritable(document.root_, "", document.mistakes_);
  return document;
}

Document load(const std::string& path, const std::vector<std::string>& overrides) {
  const std::string ending = fs::path(path).extension().string();
  const bool is_yaml = ending == ".yaml" || ending == ".yml";
  if (!is_yaml && ending != ".xml" && !fs::is_directory(path))
    throw base::InputError("cannot tell the format of the deck '" + path +
                           "' by its name's ending; admissible: .xml, .yaml or .yml");
  return parse(content_of(path), is_yaml ? Format::yaml : Format::xml, path, overrides);
}

base::InputError malformed(const std::string& path, int line, const std::string& message) {
  return base::InputError("1 mistake in " + path + "\nline " + std::to_string(line) + ": " +
                          message);
}

}  // namespace stroma::deck
