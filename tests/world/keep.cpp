// SPDX-License-Identifier: BSL-1.0
// Keep and Datum: what a world stores for a program, not for its policies.

#include <ansatz/world/keep.hpp>

#include <ansatz/world/user_data.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <memory>
#include <stdexcept>
#include <string>

using namespace ansatz;
using namespace ansatz::test;

TEST_CASE("a datum of bool is one for each body, and goes with its body", "[world][keep]") {
    World world{SemiImplicitEuler{}, Datum<bool>{}};
    const auto yes = world.add(datum(true)), no = world.add(), other = world.add(datum(true));
    world.datum(no) = true; // a vector of bool has no elements to refer to
    bool& reference = world.datum(no);
    reference = false;
    CHECK(world.datum(yes));
    CHECK_FALSE(world.datum(no));
    CHECK(world.datum(other));
    world.remove(yes);
    CHECK_FALSE(world.datum(no));
    CHECK(world.datum(other));
}

TEST_CASE("a datum of text is copied with the world, removed with the body, and not hashed", "[world][keep]") {
    World world{SemiImplicitEuler{}, Rest{}, Datum<std::string>{}};
    const auto ball = world.add(datum("a ball whose name is longer than any small buffer")),
               wall = world.add(fixed, datum(std::string("wall")));
    auto copy = world;
    copy.datum(ball) = "another";
    CHECK(copy.hash() == world.hash());
    CHECK(world.datum(ball) == "a ball whose name is longer than any small buffer");
    const auto& reading = copy;
    CHECK(reading.datum(ball) == "another");
    world.remove(ball);
    const auto heir = world.add(); // takes the id, not the name
    REQUIRE(heir.id == ball.id);
    CHECK(world.datum(heir).empty());
    CHECK(world.datum(wall) == "wall");
    for (int i = 0; i < 100; ++i) world.add(datum(std::to_string(i))); // grows
    CHECK(world.datum(wall) == "wall");
    CHECK(world.datum(world.handles()[50]) == "48");
}

TEST_CASE("a removed body's datum is let go at once", "[world][keep]") {
    World world{SemiImplicitEuler{}, Datum<std::shared_ptr<int>>{}};
    const auto shared = std::make_shared<int>(1);
    const auto body = world.add(datum(shared));
    CHECK(shared.use_count() == 2);
    world.remove(body);
    CHECK(shared.use_count() == 1);
}

namespace {
/// A datum whose copy may fail.
struct Fragile {
    int value = 0;
    bool breaks = false;
    Fragile() = default;
    explicit Fragile(bool b) : breaks(b) {}
    Fragile(const Fragile& other) : value(other.value), breaks(other.breaks) {
        if (armed && breaks) throw std::runtime_error("no copy");
    }
    Fragile& operator=(const Fragile& other) {
        if (armed && other.breaks) throw std::runtime_error("no copy");
        value = other.value;
        breaks = other.breaks;
        return *this;
    }
    static inline bool armed = false;
};
} // namespace

TEST_CASE("a datum that throws when it is copied leaves the world as it was", "[world][keep]") {
    World world{SemiImplicitEuler{}, Datum<Fragile>{}};
    const auto first = world.add();
    const auto before = world.hash();
    const auto property = datum(Fragile{true});
    Fragile::armed = true;
    CHECK_THROWS_AS(world.add(property), std::runtime_error);
    Fragile::armed = false;
    CHECK(world.size() == 1);
    CHECK(world.hash() == before);
    CHECK(world.handles().front() == first);
    CHECK(world.add().id == 1);
}

TEST_CASE("a kept column is stored, read, written and copied, and never touched by a step", "[world][keep]") {
    World world{VelocityVerlet{}, Gravity{}, Keep<Heat, Home>{}, Keep<InverseMass>{}};
    const auto body = world.add(with<Heat>(5.0 * joule), with<Home>(metres(1, 2, 3)), mass(4.0 * kilogram));
    const auto other = world.add(mass(1.0 * kilogram));
    for (int i = 0; i < 10; ++i) world.step(1.0 / 60 * second);
    CHECK(world.read<Heat>(body) == 5.0 * joule);
    CHECK(world.read<Home>(body) == metres(1, 2, 3));
    CHECK(world.mass(body) == 4.0 * kilogram);
    CHECK(world.read<Heat>(other) == 0.0 * joule);
    world.write<Heat>(body, 6.0 * joule);
    CHECK(world.read<Heat>(body) == 6.0 * joule);
    CHECK(world.read<Home>(body) == metres(1, 2, 3));
    world.set_mass(body, 8.0 * kilogram);
    CHECK(world.inverse_mass(body) == 0.125 / kilogram);
}
