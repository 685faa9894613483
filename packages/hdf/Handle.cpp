// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/hdf/Handle.hpp"

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

}  // namespace stroma::hdf
