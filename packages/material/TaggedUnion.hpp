// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// A value that is one of several kinds of struct.

#include <Kokkos_Core.hpp>
#include <type_traits>
#include <utility>

namespace stroma::material {

namespace detail {

/// Room for one of several plain structs; the first, of zeros, unless it is made from another.
template <class First, class... Rest>
union OneOfKinds {
  First first;
  OneOfKinds<Rest...> rest;

  KOKKOS_INLINE_FUNCTION OneOfKinds() : first() {}
  KOKKOS_INLINE_FUNCTION explicit OneOfKinds(const First& value) : first(value) {}
  template <class Kind>
  KOKKOS_INLINE_FUNCTION explicit OneOfKinds(const Kind& value) : rest(value) {}
};
template <class Last>
union OneOfKinds<Last> {
  Last first;

  KOKKOS_INLINE_FUNCTION OneOfKinds() : first() {}
  KOKKOS_INLINE_FUNCTION explicit OneOfKinds(const Last& value) : first(value) {}
};

template <class Kind, class Kinds>
KOKKOS_INLINE_FUNCTION auto& kind_in(Kinds& kinds) {
  if constexpr (std::is_same_v<std::decay_t<decltype(kinds.first)>, Kind>)
    return kinds.first;
  else
    return kind_in<Kind>(kinds.rest);
}

}  // namespace detail

/// One of several plain structs: trivially copyable, without virtual calls, for views of any memory
/// space. By default it is the first kind, of zeros.
template <class... Kinds>
class TaggedUnion {
 public:
  TaggedUnion() = default;
  template <class Kind, class = std::enable_if_t<(std::is_same_v<Kind, Kinds> || ...)>>
  TaggedUnion(const Kind& value) : value_(value), which_(index_of<Kind>()) {}

  /// f(value) of the kind that it is; f answers alike for all. The answer is made in its place.
  template <class F>
  KOKKOS_INLINE_FUNCTION auto visit(const F& f) const {
    return visit_from<std::common_type_t<decltype(f(std::declval<const Kinds&>()))...>, Kinds...>(
        f);
  }
  template <class Kind>
  bool is() const {
    return which_ == index_of<Kind>();
  }
  /// \pre it is of that kind
  template <class Kind>
  KOKKOS_INLINE_FUNCTION const Kind& as() const {
    return detail::kind_in<Kind>(value_);
  }
  /// f(value), which may change it.
  template <class F>
  KOKKOS_INLINE_FUNCTION void change(const F& f) {
    (void)((which_ == index_of<Kinds>() ? (f(detail::kind_in<Kinds>(value_)), true) : false) ||
           ...);
  }

 private:
  /// f(value), which is of the first kind or one of the rest.
  template <class Result, class First, class... Rest, class F>
  KOKKOS_INLINE_FUNCTION Result visit_from(const F& f) const {
    if constexpr (sizeof...(Rest) > 0) {
      if (which_ != index_of<First>()) return visit_from<Result, Rest...>(f);
    }
    return f(as<First>());
  }
  /// Its place among the kinds.
  template <class Kind>
  KOKKOS_INLINE_FUNCTION static constexpr int index_of() {
    int index = 0;
    (void)((std::is_same_v<Kind, Kinds> ? true : (++index, false)) || ...);
    return index;
  }

  detail::OneOfKinds<Kinds...> value_;
  int which_ = 0;
};

}  // namespace stroma::material
