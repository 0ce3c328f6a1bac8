// SPDX-License-Identifier: BSL-1.0
// Pools in a world: to the bit the surface by itself, a part of the world's value, and no step that makes waves grow.

#include <ansatz/springs.hpp>
#include <ansatz/water.hpp>
#include <ansatz/water/module.hpp>
#include <ansatz/water/pool.hpp>
#include <ansatz/water/pools.hpp>
#include <ansatz/water/roles.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/before_allocation.hpp"
#include "tests/water/support.hpp"

#include <sstream>

using namespace water_tests;

namespace {

std::size_t allocations = 0;
bool count(std::size_t) noexcept {
    ++allocations;
    return true;
}

constexpr auto litre = 0.001 * cubic_metre;
ColumnGrid square() { return ColumnGrid(12, 9, 0.5 * metre); } // 6 m x 4.5 m
template <class Surface_> void swell(Surface_& water) {
    set_heights(water, [](double x, double z) { return 2 + 0.1 * std::sin(x) * std::cos(z); });
}
template <class Policy> Surface<Policy> waves(const Policy& policy) {
    Surface water(policy, square(), 2.0 * metre);
    swell(water);
    return water;
}

// One world of each scalar, with all that moves water.
using Big = World<SemiImplicitEuler, Gravity, Pools<WaterColumns>, Pools<Pipes>>;
using Small = World<Space<float, 2>, SemiImplicitEuler, Gravity, Pools<ClampedColumns>, Pools<ShallowWater>>;
const WaterColumns columns{3.0 * mps, 0.1 / second, {Wall::absorbs, Wall::holds, Wall::reflects, Wall::reflects}};

struct Two {
    Big world{{}, {}, {}, {}};
    PoolHandle<WaterColumns> pond, other;
    PoolHandle<Pipes> lake;
    Two() {
        pond = world.add(Pool{waves(columns)});
        lake = world.add(Pool{waves(Pipes{}), 1025.0 * kilogram_per_cubic_metre});
        other = world.add(Pool{Surface{columns, unequal(5, 4).at(20.0 * metre, -3.0 * metre), 1.0 * metre}});
        world.add(position(metres(0, 100, 0)), velocity(metres_per_second(1, 2, 3)));
        world.pour(other, 21.0 * metre, -2.0 * metre, 20.0 * litre);
    }
    void steps(int n) {
        for (int i = 0; i < n; ++i) world.step(0.02 * second);
    }
};

template <class Policy> void same_as_alone(const Policy& policy, double g) {
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0.3, -g, 0)}, Pools<Policy>{}};
    auto alone = waves(policy);
    const auto pool = world.add(Pool{alone});
    for (int i = 0; i < 100; ++i) {
        world.step(0.02 * second);
        alone.step(0.02 * second);
    }
    CHECK(world.water(pool).surface().state() == alone.state());
    CHECK(world.water(pool).level(1.3 * metre, 2.2 * metre) == alone.level(1.3 * metre, 2.2 * metre));
    CHECK(world.water(pool).normal(1.3 * metre, 2.2 * metre) == alone.normal(1.3 * metre, 2.2 * metre));
    CHECK(alone.level(1.3 * metre, 2.2 * metre) != 2.0 * metre);
}

} // namespace

TEST_CASE("a pool of a world is to the bit the surface by itself", "[water]") {
    same_as_alone(columns, 9.81);
    same_as_alone(Pipes{3.7 * metre_per_second_squared, 0.05 / second}, 3.7);
    same_as_alone(ShallowWater{1.62 * metre_per_second_squared}, 1.62);
    same_as_alone(SecondOrderShallowWater{1.62 * metre_per_second_squared, 1.3}, 1.62);
}
TEST_CASE("a pool in float is the surface in float, in a world of two dimensions", "[water]") {
    Small world{{}, {}, {}, {}, {}};
    const ColumnGrid channel(40, 1, 0.25 * metre, 1.0 * metre);
    Surface<ShallowWater, float> alone(ShallowWater{}, channel, 1.0 * metre);
    Surface<ShallowWater> given(ShallowWater{}, channel, 1.0 * metre);
    for (std::size_t i = 0; i < 10; ++i) {
        alone.set_height(i, 0, Quantity<unit::Length, float>::from_value(1.5f));
        given.set_height(i, 0, 1.5 * metre);
    }
    const auto pool = world.add(Pool{given});
    for (int i = 0; i < 100; ++i) {
        world.step(0.02 * second);
        alone.step(double(0.02f) * second);
    }
    CHECK(world.water(pool).surface().state() == alone.state());
    CHECK(double(world.water(pool).volume().value()) == Approx(11.25).epsilon(1e-6));
}
TEST_CASE("the weight of water is the world's, whatever the surface said", "[water]") {
    const auto moon = metres_per_second_squared(0, -1.62, 0);
    Two two;
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}};
    const auto pool = world.add(Pool{waves(Pipes{100.0 * metre_per_second_squared})});
    auto earth = waves(Pipes{}), other = waves(Pipes{});
    CHECK(world.longest_step_of_water() == earth.longest_step());
    for (int i = 0; i < 50; ++i) world.step(0.02 * second);
    for (int i = 0; i < 50; ++i) earth.step(0.02 * second);
    CHECK(world.water(pool).surface().state() == earth.state());
    world.set(Gravity{moon});
    const Surface later(Pipes{1.62 * metre_per_second_squared}, square(), 2.0 * metre, earth.state());
    CHECK(world.longest_step_of_water() == later.longest_step());
    auto on_the_moon = later;
    for (int i = 0; i < 50; ++i) world.step(0.05 * second);
    for (int i = 0; i < 50; ++i) on_the_moon.step(0.05 * second);
    CHECK(world.water(pool).surface().state() == on_the_moon.state());
    // Water that weighs nothing, or would fall up, lies still.
    world.set(Gravity{metres_per_second_squared(0, 9.81, 0)});
    CHECK(world.longest_step_of_water() > 1e30 * second);
}
TEST_CASE("flat water is unchanged after 10,000 steps of a world (hard case W1)", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}, Pools<WaterColumns>{}};
    const auto lake = world.add(Pool{Surface{Pipes{}, square(), 0.1 * metre}});
    const auto pond = world.add(Pool{Surface{columns, square(), 0.1 * metre}});
    const auto before = world.water(lake).surface().state();
    const auto too = world.water(pond).surface().state().height;
    for (int i = 0; i < 10000; ++i) world.step(0.05 * second);
    CHECK(world.water(lake).surface().state() == before);
    CHECK(world.water(pond).surface().state().height == too);
}
TEST_CASE("the program of the page", "[water]") {
    //! [pool]
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}};
    const ColumnGrid grid(41, 41, 0.25 * metre);
    const auto pond = world.add(Pool{Surface{WaterColumns{3.0 * metre_per_second}, grid, 2.0 * metre}});
    world.pour(pond, 5.1 * metre, 5.1 * metre, 0.01 * cubic_metre);
    for (int n = 0; n < 60; ++n) world.step(1.0 / 60 * second);
    const auto level = world.water(pond).level(8.0 * metre, 5.125 * metre);
    //! [pool]
    CHECK(level != 2.0 * metre);
    CHECK(level.value() == Approx(world.water(pond).level(2.25 * metre, 5.125 * metre).value())
                               .epsilon(1e-14)); // the pond is its own mirror image
}
TEST_CASE("several pools of several kinds are a part of the world's value", "[water]") {
    Two two;
    two.steps(40);
    auto copy = two.world;
    std::stringstream file;
    save(two.world, file);
    Two fresh;
    Big loaded{{}, {}, {}, {}};
    load(loaded, file);
    CHECK(loaded.hash() == two.world.hash());
    CHECK(fresh.world.hash() != two.world.hash());
    two.steps(40);
    for (int i = 0; i < 40; ++i) {
        copy.step(0.02 * second);
        loaded.step(0.02 * second);
    }
    CHECK(copy.hash() == two.world.hash());
    CHECK(loaded.hash() == two.world.hash());
    CHECK(loaded.water(two.pond).surface().state() == two.world.water(two.pond).surface().state());
    CHECK(loaded.water(two.lake).density() == 1025.0 * kilogram_per_cubic_metre);
    CHECK(loaded.water(two.other).grid() == two.world.water(two.other).grid());
    copy = fresh.world;
    CHECK(copy.hash() == fresh.world.hash());
}
TEST_CASE("any number of a saved pool that is another is another hash, or is refused", "[water]") {
    Two two;
    two.steps(3);
    std::stringstream file;
    save(two.world, file);
    const std::string text = file.str();
    const auto hash = two.world.hash();
    const auto begin = text.find("\"elements\""), end = text.find("\"policies\"");
    REQUIRE(begin != std::string::npos);
    std::mt19937 random(7);
    int tried = 0, told = 0;
    while (tried < 300) {
        const auto at = begin + random() % ((end > begin ? end : text.size()) - begin);
        if (text[at] < '1' || text[at] > '8' || text[at - 1] == '_') continue;
        // The last digits of a number may be none of its bits, and a digit of the exponent is another matter.
        if (at > 3 && text[at - 1] != ' ' && text[at - 1] != '-' && text[at - 2] != '.') continue;
        std::string changed = text;
        ++changed[at];
        std::stringstream other(changed);
        Big world{{}, {}, {}, {}};
        ++tried;
        try {
            load(world, other);
            told += world.hash() != hash;
        } catch (const std::invalid_argument&) {
            ++told;
        }
    }
    CHECK(told == tried);
}
TEST_CASE("what the water is asked is what the last step has made", "[water]") {
    Two two;
    auto& world = two.world;
    two.steps(10);
    const auto at = world.water(two.other).grid().column(21.0 * metre, -2.0 * metre);
    const auto before = world.water(two.other).surface().heights()[at];
    const auto volume = world.water(two.other).volume();
    world.pour(two.other, 21.0 * metre, -2.0 * metre, 30.0 * litre);
    CHECK(world.water(two.other).surface().heights()[at] > before);
    CHECK(double((world.water(two.other).volume() - volume).value()) == Approx(0.03).epsilon(1e-12));
    CHECK(world.water(two.lake).covers(1.0 * metre, 1.0 * metre));
    CHECK_FALSE(world.water(two.lake).covers(21.0 * metre, -2.0 * metre));
    // The rate is what the column there rose by in the step.
    const auto column = world.water(two.pond).grid().column(1.2 * metre, 1.7 * metre);
    const double rose = world.water(two.pond).surface().heights()[column];
    two.steps(1);
    CHECK(world.water(two.pond).rate(1.2 * metre, 1.7 * metre).value() ==
          Approx((world.water(two.pond).surface().heights()[column] - rose) / 0.02).epsilon(1e-9));
    CHECK(sentence<std::out_of_range>([&] {
              world.water(two.lake).level(7.0 * metre, 0.0 * metre);
          }).find("the columns cover x from 0 m to 6 m") != std::string::npos);
}
TEST_CASE("a step beyond Courant's limit is refused before anything moves", "[water]") {
    Two two;
    two.steps(5);
    const auto hash = two.world.hash();
    const auto longest = two.world.longest_step_of_water();
    const auto said = refusal([&] { two.world.step(1.01 * longest); });
    CHECK(said.find("the longest step that the pools of this world take is " + describe(longest)) != std::string::npos);
    CHECK(two.world.hash() == hash);
    CHECK_NOTHROW(two.world.step(longest));
}
TEST_CASE("a StepControl that divides has the water take a long step in substeps", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Springs<>{}, StepLimit<Divide>{}};
    auto alone = waves(columns);
    const auto pool = world.add(Pool{alone});
    const auto limit = alone.longest_step();
    world.step(2.5 * limit);
    for (int i = 0; i < 3; ++i) alone.step(2.5 * limit / 3.0);
    CHECK(world.water(pool).surface().state() == alone.state());
    World strict{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Springs<>{}, StepLimit<Refuse>{}};
    strict.add(Pool{waves(columns)});
    CHECK(refusal([&] { strict.step(2.5 * limit); }).find("Courant's limit") != std::string::npos);
}
TEST_CASE("a step in substeps is divided anew where the water becomes faster than it was (hard case W8)", "[water]") {
    // 10 cm of water on a slope of a tenth: before a step is over it runs six times as fast as its waves.
    World world{SemiImplicitEuler{}, Gravity{}, Pools<ShallowWater>{}, Springs<>{}, StepLimit<Divide>{}};
    const ColumnGrid slope(200, 1, 0.5 * metre, 1.0 * metre);
    std::vector<double> bed;
    for (std::size_t i = 0; i < 200; ++i) bed.push_back(10 - 0.1 * slope.centre_x(i).value());
    Surface water(ShallowWater{}, slope, std::span<const double>(bed), 0.0 * metre);
    set_heights(water, [](double, double) { return 0.1; });
    const auto pool = world.add(Pool{water});
    const auto dt = 6.0 * second;
    CHECK(dt > water.longest_step());
    for (int i = 1; i <= 2; ++i) {
        world.step(dt);
        for (const double h : world.water(pool).surface().heights()) CHECK(h >= 0);
        CHECK(world.water(pool).volume().value() == Approx(10).epsilon(1e-12));
        // No faster than what slides without friction and runs out ahead of itself. In the middle of the water, half of
        // the bed's step of 5 cm under its height of 10 cm slower: what first order does.
        const double slides = 0.981 * 6 * i, c = std::sqrt(9.81 * 0.1);
        for (std::size_t k = 0; k < 200; ++k)
            CHECK(world.water(pool).surface().velocity(k, 0).value()[0] <= slides + 2 * c);
        if (i == 1)
            CHECK(world.water(pool).surface().velocity(100, 0).value()[0] == Approx(0.75 * slides).epsilon(1e-9));
    }
}
TEST_CASE("pools are added, read, replaced and removed by handles", "[water]") {
    Two two;
    two.steps(7);
    auto& world = two.world;
    const auto pool = world.get(two.lake);
    CHECK(pool.surface.state() == world.water(two.lake).surface().state());
    CHECK(pool.density == 1025.0 * kilogram_per_cubic_metre);
    world.set(two.lake, Pool{Surface{Pipes{}, square(), 1.0 * metre}});
    CHECK(world.water(two.lake).level(1.0 * metre, 1.0 * metre) == 1.0 * metre);
    world.remove(two.pond);
    CHECK_FALSE(world.contains(two.pond));
    CHECK(world.contains(two.other));
    two.steps(3);
    CHECK(sentence<std::out_of_range>([&] { world.water(two.pond); }).find("World::water") != std::string::npos);
    const auto again = world.add(Pool{waves(columns)});
    CHECK(again.id == two.pond.id);
    CHECK_FALSE(again == two.pond);
}
TEST_CASE("what a pool cannot be is refused, and the world is as it was", "[water]") {
    Two two;
    const auto hash = two.world.hash();
    const auto said = [&](double density) {
        return refusal([&] { two.world.add(Pool{waves(Pipes{}), density * kilogram_per_cubic_metre}); });
    };
    CHECK(said(0).find("Pool: density is 0") != std::string::npos);
    CHECK(said(-1).find("density") != std::string::npos);
    CHECK(said(not_a_number).find("density") != std::string::npos);
    const auto pour = [&](double volume) {
        return refusal([&] { two.world.pour(two.lake, 1.0 * metre, 1.0 * metre, volume * cubic_metre); });
    };
    CHECK(pour(-0.6).find("it has 0.5") != std::string::npos);
    CHECK(pour(not_a_number).find("volume") != std::string::npos);
    CHECK(pour(HUGE_VAL).find("volume is inf") != std::string::npos);
    CHECK(sentence<std::out_of_range>([&] {
              two.world.pour(two.lake, 9.0 * metre, 1.0 * metre, 1.0 * litre);
          }).find("the columns cover") != std::string::npos);
    CHECK(two.world.hash() == hash);
}
TEST_CASE("a pool that is asked stays the same pool, whatever comes or goes", "[water]") {
    Two two;
    const auto lake = two.world.water(two.lake);
    const auto pond = two.world.water(two.pond);
    std::vector<PoolHandle<WaterColumns>> more;
    for (int i = 0; i < 40; ++i) more.push_back(two.world.add(Pool{waves(columns)}));
    CHECK(pond.surface().state() == two.world.water(two.pond).surface().state());
    for (const auto& pool : more) two.world.remove(pool);
    two.steps(3);
    CHECK(pond.volume() == two.world.water(two.pond).volume());
    CHECK(lake.density() == 1025.0 * kilogram_per_cubic_metre);
    two.world.remove(two.pond);
    CHECK(sentence<std::out_of_range>([&] { (void)pond.volume(); }).find("World::water") != std::string::npos);
    two.world.add(Pool{waves(columns)}); // in its place
    CHECK(sentence<std::out_of_range>([&] { (void)pond.volume(); }).find("World::water") != std::string::npos);
}
TEST_CASE("a pool holds no body, unites none, and costs bodies nothing", "[water]") {
    using Without = World<SemiImplicitEuler, Gravity, Springs<>, Rest>;
    using With = World<SemiImplicitEuler, Gravity, Springs<>, Rest, Pools<WaterColumns>>;
    CHECK(Without::bytes_per_body == With::bytes_per_body);
    Without dry{{}, {}, {}, {}};
    With wet{{}, {}, {}, {}, {}};
    wet.add(Pool{waves(columns)});
    std::vector<Handle> bodies;
    auto hang = [&](auto& world, double x, double y) {
        const auto body = world.add(position(metres(x, y, 1)), mass(1.0 * kilogram));
        world.add(Spring{body, metres(x, 3, 1), 9.81 * newton_per_metre, 0.0 * newton_second_per_metre, 1.0 * metre});
        return body;
    };
    const auto still = hang(wet, 1, 1), swings = hang(wet, 2, 0.5);
    hang(dry, 1, 1), hang(dry, 2, 0.5);
    for (int i = 0; i < 200; ++i) {
        wet.step(0.01 * second);
        dry.step(0.01 * second);
    }
    CHECK(wet.motion(still) == Motion::resting);
    CHECK(wet.motion(swings) == Motion::awake);
    CHECK(wet.position(swings) == dry.position(swings));
}
TEST_CASE("a warm step of a world with pools allocates nothing", "[water]") {
    Two two;
    two.steps(2);
    auto copy = two.world;
    copy.step(0.02 * second);
    allocations = 0;
    ansatz::test::before_allocation = count;
    two.steps(40);
    for (int i = 0; i < 40; ++i) copy.step(0.02 * second);
    ansatz::test::before_allocation = nullptr;
    CHECK(allocations == 0);
}
