// SPDX-License-Identifier: BSD-3-Clause

#include "study/StudyPlan.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "commands/CheckCommand.hpp"
#include "run/MovingSupports.hpp"
#include "run/Specimen.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/deck/Findings.hpp"
#include "stroma/deck/Nearest.hpp"
#include "stroma/mechanics/problem/GridParameters.hpp"
#include "stroma/output/files/History.hpp"
#include "stroma/output/files/RunFolder.hpp"
#include "study/MemberRun.hpp"

namespace stroma {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t longest_name = 200;  // of a folder; file systems end at 255

/// Mistakes of members; one that several members have is told once.
class MemberMistakes {
 public:
  void add(const std::string& member, const std::string& message) {
    for (auto& [text, members] : mistakes_) {
      if (text == message) return members.push_back(member);
    }
    mistakes_.push_back({message, {member}});
  }

  void throw_if_any(const std::string& study, std::size_t member_count) const {
    if (mistakes_.empty()) return;
    std::string text = "the members of " + study + " cannot be run as they are";
    for (const auto& [message, members] : mistakes_) {
      text += members.size() == 1 ? "\nmember " : "\nmembers ";
      if (members.size() == member_count && member_count > 1) {
        text += "(all " + std::to_string(member_count) + ")";
      } else {
        for (std::size_t i = 0; i < members.size(); ++i)
          text += (i == 0 ? "\"" : ", \"") + members[i] + "\"";
      }
      text += ":";
      std::istringstream lines(message);
      for (std::string line; std::getline(lines, line);) text += "\n  " + line;
    }
    throw base::InputError(text);
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> mistakes_;
};

bool sets_title(const Member& member) {
  return std::any_of(member.overrides.begin(), member.overrides.end(),
                     [](const std::string& text) { return text.rfind("Title=", 0) == 0; });
}

/// The deck without what says how large the elements are.
std::string apart_from_element_size(const Deck& deck) {
  const Teuchos::RCP<Teuchos::ParameterList> list = as_run(deck);
  list->remove("Title", false);
  list->sublist("Grid").remove("Element Size [um]", false);
  list->sublist("Grid").remove("Elements", false);
  return xml(*list);
}

MemberFacts facts_of(const Deck& deck, const VoxelLattice& image) {
  std::array<double, 3> length{};
  for (std::size_t d = 0; d < 3; ++d)
    length[d] = static_cast<double>(image.size[d]) * image.voxel_size[d];
  MemberFacts facts;
  facts.materials = names(deck.parameters.materials.materials);
  facts.element_size = mechanics::make_grid(deck.parameters.grid, length).spacing;
  facts.moving = moving_supports(deck.parameters, length);
  facts.image = image;
  return facts;
}

/// Members that are draws of one distribution: the force of a support is told along one direction in
/// all, that of the member which moves it farthest, of those that pull if any do; and of a member that
/// happens not to move it, too.
void share_directions(std::vector<MemberFacts>& facts) {
  std::map<std::size_t, output::MovingSupport> farthest;  // by the index of the condition
  for (const MemberFacts& member : facts)
    for (const output::MovingSupport& support : member.moving) {
      output::MovingSupport& most = farthest.emplace(support.index, support).first->second;
      const auto rank_of = [](const output::MovingSupport& one) {
        return std::pair(one.strain > 0.0, moved_along(one));
      };
      if (rank_of(support) > rank_of(most)) most = support;
    }
  for (MemberFacts& member : facts) {
    std::map<std::size_t, output::MovingSupport> moving = farthest;
    for (auto& [index, support] : moving) {
      support.displacement = {};
      support.strain = 0.0;
    }
    for (output::MovingSupport support : member.moving) {
      support.along = farthest.at(support.index).along;
      moving.at(support.index) = support;
    }
    member.moving.clear();
    for (const auto& [index, support] : moving) member.moving.push_back(support);
  }
}

/// The image as the deck reads it, but for how it is segmented: what its size depends on.
std::string image_apart_from_segmentation(const Deck& deck) {
  Teuchos::ParameterList image = as_run(deck)->sublist("Image");
  image.remove("Segmentation", false);
  return xml(image);
}

VoxelLattice lattice_of(const Deck& deck, const voxels::LabelVolume& labels) {
  VoxelLattice lattice{labels.size, labels.voxel_size, {}};
  if (const auto& region = deck.parameters.image.region)
    for (std::size_t d = 0; d < 3; ++d)
      lattice.origin[d] = static_cast<double>((*region)[d]) * labels.voxel_size[d];
  return lattice;
}

/// Members with their decks; all mistakes that show in the decks alone.
void read_members(StudyPlan& plan, const std::string& output_folder) {
  const std::string base_deck = plan.study.document.resolve(plan.study.parameters.base_deck);
  if (!fs::exists(base_deck)) {
    deck::Findings findings(plan.study.document);
    findings.add("Base Deck", "there is no file '" + base_deck + "'");
    findings.throw_if_any();
  }
  const deck::Document base = deck::load(base_deck);  // whether it can be read at all
  const deck::tree::Parameter* base_title = base.root().parameter("Title");
  const std::string own_title = base_title != nullptr ? base_title->text : "";
  plan.title = plan.study.parameters.title.empty() ? own_title : plan.study.parameters.title;

  MemberMistakes mistakes;
  std::set<std::string> folders;
  std::map<std::string, std::size_t> families;
  for (Member& member : plan.members) {
    if (member.folder.size() > longest_name)
      mistakes.add(member.name,
                   "the name of its folder would have more than 200 letters; "
                   "admissible: shorter names of cases");
    if (!folders.insert(member.folder).second)
      mistakes.add(member.name, "another member would have the same folder, " + member.folder);
    plan.folders.push_back(output_folder + "/" + member.folder);
    std::vector<std::string> overrides = member.overrides;
    if (!sets_title(member))
      overrides.push_back("Title=" + own_title + (own_title.empty() ? "" : ": ") + member.name);
    try {
      plan.decks.push_back(read_deck(base_deck, overrides));
      if (asks_for_stiffness(plan.decks.back().parameters))
        throw base::InputError(
            "Rig|Kind = Stiffness has no load steps to compare; run each deck by itself");
      const auto [family, is_new] =
          families.emplace(apart_from_element_size(plan.decks.back()), families.size());
      plan.family.push_back(family->second);
    } catch (const base::InputError& error) {
      mistakes.add(member.name, in_terms_of("the study", error.what()));
    }
  }
  mistakes.throw_if_any(plan.study.document.path(), plan.members.size());
}

/// Names in the study deck that only the members' decks can tell.
void check_names(const StudyPlan& plan) {
  std::vector<std::string> columns;
  std::set<std::string> moving;
  for (std::size_t m = 0; m < plan.members.size(); ++m) {
    const auto more = output::history_columns(history_names(plan.decks[m].parameters));
    columns.insert(columns.end(), more.begin(), more.end());
    for (const auto& support : plan.facts[m].moving) moving.insert(support.name);
  }
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  deck::Findings findings(plan.study.document);
  for (const std::string& column : plan.study.parameters.also_tabulate) {
    if (!std::binary_search(columns.begin(), columns.end(), column))
      findings.add("Also Tabulate", "\"" + column + "\" is no column of a member's history.csv; " +
                                        deck::suggestion(column, columns));
  }
  const std::string& support = plan.study.parameters.plot.support;
  if (!support.empty() && moving.count(support) == 0) {
    findings.add("Plot|Support", "\"" + support + "\" is no boundary condition that moves; " +
                                     deck::suggestion(support, {moving.begin(), moving.end()}));
  }
  findings.throw_if_any();
}

}  // namespace

StudyPlan plan_study(const base::Communicator& communicator, const std::string& study_deck,
                     const std::string& output_folder) {
  std::optional<StudyPlan> plan;
  base::collectively(communicator, [&] {
    plan.emplace(StudyPlan{read_study(study_deck), {}, {}, {}, {}, {}, {}, {}});
    plan->members = members_of(plan->study.variations);
    read_members(*plan, output_folder);
  });

  MemberMistakes mistakes;
  std::map<std::string, VoxelLattice> lattices;
  const std::vector<std::string> inputs = input_files(*plan);
  for (std::size_t m = 0; m < plan->members.size(); ++m) {
    const Deck& deck = plan->decks[m];
    int finished = communicator.is_root() && is_finished(plan->folders[m], deck) ? 1 : 0;
    communicator.broadcast(finished);
    plan->finished.push_back(finished == 1);
    try {
      if (finished == 0) {
        base::Log silent(communicator, true);
        check_command(communicator, deck, silent);
        output::refuse_foreign_files(communicator, plan->folders[m], run_files(deck), inputs);
      }
      const std::string image = image_apart_from_segmentation(deck);
      if (lattices.count(image) == 0)
        lattices[image] = lattice_of(deck, read_image(communicator, deck).labels);
      plan->facts.push_back(facts_of(deck, lattices[image]));
    } catch (const base::InputError& error) {
      mistakes.add(plan->members[m].name, in_terms_of("the study", located(deck, error).what()));
    }
  }
  mistakes.throw_if_any(study_deck, plan->members.size());
  if (plan->study.parameters.uncertainty) share_directions(plan->facts);
  check_names(*plan);
  return std::move(*plan);
}

std::vector<std::string> input_files(const StudyPlan& plan) {
  std::vector<std::string> files{plan.study.document.path()};
  for (const Deck& deck : plan.decks)
    for (const std::string& file : input_files(deck))
      if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  return files;
}

const output::MovingSupport* drawn_support(const StudyPlan& plan, std::size_t member) {
  const std::string& wanted = plan.study.parameters.plot.support;
  for (const auto& support : plan.facts[member].moving)
    if (wanted.empty() || support.name == wanted) return &support;
  return nullptr;
}

}  // namespace stroma
