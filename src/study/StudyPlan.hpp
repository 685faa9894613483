// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// All members of a study, read and checked before the first one is run.

#include <array>
#include <string>
#include <vector>

#include "run/Deck.hpp"
#include "stroma/base/Communicator.hpp"
#include "study/StudyDeck.hpp"
#include "study/StudyMembers.hpp"
#include "study/StudyTable.hpp"

namespace stroma {

struct StudyPlan {
  Study study;
  std::string title;
  std::vector<Member> members;
  std::vector<Deck> decks;           ///< of the members
  std::vector<MemberFacts> facts;    ///< of the members
  std::vector<std::string> folders;  ///< of the members
  std::vector<bool> finished;        ///< there is nothing to run
  /// Members with the same number differ in nothing but the size of their elements.
  std::vector<std::size_t> family;
};

/// Reads a study deck and every member's, and checks all of these as `stroma check` does; those
/// that are finished passed that before. Collective. \throws base::InputError with all mistakes,
/// each with the members that have it
StudyPlan plan_study(const base::Communicator& communicator, const std::string& study_deck,
                     const std::string& output_folder);

/// The files that a study is read from: its deck, the members' base deck and images.
std::vector<std::string> input_files(const StudyPlan& plan);

/// The support whose force is drawn and compared: Plot|Support, or else the first that moves; null
/// where the member has none.
const output::MovingSupport* drawn_support(const StudyPlan& plan, std::size_t member);

}  // namespace stroma
