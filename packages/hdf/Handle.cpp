// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/hdf/Handle.hpp"

#include <algorithm>

namespace stroma::hdf {
namespace {

herr_t first_entry(unsigned n, const H5E_error2_t* entry, void* text) {
  if (n == 0 && entry->desc) *static_cast<std::string*>(text) = entry->desc;
  return 0;
}

}  // namespace

Messages::Messages() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Messages::~Messages() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

std::string Messages::reason() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first_entry, &text);
  return text.empty() ? "" : " (HDF5: " + text + ")";
}

bool put_text(const Handle& object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type.get(), std::max<std::size_t>(text.size(), 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  const Handle attribute(
      H5Acreate2(object.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.good() && H5Awrite(attribute.get(), type.get(), text.c_str()) >= 0;
}

}  // namespace stroma::hdf
