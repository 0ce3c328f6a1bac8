// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the estimate of a planner (notes 6.2).

#include "tools/exercises/expect.hpp"

#include <array>
#include <cstdint>
#include <limits>

using namespace ansatz::workbook;
using exercise::Action;
using exercise::Goal;
using exercise::State;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// "01-1": a bit for each fact from the first on, and - where it does not matter.
std::string said(State value, State care, int facts) {
    std::string text;
    for (int bit = 0; bit < facts; ++bit) text += care >> bit & 1 ? (value >> bit & 1 ? '1' : '0') : '-';
    return text;
}

/// A state and a goal, of so many facts.
struct Compared {
    State state;
    Goal goal;
    int facts, right;
};
const std::vector<Compared>& all_matter() {
    static const std::vector<Compared> all = {{0b0000, {0b1111, 0b1111}, 4, 4},
                                              {0b1010, {0b0101, 0b1111}, 4, 4},
                                              {0b0110, {0b0111, 0b1111}, 4, 1},
                                              {0b1001, {0b1001, 0b1111}, 4, 0},
                                              {0b1111, {0b0000, 0b1111}, 4, 4}};
    return all;
}
const std::vector<Compared>& some_matter() {
    static const std::vector<Compared> all = {{0b0000, {0b0001, 0b0001}, 4, 1},
                                              {0b1110, {0b0001, 0b0011}, 4, 2},
                                              {0b1111, {0b0101, 0b0101}, 4, 0},
                                              {0b0101, {0b0000, 0b0000}, 4, 0},
                                              {State(1) << 63, {State(1) << 62, State(3) << 62}, 64, 2}};
    return all;
}
/// `value` also has bits where `care` has none.
const std::vector<Compared>& value_beside() {
    static const std::vector<Compared> all = {{0b0000, {0b0110, 0b0010}, 4, 1},
                                              {0b0011, {0b1110, 0b0011}, 4, 1},
                                              {0b1001, {0b1101, 0b1001}, 4, 0},
                                              {0b0100, {0b1111, 0b0000}, 4, 0}};
    return all;
}
void expect_unmet(const std::vector<Compared>& all, const std::string& why) {
    for (const auto& c : all) {
        const int yours = exercise::unmet(c.state, c.goal);
        std::ostringstream text;
        text << "state " << said(c.state, ~State(0), c.facts) << ", goal " << said(c.goal.value, c.goal.care, c.facts)
             << "\n    yours  " << yours << "\n    right  " << c.right << '\n'
             << why;
        expect(yours == c.right, text.str());
    }
}

/// Five facts, a goal, and actions that need nothing.
struct Problem {
    Goal goal;
    std::vector<Action> actions;
};
constexpr int facts = 5, states = 1 << facts;

/// One action for each fact, all for the same: then the estimate can be exact.
Problem one_for_each(State value, double cost) {
    Problem p{{value, 0b11111}, {}};
    for (int bit = 0; bit < facts; ++bit) p.actions.push_back({value & State(1) << bit, State(1) << bit, cost});
    return p;
}
const std::vector<Problem>& alike() {
    static const std::vector<Problem> all = {one_for_each(0b11111, 3), one_for_each(0b01011, 0.25),
                                             one_for_each(0b00000, 1)};
    return all;
}
/// One action that sets all facts at once, and others that undo them, or set one for more than its share.
const std::vector<Problem>& all_at_once() {
    static const std::vector<Problem> all = {{{0b11111, 0b11111}, {{0b11111, 0b11111, 4}, {0b00000, 0b00011, 1}}},
                                             {{0b00110, 0b01111}, {{0b00110, 0b11111, 2}, {0b11001, 0b11111, 0.5}}},
                                             {{0b01011, 0b01111}, {{0b01011, 0b01111, 8}, {0b00001, 0b00001, 3}}}};
    return all;
}
const std::vector<Problem>& nothing_helps() {
    static const std::vector<Problem> all = {{{0b00001, 0b00001}, {{0b00010, 0b00010, 2}}},
                                             {{0b00001, 0b00001}, {{0b00000, 0b00001, 1}}},
                                             {{0b111, 0b111}, {}}};
    return all;
}
const std::vector<Problem>& random_ones() {
    static const std::vector<Problem> all = [] {
        std::vector<Problem> problems;
        std::uint32_t seed = 5;
        auto random = [&](std::uint32_t below) { return (seed = seed * 1664525u + 1013904223u) / 65536 % below; };
        for (int n = 0; n < 60; ++n) {
            Problem p{{random(states), random(states)}, {}};
            p.goal.value &= p.goal.care;
            for (std::uint32_t i = 0, many = 2 + random(5); i < many; ++i) {
                const State care = random(states);
                p.actions.push_back({random(states) & care, care, 0.5 * random(8)});
            }
            problems.push_back(p);
        }
        return problems;
    }();
    return all;
}
/// What the cheapest plan from each state costs: lowered step by step until nothing falls any more.
std::array<double, states> true_costs(const Problem& p) {
    std::array<double, states> cost{};
    for (State s = 0; s < states; ++s) cost[s] = (s & p.goal.care) == p.goal.value ? 0 : infinite;
    for (bool lowered = true; lowered;) {
        lowered = false;
        for (State s = 0; s < states; ++s)
            for (const Action& a : p.actions) {
                const double by = a.cost + cost[(s & ~a.care) | a.value];
                if (by < cost[s]) cost[s] = by, lowered = true;
            }
    }
    return cost;
}
std::string said(const Problem& p, State s) {
    std::ostringstream text;
    text << "state " << said(s, states - 1, facts) << ", goal " << said(p.goal.value, p.goal.care, facts)
         << ", actions";
    for (const Action& a : p.actions) text << "  " << said(a.value, a.care, facts) << " for " << a.cost;
    return text.str();
}
template <class Check> void for_each_state(const std::vector<Problem>& problems, Check&& check) {
    for (const auto& p : problems) {
        const auto cost = true_costs(p);
        for (State s = 0; s < states; ++s) check(p, s, cost[s], exercise::estimate(s, p.goal, p.actions));
    }
}

} // namespace

TEST_CASE("the facts that are not as they should be are counted", "[task-1][count]") {
    expect_unmet(all_matter(), "A fact that should not hold and does is as wrong as one that should and does not.");
}

TEST_CASE("what the goal does not care about does not count", "[task-1][care]") {
    expect_unmet(some_matter(), "Where care has no bit, the fact may be as it likes.");
}

TEST_CASE("nor does what value says of it", "[task-1][value]") {
    expect_unmet(value_beside(), "Where care has no bit, shown as -, value may have one here, and it says nothing.");
}

TEST_CASE("one action for each fact, all for the same: exact", "[task-2][alike]") {
    for_each_state(alike(), [](const Problem& p, State s, double truth, double yours) {
        expect_near(said(p, s), yours, truth, 1e-9, "Each wrong fact takes one action, and costs what that costs.");
    });
}

TEST_CASE("one action for all facts: exact where all of them are wrong", "[task-2][at-once]") {
    for (const auto& p : all_at_once()) {
        const State s = ~p.goal.value & (states - 1);
        expect_near(said(p, s), exercise::estimate(s, p.goal, p.actions), p.actions[0].cost, 1e-9,
                    "The cost of the action, shared by the facts of the goal that it sets as they should be; those "
                    "that it sets otherwise, or\nthat do not matter, have no share. It is its own cost by its own "
                    "facts, not by those of another.");
    }
}

TEST_CASE("nothing sets any fact of the goal: 0", "[task-2][nothing]") {
    for_each_state(nothing_helps(), [](const Problem& p, State s, double, double yours) {
        expect_near(said(p, s), yours, 0.0, 1e-12,
                    "There is no least cost of a fact here, and zero is never too much.");
    });
}

TEST_CASE("never more than the cheapest plan, and 0 in the goal", "[task-2][never-more]") {
    for_each_state(random_ones(), [](const Problem& p, State s, double truth, double yours) {
        std::ostringstream text;
        text << said(p, s) << "\n    yours              " << yours << "\n    the cheapest plan  " << truth
             << "\nAn estimate above it may lead A* to a plan that is not the best: an action can meet several "
                "facts, and may cost little.";
        expect(yours <= truth + 1e-9 && yours >= 0, text.str());
    });
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const auto* all : {&all_matter(), &some_matter(), &value_beside()})
            for (const auto& c : *all) numbers.push_back(exercise::unmet(c.state, c.goal));
        return numbers;
    }
    for (const auto* all : {&alike(), &all_at_once(), &nothing_helps(), &random_ones()})
        for_each_state(*all, [&](const Problem&, State, double, double yours) { numbers.push_back(yours); });
    return numbers;
}
