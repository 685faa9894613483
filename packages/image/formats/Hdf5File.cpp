// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/formats/Hdf5File.hpp"

#include <algorithm>

#include "stroma/base/Log.hpp"

namespace stroma::image {
namespace {

/// Attributes that say something of an image are short; what is longer is none.
constexpr std::size_t longest_attribute = std::size_t{1} << 20;

/// A template, since the type of `info` depends on the version of HDF5.
template <class Info>
herr_t collect(hid_t, const char* name, const Info* info, void* names) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(names)->push_back(name);
  return 0;
}

/// An open attribute, its type, and the number of its entries.
struct Attribute {
  hdf::Handle attribute, type;
  std::size_t entries = 0, entry_bytes = 0;

  Attribute(hid_t object, const char* name) {
    if (H5Aexists(object, name) <= 0) return;
    attribute = hdf::Handle(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    if (!attribute.good()) return;
    type = hdf::Handle(H5Aget_type(attribute.get()), H5Tclose);
    const hdf::Handle space(H5Aget_space(attribute.get()), H5Sclose);
    const hssize_t count = space.good() ? H5Sget_simple_extent_npoints(space.get()) : 0;
    entry_bytes = type.good() ? H5Tget_size(type.get()) : 0;
    if (count < 1 || entry_bytes < 1 || entry_bytes > longest_attribute) return;
    if (static_cast<std::size_t>(count) <= longest_attribute / entry_bytes)
      entries = static_cast<std::size_t>(count);
  }
};

std::vector<std::string> variable_texts(const Attribute& given) {
  const hdf::Handle space(H5Aget_space(given.attribute.get()), H5Sclose);
  std::vector<char*> pointers(given.entries, nullptr);
  std::vector<std::string> texts;
  if (H5Aread(given.attribute.get(), given.type.get(), pointers.data()) < 0) return texts;
  for (const char* text : pointers) texts.emplace_back(text != nullptr ? text : "");
  H5Dvlen_reclaim(given.type.get(), space.get(), H5P_DEFAULT, pointers.data());
  return texts;
}

/// Names of filters that files are met with and that HDF5 itself does not have; those of szip and
/// others it knows.
std::string known_filter(H5Z_filter_t filter) {
  switch (filter) {
    case H5Z_FILTER_DEFLATE:
      return "deflate";
    case H5Z_FILTER_SZIP:
      return "szip";
    case 307:
      return "bzip2";
    case 32000:
      return "lzf";
    case 32001:
      return "blosc";
    case 32004:
      return "lz4";
    case 32008:
      return "bitshuffle";
    case 32013:
      return "zfp";
    case 32015:
      return "zstd";
    case 32026:
      return "blosc2";
    default:
      return "";
  }
}

}  // namespace

hdf::Handle open_object(hid_t file, const std::string& path) {
  const hdf::Handle access(H5Pcreate(H5P_LINK_ACCESS), H5Pclose);
  const auto refuse_file = [](const char*, const char*, const char*, const char*, unsigned*, hid_t,
                              void*) -> herr_t { return -1; };
  H5Pset_elink_cb(access.get(), refuse_file, nullptr);
  return {H5Oopen(file, path.c_str(), access.get()), H5Oclose};
}

std::optional<std::vector<std::string>> datasets_of(hid_t file) {
  std::vector<std::string> names;
  if (H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, collect, &names, H5O_INFO_BASIC) < 0)
    return std::nullopt;
  return names;
}

std::vector<std::string> text_attribute(hid_t object, const char* name) {
  const Attribute given(object, name);
  if (given.entries == 0 || H5Tget_class(given.type.get()) != H5T_STRING) return {};
  if (H5Tis_variable_str(given.type.get()) > 0) return variable_texts(given);
  std::string all(given.entries * given.entry_bytes, '\0');
  if (H5Aread(given.attribute.get(), given.type.get(), all.data()) < 0) return {};
  if (given.entry_bytes == 1) return {all.substr(0, all.find('\0'))};
  std::vector<std::string> texts;
  for (std::size_t entry = 0; entry < given.entries; ++entry)
    texts.emplace_back(all.substr(entry * given.entry_bytes, given.entry_bytes).c_str());
  return texts;
}

std::vector<double> number_attribute(hid_t object, const char* name, std::size_t most) {
  const Attribute given(object, name);
  if (given.entries == 0 || given.entries > most) return {};
  const H5T_class_t kind = H5Tget_class(given.type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) return {};
  std::vector<double> numbers(given.entries);
  if (H5Aread(given.attribute.get(), H5T_NATIVE_DOUBLE, numbers.data()) < 0) return {};
  return numbers;
}

std::optional<std::string> missing_filter(hid_t creation_properties) {
  const int filters = H5Pget_nfilters(creation_properties);
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0, configuration = 0;
    std::size_t values = 0;
    char stored[64] = "";
    const H5Z_filter_t filter =
        H5Pget_filter2(creation_properties, static_cast<unsigned>(i), &flags, &values, nullptr,
                       sizeof stored - 1, stored, &configuration);
    if (filter < 0 || H5Zfilter_avail(filter) > 0) continue;
    std::string name = known_filter(filter);
    for (const char* c = stored; name.empty() && *c != '\0'; ++c) {
      if (*c < ' ' || *c > '~') break;
      if (c[1] == '\0') name = stored;
    }
    return (name.empty() ? "a filter of unknown name" : name) +
           base::format(" (HDF5 filter %d)", static_cast<int>(filter));
  }
  return std::nullopt;
}

}  // namespace stroma::image
