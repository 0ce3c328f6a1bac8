// SPDX-License-Identifier: BSL-1.0
// The checkers of guards: what is probably wrong with them, by its name.

#include <ansatz/states/check.hpp>
#include <ansatz/states/overlap.hpp>

#include "tests/states/guarded.hpp"

#include <vector>

using namespace states_tests;

namespace {
struct Bad {
    using Context = Walker;
    static constexpr auto machine = states::machine(
        state("a", transition(when(place == 5.0 * metre), to("b")), transition(on("e"), to("b")),
              transition(on("e"), when("x", [](const Walker&) { return true; }), to("trap"))),
        state("b", transition(on("back"), to("a")), transition(when(value("coins", &Walker::coins) == 3), to("trap"))),
        state("trap"), state("island", transition(on("e"), to("a"))));
};
struct Twice {
    using Context = Walker;
    static constexpr auto machine = states::machine(
        state("a", transition(when(place > 1.0 * metre), to("b")), transition(when(place > 2.0 * metre), to("c"))),
        state("b"), state("c"));
};
} // namespace

TEST_CASE("the checkers name what is probably wrong", "[states]") {
    const auto found = check(outline_of<Bad>());
    auto count = [&](Finding::What what, const std::string& name) {
        return std::count_if(found.begin(), found.end(),
                             [&](const Finding& f) { return f.what == what && f.state == name; });
    };
    CHECK(count(Finding::What::equality, "a") == 1);
    CHECK(count(Finding::What::hidden, "a") == 1);
    CHECK(count(Finding::What::no_exit, "trap") == 1);
    CHECK(count(Finding::What::unreachable, "island") == 1);
    CHECK(found.size() == 4); // and the equality of a whole number is none
    for (const auto& f : found) CHECK_THAT(f.text, ContainsSubstring("\"" + f.state + "\""));

    using Same = Turns<[] { return (place > 1.0 * metre); }, [] { return place < 2.0 * metre; }>;
    using Apart = Turns<[] { return (place > 2.0 * metre); }, [] { return place < 1.0 * metre; }>;
    std::vector<Walker> grid(40);
    for (std::size_t i = 0; i < grid.size(); ++i) grid[i].x = 0.1 * double(i) * metre;
    const auto both = overlapping<Same>(grid);
    REQUIRE(both.size() == 1);
    CHECK(both[0].what == Finding::What::back_and_forth);
    CHECK_THAT(both[0].text,
               ContainsSubstring("\"x > 1 m\" leads from \"low\" to \"high\" and \"x < 2 m\" leads back"));
    CHECK(overlapping<Apart>(grid).empty());
    const auto twice = overlapping<Twice>(grid);
    REQUIRE(twice.size() == 1);
    CHECK(twice[0].what == Finding::What::overlap);
    grid.resize(15); // up to 1.4 m they do not meet
    CHECK(overlapping<Twice>(grid).empty());
}

/// Names that a user of both namespaces takes for his own; `Guard` was one of the library's.
struct Guard {
    double health = 1;
};
struct GuardsLife {
    using Context = Guard;
    static constexpr auto machine = states::machine(
        state("alive",
              transition(when(held_for(value("health", &Guard::health) < 0.5 && !after(9.0 * second), 1.0 * second)),
                         to("dead"))),
        final_state("dead"));
};

TEST_CASE("whoever uses both namespaces may call his class Guard", "[states]") {
    Guard guard{0.2};
    Machine<GuardsLife, Switch> machine;
    machine.start(guard);
    for (int i = 0; i < 59; ++i) CHECK_FALSE(machine.update(guard, frame));
    CHECK(machine.update(guard, frame));
    CHECK(machine.done());
}
