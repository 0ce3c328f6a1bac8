// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on overlapping boxes (notes 2.1.1, bounding box test).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <set>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Box;

struct Stretches {
    double low_a, high_a, low_b, high_b;
    bool right;
    bool overlap() const { return exercise::overlap(low_a * metre, high_a * metre, low_b * metre, high_b * metre); }
    Stretches exchanged() const { return {low_b, high_b, low_a, high_a, right}; }
};
const std::vector<Stretches> apart{
    {0, 1, 2, 3, false}, {2, 3, 0, 1, false}, {-5, -4, 4, 5, false}, {7, 9, -1, 6.5, false}};
const std::vector<Stretches> beside{{0, 2, 1, 3, true}, {1, 3, 0, 2, true}, {-2, 0.5, 0.25, 9, true}};
const std::vector<Stretches> around{{1, 2, 0, 5, true}, {0, 5, 1, 2, true}, {-1, 1, -3, 3, true}};
const std::vector<Stretches> shared{{0, 1, 1, 2, true}, {-3, -2, -4, -3, true}, {0.5, 0.5, 0.5, 0.5, true}};

void expect_all(const std::vector<Stretches>& all, const char* why) {
    for (const Stretches& s : all) {
        std::ostringstream text;
        text << "from " << s.low_a << " m to " << s.high_a << " m, and from " << s.low_b << " m to " << s.high_b
             << " m: do they overlap?\n    yours  " << (s.right ? "no" : "yes") << "\n    right  "
             << (s.right ? "yes" : "no") << '\n'
             << why;
        expect(s.overlap() == s.right, text.str());
    }
}

Box box(double x, double y, double z, double wide, double high, double deep) {
    return {metres(x, y, z), metres(x + wide, y + high, z + deep)};
}
std::string said(const Box& b) {
    std::ostringstream text;
    text << "the box from " << b.lower << " to " << b.upper;
    return text.str();
}
void expect_touch(const Box& a, const Box& b, bool right, const char* why) {
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
        expect(exercise::touch(one, other) == right, said(one) + " and " + said(other) +
                                                         (right ? " touch" : " do not touch") +
                                                         "; yours says otherwise.\n" + why);
}

/// A ladder of boxes of which some touch, and some far apart in the list.
std::vector<Box> some_boxes() {
    std::vector<Box> boxes;
    for (int i = 0; i < 9; ++i) boxes.push_back(box(i % 3 * 0.75, i / 3 * 0.9375, 0.25 * i, 1, 1, 1));
    boxes.push_back(box(0.25, 0.5, 0.5, 3, 3, 3)); // the last, and it meets the first
    return boxes;
}
std::vector<exercise::Pair> right_pairs(const std::vector<Box>& boxes) {
    std::vector<exercise::Pair> pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if ((boxes[i].lower.value().array() <= boxes[j].upper.value().array()).all() &&
                (boxes[j].lower.value().array() <= boxes[i].upper.value().array()).all())
                pairs.emplace_back(i, j);
    return pairs;
}

} // namespace

TEST_CASE("stretches with a gap between them do not overlap", "[task-1][apart]") {
    expect_all(apart, "There is a gap between them, on whichever side.");
}

TEST_CASE("one that lies around the other overlaps it", "[task-1][around]") {
    expect_all(around, "The one holds all of the other: no end of the outer one need be inside.");
}

TEST_CASE("stretches that share an end have that point in common", "[task-1][shared-end]") {
    expect_all(shared, "Their ends belong to them, so one point is in both.");
}

TEST_CASE("which of the two comes first does not matter", "[task-1][either-way]") {
    for (const auto* all : {&apart, &beside, &around})
        for (const Stretches& s : *all) {
            std::ostringstream text;
            text << s.low_a << " m to " << s.high_a << " m and " << s.low_b << " m to " << s.high_b
                 << " m: yours says one thing, and the other when they are exchanged";
            expect(s.overlap() == s.exchanged().overlap(), text.str());
        }
}

TEST_CASE("apart on one axis is apart", "[task-2][one-axis-apart]") {
    for (int axis = 0; axis < 3; ++axis) {
        Vector<double, 3> away = Vector<double, 3>::Constant(0.25);
        away[axis] = 3;
        expect_touch(box(0, 0, 0, 1, 1, 1), box(away[0], away[1], away[2], 1, 1, 1), false,
                     "On one axis there is a gap, and whatever the others say, nothing can touch across it.");
    }
    expect_touch(box(0, 0, 0, 1, 1, 1), box(0.5, 0.5, 0.5, 1, 1, 1), true, "On every axis they overlap.");
}

TEST_CASE("beams that cross touch", "[task-2][crossing]") {
    expect_touch(box(-5, 0, 0, 10, 1, 1), box(0, -5, 0.25, 1, 10, 0.5), true,
                 "They go through each other, though no corner of one lies in the other.");
    expect_touch(box(0, 0, 0, 1, 1, 1), box(-2, 0.25, 0.25, 6, 0.5, 0.5), true,
                 "A bar goes through a cube; no corner of one lies in the other.");
}

TEST_CASE("no pair comes twice, and nobody meets himself", "[task-3][each-once]") {
    std::set<exercise::Pair> told;
    for (const auto& [i, j] : exercise::touching_pairs(some_boxes())) {
        std::ostringstream text;
        text << "yours names the pair (" << i << ", " << j << ")";
        expect(i < j, text.str() + ": the first index is the smaller, and no box is paired with itself.");
        expect(told.insert({i, j}).second, text.str() + " two times.");
    }
}

TEST_CASE("every pair that touches is found", "[task-3][all-found]") {
    const auto boxes = some_boxes();
    const auto yours = exercise::touching_pairs(boxes);
    for (const auto& pair : right_pairs(boxes)) {
        std::ostringstream text;
        text << "boxes " << pair.first << " and " << pair.second << " of " << boxes.size()
             << " touch, and yours does not name them.\nThe order of the list says nothing about where they are.";
        expect(std::find(yours.begin(), yours.end(), pair) != yours.end(), text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto* all : {&apart, &beside, &around, &shared})
            for (const Stretches& s : *all) numbers.push_back(s.overlap()), numbers.push_back(s.exchanged().overlap());
    else if (task == 2)
        for (const Box& a : {box(0, 0, 0, 1, 1, 1), box(-5, 0, 0, 10, 1, 1), box(0, -5, 0.25, 1, 10, 0.5),
                             box(0.25, 0.25, 3, 1, 1, 1), box(3, 0.25, 0.25, 1, 1, 1)})
            for (const Box& b : {box(0.5, 0.5, 0.5, 1, 1, 1), box(0, -5, 0.25, 1, 10, 0.5),
                                 box(-2, 0.25, 0.25, 6, 0.5, 0.5), box(9, 9, 9, 1, 1, 1)})
                numbers.push_back(exercise::touch(a, b));
    else
        for (const auto& [i, j] : exercise::touching_pairs(some_boxes())) numbers.push_back(double(100 * i + j));
    return numbers;
}
