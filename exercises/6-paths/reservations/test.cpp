// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on reservations in space and time (notes 6.3.10).

#include "tools/exercises/expect.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace ansatz::workbook;
using exercise::Place;
using exercise::Plan;

namespace {

/// A walks to the east and stays, B comes from the south and goes on, C stands. None of them meets another.
const Plan a{{1, 1}, {2, 1}, {3, 1}, {4, 1}};
const Plan b{{2, 4}, {2, 3}, {2, 2}, {2, 1}, {2, 0}, {1, 0}};
const Plan c{{5, 3}};
const std::vector<Plan> reserved{a, b, c};
const exercise::Room room{"......", "......", ".#....", "......", "......"};

std::string said(Place p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }
std::string said(const Plan& plan) {
    std::string text;
    for (const Place p : plan) text += (text.empty() ? "" : " ") + said(p);
    return text;
}
const std::string& all_plans() {
    static const std::string text =
        "reserved are, from step 0 on\n    A  " + said(a) + "\n    B  " + said(b) + "\n    C  " + said(c) + "\n";
    return text;
}

struct Asked {
    Place from, to;
    std::size_t step;
};
void expect_free(const std::vector<Asked>& all, bool right, const std::string& why) {
    auto word = [](bool yes) { return yes ? "free" : "not free"; };
    for (const Asked& q : all) {
        const bool yours = exercise::is_free(reserved, q.from, q.to, q.step);
        expect(yours == right, all_plans() + "from " + said(q.from) + " in step " + std::to_string(q.step) + " to " +
                                   said(q.to) + " in step " + std::to_string(q.step + 1) + "\n    yours  " +
                                   word(yours) + "\n    right  " + word(right) + "\n" + why);
    }
}
using List = const std::vector<Asked>& (*)();
const std::vector<Asked>& occupied() {
    static const std::vector<Asked> all = {
        {{3, 2}, {3, 1}, 1}, {{5, 1}, {4, 1}, 2}, {{1, 3}, {2, 3}, 0}, {{5, 4}, {5, 3}, 0}};
    return all;
}
/// Behind the end of a plan its owner is still there.
const std::vector<Asked>& occupied_later() {
    static const std::vector<Asked> all = {{{4, 0}, {4, 1}, 7}, {{5, 2}, {5, 3}, 4}, {{0, 0}, {1, 0}, 11}};
    return all;
}
const std::vector<Asked>& swapped() {
    static const std::vector<Asked> all = {{{2, 1}, {1, 1}, 0}, {{4, 1}, {3, 1}, 2}, {{2, 1}, {2, 2}, 2}};
    return all;
}
/// Somebody is there now, and goes on in another direction; a third one may come to where you were.
const std::vector<Asked>& followed() {
    static const std::vector<Asked> all = {{{0, 1}, {1, 1}, 0}, {{2, 2}, {2, 1}, 1}, {{3, 2}, {2, 2}, 2}};
    return all;
}
const std::vector<Asked>& nobody_near() {
    static const std::vector<Asked> all = {{{1, 4}, {2, 4}, 1}, {{3, 3}, {3, 2}, 1}, {{1, 3}, {1, 4}, 3}};
    return all;
}
const std::vector<Asked>& waiting_free() {
    static const std::vector<Asked> all = {{{4, 1}, {4, 1}, 0}, {{2, 0}, {2, 0}, 0}, {{0, 4}, {0, 4}, 9}};
    return all;
}
const std::vector<Asked>& waiting_taken() {
    static const std::vector<Asked> all = {{{2, 1}, {2, 1}, 0}, {{4, 1}, {4, 1}, 2}, {{2, 2}, {2, 2}, 1}};
    return all;
}

struct Standing {
    Place at;
    std::size_t step;
};
const std::vector<Standing>& crowded() { // somebody comes
    static const std::vector<Standing> all = {{{2, 1}, 0}, {{2, 1}, 2}, {{4, 1}, 2}, {{5, 2}, 1}};
    return all;
}
const std::vector<Standing>& at_the_walls() {
    static const std::vector<Standing> all = {{{0, 0}, 0}, {{5, 4}, 8}, {{0, 2}, 3}, {{1, 3}, 7}, {{1, 1}, 3}};
    return all;
}
const std::vector<Standing>& in_the_open() {
    static const std::vector<Standing> all = {{{3, 3}, 4}, {{2, 3}, 7}, {{3, 2}, 5}};
    return all;
}
std::vector<Place> sorted(std::vector<Place> places) {
    std::sort(places.begin(), places.end(), [](Place p, Place q) { return std::pair(p.y, p.x) < std::pair(q.y, q.x); });
    return places;
}
/// Said anew, by a rule that is written out: what stands in the plans at one step and at the next.
std::vector<Place> right_places(const Standing& s) {
    const auto at = [](const Plan& plan, std::size_t step) { return step < plan.size() ? plan[step] : plan.back(); };
    std::vector<Place> next;
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 6; ++x) {
            const int apart = std::abs(x - s.at.x) + std::abs(y - s.at.y);
            bool possible = apart <= 1 && room[std::size_t(y)][std::size_t(x)] == '.';
            for (const Plan& plan : reserved) {
                const Place was = at(plan, s.step), will = at(plan, s.step + 1), to{x, y};
                possible = possible && !(will == to) && !(was == to && will == s.at);
            }
            if (possible) next.push_back({x, y});
        }
    return sorted(next);
}
void expect_places(const std::vector<Standing>& all, const std::string& why) {
    for (const Standing& s : all) {
        const auto yours = sorted(exercise::next_places(room, reserved, s.at, s.step)), right = right_places(s);
        expect(yours == right, all_plans() + "the room has 6 x 5 tiles and a wall at (1, 2); from " + said(s.at) +
                                   " in step " + std::to_string(s.step) + "\n    yours  " + said(yours) +
                                   "\n    right  " + said(right) + "\n" + why);
    }
}

const std::vector<Standing>& passed_later() {
    static const std::vector<Standing> all = {{{2, 1}, 2}, {{2, 2}, 0}, {{2, 0}, 1}, {{3, 1}, 0}};
    return all;
}
const std::vector<Standing>& ends_there() {
    static const std::vector<Standing> all = {{{4, 1}, 1}, {{4, 1}, 9}, {{5, 3}, 2}, {{1, 0}, 3}, {{1, 0}, 12}};
    return all;
}
const std::vector<Standing>& passed_before() {
    static const std::vector<Standing> all = {{{1, 1}, 1}, {{2, 1}, 4}, {{2, 4}, 1}, {{3, 1}, 3}, {{2, 0}, 7}};
    return all;
}
const std::vector<Standing>& never_passed() {
    static const std::vector<Standing> all = {{{0, 0}, 0}, {{3, 3}, 2}, {{0, 0}, 12}, {{5, 4}, 20}};
    return all;
}
void expect_stay(const std::vector<Standing>& all, bool right, const std::string& why) {
    auto word = [](bool yes) { return yes ? "can stay" : "cannot stay"; };
    for (const Standing& s : all) {
        const bool yours = exercise::can_stay(reserved, s.at, s.step);
        expect(yours == right, all_plans() + "who comes to " + said(s.at) + " in step " + std::to_string(s.step) +
                                   "\n    yours  " + word(yours) + "\n    right  " + word(right) + "\n" + why);
    }
}

} // namespace

TEST_CASE("where somebody is in a step of its plan", "[task-1][on-the-way]") {
    for (std::size_t step = 0; step < b.size(); ++step)
        expect(exercise::place_at(b, step) == b[step], "the plan is " + said(b) + "; step " + std::to_string(step) +
                                                           "\n    yours  " + said(exercise::place_at(b, step)) +
                                                           "\n    right  " + said(b[step]) +
                                                           "\nThe k-th place is that of step k, counted from 0.");
}

TEST_CASE("who has arrived stays where it is", "[task-1][arrived]") {
    for (const Plan& plan : reserved)
        for (const std::size_t step : {plan.size(), plan.size() + 1, plan.size() + 9})
            expect(exercise::place_at(plan, step) == plan.back(),
                   "the plan is " + said(plan) + "; step " + std::to_string(step) + "\n    yours  " +
                       said(exercise::place_at(plan, step)) + "\n    right  " + said(plan.back()) +
                       "\nBehind the end of its plan it stays, and is in the way of others.");
}

TEST_CASE("a tile that somebody has in the next step is not free", "[task-2][occupied]") {
    expect_free(occupied(), false, "Somebody is there when you come.");
    expect_free(occupied_later(), false, "Its plan is at an end, and it stands there still.");
}

TEST_CASE("two cannot change places", "[task-2][swap]") {
    expect_free(swapped(), false, "It comes from where you go, and goes to where you are: you would meet half-way.");
}

TEST_CASE("a tile that somebody leaves for another one is free", "[task-2][follow]") {
    expect_free(followed(), true,
                "Whoever is there now is gone in the next step, and does not come to where you were.");
    expect_free(nobody_near(), true, "Nobody is near.");
}

TEST_CASE("to wait is to be on the same tile in the next step", "[task-2][wait]") {
    expect_free(waiting_free(), true, "Nobody comes to it.");
    expect_free(waiting_taken(), false, "Somebody comes to the tile on which you would wait.");
}

TEST_CASE("in the open five edges lead on, and the fifth is to wait", "[task-3][open]") {
    expect_places(in_the_open(), "East, south, west, north, and to stay where you are.");
}

TEST_CASE("no edge leads into a wall or out of the room", "[task-3][walls]") {
    expect_places(at_the_walls(), "A tile that is a wall, or outside of the room, is none.");
}

TEST_CASE("no edge leads to where somebody comes", "[task-3][crowd]") {
    expect_places(crowded(), "Each of the five is asked whether it is free in the next step.");
}

TEST_CASE("nobody can stay where another comes later", "[task-4][later]") {
    expect_stay(passed_later(), false, "The goal is free now, but somebody has reserved it for a later step.");
}

TEST_CASE("nobody can stay where another stays", "[task-4][taken]") {
    expect_stay(ends_there(), false, "A plan ends there, so that its owner is there for ever.");
}

TEST_CASE("what has passed the goal before does not matter", "[task-4][before]") {
    expect_stay(passed_before(), true, "Whoever was there is gone, and does not come back.");
    expect_stay(never_passed(), true, "Nobody comes there at all.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    const auto place = [&](Place p) { numbers.push_back(10 + p.x), numbers.push_back(20 + p.y); };
    if (task == 1)
        for (const Plan& plan : reserved)
            for (std::size_t step = 0; step < 9; ++step) place(exercise::place_at(plan, step));
    if (task == 2)
        for (const List list : {occupied, occupied_later, swapped, followed, nobody_near, waiting_free, waiting_taken})
            for (const Asked& q : list()) numbers.push_back(exercise::is_free(reserved, q.from, q.to, q.step));
    if (task == 3)
        for (const auto list : {in_the_open, at_the_walls, crowded})
            for (const Standing& s : list()) {
                for (const Place p : sorted(exercise::next_places(room, reserved, s.at, s.step))) place(p);
                numbers.push_back(-1);
            }
    if (task == 4)
        for (const auto list : {passed_later, ends_there, passed_before, never_passed})
            for (const Standing& s : list()) numbers.push_back(exercise::can_stay(reserved, s.at, s.step));
    return numbers;
}
