// SPDX-License-Identifier: BSL-1.0
// What a loop is divided into, by an execution that writes down what it was asked.

#include <ansatz/world/execution.hpp>

#include "tests/catch.hpp"

#include <tuple>
#include <utility>
#include <vector>

using namespace ansatz;

namespace {

/// Gives each line of rows by itself, the last one first.
struct Lines {
    using role = roles::Execution;
    std::vector<std::pair<std::size_t, std::size_t>>* asked;
    void execute(std::size_t count, std::size_t grain, const auto& loop) const {
        asked->emplace_back(count, grain);
        loop(count, count); // an empty part is none
        for (std::size_t i = count; i-- > 0;) loop(i, i + 1);
    }
};
struct SomethingElse {
    using role = roles::Observer;
};
/// As much of a composition as a loop reads.
template <class T, bool Executed> struct Composed {
    struct S {
        using Scalar = T;
    };
    static constexpr bool executed = Executed;
};
struct Wide {
    double digits[12];
};

} // namespace

TEMPLATE_TEST_CASE("A divided loop comes to each row once, in ranges that share no cache line", "[execution]", float,
                   double, Wide) {
    constexpr std::size_t line = sizeof(TestType) < 64 ? 64 / sizeof(TestType) : 1;
    for (const std::size_t begin : {0, 1, 8, 15, 16, 17})
        for (std::size_t rows = 0; rows < 70; ++rows) {
            CAPTURE(begin, rows);
            const std::size_t end = begin + rows;
            std::vector<std::pair<std::size_t, std::size_t>> asked;
            std::vector<int> times(end + 20, 0);
            bool on_lines = true;
            in_ranges<Composed<TestType, true>>(std::tuple(SomethingElse{}, Lines{&asked}), begin, end,
                                                [&](std::size_t first, std::size_t last) {
                                                    on_lines &= first < last && (first == begin || first % line == 0);
                                                    for (auto i = first; i < last; ++i) ++times[i];
                                                });
            std::vector<int> once(end + 20, 0);
            for (auto i = begin; i < end; ++i) once[i] = 1;
            CHECK(times == once);
            CHECK(on_lines);
            CHECK(asked.size() == (rows > 0 ? 1 : 0)); // nothing to do wakes no body
            for (const auto& [count, grain] : asked) {
                CHECK(count >= rows / line);
                CHECK(count <= rows / line + 2);
                CHECK(grain >= 1);
            }
        }
}
TEST_CASE("Without an execution a loop runs once, over all of it", "[execution]") {
    std::vector<std::pair<std::size_t, std::size_t>> parts;
    const auto note = [&](std::size_t begin, std::size_t end) { parts.emplace_back(begin, end); };
    in_ranges<Composed<double, false>>(std::tuple(SomethingElse{}), 3, 20, note);
    in_ranges<Composed<double, false>>(std::tuple(SomethingElse{}), 3, 3, note);
    CHECK(parts == std::vector<std::pair<std::size_t, std::size_t>>{{3, 20}, {3, 3}});
}
TEST_CASE("What a row throws leaves the loop", "[execution]") {
    std::vector<std::pair<std::size_t, std::size_t>> asked;
    const auto fail = [](std::size_t, std::size_t) { throw 7; };
    CHECK_THROWS_AS((in_ranges<Composed<double, true>>(std::tuple(Lines{&asked}), 0, 100, fail)), int);
}
TEST_CASE("A runner runs a loop as its execution does, or at once without one", "[execution]") {
    std::vector<std::pair<std::size_t, std::size_t>> asked, parts;
    const auto note = [&](std::size_t begin, std::size_t end) { parts.emplace_back(begin, end); };
    const Lines lines{&asked};
    const LoopRunner by_lines(lines), copy = by_lines, by_nothing;
    by_nothing(20, 3, note);
    CHECK(parts == std::vector<std::pair<std::size_t, std::size_t>>{{0, 20}});
    for (const auto* run : {&by_lines, &copy}) {
        parts.clear(), asked.clear();
        (*run)(3, 7, note);
        CHECK(asked == std::vector<std::pair<std::size_t, std::size_t>>{{3, 7}});
        CHECK(parts == std::vector<std::pair<std::size_t, std::size_t>>{{3, 3}, {2, 3}, {1, 2}, {0, 1}});
    }
    CHECK_THROWS_AS(by_lines(9, 1, [](std::size_t, std::size_t) { throw 7; }), int);
}
