// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the cells of a grid (notes 2.1.1, world partitioning).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <array>
#include <cstdint>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

const double widths[] = {0.5, 1, 4}; // m; exact in binary, so that walls are exact as well

std::int64_t cell_of(double x, double width) { return exercise::cell_of(x * metre, width * metre); }
exercise::Cells cells_of(double low, double high, double width) {
    return exercise::cells_of(low * metre, high * metre, width * metre);
}

struct Body {
    double low, high; // m
};
/// Two that overlap, with cells of 1 m.
const std::vector<std::array<Body, 2>> overlapping{{{{0.2, 0.6}, {0.5, 0.9}}},      {{{0.2, 1.4}, {0.8, 1.9}}},
                                                   {{{-3.5, 4.5}, {2.25, 2.75}}},   {{{5.25, 9.5}, {-1.5, 6.75}}},
                                                   {{{-2.75, -1.25}, {-1.5, 3.5}}}, {{{0, 20}, {12.5, 13.25}}}};
std::int64_t told_in(const Body& a, const Body& b) {
    return exercise::told_in(a.low * metre, a.high * metre, b.low * metre, b.high * metre, 1.0 * metre);
}

void expect_cell(double x, double width, std::int64_t right, const char* why) {
    std::ostringstream text;
    text << "the cell of " << x << " m, where cells are " << width << " m wide\n    yours  " << cell_of(x, width)
         << "\n    right  " << right << '\n'
         << why;
    expect(cell_of(x, width) == right, text.str());
}
void expect_cells(double low, double high, double width, std::int64_t first, std::int64_t last, const char* why) {
    const auto yours = cells_of(low, high, width);
    std::ostringstream text;
    text << "the cells of a body from " << low << " m to " << high << " m, where cells are " << width
         << " m wide\n    yours  " << yours.first << " to " << yours.last << "\n    right  " << first << " to " << last
         << '\n'
         << why;
    expect(yours.first == first && yours.last == last, text.str());
}

} // namespace

TEST_CASE("below zero cells are as wide as elsewhere", "[task-1][below-zero]") {
    for (const double width : widths) {
        expect_cell(0.25 * width, width, 0, "It lies behind the origin, in the cell that begins there.");
        expect_cell(-0.25 * width, width, -1,
                    "It lies before the origin: cell 0 begins at it, and this is the cell before.");
        expect_cell(-2.75 * width, width, -3, "Rounding down goes to the left on both sides of the origin.");
    }
}

TEST_CASE("each cell holds one width and no more", "[task-1][each-width]") {
    for (const double width : widths)
        for (int cell = -3; cell <= 3; ++cell) {
            const std::int64_t early = cell_of((cell + 0.125) * width, width),
                               late = cell_of((cell + 0.875) * width, width),
                               next = cell_of((cell + 1.125) * width, width);
            std::ostringstream text;
            text << "cells of " << width << " m: yours puts " << (cell + 0.125) * width << " m into cell " << early
                 << ", " << (cell + 0.875) * width << " m into " << late << " and " << (cell + 1.125) * width
                 << " m into " << next << "\nThe first two lie between the same walls, the third behind the next.";
            expect(early == late && next == late + 1, text.str());
        }
}

TEST_CASE("a wall belongs to the cell that begins there", "[task-1][on-a-wall]") {
    for (const double width : widths)
        for (int cell = -3; cell <= 3; ++cell)
            expect_cell(cell * width, width, cell, "A wall must be in one cell, and in the same for all who ask.");
}

TEST_CASE("far out there is a cell for everybody", "[task-1][far-out]") {
    expect_cell(1e6 + 0.0001220703125, 0.00048828125, 2048000000, "The number of a cell may be large.");
    expect_cell(4e6 + 0.0001220703125, 0.00048828125, 8192000000,
                "The number of a cell may be larger than 2^31: it takes a std::int64_t all the way.");
    expect_cell(-4e6 - 0.0001220703125, 0.00048828125, -8192000001, "The number of a cell may be smaller than -2^31.");
}

TEST_CASE("a body is in the cells of both of its ends", "[task-2][both-ends]") {
    for (const double width : widths) {
        expect_cells(0.25 * width, 0.5 * width, width, 0, 0, "It lies between two walls, in one cell.");
        expect_cells(0.75 * width, 1.25 * width, width, 0, 1,
                     "It lies over a wall, and is in the cells on both sides of it.");
        expect_cells(-0.25 * width, 0.125 * width, width, -1, 0,
                     "It lies over the origin, where there is a wall as well.");
    }
}

TEST_CASE("a long body is in all the cells between", "[task-2][long]") {
    for (const double width : widths) {
        expect_cells(-2.5 * width, 3.5 * width, width, -3, 3,
                     "Cells -3 and 3 hold its ends, and it goes through all between them.");
        expect_cells(10.25 * width, 110.75 * width, width, 10, 110, "A body may be a hundred cells long.");
    }
}

TEST_CASE("a body that ends on a wall touches what begins there", "[task-2][ends-on-a-wall]") {
    for (const double width : widths) {
        expect_cells(0.25 * width, width, width, 0, 1, "Its end belongs to it, and the wall to the cell behind.");
        expect_cells(-1.5 * width, 0, width, -2, 0, "Its end belongs to it, and the origin to cell 0.");
    }
}

TEST_CASE("a pair is told in a cell that both bodies are in", "[task-3][both-are-there]") {
    for (const auto& [a, b] : overlapping) {
        const std::int64_t yours = told_in(a, b);
        const auto in = [&](const Body& body) {
            return yours >= std::int64_t(std::floor(body.low)) && yours <= std::int64_t(std::floor(body.high));
        };
        std::ostringstream text;
        text << "bodies from " << a.low << " m to " << a.high << " m and from " << b.low << " m to " << b.high
             << " m, cells of 1 m: yours tells them in cell " << yours
             << "\nOne of them is not there. Take a point that both have in common.";
        expect(in(a) && in(b), text.str());
    }
}

TEST_CASE("and in the same when they are exchanged", "[task-3][exchanged]") {
    for (const auto& [a, b] : overlapping) {
        std::ostringstream text;
        text << "bodies from " << a.low << " m to " << a.high << " m and from " << b.low << " m to " << b.high
             << " m, cells of 1 m: yours tells them in cell " << told_in(a, b) << ", and in cell " << told_in(b, a)
             << " when they are exchanged.\nIn two cells a pair is told two times.";
        expect(told_in(a, b) == told_in(b, a), text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const double width : widths)
            for (const double x : {-3.0, -2.75, -0.25, 0.0, 0.25, 0.875, 1.0, 2.5})
                numbers.push_back(double(cell_of(x * width, width)));
        numbers.push_back(double(cell_of(4e6, 0.00048828125)));
    } else if (task == 2) {
        for (const double width : widths)
            for (const Body& body :
                 {Body{0.25, 0.5}, {0.75, 1.25}, {-0.25, 0.125}, {-2.5, 3.5}, {0.25, 1}, {10.25, 110.75}, {-1.5, 0}}) {
                const auto cells = cells_of(body.low * width, body.high * width, width);
                numbers.push_back(double(cells.first)), numbers.push_back(double(cells.last));
            }
    } else
        for (const auto& [a, b] : overlapping)
            numbers.push_back(double(told_in(a, b))), numbers.push_back(double(told_in(b, a)));
    return numbers;
}
