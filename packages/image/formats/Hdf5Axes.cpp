// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/Hdf5Axes.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/Hdf5File.hpp"
#include "stroma/image/formats/ImageSource.hpp"

namespace stroma::image {
namespace {

/// "6 x 10 x 14"
std::string extents_text(const std::vector<hsize_t>& extents) {
  std::string text;
  for (const hsize_t extent : extents)
    text += (text.empty() ? "" : " x ") + std::to_string(static_cast<unsigned long long>(extent));
  return text;
}

/// "[z][y][x][c]"
std::string brackets(const std::string& keys) {
  std::string text;
  for (const char key : keys) text += std::string("[") + key + "]";
  return text;
}

/// The letter of a dimension's label: "z", "Z", "channel", "time", ...; '?' for any other.
char key_of_label(std::string label) {
  std::transform(label.begin(), label.end(), label.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (label == "channel" || label == "channels") return 'c';
  if (label == "time" || label == "frame") return 't';
  return label.size() == 1 ? label.front() : '?';
}

/// The axes that the dataset states, a letter for each dimension, and where.
struct StatedAxes {
  std::string keys, found_in;
};

std::optional<StatedAxes> stated_axes(hid_t dataset, std::vector<std::string>& notes) {
  const std::vector<std::string> tags = text_attribute(dataset, "axistags");
  if (!tags.empty()) return StatedAxes{keys_of_axistags(tags.front()), "axistags"};
  const std::vector<std::string> labels = text_attribute(dataset, "DIMENSION_LABELS");
  if (labels.empty()) {
    if (H5Aexists(dataset, "DIMENSION_LIST") > 0)
      notes.emplace_back(
          "its dimension scales, which may name the axes, are not read; the axes are taken in the usual "
          "order, x last; an attribute DIMENSION_LABELS says otherwise");
    return std::nullopt;
  }
  StatedAxes stated{"", "DIMENSION_LABELS"};
  for (const std::string& label : labels) stated.keys += key_of_label(label);
  if (stated.keys.find('?') == std::string::npos) return stated;
  notes.emplace_back("DIMENSION_LABELS are none of x, y, z, c, t everywhere; not used");
  return std::nullopt;
}

/// Axes from letters; complains by returning what is wrong.
std::string assign(const std::string& keys, const std::vector<hsize_t>& extents, Hdf5Axes& axes) {
  if (keys.size() != extents.size()) return "do not fit its " + extents_text(extents) + " values";
  for (std::size_t d = 0; d < keys.size(); ++d) {
    const std::size_t place = std::string("xyzct").find(keys[d]);
    if (place == std::string::npos) {
      if (extents[d] == 1) continue;  // whatever it means, there is one of it
      return base::format("call an axis of %llu entries neither x, y, z, c nor t",
                          static_cast<unsigned long long>(extents[d]));
    }
    int& axis = place < 3 ? axes.space[place] : place == 3 ? axes.channel : axes.time;
    if (axis >= 0) return "name an axis twice";
    axis = static_cast<int>(d);
  }
  if (axes.space[0] < 0 || axes.space[1] < 0) return "name no x or no y";
  return "";
}

/// Says so where the usual order makes a volume of what looks like the channels of a pixel.
void doubt(const std::string& keys, const std::vector<hsize_t>& extents,
           std::vector<std::string>& notes) {
  const hsize_t last = extents.back();
  const bool short_last =
      extents.size() >= 3 && last <= 4 &&
      std::all_of(extents.end() - 3, extents.end() - 1, [&](hsize_t n) { return n > last; });
  if (extents.size() >= 5 || short_last) {
    notes.push_back("the axes of " + extents_text(extents) + " values are not stated; read as " +
                    brackets(keys));
  }
  if (short_last) {
    notes.back() += base::format(
        ", though the last has only %llu entries; if these are channels, an attribute axistags or "
        "DIMENSION_LABELS must say so",
        static_cast<unsigned long long>(last));
  }
}

}  // namespace

std::string keys_of_axistags(const std::string& json) {
  // What is needed are the texts that follow "key":, wherever they stand; texts are skipped as
  // wholes, so that a description may hold anything.
  std::string keys, previous;
  bool after_colon = false;
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '"') {
      std::string text;
      for (++at; at < json.size() && json[at] != '"'; ++at) {
        if (json[at] == '\\') ++at;
        if (at < json.size()) text += json[at];
      }
      if (after_colon && previous == "key") keys += key_of_label(text);
      previous = after_colon ? "" : text;
      after_colon = false;
    } else if (c == ':') {
      after_colon = true;
    } else if (c == ',' || c == '{' || c == '[') {
      after_colon = false;
    }
  }
  return keys;
}

Hdf5Axes find_axes(hid_t dataset, const std::vector<hsize_t>& extents, const std::string& path,
                   const std::string& name, std::vector<std::string>& notes) {
  Hdf5Axes axes;
  if (const std::optional<StatedAxes> stated = stated_axes(dataset, notes)) {
    const std::string wrong = assign(stated->keys, extents, axes);
    if (!wrong.empty()) {
      refuse(path, "the axes of dataset \"" + name + "\", \"" + stated->keys + "\" (" +
                       stated->found_in + "), " + wrong +
                       "; admissible: x and y, and z, c and t where it has them, each once");
    }
    if (stated->keys != std::string("tczyx").substr(5 - std::min<std::size_t>(5, extents.size())))
      notes.push_back("axes " + brackets(stated->keys) + " as " + stated->found_in + " say");
    return axes;
  }
  // The usual order, from the last dimension on; more dimensions in front only if they are single.
  const std::size_t spare = extents.size() > 5 ? extents.size() - 5 : 0;
  const bool single = std::all_of(extents.begin(), extents.begin() + static_cast<long>(spare),
                                  [](hsize_t n) { return n == 1; });
  if (extents.size() < 2 || !single) {
    refuse(path, "dataset \"" + name +
                     base::format("\" has %d dimensions; admissible: [y][x], [z][y][x], "
                                  "[c][z][y][x], [t][c][z][y][x], or as axistags say",
                                  static_cast<int>(extents.size())));
  }
  const std::string keys =
      std::string(spare, '1') +
      std::string("tczyx").substr(5 - std::min<std::size_t>(5, extents.size()));
  assign(keys, extents, axes);
  doubt(keys, extents, notes);
  if (H5Aexists(dataset, "MATLAB_class") > 0)
    notes.emplace_back(
        "written by MATLAB, whose first index is the file's last: its rows are counted along x, its "
        "columns along y");
  return axes;
}

}  // namespace stroma::image
