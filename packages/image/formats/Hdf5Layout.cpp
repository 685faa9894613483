// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/Hdf5Layout.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "stroma/base/Log.hpp"
#include "stroma/image/formats/Hdf5File.hpp"
#include "stroma/image/formats/LengthUnit.hpp"

namespace stroma::image {
namespace {

using Numbers = std::vector<std::int64_t>;

constexpr const char* imaris_pattern = "DataSet/ResolutionLevel #/TimePoint #/Channel #/Data";
constexpr const char* view_pattern = "t#/s#/#/cells";

/// The numbers of a name that has this form, where each # stands for digits; nothing otherwise.
std::optional<Numbers> match(const std::string& name, const std::string& pattern) {
  Numbers numbers;
  std::size_t at = 0;
  for (const char c : pattern) {
    if (c != '#') {
      if (at >= name.size() || name[at++] != c) return std::nullopt;
      continue;
    }
    std::int64_t number = 0;
    const auto [end, failure] =
        std::from_chars(name.data() + at, name.data() + name.size(), number);
    if (failure != std::errc() || number < 0) return std::nullopt;
    numbers.push_back(number);
    at = static_cast<std::size_t>(end - name.data());
  }
  return at == name.size() ? std::optional(numbers) : std::nullopt;
}

std::optional<double> number_in(const std::vector<std::string>& texts) {
  if (texts.empty()) return std::nullopt;
  const std::string& text = texts.front();
  double number = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
    return std::nullopt;
  return number;
}

/// The number of the wanted channel or frame among those that occur in names.
std::int64_t chosen(const std::set<std::int64_t>& numbers, std::int64_t wanted) {
  auto number = numbers.begin();
  std::advance(number, wanted);
  return *number;
}

/// Chooses among datasets by their names: `pattern` has a number for the level, the channel and the
/// frame, at these places. Nothing when no dataset has such a name.
std::optional<Numbers> choose(const std::vector<std::string>& names, const std::string& pattern,
                              const std::array<std::size_t, 3>& level_channel_frame,
                              const ImageRequest& request, Hdf5Place& place) {
  const auto [level, channel, frame] = level_channel_frame;
  std::set<std::int64_t> channels, frames;
  std::vector<std::pair<Numbers, std::string>> found;
  for (const std::string& name : names) {
    const std::optional<Numbers> numbers = match(name, pattern);
    if (!numbers) continue;
    if (name == request.dataset || "/" + name == request.dataset) {
      place.dataset = name;
      return numbers;
    }
    if ((*numbers)[level] != 0) continue;
    channels.insert((*numbers)[channel]);
    frames.insert((*numbers)[frame]);
    found.emplace_back(*numbers, name);
  }
  if (found.empty() || !request.dataset.empty()) return std::nullopt;
  place.channels = static_cast<std::int64_t>(channels.size());
  place.frames = static_cast<std::int64_t>(frames.size());
  check_channel(request.path, request.channel, place.channels);
  check_frame(request.path, request.frame, place.frames);
  for (const auto& [numbers, name] : found) {
    if (numbers[channel] != chosen(channels, request.channel) ||
        numbers[frame] != chosen(frames, request.frame))
      continue;
    place.dataset = name;
    return numbers;
  }
  refuse(request.path, base::format("holds no dataset of channel %d in frame %d", request.channel,
                                    request.frame));
}

/// Size and voxel size from the attributes of Imaris.
void read_imaris_attributes(hid_t file, Hdf5Place& place) {
  const hdf::Handle group =
      open_object(file, place.dataset.substr(0, place.dataset.find_last_of('/')));
  const hdf::Handle info = open_object(file, "DataSetInfo/Image");
  std::array<std::int64_t, 3> size{};
  bool sized = group.good();
  for (std::size_t axis = 0; axis < 3 && sized; ++axis) {
    const std::string name = std::string("ImageSize") + "XYZ"[axis];
    const std::optional<double> number = number_in(text_attribute(group.get(), name.c_str()));
    sized = number && *number >= 1.0 && *number < 1e9 && *number == std::floor(*number);
    if (sized) size[axis] = static_cast<std::int64_t>(*number);
  }
  if (!sized) {
    place.notes.emplace_back(
        "Imaris pads images, and this one's size (ImageSizeX, Y, Z) is not stated: padding is read "
        "as image");
    return;
  }
  place.size = size;
  if (!info.good()) return;
  const std::vector<std::string> unit = text_attribute(info.get(), "Unit");
  const std::optional<double> um = unit.empty() ? 1.0 : micrometres_per(unit.front());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string number = std::to_string(axis);
    const auto low = number_in(text_attribute(info.get(), ("ExtMin" + number).c_str()));
    const auto high = number_in(text_attribute(info.get(), ("ExtMax" + number).c_str()));
    if (!low || !high) {
      place.notes.push_back(
          base::format("Imaris: the extents along %c are not stated as numbers", "xyz"[axis]));
      continue;
    }
    const double length = (*high - *low) / static_cast<double>(size[axis]) * um.value_or(0.0);
    if (length > 0.0 && std::isfinite(length)) {
      place.voxel_size.set(static_cast<int>(axis), length, "Imaris extents");
    } else {
      place.notes.push_back(base::format("the Imaris extents %g to %g along %c are not used", *low,
                                         *high, "xyz"[axis]));
    }
  }
}

void read_view_attributes(const Numbers& numbers, const ImageRequest& request, Hdf5Place& place) {
  const std::int64_t setup = numbers[1], level = numbers[2];
  place.notes.push_back(base::format("BigDataViewer: view setup %lld, resolution level %lld",
                                     static_cast<long long>(setup), static_cast<long long>(level)));
  const std::filesystem::path xml = std::filesystem::path(request.path).replace_extension(".xml");
  std::error_code trouble;
  if (level != 0 || !std::filesystem::is_regular_file(xml, trouble)) {
    place.notes.push_back("the voxel size of BigDataViewer's files is in " +
                          xml.filename().string() +
                          (level != 0 ? ", for level 0 only: not used" : ", which is not there"));
    return;
  }
  constexpr std::size_t longest = std::size_t{1} << 26;
  std::string text(std::min<std::size_t>(longest, std::filesystem::file_size(xml, trouble)), '\0');
  std::ifstream(xml, std::ios::binary).read(text.data(), static_cast<std::streamsize>(text.size()));
  place.files.push_back(xml.string());
  place.voxel_size = voxel_size_of_view(text, setup, place.notes);
}

/// The only dataset, or the one that is asked for.
std::string named_dataset(hid_t file, const std::vector<std::string>& names,
                          const ImageRequest& request) {
  const std::string& wanted = request.dataset;
  if (names.empty()) refuse(request.path, "holds no dataset");
  constexpr std::size_t most = 40;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += (list.empty() ? "" : ", ") + names[i];
  if (names.size() > most) list += base::format(", ... (%zu)", names.size());
  if (wanted.empty()) {
    if (names.size() > 1)
      refuse(request.path, "holds several datasets; name one by Image|Dataset: " + list);
    return names.front();
  }
  const std::string name = wanted.front() == '/' ? wanted.substr(1) : wanted;
  // Of several links to a dataset, only one is among the names.
  const hdf::Handle object = open_object(file, name);
  if (!object.good() || H5Iget_type(object.get()) != H5I_DATASET)
    refuse(request.path,
           "holds no dataset \"" + wanted + "\" (Image|Dataset); admissible: " + list);
  return name;
}

}  // namespace

Hdf5Place find_place(hid_t file, const ImageRequest& request) {
  const std::optional<std::vector<std::string>> names = datasets_of(file);
  if (!names) {
    refuse(request.path,
           "is a broken HDF5 file: its datasets cannot be listed" + hdf::Messages::reason());
  }
  Hdf5Place place;
  if (choose(*names, imaris_pattern, {0, 2, 1}, request, place)) {
    place.format = "HDF5, Imaris";
    read_imaris_attributes(file, place);
  } else if (const auto numbers = choose(*names, view_pattern, {2, 1, 0}, request, place)) {
    place.format = "HDF5, BigDataViewer";
    place.meant_unsigned = true;
    read_view_attributes(*numbers, request, place);
  } else {
    place.dataset = named_dataset(file, *names, request);
    return place;
  }
  place.has_own_axes = false;
  return place;
}

}  // namespace stroma::image
