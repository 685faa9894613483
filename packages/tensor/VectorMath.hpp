// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Elementary functions of which a compiler makes several at once in a loop.
///
/// GCC does so with the vector forms in glibc's libmvec (x86, from glibc 2.35 on), which are within 4
/// units in the last place; elsewhere they are the usual functions. A loop that calls them is
/// vectorised if it has no branches.

#include <Kokkos_Macros.hpp>
#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
#define STROMA_HAS_VECTOR_MATH
#endif
#endif

namespace stroma::tensor {

#ifdef STROMA_HAS_VECTOR_MATH
namespace detail {
#define STROMA_SEVERAL_AT_ONCE __attribute__((simd("notinbranch"), const, nothrow))
extern "C" {
STROMA_SEVERAL_AT_ONCE double stroma_vector_exp(double) __asm__("exp");
STROMA_SEVERAL_AT_ONCE double stroma_vector_expm1(double) __asm__("expm1");
STROMA_SEVERAL_AT_ONCE double stroma_vector_pow(double, double) __asm__("pow");
}
#undef STROMA_SEVERAL_AT_ONCE
}  // namespace detail
inline double vector_exp(double x) { return detail::stroma_vector_exp(x); }
inline double vector_expm1(double x) { return detail::stroma_vector_expm1(x); }
inline double vector_pow(double x, double y) { return detail::stroma_vector_pow(x, y); }
#else
KOKKOS_INLINE_FUNCTION double vector_exp(double x) { return exp(x); }
KOKKOS_INLINE_FUNCTION double vector_expm1(double x) { return expm1(x); }
KOKKOS_INLINE_FUNCTION double vector_pow(double x, double y) { return pow(x, y); }
#endif

}  // namespace stroma::tensor
