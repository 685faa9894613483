// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyMembers.hpp"

#include <cctype>
#include <set>

namespace stroma {

std::string folder_name(const std::vector<std::string>& labels) {
  std::string name;
  for (const std::string& label : labels) {
    if (!name.empty()) name += "__";
    for (const char c : label) {
      const auto byte = static_cast<unsigned char>(c);
      const bool stays =
          byte >= 0x80 || std::isalnum(byte) != 0 || c == '.' || c == '+' || c == '-';
      name += stays ? c : '_';
    }
  }
  if (!name.empty() && (name[0] == '.' || name[0] == '-')) name[0] = '_';
  return name;
}

bool is_reserved(const std::string& folder) {
  static const std::set<std::string> names{
      "pictures",         "study.csv",        "convergence.csv",
      "log.txt",          "force_strain.png", "force_element_size.png",
      "von_mises.png",    "draws.csv",        "bands.csv",
      "correlations.csv", "force_band.png",   "report.html"};
  return names.count(folder) > 0;
}

std::vector<Member> members_of(const std::vector<Variation>& variations) {
  std::vector<Member> members(1);
  for (const Variation& variation : variations) {
    std::vector<Member> longer;
    for (const Member& member : members) {
      for (const Choice& choice : variation.choices) {
        Member next = member;
        next.name += (next.name.empty() ? "" : ", ") + choice.label;
        next.values.push_back(choice.value);
        next.labels.push_back(choice.label);
        for (const Setting& setting : choice.settings)
          next.overrides.push_back(setting.parameter + "=" + setting.value);
        longer.push_back(std::move(next));
      }
    }
    members = std::move(longer);
  }
  for (Member& member : members) member.folder = folder_name(member.labels);
  return members;
}

}  // namespace stroma
