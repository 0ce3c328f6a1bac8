// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on a table of transitions (notes 5.1).

#include "tools/exercises/expect.hpp"

#include <random>

using namespace ansatz::workbook;
using namespace exercise;

namespace {

bool paid(const Gate& g) { return g.coins >= 1; }
void take(Gate& g) { ++g.coins; }
void use(Gate& g) { g.coins = 0; }
void pass(Gate& g) { ++g.passed; }
void give_back(Gate& g) { ++g.returned; }

/// The turnstile. The row with a guard stands before the one without.
const Rows& turnstile() {
    static const Rows rows{
        {State::locked, Event::coin, paid, use, State::unlocked},            // 0
        {State::locked, Event::coin, nullptr, take, State::locked},          // 1
        {State::unlocked, Event::push, nullptr, pass, State::locked},        // 2
        {State::unlocked, Event::coin, nullptr, give_back, State::unlocked}, // 3
        {State::unlocked, Event::kick, nullptr, nullptr, State::unlocked},   // 4
        {State::locked, Event::kick, paid, give_back, State::locked},        // 5
    };
    return rows;
}
/// Another one, which is broken. The row with a guard stands behind the one without, so that it never answers, and a
/// kick opens it.
const Rows& broken() {
    static const Rows rows{
        {State::locked, Event::coin, nullptr, take, State::locked},       // 0
        {State::locked, Event::coin, paid, use, State::unlocked},         // 1
        {State::locked, Event::kick, nullptr, nullptr, State::unlocked},  // 2
        {State::unlocked, Event::push, paid, give_back, State::unlocked}, // 3
        {State::unlocked, Event::push, nullptr, pass, State::locked},     // 4
    };
    return rows;
}
const char* name(State s) {
    return s == State::locked ? "locked" : s == State::unlocked ? "unlocked" : "no state at all";
}
const char* name(Event e) { return e == Event::coin ? "coin" : e == Event::push ? "push" : "kick"; }

void expect_row(State state, Event event, int coins, int right, const std::string& why,
                const Rows& rows = turnstile()) {
    const int yours = row_for(rows, state, event, Gate{coins, 0, 0});
    const std::string where = &rows == &broken() ? "of the broken turnstile " : "";
    expect(yours == right, "the row " + where + "for \"" + name(event) + "\" in " + name(state) + " with " +
                               std::to_string(coins) + " coins paid\n    yours  " + std::to_string(yours) +
                               "\n    right  " + std::to_string(right) + "\n" + why);
}
void expect_state(State yours, State right, const std::string& what, const std::string& why) {
    expect(yours == right, what + "\n    yours  " + name(yours) + "\n    right  " + name(right) + "\n" + why);
}
void expect_count(int yours, int right, const std::string& what, const std::string& why) {
    expect(yours == right,
           what + "\n    yours  " + std::to_string(yours) + "\n    right  " + std::to_string(right) + "\n" + why);
}

} // namespace

TEST_CASE("a row fits by its state and its event", "[task-1][fits]") {
    expect_row(State::unlocked, Event::push, 0, 2, "Row 2 is the only one for a push.");
    expect_row(State::unlocked, Event::coin, 0, 3, "Row 3 is the one for a coin while it is unlocked.");
    expect_row(State::locked, Event::push, 0, -1, "A push at a locked turnstile has no row at all.");
    expect_row(State::locked, Event::push, 5, -1, "A push at a locked turnstile has no row at all.");
}

TEST_CASE("and by its guard, where it has one", "[task-1][guard]") {
    expect_row(State::locked, Event::coin, 0, 1,
               "Row 0 asks for a coin that was paid before, and there is none: row 1.");
    expect_row(State::locked, Event::kick, 0, -1,
               "The only row for a kick at a locked turnstile has a guard that does not hold.");
    expect_row(State::locked, Event::kick, 1, 5, "The guard of row 5 holds.");
}

TEST_CASE("of several rows the first one answers", "[task-1][first]") {
    expect_row(State::locked, Event::coin, 1, 0,
               "Rows 0 and 1 both fit. The first one wins, so the order of a table is a part of its meaning.");
    expect_row(
        State::locked, Event::coin, 1, 0,
        "Rows 0 and 1 both fit. The first one wins here too, though it has no guard and row 1 has one that holds.",
        broken());
    expect_row(State::unlocked, Event::push, 1, 3, "Rows 3 and 4 both fit. The first one wins, and its guard holds.",
               broken());
}

TEST_CASE("an event does what its row says and leads where it says", "[task-2][does]") {
    Gate gate;
    expect_state(handle(turnstile(), State::locked, Event::coin, gate), State::locked, "after the first coin",
                 "Row 1: the coin is kept, and that is all.");
    expect_count(gate.coins, 1, "coins kept after the first coin", "Row 1 takes it.");
    expect_state(handle(turnstile(), State::unlocked, Event::push, gate), State::locked, "after a push, unlocked",
                 "Row 2 locks it behind whoever went through.");
    expect_count(gate.passed, 1, "people who went through", "Row 2 counts them.");
    expect_state(handle(turnstile(), State::unlocked, Event::kick, gate), State::unlocked, "after a kick, unlocked",
                 "Row 4 has no action, which is a row like any other.");
    gate = {};
    expect_state(handle(broken(), State::locked, Event::kick, gate), State::unlocked,
                 "after a kick, with the broken turnstile locked",
                 "Its row 2 has no action and leads to unlocked. A row without an action leads where it says.");
    expect_count(100 * gate.coins + 10 * gate.passed + gate.returned, 0,
                 "coins, people and returned coins after that kick, as one number", "There is nothing to do in row 2.");
}

TEST_CASE("an event takes one row, not another one in the new state", "[task-2][one-row]") {
    Gate gate{1, 0, 0};
    expect_state(handle(turnstile(), State::locked, Event::coin, gate), State::unlocked, "after the second coin",
                 "Row 0 unlocks it.");
    expect_count(gate.returned, 0, "coins given back at the second coin",
                 "Row 0 has answered the coin. Row 3 is for another coin, which comes later.");
}

TEST_CASE("an event without a row changes nothing", "[task-2][no-row]") {
    for (const int coins : {0, 1}) {
        Gate gate{coins, 3, 2};
        expect_state(handle(turnstile(), State::locked, Event::push, gate), State::locked, "after a push, locked",
                     "There is no row for it: the state stays.");
        expect_count(100 * gate.coins + 10 * gate.passed + gate.returned, 100 * coins + 32,
                     "coins, people and returned coins, as one number", "Nothing is done either.");
    }
    Gate gate;
    expect_state(handle(broken(), State::unlocked, Event::coin, gate), State::unlocked,
                 "after a coin, with the broken turnstile unlocked",
                 "It has no row for that: the state stays what it was, whichever state that is.");
    expect_count(100 * gate.coins + 10 * gate.passed + gate.returned, 0,
                 "coins, people and returned coins after that coin, as one number", "Nothing is done either.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    std::mt19937 random(5);
    exercise::State state = exercise::State::locked;
    Gate gate;
    for (int i = 0; i < 60; ++i) {
        const exercise::Event event = exercise::Event(random() % 3);
        if (task == 1) {
            numbers.push_back(
                row_for(turnstile(), exercise::State(random() % 2), event, Gate{int(random() % 2), 0, 0}));
        } else {
            state = handle(turnstile(), state, event, gate);
            numbers.push_back(1000 * gate.coins + 100 * gate.passed + 10 * gate.returned + int(state));
        }
    }
    for (const exercise::State from : {exercise::State::locked, exercise::State::unlocked})
        for (const exercise::Event event : {exercise::Event::coin, exercise::Event::push, exercise::Event::kick})
            for (const int coins : {0, 1}) {
                Gate there{coins, 0, 0};
                if (task == 1) numbers.push_back(row_for(broken(), from, event, there));
                else {
                    const exercise::State to = handle(broken(), from, event, there);
                    numbers.push_back(1000 * there.coins + 100 * there.passed + 10 * there.returned + int(to));
                }
            }
    return numbers;
}
