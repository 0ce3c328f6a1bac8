// SPDX-License-Identifier: BSL-1.0
// A world that was moved from is empty and usable; huge and wrong numbers are refused before anything is touched.

#include <ansatz/world/cache.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <utility>

using namespace ansatz;
using namespace ansatz::test;

TEMPLATE_TEST_CASE("a world moved from has no bodies and can be used again", "[world][value]", SemiImplicitEuler,
                   Verlet) {
    World world{TestType{}, Gravity{}, Rest{}, Datum<int>{}};
    Handle last;
    for (int i = 0; i < 100; ++i) last = world.add(datum(i));
    world.step(0.1 * second);
    const auto hash = world.hash();
    auto other = std::move(world);
    CHECK(other.hash() == hash);
    CHECK(other.datum(last) == 99);
    CHECK(world.size() == 0);
    CHECK(world.count(Motion::awake) == 0);
    CHECK_FALSE(world.contains(last));
    for (int i = 0; i < 20; ++i) world.add(datum(7));
    world.step(0.1 * second);
    CHECK(world.size() == 20);

    auto& self = other;
    other = std::move(self);
    CHECK(other.hash() == hash);
    CHECK(other.datum(last) == 99);
    other.step(0.1 * second);
    CHECK(other.size() == 100);

    world = std::move(other);
    CHECK(world.size() == 100);
    CHECK(other.size() == 0);
    CHECK(other.count(Motion::awake) == 0);
}

TEST_CASE("room for more bodies than can be named is refused", "[world][door]") {
    World world{SemiImplicitEuler{}};
    for (int i = 0; i < 100; ++i) world.add();
    const auto hash = world.hash();
    CHECK_THAT(sentence<std::invalid_argument>([&] { world.reserve(std::size_t(-1)); }),
               Catch::Matchers::ContainsSubstring("World::reserve: n is 18446744073709551615"));
    CHECK(world.hash() == hash);
    Lanes<Space<>, Columns<Position>> lanes;
    CHECK_THAT(sentence<std::invalid_argument>([&] { lanes.reserve(std::size_t(-1) / 8); }),
               Catch::Matchers::ContainsSubstring("Lanes::reserve"));
}

TEST_CASE("a lane and a slot that are not there are refused", "[world]") {
    World<SemiImplicitEuler, Space<double, 2>> world{SemiImplicitEuler{}, Space<double, 2>{}};
    world.add(position(metres(1, 2)));
    CHECK(world.lane<Position>(1)[0] == 2);
    CHECK_THAT(sentence<std::out_of_range>([&] { (void)world.lane<Position>(2); }),
               Catch::Matchers::ContainsSubstring("component 2 of position: it has 2"));
    CHECK_THAT(sentence<std::out_of_range>([&] { (void)world.lane<Position>(-1); }),
               Catch::Matchers::ContainsSubstring("component -1"));
    CHECK_THAT(sentence<std::out_of_range>([&] { (void)world.body_at(1); }),
               Catch::Matchers::ContainsSubstring("slot 1: there are 1"));
}

TEST_CASE("a parameter that the world's scalar cannot hold is refused", "[world][door]") {
    CHECK_THAT(sentence<std::invalid_argument>([] {
                   World world{Space<float, 3>{}, SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 1e300, 0)}};
               }),
               Catch::Matchers::ContainsSubstring("Gravity: acceleration is (0, 1e+300, 0) m/s^2"));
    CHECK_THAT(sentence<std::invalid_argument>([] {
                   World world{Space<float, 3>{}, SemiImplicitEuler{}, QuadraticDrag{1e39 * kilogram_per_metre}};
               }),
               Catch::Matchers::ContainsSubstring("1e+39 kg/m"));
    CHECK_NOTHROW(World{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 1e300, 0)}});
    World world{SemiImplicitEuler{}};
    world.step(1e308 * second);
    CHECK_THAT(sentence<std::invalid_argument>([&] { world.step(1e308 * second); }),
               Catch::Matchers::ContainsSubstring("the time after the step is finite"));
}

namespace {
struct Wind : Gravity { // a second force bound by the first one's In
    static constexpr std::string_view name = "Wind";
};
} // namespace

TEST_CASE("two forces may share what binds them to a space", "[world][composition]") {
    World world{VelocityVerlet{}, Gravity{metres_per_second_squared(0, -1, 0)},
                Wind{Gravity{metres_per_second_squared(3, 0, 0)}}};
    const auto body = world.add();
    world.step(1.0 * second);
    CHECK(world.velocity(body) == metres_per_second(3, -1, 0));
    CHECK(world.laws().get<Wind>().g == metres_per_second_squared(3, 0, 0));
}
