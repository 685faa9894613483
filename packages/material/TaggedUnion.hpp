// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A value that is one of several kinds of struct.

#include <Kokkos_Core.hpp>
#include <algorithm>
#include <new>
#include <type_traits>
#include <utility>

namespace stroma::material {

/// One of several plain structs: trivially copyable, without virtual calls, for views of any memory
/// space. By default it is the first kind, of zeros.
template <class... Kinds>
class TaggedUnion {
 public:
  TaggedUnion() = default;
  template <class Kind, class = std::enable_if_t<(std::is_same_v<Kind, Kinds> || ...)>>
  TaggedUnion(const Kind& value) : which_(index_of<Kind>()) {
    new (storage_) Kind(value);
  }

  /// f(value) of the kind that it is; f answers alike for all.
  template <class F>
  KOKKOS_INLINE_FUNCTION auto visit(const F& f) const {
    std::common_type_t<decltype(f(std::declval<const Kinds&>()))...> result{};
    (void)((which_ == index_of<Kinds>() ? (result = f(as<Kinds>()), true) : false) || ...);
    return result;
  }
  template <class Kind>
  bool is() const {
    return which_ == index_of<Kind>();
  }
  template <class Kind>
  KOKKOS_INLINE_FUNCTION const Kind& as() const {
    return *reinterpret_cast<const Kind*>(storage_);
  }
  template <class Kind>
  KOKKOS_INLINE_FUNCTION Kind& as() {
    return *reinterpret_cast<Kind*>(storage_);
  }
  /// f(value), which may change it.
  template <class F>
  KOKKOS_INLINE_FUNCTION void change(const F& f) {
    (void)((which_ == index_of<Kinds>() ? (f(as<Kinds>()), true) : false) || ...);
  }

 private:
  /// Its place among the kinds.
  template <class Kind>
  KOKKOS_INLINE_FUNCTION static constexpr int index_of() {
    int index = 0;
    (void)((std::is_same_v<Kind, Kinds> ? true : (++index, false)) || ...);
    return index;
  }

  alignas(std::max({alignof(Kinds)...})) unsigned char storage_[std::max({sizeof(Kinds)...})] = {};
  int which_ = 0;
};

}  // namespace stroma::material
