// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Copies of host data where kernels read them.

#include <algorithm>
#include <string>
#include <vector>

#include "stroma/grid/Types.hpp"

namespace stroma::grid {

template <class T>
Kokkos::View<const T*, Device> to_device(const std::string& name, const std::vector<T>& values) {
  const Kokkos::View<T*, Device> view(name, values.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

}  // namespace stroma::grid
