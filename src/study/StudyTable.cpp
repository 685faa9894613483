// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyTable.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace stroma {
namespace {

using output::csv_field;
using output::csv_number;

void add_new(std::vector<std::string>& list, const std::string& name) {
  if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

std::string last_of(const output::HistoryTable& history, const std::string& column) {
  const std::vector<double>* values = history.find(column);
  return values == nullptr || values->empty() ? "" : csv_number(values->back());
}

std::string sum_of(const output::HistoryTable& history, const std::string& column) {
  const std::vector<double>* values = history.find(column);
  if (values == nullptr) return "";
  return std::to_string(
      static_cast<std::int64_t>(std::accumulate(values->begin(), values->end(), 0.0)));
}

const char* name_of(MemberStatus status) {
  switch (status) {
    case MemberStatus::done:
      return "done";
    case MemberStatus::failed:
      return "failed";
    case MemberStatus::waiting:
      break;
  }
  return "waiting";
}

std::string line_of(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    line += (i == 0 ? "" : ",") + csv_field(fields[i]);
  return line + "\n";
}

}  // namespace

std::vector<double> force_along(const output::MovingSupport& support,
                                const output::HistoryTable& history) {
  std::vector<double> force(history.rows(), 0.0);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto& reaction = history.column(support.name + ".reaction_" + "xyz"[d]);
    for (std::size_t s = 0; s < force.size(); ++s) force[s] += reaction[s] * support.along[d];
  }
  return force;
}

double moved_along(const output::MovingSupport& support) {
  double sum = 0.0;
  for (std::size_t d = 0; d < 3; ++d) sum += support.displacement[d] * support.along[d];
  return sum;
}

std::string study_table(const std::vector<Variation>& variations,
                        const std::vector<Member>& members, const std::vector<MemberFacts>& facts,
                        const std::vector<MemberResult>& results, const ComparisonTable& comparison,
                        const std::vector<std::string>& also) {
  std::vector<std::string> supports, materials;
  for (const MemberFacts& member : facts) {
    for (const auto& support : member.moving) add_new(supports, support.name);
    for (const std::string& material : member.materials) add_new(materials, material);
  }
  std::vector<std::string> header{"member"};
  for (const Variation& variation : variations) header.push_back(variation.name);
  header.insert(header.end(), {"status", "load"});
  for (const std::string& name : supports) header.push_back(name + ".force");
  header.insert(header.end(), comparison.columns.begin(), comparison.columns.end());
  header.push_back("strain_energy");
  for (const std::string& name : materials) header.push_back(name + ".von_mises_mean");
  header.insert(header.end(), {"newton_iterations", "linear_iterations", "wall_seconds"});
  header.insert(header.end(), also.begin(), also.end());

  std::string table = line_of(header);
  for (std::size_t m = 0; m < members.size(); ++m) {
    const MemberResult& result = results[m];
    const output::HistoryTable& history = result.history;
    const bool at_full_load = result.status == MemberStatus::done;
    const auto figure = [&](const std::string& column) {
      return at_full_load ? last_of(history, column) : "";
    };
    std::vector<std::string> row{members[m].folder};
    row.insert(row.end(), members[m].values.begin(), members[m].values.end());
    row.insert(row.end(), {name_of(result.status), last_of(history, "load")});
    for (const std::string& name : supports) {
      const auto& moving = facts[m].moving;
      const auto support = std::find_if(moving.begin(), moving.end(),
                                        [&](const auto& one) { return one.name == name; });
      const bool has_force = at_full_load && support != moving.end();
      row.push_back(has_force ? csv_number(force_along(*support, history).back()) : "");
    }
    for (const std::optional<double>& value : comparison.rows[m])
      row.push_back(value ? csv_number(*value) : "");
    row.push_back(figure("strain_energy"));
    for (const std::string& name : materials) row.push_back(figure(name + ".von_mises_mean"));
    row.insert(row.end(), {sum_of(history, "newton_iterations"),
                           sum_of(history, "linear_iterations"), last_of(history, "wall_seconds")});
    for (const std::string& column : also) row.push_back(figure(column));
    table += line_of(row);
  }
  return table;
}

std::string convergence_table(const std::vector<SizeGroup>& groups) {
  std::string table = line_of({"series", "sizes", "finest_element_size", "finest_force",
                               "extrapolated_force", "order", "remark"});
  for (const SizeGroup& group : groups) {
    const auto finest = std::min_element(
        group.forces.begin(), group.forces.end(),
        [](const SizedFigure& a, const SizedFigure& b) { return a.size < b.size; });
    const auto& limit = group.limit.extrapolation;
    table += line_of({group.name, std::to_string(group.forces.size()), csv_number(finest->size),
                      csv_number(finest->figure), limit ? csv_number(limit->value) : "",
                      limit ? csv_number(limit->order) : "", group.limit.undefined_because});
  }
  return table;
}

}  // namespace stroma
