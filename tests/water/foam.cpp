// SPDX-License-Identifier: BSL-1.0
// Foam, a number for each column: how it grows and fades, whatever the step, goes with the flow, and follows a hull.

#include <ansatz/water.hpp>
#include <ansatz/water/foam.hpp>
#include <ansatz/world.hpp>

#include "tests/before_allocation.hpp"
#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
std::size_t allocations = 0;
bool count(std::size_t) noexcept {
    ++allocations;
    return true;
}
double covered(const Foam<double>& foam) {
    double sum = 0;
    for (const double f : foam.parts()) sum += f;
    return sum;
}
} // namespace

TEMPLATE_TEST_CASE("on a slope foam settles at its closed form, whatever the step, and fades on level water", "[water]",
                   float, double) {
    // A plane of slope 0.5 along x and 0.4 along z: no column is steeper or flatter, but at the walls.
    Surface<WaterColumns, TestType> steep{WaterColumns{3.0 * mps}, unequal(9, 8), 2.0 * metre}, level = steep;
    set_heights(steep, [](double x, double z) { return 1 + 0.5 * x + 0.4 * z; });
    const FoamLaw law{.steep = 0.4, .grows_in = 0.5 * second, .fades_in = 2.0 * second};
    const double s = std::hypot(0.5, 0.4), a = (s - 0.4) / (0.4 * 0.5), b = 0.5;
    for (const int steps : {1, 7, 200}) {
        auto foam = foam_on(steep, law);
        for (int i = 0; i < steps; ++i) foam.step(steep, 0.9 / steps * second);
        const double grown = a / (a + b) * (1 - std::exp(-(a + b) * 0.9));
        for (std::size_t j = 0; j < 8; ++j)
            for (std::size_t i = 0; i < 9; ++i) CHECK(double(foam.part(i, j)) == Approx(grown).epsilon(1e-5));
        for (int i = 0; i < steps; ++i) foam.step(level, 1.5 / steps * second);
        CHECK(double(foam.part(4, 3)) == Approx(grown * std::exp(-b * 1.5)).epsilon(1e-5));
    }
    auto none = foam_on(level);
    for (int i = 0; i < 50; ++i) none.step(level, 0.1 * second);
    for (const TestType f : none.parts()) CHECK(f == TestType(0));
}
TEST_CASE("below its steepness water has no foam, and none stands on dry ground", "[water]") {
    Surface calm{WaterColumns{3.0 * mps}, ColumnGrid(12, 9, 0.5 * metre), 2.0 * metre};
    set_heights(calm, [](double x, double) { return 2 + 0.29 * x; });
    auto foam = foam_on(calm);
    foam.step(calm, 1.0 * second);
    CHECK(covered(foam) == 0);
    // A shore that rises with 1 in 2: its water is level, and so has no slope, up to the last wet column.
    std::vector<double> bed;
    for (int n = 0; n < 12 * 3; ++n) bed.push_back(0.25 * (n % 12));
    Surface shore{Pipes{}, ColumnGrid(12, 3, 0.5 * metre), bed, 1.1 * metre};
    auto beside = foam_on(shore);
    std::vector<double> all(36, 1.0);
    beside.set_parts(all);
    beside.step(shore, 2.0 * second);
    CHECK(beside.part(4, 1) == Approx(std::exp(-1.0)));
    CHECK(beside.part(5, 1) == 0);
    beside.step(shore, 2.0 * second);
    CHECK(beside.part(0, 1) == Approx(std::exp(-2.0)));
}
TEST_CASE("foam goes with the flow", "[water]") {
    // A channel in which all water flows with the same speed.
    Surface river{ShallowWater{}, ColumnGrid(80, 1, 0.25 * metre), 1.0 * metre};
    auto state = river.state();
    for (auto& hu : state.momentum_x) hu = 0.8;
    for (std::size_t n = 0; n < state.momentum_z.size(); ++n) state.momentum_z[n] = 0;
    river = Surface{ShallowWater{}, river.grid(), 1.0 * metre, state};
    auto foam = foam_on(river, {.fades_in = 1e12 * second});
    std::vector<double> patch(80, 0.0);
    for (int n = 20; n < 30; ++n) patch[std::size_t(n)] = 0.5;
    foam.set_parts(patch);
    auto middle = [&] {
        double sum = 0;
        for (std::size_t n = 0; n < 80; ++n) sum += foam.parts()[n] * river.grid().centre_x(n).value();
        return sum / covered(foam);
    };
    const double before = middle();
    for (int i = 0; i < 50; ++i) foam.step(river, 0.1 * second); // the river stands still: it is the foam that moves
    CHECK(middle() - before == Approx(4.0).epsilon(1e-9));
    CHECK(covered(foam) == Approx(5.0).epsilon(1e-9));
}
TEST_CASE("foam stands behind a hull and not before it, stays between 0 and 1, and allocates nothing", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    const auto pool = world.add(Pool{Surface{WaterColumns{2.0 * mps}, ColumnGrid(80, 40, 0.25 * metre), 2.0 * metre}});
    const auto hull = world.add(position(metres(2, 2, 5)), velocity(metres_per_second(4, 0, 0)), moving);
    world.add(Floating{hull, Sphere{0.8 * metre}});
    auto foam = foam_on(world.water(pool).surface(), {.steep = 0.1});
    auto copy = foam;
    for (int i = 0; i < 300; ++i) {
        world.step(0.01 * second);
        if (i == 20) {
            allocations = 0;
            ansatz::test::before_allocation = count;
        }
        foam.step(world.water(pool).surface(), 0.01 * second);
        ansatz::test::before_allocation = nullptr;
        copy.step(world.water(pool).surface(), 0.01 * second);
    }
    CHECK(allocations == 0);
    CHECK(copy == foam);
    double behind = 0, ahead = 0;
    for (std::size_t j = 0; j < 40; ++j)
        for (std::size_t i = 0; i < 80; ++i) {
            const double x = foam.grid().centre_x(i).value(), f = foam.part(i, j);
            REQUIRE(f >= 0);
            REQUIRE(f <= 1);
            // The hull is at 14 m, faster than waves; its ring reaches 1.6 m ahead.
            if (x < 12) behind += f;
            if (x > 16.5) ahead += f;
        }
    CHECK(behind > 20);
    CHECK(ahead == 0);
}
TEST_CASE("foam that comes and goes at once is there where it is steep, and nowhere else", "[water]") {
    const ColumnGrid grid(8, 1, 1.0 * metre);
    Surface water{WaterColumns{1.0 * mps}, grid, 1.0 * metre};
    water.set_height(2, 0, 2.0 * metre);
    for (const double grows : {1e-310, 0.3})
        for (const double dt : {0.0, 1e-3, 1.0}) {
            auto foam = foam_on(water, {.steep = 1e-310, .grows_in = grows * second, .fades_in = 1e-310 * second});
            foam.step(water, dt * second);
            for (std::size_t i = 0; i < 8; ++i) {
                CHECK(foam.part(i, 0) >= 0);
                CHECK(foam.part(i, 0) <= 1);
                if (dt == 0 || i == 2 || i > 3) CHECK(foam.part(i, 0) == 0); // a crest is level, and so is the rest
                else if (i == 3 || i == 1) CHECK(foam.part(i, 0) == 0.5);    // as fast as it fades
            }
        }
}
TEST_CASE("what foam cannot be is refused", "[water]") {
    const ColumnGrid grid(4, 4, 1.0 * metre);
    Surface water{WaterColumns{1.0 * mps}, grid, 1.0 * metre};
    auto foam = foam_on(water);
    const auto before = foam;
    auto said = [&](auto&& call, const char* part) { return refusal(call).find(part) != std::string::npos; };
    CHECK(said([&] { foam_on(water, {.steep = 0}); }, "steep is 0"));
    CHECK(said([&] { foam_on(water, {.grows_in = 0.0 * second}); }, "grows_in is 0 s"));
    CHECK(said([&] { foam_on(water, {.fades_in = not_a_number * second}); }, "fades_in is nan"));
    CHECK(said([&] { foam.step(water, -1.0 * second); }, "dt is -1 s"));
    CHECK(said(
        [&] {
            foam.step(Surface{WaterColumns{1.0 * mps}, ColumnGrid(4, 4, 2.0 * metre), 1.0 * metre}, 1.0 * second);
        },
        "the grid of the surface"));
    CHECK(said([&] { foam.set_parts(std::vector<double>(3, 0.0)); }, "16 columns"));
    CHECK(sentence<std::out_of_range>([&] { (void)foam.part(1, 4); }) ==
          "Foam::part: a column is (1, 4); there are 4 x 4, counted from 0");
    CHECK(sentence<std::out_of_range>([&] { (void)foam.part(4, 1); }) ==
          "Foam::part: a column is (4, 1); there are 4 x 4, counted from 0");
    CHECK(said([&] { foam.set_parts(std::vector<double>(16, 1.1)); }, "a part is 1.1"));
    CHECK(foam == before);
}
