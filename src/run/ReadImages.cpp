// SPDX-License-Identifier: BSD-3-Clause

#include "run/ReadImages.hpp"

#include <algorithm>

namespace stroma {

void ReadImages::add(const std::string& where, const image::ImageSummary& found) {
  const auto add_once = [](std::vector<std::string>& list, const std::string& one) {
    if (std::find(list.begin(), list.end(), one) == list.end()) list.push_back(one);
  };
  for (const std::string& name : found.files) add_once(files, name);
  for (const std::string& note : found.notes) add_once(notes, where + ": " + note);
}

}  // namespace stroma
