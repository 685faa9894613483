// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// The XML beside a BigDataViewer file: SpimData / SequenceDescription / ViewSetups / ViewSetup,
/// with an id and a voxelSize of a unit and a size, "0.3 0.3 1" along x, y, z.

#include <expat.h>

#include <cmath>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/Hdf5Layout.hpp"
#include "stroma/image/formats/LengthUnit.hpp"

namespace stroma::image {
namespace {

struct Setup {
  std::string id, unit, size;
};

struct State {
  std::vector<std::string> path;  ///< of the element that is being read
  Setup current;
  std::vector<Setup> setups;

  bool ends_with(const std::vector<std::string>& tail) const {
    return path.size() >= tail.size() &&
           std::equal(tail.begin(), tail.end(), path.end() - static_cast<long>(tail.size()));
  }
};

void start(void* user, const char* name, const char**) {
  State& state = *static_cast<State*>(user);
  state.path.emplace_back(name);
  if (state.ends_with({"ViewSetup"})) state.current = {};
}

void end(void* user, const char*) {
  State& state = *static_cast<State*>(user);
  if (state.ends_with({"ViewSetup"})) state.setups.push_back(state.current);
  state.path.pop_back();
}

void text(void* user, const char* characters, int count) {
  State& state = *static_cast<State*>(user);
  const auto length = static_cast<std::size_t>(count);
  if (state.ends_with({"ViewSetup", "id"})) state.current.id.append(characters, length);
  if (state.ends_with({"voxelSize", "unit"})) state.current.unit.append(characters, length);
  if (state.ends_with({"voxelSize", "size"})) state.current.size.append(characters, length);
}

std::vector<double> numbers_of(const std::string& list) {
  std::istringstream words(list);
  words.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number; words >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace

VoxelSize voxel_size_of_view(const std::string& xml, std::int64_t setup,
                             std::vector<std::string>& notes) {
  VoxelSize voxel_size;
  State state;
  const XML_Parser parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &state);
  XML_SetElementHandler(parser, start, end);
  XML_SetCharacterDataHandler(parser, text);
  const bool good = XML_Parse(parser, xml.data(), static_cast<int>(xml.size()), 1) == XML_STATUS_OK;
  XML_ParserFree(parser);
  const std::string wanted = std::to_string(setup);
  for (const Setup& candidate : state.setups) {
    if (!good || candidate.id != wanted) continue;
    const std::vector<double> size = numbers_of(candidate.size);
    const std::optional<double> um = micrometres_per(candidate.unit);
    if (size.size() != 3 || !um) break;
    for (int axis = 0; axis < 3; ++axis) {
      const double length = size[static_cast<std::size_t>(axis)] * *um;
      if (length > 0.0 && std::isfinite(length)) voxel_size.set(axis, length, "BigDataViewer XML");
    }
    if (voxel_size.complete()) return voxel_size;
  }
  notes.push_back(base::format(
      "the BigDataViewer XML states no voxel size in a known unit for view setup %s; not used",
      wanted.c_str()));
  return voxel_size;
}

}  // namespace stroma::image
