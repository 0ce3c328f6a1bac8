// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the path from the parents (notes 6.1).

#include "tools/exercises/expect.hpp"

#include <cstdint>

using namespace ansatz::workbook;
using exercise::nobody;

namespace {

using Way = std::vector<std::size_t>;

/// What a search left behind.
struct Tree {
    Way parents;
    std::size_t start, goal;
};
std::string said(const Way& way) {
    std::string text;
    for (const std::size_t v : way)
        text += (text.empty() ? "" : " ") + (v == nobody ? std::string("nobody") : std::to_string(v));
    return text.empty() ? "empty" : text;
}
std::string said(const Tree& t) {
    return "the parents of nodes 0, 1, ... are " + said(t.parents) + "; the goal is " + std::to_string(t.goal);
}

/// By hand, and thirty at random, in which node 0 is not always the start.
const std::vector<Tree>& reached() {
    static const std::vector<Tree> all = [] {
        std::vector<Tree> trees{
            {{0, 0, 1, 2}, 0, 3}, {{3, 0, 0, 3, 2}, 3, 4}, {{1, 1, nobody, 0, 3}, 1, 4}, {{0, 0, 0, 0}, 0, 2}};
        std::uint32_t seed = 7;
        auto random = [&](std::size_t below) {
            return std::size_t((seed = seed * 1664525u + 1013904223u) >> 8) % below;
        };
        for (int n = 0; n < 30; ++n) {
            const std::size_t size = 4 + random(12);
            Way order(size), parents(size);
            for (std::size_t i = 0; i < size; ++i) order[i] = i;
            for (std::size_t i = size; i-- > 1;) std::swap(order[i], order[random(i + 1)]);
            parents[order[0]] = order[0];
            for (std::size_t i = 1; i < size; ++i) parents[order[i]] = order[random(i)];
            trees.push_back({parents, order[0], order[1 + random(size - 1)]});
        }
        return trees;
    }();
    return all;
}
const std::vector<Tree>& unreached() {
    static const std::vector<Tree> all = {{{0, 0, nobody, 1}, 0, 2}, {{nobody, 1, 1}, 1, 0}};
    return all;
}
const std::vector<Tree>& at_the_start() {
    static const std::vector<Tree> all = {{{0, 0, 1}, 0, 0}, {{2, nobody, 2}, 2, 2}, {{0}, 0, 0}};
    return all;
}
void expect_way(const Tree& t, const Way& yours, const Way& right, const std::string& why) {
    expect(yours == right, said(t) + "\n    yours  " + said(yours) + "\n    right  " + said(right) + "\n" + why);
}
/// From the goal to the start, by counting instead of comparing: no way is longer than there are nodes.
Way right_way_back(const Tree& t) {
    Way way{t.goal};
    for (std::size_t i = 0; i < t.parents.size() && way.back() != t.start; ++i) way.push_back(t.parents[way.back()]);
    return way;
}
Way turned(Way way) {
    std::reverse(way.begin(), way.end());
    return way;
}

} // namespace

TEST_CASE("back from the goal, with goal and start", "[task-1][back]") {
    for (const auto& t : reached())
        expect_way(t, exercise::way_back(t.parents, t.goal), right_way_back(t),
                   "Every node of the way, the goal first and the start last, each followed by its parent.");
}

TEST_CASE("no way to a node that the search has not come to", "[task-1][unreached]") {
    for (const auto& t : unreached())
        expect_way(t, exercise::way_back(t.parents, t.goal), {},
                   "A goal without a parent was never put on a list: there is no way to it.");
}

TEST_CASE("the start is the goal: a way of one node", "[task-1][at-the-start]") {
    for (const auto& t : at_the_start())
        expect_way(t, exercise::way_back(t.parents, t.goal), {t.goal},
                   "Whoever is there already has a way, of no step.");
}

TEST_CASE("the path leads from the start to the goal", "[task-2][forwards]") {
    for (const auto& t : reached())
        expect_way(t, exercise::path(t.parents, t.goal), turned(right_way_back(t)),
                   "The start first, the goal last, each behind its parent.");
}

TEST_CASE("each node of the path is the child of the one before it", "[task-2][steps]") {
    for (const auto& t : reached()) {
        const Way yours = exercise::path(t.parents, t.goal);
        bool steps = !yours.empty();
        for (std::size_t i = 1; i < yours.size(); ++i) steps = steps && t.parents[yours[i]] == yours[i - 1];
        expect(steps, said(t) + "\n    yours  " + said(yours) + "\nThe parent of each node stands before it.");
    }
}

TEST_CASE("no path to a node that the search has not come to", "[task-2][no-path]") {
    for (const auto& t : unreached())
        expect_way(t, exercise::path(t.parents, t.goal), {},
                   "Where there is no way back there is none there either, and nothing to turn round: ask for that "
                   "before a first or last node is used.");
}

TEST_CASE("the start is the goal: a path of one node", "[task-2][one-node]") {
    for (const auto& t : at_the_start())
        expect_way(t, exercise::path(t.parents, t.goal), {t.goal},
                   "It is the start and the goal, and stands there once.");
}

/// Of task 2 the way back too: a path is wrong by itself, or because the way back is.
std::vector<double> probe(int task) {
    std::vector<double> numbers;
    auto add = [&](const Way& way) {
        for (const std::size_t v : way) numbers.push_back(double(v));
        numbers.push_back(-1);
    };
    for (const auto* all : {&reached(), &unreached(), &at_the_start()})
        for (const auto& t : *all) {
            add(exercise::way_back(t.parents, t.goal));
            if (task == 2) add(exercise::path(t.parents, t.goal));
        }
    return numbers;
}
