// SPDX-License-Identifier: BSL-1.0
// A map of heights: bilinear exactly, its normal that of the surface, tessellated without a change, and what it
// refuses.

#include <ansatz/water/height_map.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <limits>
#include <random>

using namespace ansatz;
using namespace ansatz::test;
using Catch::Approx;

namespace {
using Length = Quantity<unit::Length>;
double bilinear(double x, double z) { return 1.5 - 0.25 * x + 0.5 * z + 0.125 * x * z; }

template <class Scalar> HeightMap<Scalar> hilly(std::mt19937& random) {
    std::uniform_real_distribution<double> y(-2, 3);
    return HeightMap<Scalar>::of(7, 5, 0.5 * metre, 0.75 * metre,
                                 [&](Length, Length) { return scalar_cast<Scalar>(y(random) * metre); })
        .at(-1.0 * metre, 2.0 * metre);
}
} // namespace

TEST_CASE("a bilinear function of x and z is reproduced everywhere, and so is its normal", "[water]") {
    const auto map = HeightMap<>::of(6, 9, 0.5 * metre, 0.25 * metre,
                                     [](Length x, Length z) { return bilinear(x.value(), z.value()) * metre; });
    std::mt19937 random(1);
    std::uniform_real_distribution<double> along_x(0, 2.5), along_z(0, 2);
    for (int i = 0; i < 1000; ++i) {
        const double x = along_x(random), z = along_z(random);
        CHECK(map.height(x * metre, z * metre).value() == Approx(bilinear(x, z)).margin(1e-14));
        const Vector<double, 3> slope(0.25 - 0.125 * z, 1, -0.5 - 0.125 * x);
        CHECK((map.normal(x * metre, z * metre) - slope.normalized()).norm() < 1e-13);
    }
}

TEMPLATE_TEST_CASE("the map goes through its points, is continuous across their lines and reaches its border",
                   "[water]", float, double) {
    std::mt19937 random(2);
    const auto map = hilly<TestType>(random);
    const double eps = std::numeric_limits<TestType>::epsilon();
    for (std::size_t j = 0; j < map.points_z(); ++j)
        for (std::size_t i = 0; i < map.points_x(); ++i)
            CHECK(map.height(map.x(i), map.z(j)).value() == map(i, j).value());
    for (std::size_t i = 1; i + 1 < map.points_x(); ++i)
        for (const double z : {2.1, 3.3, 4.999}) {
            const auto line = map.x(i), hair = 1e-9 * metre;
            const double before = map.height(line - hair, z * metre).value(),
                         after = map.height(line + hair, z * metre).value();
            CHECK(std::abs(before - after) <= 1e-7 + 8 * eps);
        }
    CHECK(map.covers(-1.0 * metre, 2.0 * metre));
    CHECK(map.covers(2.0 * metre, 5.0 * metre));
    CHECK_FALSE(map.covers(2.0001 * metre, 5.0 * metre));
    CHECK_FALSE(map.covers(std::numeric_limits<double>::quiet_NaN() * metre, 3.0 * metre));
}

TEMPLATE_TEST_CASE("at a point of the map its height is that point's, and its normal that of the cell after it",
                   "[water]", float, double) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> apart(0.01, 3), from(-50, 50), y(-1, 1);
    for (int trial = 0; trial < 100; ++trial) {
        // Most of these distances, and of these places, have no finite binary digits.
        const bool tenths = trial % 2 == 0;
        const auto dx = tenths ? 0.1 * metre : apart(random) * metre, dz = apart(random) * metre;
        const auto map = HeightMap<TestType>::of(90, 4, dx, dz, [&](Length, Length) {
                             return scalar_cast<TestType>(y(random) * metre);
                         }).at(tenths ? 0.0 * metre : from(random) * metre, from(random) * metre);
        for (std::size_t j = 0; j + 1 < map.points_z(); ++j)
            for (std::size_t i = 0; i + 1 < map.points_x(); ++i) {
                CAPTURE(trial, i, j);
                REQUIRE(map.height(map.x(i), map.z(j)).value() == map(i, j).value());
                const double by_x = double(map(i + 1, j).value() - map(i, j).value()) / dx.value(),
                             by_z = double(map(i, j + 1).value() - map(i, j).value()) / dz.value();
                const Vector<double, 3> expected = Vector<double, 3>(-by_x, 1, -by_z).normalized();
                REQUIRE((map.normal(map.x(i), map.z(j)).template cast<double>() - expected).norm() < 1e-5);
            }
        const std::size_t east = map.points_x() - 1, north = map.points_z() - 1;
        REQUIRE(map.height(map.x(east), map.z(north)).value() == map(east, north).value());
    }
}

TEMPLATE_TEST_CASE("the normal is that of the surface: central differences of the height (hard case W11)", "[water]",
                   double) {
    std::mt19937 random(3);
    const auto map = hilly<TestType>(random);
    std::uniform_real_distribution<double> part(0.01, 0.99);
    for (std::size_t j = 0; j + 1 < map.points_z(); ++j)
        for (std::size_t i = 0; i + 1 < map.points_x(); ++i) {
            const auto x = map.x(i) + part(random) * map.dx(), z = map.z(j) + part(random) * map.dz(), e = 1e-5 * metre;
            const double by_x = double((map.height(x + e, z) - map.height(x - e, z)) / (2.0 * e)),
                         by_z = double((map.height(x, z + e) - map.height(x, z - e)) / (2.0 * e));
            const Vector<double, 3> expected = Vector<double, 3>(-by_x, 1, -by_z).normalized();
            CHECK((map.normal(x, z) - expected).norm() < 1e-8);
            CHECK(map.normal(x, z).norm() == Approx(1).epsilon(1e-14));
        }
}

TEMPLATE_TEST_CASE("a tessellated map is the same surface with more points", "[water]", float, double) {
    std::mt19937 random(4);
    const auto map = hilly<TestType>(random);
    const double most = 16 * std::numeric_limits<TestType>::epsilon();
    CHECK(map.tessellated(1) == map);
    for (const std::size_t factor : {2U, 3U, 8U}) {
        const auto fine = map.tessellated(factor);
        REQUIRE(fine.points_x() == 6 * factor + 1);
        REQUIRE(fine.points_z() == 4 * factor + 1);
        for (std::size_t j = 0; j < map.points_z(); ++j)
            for (std::size_t i = 0; i < map.points_x(); ++i)
                CHECK(fine(i * factor, j * factor).value() == map(i, j).value());
        std::uniform_real_distribution<double> x(-1, 2), z(2, 5);
        for (int i = 0; i < 200; ++i) {
            const auto at_x = x(random) * metre, at_z = z(random) * metre;
            CHECK(std::abs(double(fine.height(at_x, at_z).value() - map.height(at_x, at_z).value())) <= 3 * most);
        }
    }
}

TEST_CASE("a map refuses what it cannot hold, and names it", "[water]") {
    HeightMap map(3, 3, 1.0 * metre, 1.0 * metre);
    const auto before = map;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal([] { HeightMap(1, 3, 1.0 * metre, 1.0 * metre); }) ==
          "HeightMap: the number of points along x is 1; a map has at least 2 points along x and along z");
    CHECK(refusal([] { HeightMap(3, 0, 1.0 * metre, 1.0 * metre); }) ==
          "HeightMap: the number of points along z is 0; a map has at least 2 points along x and along z");
    CHECK(refusal([] { HeightMap(3, 3, 0.0 * metre, 1.0 * metre); }) ==
          "HeightMap: dx is 0 m; it must be finite and greater than zero");
    CHECK(refusal([&] { HeightMap(3, 3, 1.0 * metre, nan * metre); }) ==
          "HeightMap: dz is nan m; it must be finite and greater than zero");
    CHECK(refusal([&] { map.set(1, 2, nan * metre); }) ==
          "HeightMap::set: the height of point (1, 2) is nan m; it must be finite");
    CHECK(refusal([&] { (void)map.tessellated(0); }) ==
          "HeightMap::tessellated: factor is 0; each side is divided into 1 or more");
    CHECK(sentence<std::out_of_range>([&] { map.set(3, 0, 1.0 * metre); }) ==
          "HeightMap: a point is (3, 0); the map has 3 x 3 points, counted from 0");
    CHECK(sentence<std::out_of_range>([&] { (void)map.height(2.5 * metre, 0.0 * metre); }) ==
          "HeightMap::height: (x, z) is (2.5 m, 0 m); the map covers x from 0 m to 2 m and z from 0 m to 2 m");
    CHECK(sentence<std::out_of_range>([&] { (void)map.normal(1.0 * metre, -1.0 * metre); }) ==
          "HeightMap::normal: (x, z) is (1 m, -1 m); the map covers x from 0 m to 2 m and z from 0 m to 2 m");
    CHECK(map == before);
}

TEST_CASE("the normal of a cliff is of length 1, however high it is", "[water]") {
    for (const double height : {1.0, 1e100, 1e160, 1e300}) {
        const auto map = HeightMap<>::of(2, 2, 1.0 * metre, 1.0 * metre,
                                         [&](auto x, auto z) { return height * (x.value() - 2 * z.value()) * metre; });
        const auto normal = map.normal(0.5 * metre, 0.5 * metre);
        CHECK(normal.norm() == Approx(1).epsilon(1e-14));
        CHECK(normal[2] == Approx(-2 * normal[0]).epsilon(1e-14));
        CHECK(normal[0] < 0);
    }
}
