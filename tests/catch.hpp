// SPDX-License-Identifier: BSL-1.0
#pragma once

// Catch2, version 3 where it is installed, else 2.13 (Debian 12). Tests are written in the spelling of version 3; what
// 2.13 spells otherwise is given its name of version 3 here. Add a name when a test needs it.

#if __has_include(<catch2/catch_all.hpp>)

#include <catch2/catch_all.hpp>

#else

#define CATCH_CONFIG_ENABLE_BENCHMARKING // version 3 always has BENCHMARK
#include <catch2/catch.hpp>

#include <exception>
#include <string>
#include <utility>

namespace Catch {

using Detail::Approx;

namespace Matchers {

inline auto ContainsSubstring(const std::string& part, CaseSensitive::Choice choice = CaseSensitive::Yes) {
    return Contains(part, choice);
}

/// Matches an exception whose what() matches: MessageMatches(StartsWith("World::add") && ContainsSubstring("kg")).
template <class Matcher> class MessageMatchesMatcher : public MatcherBase<std::exception> {
public:
    explicit MessageMatchesMatcher(Matcher matcher) : matcher_{std::move(matcher)} {}
    bool match(const std::exception& error) const override { return matcher_.match(error.what()); }
    std::string describe() const override { return "matches \"" + matcher_.toString() + '"'; }

private:
    Matcher matcher_;
};

template <class Matcher> MessageMatchesMatcher<Matcher> MessageMatches(Matcher matcher) {
    return MessageMatchesMatcher<Matcher>{std::move(matcher)};
}

} // namespace Matchers
} // namespace Catch

/// Ends the test and has ctest report it as skipped, if nothing failed before. A reason is required.
#define SKIP(reason)                                                                                                   \
    do {                                                                                                               \
        WARN("test skipped: " << reason);                                                                              \
        SUCCEED();                                                                                                     \
        return;                                                                                                        \
    } while (false)

#endif
