// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Eight numbers at once, in the vector types of GCC and Clang, which compile for any processor.

namespace stroma::tangent {

/// Eight values of a type, with the arithmetic of the compiler's vector types.
template <class T>
struct SimdPack;
template <>
struct SimdPack<float> {
  using Type = float __attribute__((vector_size(32)));
};
template <>
struct SimdPack<double> {
  using Type = double __attribute__((vector_size(64)));
};
/// The same anywhere in an array. An attribute of alignment on the vector's type itself is lost where Clang
/// finds it through a template.
template <class T>
struct __attribute__((packed, may_alias)) UnalignedPack {
  typename SimdPack<T>::Type values;
};

template <class T>
inline typename SimdPack<T>::Type load_pack(const T* from) {
  return reinterpret_cast<const UnalignedPack<T>*>(from)->values;
}
template <class T>
inline void add_pack(T* to, const typename SimdPack<T>::Type& values) {
  reinterpret_cast<UnalignedPack<T>*>(to)->values += values;
}
/// Eight floats as eight T.
template <class T>
inline typename SimdPack<T>::Type converted(const float* from) {
  return __builtin_convertvector(load_pack(from), typename SimdPack<T>::Type);
}
/// Each value one place up; the first is `first`.
template <class Vector, class T>
inline Vector shifted_up(const Vector& v, T first) {
  Vector shifted = __builtin_shufflevector(v, v, 0, 0, 1, 2, 3, 4, 5, 6);
  shifted[0] = first;
  return shifted;
}
/// Each value one place down; the last is zero.
template <class Vector>
inline Vector shifted_down(const Vector& v) {
  return __builtin_shufflevector(v, Vector{}, 1, 2, 3, 4, 5, 6, 7, 8);
}

}  // namespace stroma::tangent
