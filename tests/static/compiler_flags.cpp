// SPDX-License-Identifier: BSL-1.0
// Under the flags that are not refused NaN and infinity are told from numbers (tests/core/compiler_flags.sh has those
// that are).

#include <ansatz/core/compiler_flags.hpp>

#include <limits>

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
static_assert(none != none && !(none < 0) && !(none >= 0));
static_assert(infinite > std::numeric_limits<double>::max());
static_assert((1e16 + 1.0) - 1e16 == 0.0, "sums are done in the order in which they are written");

} // namespace
