// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// The members of a study: every combination of what is varied, and what each is called.

#include <string>
#include <vector>

#include "study/StudyDeck.hpp"

namespace stroma {

struct Member {
  std::string name;                    ///< "8 px, Shear Modulus 520.8 Pa"
  std::string folder;                  ///< "8_px__Shear_Modulus_520.8_Pa"
  std::vector<std::string> values;     ///< one of each variation, for the table
  std::vector<std::string> labels;     ///< the same, for legends
  std::vector<std::string> overrides;  ///< "Section|Parameter=value", to lay over the base deck
};

/// All combinations; the last variation changes fastest.
std::vector<Member> members_of(const std::vector<Variation>& variations);

/// A folder's name that needs no quotes in a shell: the labels joined by "__", every character but
/// letters, digits and . + - (and what is not ASCII) as "_", no dot at the beginning.
std::string folder_name(const std::vector<std::string>& labels);

/// Whether a study itself writes a file or folder of that name.
bool is_reserved(const std::string& folder);

}  // namespace stroma
