#pragma once

/// \file
/// Eight numbers at once, in the vector types of GCC and Clang, which compile for any processor.

namespace stroma::mechanics {

/// Eight values of a type, with the arithmetic of the compiler's vector types.
template <class T>
struct Eight;
template <>
struct Eight<float> {
  using Type = float __attribute__((vector_size(32)));
  using Unaligned = float __attribute__((vector_size(32), aligned(4)));
};
template <>
struct Eight<double> {
  using Type = double __attribute__((vector_size(64)));
  using Unaligned = double __attribute__((vector_size(64), aligned(8)));
};

template <class T>
inline typename Eight<T>::Type load_eight(const T* from) {
  return *reinterpret_cast<const typename Eight<T>::Unaligned*>(from);
}
template <class T>
inline void add_eight(T* to, const typename Eight<T>::Type& values) {
  *reinterpret_cast<typename Eight<T>::Unaligned*>(to) += values;
}
/// Eight floats as eight T.
template <class T>
inline typename Eight<T>::Type converted(const float* from) {
  return __builtin_convertvector(load_eight(from), typename Eight<T>::Type);
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

}  // namespace stroma::mechanics
