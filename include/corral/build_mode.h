// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_BUILD_MODE_H
#define CORRAL_BUILD_MODE_H

/// \file
/// How a translation unit that includes Corral must be compiled. Every header includes this one.

#if defined __FAST_MATH__ || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error "Corral: compiled with -ffast-math or -ffinite-math-only; expected IEEE 754 arithmetic and infinities"
#endif
#if defined __ASSOCIATIVE_MATH__
#error "Corral: compiled with -fassociative-math; expected sums in the order in which they are written"
#endif

namespace corral::detail {

// With _GLIBCXX_DEBUG the standard containers have another layout, which a library compiled without it cannot read.
// The library defines the variable of its own mode, and every translation unit asks for that of its own.
#ifdef _GLIBCXX_DEBUG
extern const char library_is_compiled_with_GLIBCXX_DEBUG;
[[gnu::used]] static const char* const library_mode = &library_is_compiled_with_GLIBCXX_DEBUG;
#else
extern const char library_is_compiled_without_GLIBCXX_DEBUG;
[[gnu::used]] static const char* const library_mode = &library_is_compiled_without_GLIBCXX_DEBUG;
#endif

} // namespace corral::detail

#endif
