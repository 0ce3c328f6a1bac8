// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on when to search again (notes 6.3.5).

#include "tools/exercises/expect.hpp"

#include <limits>

using namespace ansatz::workbook;
using exercise::Event;

namespace {

constexpr double blocked = std::numeric_limits<double>::infinity();
using Path = std::vector<std::size_t>;
const Path path{4, 7, 2, 9, 5, 1};

/// An event, and where on the path the walker stands.
struct Asked {
    std::size_t at;
    Event event;
};
std::string said(double cost) {
    if (cost == blocked) return "blocked";
    std::ostringstream text;
    text << cost;
    return text.str();
}
std::string said(const Asked& a) {
    std::string text = "the path is";
    for (const std::size_t v : path) text += ' ' + std::to_string(v);
    return text + "; the walker stands at " + std::to_string(path[a.at]) + "; the edge from " +
           std::to_string(a.event.from) + " to " + std::to_string(a.event.to) + " was " + said(a.event.before) +
           " and is " + said(a.event.after);
}
void expect_answer(const std::string& name, const Asked& a, bool yours, bool right, const std::string& why) {
    auto word = [](bool yes) { return yes ? "search" : "walk on"; };
    expect(yours == right,
           said(a) + "\n    yours, " + name + "  " + word(yours) + "\n    right  " + word(right) + "\n" + why);
}

const std::vector<Asked>& dearer_ahead() {
    static const std::vector<Asked> all = {{0, {4, 7, 1, 3}},       {0, {5, 1, 1, blocked}}, {2, {2, 9, 1, 1.5}},
                                           {2, {9, 5, 1, blocked}}, {4, {5, 1, 2, 3}},       {0, {2, 9, 1, 2}},
                                           {1, {7, 2, 1, blocked}}};
    return all;
}
const std::vector<Asked>& dearer_behind() {
    static const std::vector<Asked> all = {
        {1, {4, 7, 1, 3}}, {3, {2, 9, 1, blocked}}, {5, {5, 1, 1, blocked}}, {4, {7, 2, 1, 2}}};
    return all;
}
const std::vector<Asked>& dearer_elsewhere() {
    static const std::vector<Asked> all = {{0, {3, 6, 1, blocked}}, {2, {7, 3, 1, 4}},       {0, {8, 1, 1, blocked}},
                                           {1, {9, 3, 2, blocked}}, {0, {2, 5, 3, blocked}}, {1, {7, 1, 5, 6}}};
    return all;
}
/// Both ends are on the path, but nobody walks there, or not in this direction.
const std::vector<Asked>& other_direction() {
    static const std::vector<Asked> all = {{0, {9, 2, 1, blocked}}, {1, {1, 5, 1, 3}}, {0, {2, 7, 2, blocked}}};
    return all;
}
const std::vector<Asked>& cheaper_ahead() {
    static const std::vector<Asked> all = {{0, {7, 2, 2, 1}}, {2, {5, 1, 3, 0.5}}};
    return all;
}
const std::vector<Asked>& cheaper_elsewhere() {
    static const std::vector<Asked> all = {{0, {3, 6, 4, 1}}, {2, {7, 3, blocked, 1}}, {0, {4, 1, blocked, 2}}};
    return all;
}
const std::vector<Asked>& cheaper_behind() {
    static const std::vector<Asked> all = {{2, {4, 7, 3, 1}}, {3, {2, 9, 2, 1}}};
    return all;
}
const std::vector<Asked>& unchanged() {
    static const std::vector<Asked> all = {{0, {4, 7, 1, 1}}, {2, {9, 5, 1, 1}}, {0, {3, 6, blocked, blocked}}};
    return all;
}
using List = const std::vector<Asked>& (*)();
void expect_answers(bool must, std::initializer_list<List> lists, bool right, const std::string& why) {
    for (const List list : lists)
        for (const auto& a : list()) {
            if (must) expect_answer("must_search", a, exercise::must_search(path, a.at, a.event), right, why);
            else expect_answer("should_search", a, exercise::should_search(path, a.at, a.event), right, why);
        }
}

} // namespace

TEST_CASE("an edge ahead became dearer: search", "[task-1][ahead]") {
    expect_answers(true, {dearer_ahead}, true,
                   "The rest of the path costs more than was thought, and another may be better now.");
}

TEST_CASE("an edge behind the walker became dearer: walk on", "[task-1][behind]") {
    expect_answers(true, {dearer_behind}, false, "Nobody walks there any more.");
}

TEST_CASE("an edge elsewhere became dearer: walk on", "[task-1][elsewhere]") {
    expect_answers(true, {dearer_elsewhere}, false,
                   "What became dearer elsewhere makes no other path better. The path goes along an edge where the two "
                   "nodes follow each other.");
}

TEST_CASE("an edge of the path became dearer in the other direction: walk on", "[task-1][direction]") {
    expect_answers(true, {other_direction}, false, "The path leads along this edge the other way.");
}

TEST_CASE("something became cheaper, or nothing changed: the path is still valid", "[task-1][cheaper]") {
    expect_answers(true, {cheaper_ahead, cheaper_elsewhere, cheaper_behind, unchanged}, false,
                   "The rest of the path costs no more than was thought, so nobody must search.");
}

TEST_CASE("something became cheaper anywhere: there may be a better path", "[task-2][better]") {
    expect_answers(false, {cheaper_ahead, cheaper_elsewhere, cheaper_behind}, true,
                   "A way through it may be better than the rest of the path. Only a search can tell.");
}

TEST_CASE("the rest of the path became dearer: search by this rule too", "[task-2][touched]") {
    expect_answers(false, {dearer_ahead}, true, "Who must search should search.");
}

TEST_CASE("what became dearer behind or elsewhere makes no path better", "[task-2][no-better]") {
    expect_answers(false, {dearer_behind, dearer_elsewhere, other_direction, unchanged}, false,
                   "Nothing became cheaper, and the rest of the path is what it was.");
}

/// Of task 2 both answers: should_search is wrong by itself, or because must_search is.
std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for (const List list : {dearer_ahead, dearer_behind, dearer_elsewhere, other_direction, cheaper_ahead,
                            cheaper_elsewhere, cheaper_behind, unchanged})
        for (const auto& a : list()) {
            numbers.push_back(exercise::must_search(path, a.at, a.event));
            if (task == 2) numbers.push_back(exercise::should_search(path, a.at, a.event));
        }
    return numbers;
}
