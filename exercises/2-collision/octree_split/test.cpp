// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the division of an octree's cell (notes 2.1.1, binary search partitioning).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <bitset>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Box;
using exercise::Point;

/// Centres of cubes: of the first, and of those that come out of it.
const std::vector<Point>& centres() {
    static const std::vector<Point> all{metres(0, 0, 0), metres(4, -4, 4), metres(-2, 6, -6)};
    return all;
}
Point beside(const Point& centre, double x, double y, double z) { return centre + metres(x, y, z); }

void expect_part(const Point& point, const Point& centre, unsigned right, const char* why) {
    const unsigned yours = exercise::part_of(point, centre);
    std::ostringstream text;
    text << "the part of " << point << " in a cube whose centre is " << centre << "\n    yours  " << yours
         << " (bits zyx " << std::bitset<3>(yours) << ")\n    right  " << right << " (bits zyx "
         << std::bitset<3>(right) << ")\n"
         << why;
    expect(yours == right, text.str());
}
void expect_parts(const Box& box, const Point& centre, unsigned right, const char* why) {
    const unsigned yours = exercise::parts_of(box, centre);
    std::ostringstream text;
    text << "the children that the box from " << box.lower << " to " << box.upper
         << " reaches into, in a cube whose centre is " << centre << "\n    yours  " << std::bitset<8>(yours)
         << " (child 7 first)\n    right  " << std::bitset<8>(right) << '\n'
         << why;
    expect(yours == right, text.str());
}
Box box(const Point& centre, double x, double y, double z, double wide, double high, double deep) {
    return {beside(centre, x, y, z), beside(centre, x + wide, y + high, z + deep)};
}

void expect_division(int count, int threshold, int depth, int deepest, bool right, const char* why) {
    std::ostringstream text;
    text << "is a cell divided that holds " << count << " bodies, where the threshold is " << threshold << ", at depth "
         << depth << " of " << deepest << "?\n    yours  " << (right ? "no" : "yes") << "\n    right  "
         << (right ? "yes" : "no") << '\n'
         << why;
    expect(exercise::divide(count, threshold, depth, deepest) == right, text.str());
}

} // namespace

TEST_CASE("each of the eight children has its number", "[task-1][eight-parts]") {
    for (const Point& centre : centres())
        for (unsigned part = 0; part < 8; ++part)
            expect_part(beside(centre, part & 1 ? 1 : -1, part & 2 ? 1 : -1, part & 4 ? 1 : -1), centre, part,
                        "Bit 0 is x, bit 1 is y, bit 2 is z; 1 is the upper side.");
}

TEST_CASE("a plane belongs to the upper side", "[task-1][on-a-plane]") {
    for (const Point& centre : centres()) {
        expect_part(centre, centre, 7, "The centre is on all three planes.");
        expect_part(beside(centre, 0, -1, -1), centre, 1, "It is on the plane of x.");
        expect_part(beside(centre, -1, 0, 1), centre, 6, "It is on the plane of y.");
    }
}

TEST_CASE("a box is in the children on both sides of a plane that it lies over", "[task-2][straddles]") {
    for (const Point& centre : centres()) {
        expect_parts(box(centre, -2, -2, -2, 1, 1, 1), centre, 1u << 0, "It lies in one part.");
        expect_parts(box(centre, 1, 1, -2, 1, 1, 1), centre, 1u << 3, "It lies in one part.");
        expect_parts(box(centre, -0.25, 1, 1, 1, 1, 1), centre, (1u << 6) | (1u << 7),
                     "It lies over the plane of x, and is in the children on both sides.");
        expect_parts(box(centre, -2, -2, -0.75, 1, 1, 1), centre, (1u << 0) | (1u << 4),
                     "It lies over the plane of z, and is in the children on both sides.");
    }
}

TEST_CASE("over two planes it is in four children", "[task-2][over-two]") {
    for (const Point& centre : centres())
        for (const double z : {-2.0, 1.0}) {
            const unsigned parts = exercise::parts_of(box(centre, -0.5, -0.25, z, 1, 1, 1), centre),
                           right = z < 0 ? 0x0Fu : 0xF0u;
            std::ostringstream text;
            text << "a box that lies over the planes of x and y of the centre " << centre << ": yours hands it to "
                 << std::bitset<8>(parts) << " (child 7 first)\n"
                 << "It does not reach over the plane of z, so that the four children on the other side of it have "
                    "nothing to do with it.";
            expect((parts & ~right) == 0, text.str());
        }
}

TEST_CASE("no child that a box reaches into is left out", "[task-2][over-many]") {
    for (const Point& centre : centres())
        for (const auto& [x, y, z, right] : {std::tuple(-0.5, -0.25, 1.0, 0xF0u), std::tuple(-2.0, -0.5, -0.5, 0x55u),
                                             std::tuple(-0.5, -0.5, -0.5, 0xFFu)}) {
            const unsigned parts = exercise::parts_of(box(centre, x, y, z, 1, 1, 1), centre);
            if (std::bitset<8>(right).count() == 8 ||
                std::bitset<8>(parts).count() > 1) { // one child alone is another mistake
                std::ostringstream text;
                text << "a box of 1 m whose lower corner is beside the centre " << centre << " by " << x << ", " << y
                     << ", " << z << " m: yours hands it to " << std::bitset<8>(parts)
                     << " (child 7 first), and it reaches into " << std::bitset<8>(right)
                     << "\nIn each axis by itself it is on one side or on both; every combination of these is a child.";
                expect((right & ~parts) == 0 || std::bitset<8>(parts).count() == 1, text.str());
            }
        }
}

TEST_CASE("a box that ends on a plane touches what begins there", "[task-2][ends-on-a-plane]") {
    for (const Point& centre : centres()) {
        const unsigned parts = exercise::parts_of(box(centre, -1, -3, -2.5, 1, 5, 1), centre);
        std::ostringstream text;
        text << "a box that ends on the plane of x of the centre " << centre << ": yours hands it to "
             << std::bitset<8>(parts) << " (child 7 first)\n"
             << "Its face belongs to it, and the plane to the upper side, children 1 and 3 here.";
        expect((parts & 0x0Au) != 0, text.str());
    }
}

TEST_CASE("a cell that holds more than the threshold is divided", "[task-3][threshold]") {
    for (const int threshold : {1, 8, 100})
        for (const int depth : {0, 3}) {
            expect_division(threshold + 1, threshold, depth, 10, true,
                            "It holds more than it may, and may be divided.");
            expect_division(threshold, threshold, depth, 10, false, "It holds no more than it may.");
            expect_division(0, threshold, depth, 10, false, "There is nobody in it.");
        }
}

TEST_CASE("and not deeper than it may be", "[task-3][deepest]") {
    for (const int deepest : {0, 1, 12}) {
        expect_division(1000, 8, deepest, deepest, false,
                        "Bodies that lie in one place are never separated: there must be an end to it.");
        if (deepest > 0)
            expect_division(1000, 8, deepest - 1, deepest, true,
                            "Its children are as deep as they may be, and no deeper.");
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const Point& centre : centres())
            for (const auto& [x, y, z] : {std::tuple(1.0, -1.0, -1.0), std::tuple(-1.0, -1.0, 1.0),
                                          std::tuple(0.0, -1.0, 1.0), std::tuple(-1.0, 0.0, 0.0)})
                numbers.push_back(exercise::part_of(beside(centre, x, y, z), centre));
    else if (task == 2)
        for (const Point& centre : centres())
            for (const auto& [x, y, z] :
                 {std::tuple(-2.0, 1.0, 1.0), std::tuple(-0.25, 1.0, -2.0), std::tuple(-0.5, -0.5, 2.0),
                  std::tuple(-0.5, -0.5, -0.75), std::tuple(-1.0, -2.0, 0.5)})
                numbers.push_back(exercise::parts_of(box(centre, x, y, z, 1, 1, 1), centre));
    else
        for (const int count : {0, 7, 8, 9})
            for (const int depth : {0, 4, 5, 6}) numbers.push_back(exercise::divide(count, 8, depth, 5));
    return numbers;
}
