// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on hierarchies (notes 5.3).

#include "tools/exercises/expect.hpp"

using namespace ansatz::workbook;

namespace {

/// The guard of section 5.3: awake { on duty { patrol { walk, look }, combat { approach, strike } }, flee { run, hide }
/// }, home.
enum : int { machine, awake, on_duty, patrol, walk, look, combat, approach, strike, flee, run, hide, home };
const exercise::Parents guard{-1,     machine, awake, on_duty, patrol, patrol, on_duty,
                              combat, combat,  awake, flee,    flee,   machine};

std::string name(int state) {
    constexpr const char* names[] = {"the machine", "awake",  "on duty", "patrol", "walk", "look", "combat",
                                     "approach",    "strike", "flee",    "run",    "hide", "home"};
    return state >= 0 && state < int(guard.size()) ? names[state] : "no state (" + std::to_string(state) + ")";
}
std::string said(const std::vector<int>& states) {
    std::string text;
    for (const int s : states) text += (text.empty() ? "" : ", ") + name(s);
    return text.empty() ? "nothing" : text;
}
void expect_around(int source, int target, int right, const std::string& why) {
    const int yours = exercise::around_both(guard, source, target);
    expect(yours == right, "around " + name(source) + " and " + name(target) + "\n    yours  " + name(yours) +
                               "\n    right  " + name(right) + "\n" + why);
}
void expect_states(const std::string& what, const std::vector<int>& yours, const std::vector<int>& right,
                   const std::string& why) {
    expect(yours == right, what + "\n    yours  " + said(yours) + "\n    right  " + said(right) + "\n" + why);
}
void expect_taken(int innermost, const std::vector<exercise::Transition>& transitions, int right,
                  const std::string& why) {
    std::string what = "in " + name(innermost) + ", with conditions that hold in";
    for (const auto& t : transitions)
        if (t.holds) what += " " + name(t.source) + ",";
    what.back() = ':';
    const int yours = exercise::taken(guard, innermost, transitions);
    expect(yours == right, what + "\n    yours  transition " + std::to_string(yours) + "\n    right  transition " +
                               std::to_string(right) + "\n" + why);
}

} // namespace

TEST_CASE("around two states is the innermost that holds both", "[task-1][siblings]") {
    expect_around(walk, look, patrol, "Both are states of patrol.");
    expect_around(walk, strike, on_duty, "Patrol and combat are different, and both are on duty.");
    expect_around(strike, hide, awake, "On duty and flee are different, and both are awake.");
    expect_around(hide, home, machine, "Nothing but the machine itself is around both.");
}

TEST_CASE("and neither of them", "[task-1][neither]") {
    expect_around(strike, combat, on_duty,
                  "Combat is around strike, but not around itself: a transition to it leaves it and enters it again.");
    expect_around(strike, awake, machine, "Awake is around strike, but not around itself.");
    expect_around(walk, walk, patrol, "A state is not around itself.");
}

TEST_CASE("a number says nothing of how far in a state is", "[task-1][numbers]") {
    // State 2 { state 1 { state 3 }, state 4 }, state 5: state 1 is inside a state with a larger number.
    const exercise::Parents other{-1, 2, 0, 1, 2, 0};
    const auto expect_in_other = [&](int source, int target, int right, const std::string& why) {
        const int yours = exercise::around_both(other, source, target);
        expect(yours == right, "around state " + std::to_string(source) + " and state " + std::to_string(target) +
                                   ", where the parents of the states 1 to 5 are 2, 0, 1, 2 and 0\n    yours  state " +
                                   std::to_string(yours) + "\n    right  state " + std::to_string(right) + "\n" + why);
    };
    expect_in_other(3, 4, 2, "State 3 is in state 1, which is in state 2, and so is state 4.");
    expect_in_other(4, 3, 2, "State 4 is in state 2, and so is state 1 with state 3 in it.");
    expect_in_other(3, 1, 2, "State 1 is around state 3, but not around itself.");
    expect_in_other(4, 5, 0, "Nothing but the machine itself is around both.");
}

TEST_CASE("a transition leaves the inner states first", "[task-2][left]") {
    expect_states("left from strike to hide", exercise::way(guard, strike, hide).left, {strike, combat, on_duty},
                  "From the innermost outwards, up to awake, which stays.");
    expect_states("left from walk to look", exercise::way(guard, walk, look).left, {walk},
                  "Patrol stays: both are in it.");
    expect_states("left from look to home", exercise::way(guard, look, home).left, {look, patrol, on_duty, awake},
                  "Home is in none of them.");
}

TEST_CASE("and enters the outer states first", "[task-2][entered]") {
    expect_states("entered from hide to strike", exercise::way(guard, hide, strike).entered, {on_duty, combat, strike},
                  "From the outermost inwards: nobody strikes who is not in combat yet.");
    expect_states("entered from home to look", exercise::way(guard, home, look).entered, {awake, on_duty, patrol, look},
                  "From the outermost inwards.");
    expect_states("entered from walk to look", exercise::way(guard, walk, look).entered, {look},
                  "Patrol was not left.");
}

TEST_CASE("a transition to a parent leaves and enters it", "[task-2][parent]") {
    const auto way = exercise::way(guard, strike, combat);
    expect_states("left from strike to combat", way.left, {strike, combat},
                  "Combat is begun anew, so it is left first.");
    expect_states("entered from strike to combat", way.entered, {combat}, "And entered again.");
    const auto same = exercise::way(guard, look, look);
    expect_states("left from look to look", same.left, {look}, "It is begun anew, so it is left first.");
    expect_states("entered from look to look", same.entered, {look}, "And entered again.");
}

TEST_CASE("the conditions of every active state are checked", "[task-3][all]") {
    expect_taken(strike, {{combat, false}, {on_duty, true}}, 1,
                 "On duty is active too: what holds for it holds for every state in it.");
    expect_taken(strike, {{awake, true}}, 0, "Awake is active too.");
    expect_taken(strike, {{combat, false}, {machine, true}}, 1,
                 "The machine itself is around all states and is asked last. It has number 0, and is a state like any "
                 "other here.");
    expect_taken(strike, {{patrol, true}, {flee, true}, {walk, true}}, -1, "None of these is active.");
    expect_taken(strike, {{strike, false}, {awake, false}}, -1, "No condition holds.");
}

TEST_CASE("the innermost first", "[task-3][inner]") {
    expect_taken(strike, {{awake, true}, {combat, true}, {strike, true}}, 2,
                 "Strike is the innermost, wherever its transition stands in the list.");
    expect_taken(strike, {{awake, true}, {combat, true}, {strike, false}}, 1, "Combat is inside awake.");
}

TEST_CASE("of one state the first that holds", "[task-3][first]") {
    expect_taken(look, {{look, false}, {look, true}, {look, true}}, 1, "Two hold, and the first of them is taken.");
    expect_taken(look, {{patrol, true}, {patrol, true}}, 0, "Two hold, and the first of them is taken.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const int source : {3, 4, 5})
            for (const int target : {1, 2, 3, 4, 5})
                numbers.push_back(exercise::around_both({-1, 2, 0, 1, 2, 0}, source, target));
    for (const int source : {walk, strike, hide, home}) {
        if (task == 3)
            for (int mask = 0; mask < 128; ++mask) {
                std::vector<exercise::Transition> transitions;
                const int sources[] = {awake, source, on_duty, combat, source, flee, machine};
                for (int i = 0; i < 7; ++i) transitions.push_back({sources[i], (mask >> i & 1) != 0});
                numbers.push_back(exercise::taken(guard, source, transitions));
                // And where the innermost state has none of its own.
                for (auto& t : transitions)
                    if (t.source == source) t.source = look;
                numbers.push_back(exercise::taken(guard, source, transitions));
            }
        for (int target = 1; task != 3 && target < int(guard.size()); ++target) {
            if (task == 1) numbers.push_back(exercise::around_both(guard, source, target));
            if (task != 2) continue;
            const auto way = exercise::way(guard, source, target);
            for (const int s : way.left) numbers.push_back(s);
            for (const int s : way.entered) numbers.push_back(100 + s);
        }
    }
    return numbers;
}
