// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudySummary.hpp"

#include <algorithm>
#include <cmath>

#include "stroma/base/Log.hpp"

namespace stroma {
namespace {

using base::format;

/// Letters of a text, not bytes: UTF-8 is admissible in names.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, width_of(text)), ' ');
}

/// Without a sign in front of what rounds to nothing.
std::string percent(double value) {
  return format("%.3f %%", std::abs(value) < 5e-6 ? 0.0 : 100.0 * value);
}

}  // namespace

std::vector<std::optional<ForceRecord>> force_records(const StudyPlan& plan,
                                                      const std::vector<MemberResult>& results) {
  std::vector<std::optional<ForceRecord>> records(results.size());
  for (std::size_t m = 0; m < results.size(); ++m) {
    const output::MovingSupport* support = drawn_support(plan, m);
    const output::HistoryTable& history = results[m].history;
    if (support == nullptr || results[m].status != MemberStatus::done || history.rows() == 0)
      continue;
    records[m] = ForceRecord{history.column("load"), force_along(*support, history)};
  }
  return records;
}

std::vector<std::string> study_summary(const StudyPlan& plan,
                                       const std::vector<std::optional<ForceRecord>>& records,
                                       const ComparisonTable& comparison) {
  std::size_t widest = 6;
  for (const Member& member : plan.members) widest = std::max(widest, width_of(member.name));
  std::string head = padded("member", widest) + format("  %14s", "force");
  for (const std::string& column : comparison.columns) head += format("  %19s", column.c_str());
  std::vector<std::string> lines{head};
  for (std::size_t m = 0; m < plan.members.size(); ++m) {
    std::string line = padded(plan.members[m].name, widest);
    line +=
        format("  %14s", records[m] ? format("%.8g pN", records[m]->force.back()).c_str() : "-");
    for (const std::optional<double>& value : comparison.rows[m])
      line += format("  %19s", value ? percent(*value).c_str() : "-");
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> size_summary(const std::vector<SizeGroup>& groups) {
  std::vector<std::string> lines;
  for (const SizeGroup& group : groups) {
    const std::string name = group.name.empty() ? "force" : "force, " + group.name;
    if (const auto& limit = group.limit.extrapolation)
      lines.push_back(
          format("%s: %.8g pN at element size 0, observed order %.3f (from %g, %g and %g um)",
                 name.c_str(), limit->value, limit->order, limit->sizes[0], limit->sizes[1],
                 limit->sizes[2]));
    else
      lines.push_back(name +
                      ": no extrapolation to element size 0: " + group.limit.undefined_because);
  }
  return lines;
}

}  // namespace stroma
