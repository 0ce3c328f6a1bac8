// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Flags under which the library would not do what it says, refused by every header: each includes this one first,
/// directly or through another.
///
/// Every door of the library asks whether a number is finite, and "equal inputs give bit-equal results" rests on sums
/// that are done in the order in which they are written. Under `-ffinite-math-only` the first question is answered
/// without a test; under
/// `-fassociative-math` and `-freciprocal-math` the second does not hold. `-ffast-math` and `-Ofast` are all of them.
/// Wanted for their speed are mostly `-fno-math-errno` and `-O3`, which are allowed.
///
/// g++ tells of each of them by a macro. clang tells of `-ffast-math` and `-ffinite-math-only` only: there,
/// `-funsafe-math-optimizations` by itself is not seen.

#if defined(__cplusplus) && __cplusplus < 202002L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)
#error "Ansatz: the library is written in C++20; compile with -std=c++20 or newer"
#endif

#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error                                                                                                                 \
    "Ansatz: -ffast-math is refused: it lets the compiler reorder sums and forget NaN, and equal worlds would differ; use -O3"
#elif defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error                                                                                                                 \
    "Ansatz: -ffinite-math-only is refused: every value would count as finite, and nothing would be refused at the door; leave it out"
#elif defined(__ASSOCIATIVE_MATH__)
#error                                                                                                                 \
    "Ansatz: -funsafe-math-optimizations is refused: it lets the compiler reorder sums, and equal worlds would differ; use -O3"
#elif defined(__RECIPROCAL_MATH__)
#error                                                                                                                 \
    "Ansatz: -freciprocal-math is refused: x / y would be another number from place to place, and equal worlds would differ; use -O3"
#endif
