// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudySizes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace stroma {
namespace {

/// Newton stops at this share of the largest force; differences below it tell nothing.
double noise_of(const Deck& deck) { return 10.0 * deck.parameters.solver.newton_tolerance; }

/// The labels that all these members share.
std::string common_name(const StudyPlan& plan, const std::vector<std::size_t>& members) {
  std::string name;
  const auto& labels = plan.members[members.front()].labels;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    const bool is_common = std::all_of(members.begin(), members.end(), [&](std::size_t m) {
      return plan.members[m].labels[v] == labels[v];
    });
    if (is_common) name += (name.empty() ? "" : ", ") + labels[v];
  }
  return name;
}

/// The axis along which the members' elements differ first, -1 if they are alike, -2 if they differ
/// in shape: along the other axes a size may stay or change in the same ratio.
int size_axis(const StudyPlan& plan, const std::vector<std::size_t>& members) {
  const auto& first = plan.facts[members.front()].element_size;
  const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-6 * b; };
  int axis = -1;
  for (int d = 2; d >= 0; --d)
    for (const std::size_t m : members)
      if (differs(plan.facts[m].element_size[static_cast<std::size_t>(d)],
                  first[static_cast<std::size_t>(d)]))
        axis = d;
  if (axis < 0) return axis;
  for (std::size_t d = 0; d < 3; ++d) {
    bool stays = true, follows = true;
    for (const std::size_t m : members) {
      const auto& size = plan.facts[m].element_size;
      const auto a = static_cast<std::size_t>(axis);
      stays = stays && !differs(size[d], first[d]);
      follows = follows && !differs(size[d] / first[d], size[a] / first[a]);
    }
    if (!stays && !follows) return -2;
  }
  return axis;
}

}  // namespace

std::vector<SizeGroup> size_groups(const StudyPlan& plan,
                                   const std::vector<MemberResult>& results) {
  std::map<std::size_t, std::vector<std::size_t>> families;
  for (std::size_t m = 0; m < plan.members.size(); ++m)
    if (results[m].status == MemberStatus::done && drawn_support(plan, m) != nullptr)
      families[plan.family[m]].push_back(m);

  std::vector<SizeGroup> groups;
  for (const auto& [family, members] : families) {
    const int axis = size_axis(plan, members);
    if (axis == -1) continue;
    SizeGroup group;
    group.name = common_name(plan, members);
    for (const std::size_t m : members) {
      const double size = plan.facts[m].element_size[static_cast<std::size_t>(std::max(axis, 0))];
      group.forces.push_back(
          {size, force_along(*drawn_support(plan, m), results[m].history).back()});
    }
    group.limit = axis == -2 ? RichardsonResult{std::nullopt, "the elements differ in shape"}
                             : richardson(group.forces, noise_of(plan.decks[members.front()]));
    std::sort(group.forces.begin(), group.forces.end(),
              [](const SizedFigure& a, const SizedFigure& b) { return a.size > b.size; });
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace stroma
