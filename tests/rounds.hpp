// SPDX-License-Identifier: BSL-1.0
#pragma once

// How long a random test plays under the sanitizers of .ci/run, where each round takes ten times as long.

namespace ansatz::test {

/// Of so many, one is played by the stage `ci-sanitize`; all of them are by ./workbook test and by the stages
/// `sanitize` and `clang-sanitize`.
#ifdef ANSATZ_FEWER_TYPES
inline constexpr int one_in = 6;
#else
inline constexpr int one_in = 1;
#endif

/// \param all how many rounds a test has
constexpr int rounds(int all) { return all / one_in; }
/// What they must meet at least; of a part of the rounds half its share, since few rounds differ more.
/// \param all what all rounds together must meet
constexpr int at_least(int all) { return one_in == 1 ? all : all / (2 * one_in); }

} // namespace ansatz::test
