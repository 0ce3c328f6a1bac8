// SPDX-License-Identifier: BSL-1.0
// Saved games: what comes out of a file goes on as what went in would have, to the bit.

#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"
#include "tests/scratch.hpp"
#include "tests/world/files.hpp"
#include "tests/world/lives.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

using namespace ansatz;
using namespace ansatz::test;

namespace {} // namespace

TEST_CASE("a world saved at step 30, loaded and run to 60 is the world run to 60, to the bit", "[world][save][I19]") {
    auto make = [] { return eventful<Space<float, 2>, Verlet>(); };
    auto world = make();
    live(world, 0, 30);
    const auto text = text_of(world);

    auto loaded = make(); // a new world, with other parameters than the saved one
    loaded.set(Drag{7.0 / second});
    load_text(loaded, text);
    CHECK(same_to_the_bit(loaded, world));
    CHECK(loaded.get<Drag>().rate == world.get<Drag>().rate);
    CHECK(text_of(loaded) == text);

    auto used = make(); // a world in the middle of another life
    live(used, 0, 47);
    load_text(used, text);
    CHECK(same_to_the_bit(used, world));

    live(world, 30, 60);
    live(loaded, 30, 60);
    live(used, 30, 60);
    CHECK(same_to_the_bit(loaded, world));
    CHECK(same_to_the_bit(used, world));
    CHECK(text_of(used) == text_of(world));
}

TEST_CASE("a world whose bodies couple, by an integrator of history, is saved whole", "[world][save][I19]") {
    World world{Verlet{}, Attraction{1.0 * (cubic_metre / (kilogram * second * second)), 0.1 * metre}, QuadraticDrag{}};
    auto empty = world;
    for (int i = 0; i < 4; ++i)
        world.add(position(metres(i, i * i, 1)), velocity(metres_per_second(0, 1, -i)), mass((1.0 + i) * kilogram));
    auto run = [](auto& w, int steps) {
        for (int i = 0; i < steps; ++i) w.step(1.0 / 60 * second);
    };
    for (const int steps : {0, 30}) { // before the first step, where every start still waits, and under way
        run(world, steps);
        auto loaded = empty;
        load_text(loaded, text_of(world));
        CHECK(same_to_the_bit(loaded, world));
        auto straight = world;
        run(straight, 30);
        run(loaded, 30);
        CHECK(same_to_the_bit(loaded, straight));
    }
}

TEST_CASE("every number of a state survives the file: signs of zero, denormals, the largest", "[world][save]") {
    World world{SemiImplicitEuler{}, Keep<Home>{}};
    using Limits = std::numeric_limits<double>;
    const auto body = world.add(position(metres(-0.0, Limits::denorm_min(), 0.1)),
                                velocity(metres_per_second(Limits::max(), -1e-300, 1.0 / 3)),
                                with<Home>(metres(1e22, 123456789012345678.0, Limits::epsilon())));
    World loaded{SemiImplicitEuler{}, Keep<Home>{}};
    load_text(loaded, text_of(world));
    CHECK(same_bits(loaded.position(body), world.position(body)));
    CHECK(same_bits(loaded.velocity(body), world.velocity(body)));
    CHECK(same_bits(loaded.read<Home>(body), world.read<Home>(body)));
    Dice dice(3);
    World narrow{Space<float, 2>{}, SemiImplicitEuler{}};
    for (int i = 0; i < 1000; ++i) {
        const double scale = std::pow(10.0, double(dice.below(60)) - 30);
        narrow.add(position(metres(dice.number(-1, 1) * scale, dice.number(-1, 1) * scale)));
    }
    World again{Space<float, 2>{}, SemiImplicitEuler{}};
    load_text(again, text_of(narrow));
    CHECK(same_to_the_bit(again, narrow));
}

TEST_CASE("handles of the saved world name its bodies in the loaded one, and stale ones stay stale", "[world][save]") {
    World world{SemiImplicitEuler{}, Rest{}};
    const auto a = world.add(position(metres(1, 0, 0))), b = world.add(), c = world.add(resting), d = world.add(fixed);
    world.remove(b);
    world.remove(a);
    const auto heir = world.add(position(metres(2, 0, 0))); // of a
    const auto e = world.add(), f = world.add(), g = world.add();
    for (const auto h : {f, g, e})
        world.remove(h); // the order in which ids become free is that in which they are used again
    World loaded{SemiImplicitEuler{}, Rest{}};
    load_text(loaded, text_of(world));
    CHECK_FALSE(loaded.contains(a));
    CHECK_FALSE(loaded.contains(b));
    CHECK(loaded.position(heir) == metres(2, 0, 0));
    CHECK(loaded.motion(c) == Motion::resting);
    CHECK(loaded.motion(d) == Motion::fixed);
    for (int i = 0; i < 5; ++i) CHECK(loaded.add() == world.add()); // and the next ones get the same handles in both
    CHECK(loaded.hash() == world.hash());
}

TEST_CASE("an empty world is saved and loaded, also over a full one, and the clock with it", "[world][save]") {
    World empty{SemiImplicitEuler{}, Gravity{}};
    for (int i = 0; i < 3; ++i) empty.step(1.0 / 60 * second);
    World full{SemiImplicitEuler{}, Gravity{metres_per_second_squared(1, 2, 3)}};
    const auto body = full.add();
    load_text(full, text_of(empty));
    CHECK(full.size() == 0);
    CHECK_FALSE(full.contains(body));
    CHECK(full.tick() == 3);
    CHECK(full.time() == empty.time());
    CHECK(full.get<Gravity>().acceleration == metres_per_second_squared(0, -9.81, 0));
    CHECK(full.hash() == empty.hash());
    full.add();
    full.step(1.0 / 60 * second);
    CHECK(full.size() == 1);
}

TEST_CASE("a datum that cannot be saved: a new world has new ones, one that had them keeps them",
          "[world][save][keep]") {
    using Shared = std::shared_ptr<std::string>;
    World world{SemiImplicitEuler{}, Datum<Shared>{}};
    const auto body = world.add(datum(std::make_shared<std::string>("ball")));
    const auto text = text_of(world);
    CHECK(text.find("datum") == std::string::npos);
    World fresh{SemiImplicitEuler{}, Datum<Shared>{}};
    load_text(fresh, text);
    CHECK_FALSE(fresh.datum(body));
    world.step(1.0 / 60 * second);
    load_text(world, text); // back to the saved moment
    CHECK(*world.datum(body) == "ball");
    World other{SemiImplicitEuler{}, Datum<Shared>{}};
    other.remove(other.add());
    const auto later = other.add(datum(std::make_shared<std::string>("box"))); // the same id, another generation
    REQUIRE((later.id == body.id && !(later == body)));
    load_text(other, text);
    CHECK_FALSE(other.datum(body));
}

TEST_CASE("a world goes through a file on disk, and a path that cannot be opened is named", "[world][save]") {
    const auto path = ansatz::test::scratch_path("save").string();
    World world{SemiImplicitEuler{}, Gravity{}};
    const auto body = world.add(position(metres(1, 2, 3)));
    save(world, path);
    World loaded{SemiImplicitEuler{}, Gravity{}};
    load(loaded, path);
    CHECK(loaded.position(body) == metres(1, 2, 3));
    std::remove(path.c_str());
    CHECK(sentence<std::invalid_argument>([&] { load(loaded, path); }) ==
          "load: " + path + " cannot be opened for reading");
    const std::string nowhere = path + "/in/no/folder";
    CHECK(sentence<std::invalid_argument>([&] { save(world, nowhere); }) ==
          "save: " + nowhere + " cannot be opened for writing: No such file or directory");
    CHECK(loaded.position(body) == metres(1, 2, 3));
}

TEST_CASE("a stream that breaks is noticed when saving", "[world][save]") {
    World world{SemiImplicitEuler{}};
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    CHECK(sentence<std::invalid_argument>([&] { save(world, out); }).find("save: ") == 0);
}
