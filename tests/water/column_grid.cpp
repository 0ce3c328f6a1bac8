// SPDX-License-Identifier: BSL-1.0
// Where columns stand: footprints, volume, and which column is found.

#include <ansatz/water/column_grid.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

TEST_CASE("a column of 3 m over 1 m by 2 m holds 6 m^3 (hard case W13)", "[water]") {
    const ColumnGrid grid(3, 3, 1.0 * metre, 2.0 * metre);
    CHECK(grid.footprint(1, 1) == 2.0 * square_metre);
    CHECK(grid.area() == 18.0 * square_metre);
    std::vector<double> heights(9);
    heights[grid.index(1, 2)] = 3;
    CHECK(grid.volume(std::span<const double>(heights)) == 6.0 * cubic_metre);
}

TEST_CASE("volume is the sum over unequal footprints, in double for float", "[water]") {
    const auto grid = unequal(7, 5);
    CHECK_FALSE(grid.uniform());
    std::vector<float> heights;
    double expected = 0, area = 0;
    for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t i = 0; i < 7; ++i) {
            heights.push_back(1 + 0.1F * float(i * j));
            expected += double(heights.back()) * grid.footprint(i, j).value();
            area += grid.footprint(i, j).value();
        }
    const auto volume = grid.volume(std::span<const float>(heights));
    STATIC_REQUIRE(std::is_same_v<decltype(volume.value()), const double&>);
    CHECK(volume.value() == Approx(expected).epsilon(1e-14));
    CHECK(grid.area().value() == Approx(area).epsilon(1e-14));
}

TEST_CASE("the column that is found contains the place, wherever the grid stands", "[water]") {
    const auto grid = unequal(8, 6).at(-3.0 * metre, 10.0 * metre);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(grid.begin_x().value(), grid.end_x().value()),
        z(grid.begin_z().value(), grid.end_z().value());
    for (int n = 0; n < 1000; ++n) {
        const auto at_x = x(random) * metre, at_z = z(random) * metre;
        const std::size_t column = grid.column(at_x, at_z), i = column % 8, j = column / 8;
        CHECK(abs(at_x - grid.centre_x(i)) <= 0.5 * grid.width_x(i) * (1 + 1e-12));
        CHECK(abs(at_z - grid.centre_z(j)) <= 0.5 * grid.width_z(j) * (1 + 1e-12));
    }
    CHECK(grid.column(grid.begin_x(), grid.begin_z()) == 0);
    CHECK(grid.column(grid.end_x(), grid.end_z()) == grid.size() - 1);
    CHECK(grid == unequal(8, 6).at(-3.0 * metre, 10.0 * metre));
    CHECK_FALSE(grid == unequal(8, 6));
}

TEST_CASE("a grid refuses what is no grid, and names it", "[water]") {
    CHECK(refusal([] { ColumnGrid(2, 3, 1.0 * metre); }) ==
          "ColumnGrid: the number of columns along x is 2; a grid has at least 3 columns along x and along z, or 1 "
          "along z: a channel");
    CHECK(refusal([] { ColumnGrid(3, 2, 1.0 * metre); }) ==
          "ColumnGrid: the number of columns along z is 2; a grid has at least 3 columns along x and along z, or 1 "
          "along z: a channel");
    CHECK(refusal([] { ColumnGrid(1, 1, 1.0 * metre); }).find("along x is 1") != std::string::npos);
    CHECK(refusal([] { ColumnGrid(3, 3, -1.0 * metre); }) ==
          "ColumnGrid: the width of column 0 along x is -1 m; it must be finite and greater than zero");
    CHECK(refusal([] {
              auto bad = widths(4, 0);
              bad[2] = not_a_number * metre;
              ColumnGrid(widths(4, 0), bad);
          }) == "ColumnGrid: the width of column 2 along z is nan m; it must be finite and greater than zero");
    const ColumnGrid grid(3, 1, 1.0 * metre, 2.0 * metre);
    CHECK(sentence<std::out_of_range>([&] { (void)grid.column(3.5 * metre, 1.0 * metre); }) ==
          "ColumnGrid::column: (x, z) is (3.5 m, 1 m); the columns cover x from 0 m to 3 m and z from 0 m to 2 m");
    CHECK_FALSE(grid.covers(not_a_number * metre, 1.0 * metre));
    CHECK(sentence<std::out_of_range>([&] { (void)grid.footprint(0, 1); }) ==
          "ColumnGrid: a column has number 1; they are numbered 0 to 0");
    const std::vector<double> four(4);
    CHECK(refusal([&] { (void)grid.volume(std::span<const double>(four)); }) ==
          "ColumnGrid::volume: the number of heights is 4; there is one for each of the 3 columns");
}

TEST_CASE("faces that were read from a file are those that the widths make", "[water]") {
    const auto read = [](std::size_t face, double at) {
        auto grid = ColumnGrid(widths(5, 0.3), widths(3, 0.3)).at(-7.0 * metre, 1e6 * metre);
        ColumnGrid::fields(grid, [&](std::string_view name, auto& numbers) {
            if (name == "faces_x") numbers[face] = at;
        });
        return refusal([&] { grid.check(); });
    };
    const auto grid = ColumnGrid(widths(5, 0.3), widths(3, 0.3)).at(-7.0 * metre, 1e6 * metre);
    CHECK_NOTHROW(grid.check());
    CHECK_NOTHROW(grid.at(1e12 * metre, -3e-9 * metre).check());
    CHECK(grid.at(1e12 * metre, -3e-9 * metre).at(-7.0 * metre, 1e6 * metre) == grid);
    CHECK(read(0, -7) == "nothing");
    CHECK(read(2, -6).find("ColumnGrid: face 2 along x is -6 m; it must be finite, and by the widths before it at") ==
          0);
    CHECK(read(5, 1e300).find("face 5 along x is 1e+300 m") != std::string::npos);
    CHECK(read(0, not_a_number).find("face 0 along x is nan m") != std::string::npos);
    CHECK(read(1, -HUGE_VAL).find("face 1 along x is -inf m") != std::string::npos);
}

TEST_CASE("far away a grid keeps its area, and is refused where its columns have no width", "[water]") {
    const auto grid = unequal(8, 6);
    for (const double x : {1e6, 1e12, -1e13}) CHECK(grid.at(x * metre, -x * metre).area() == grid.area());
    CHECK(refusal([&] {
              (void)grid.at(0.0 * metre, 1e17 * metre);
          }).find("ColumnGrid::at: z is 1e+17 m; a column of ") == 0);
    CHECK(refusal([&] { (void)ColumnGrid(3, 3, 0.5 * metre).at(-1e17 * metre, 0.0 * metre); }) ==
          "ColumnGrid::at: x is -1e+17 m; a column of 0.5 m is lost in rounding there");
}
