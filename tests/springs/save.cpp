// SPDX-License-Identifier: BSL-1.0
// Springs in a saved world: they come back to the bit, and a file that lies is refused with the place.

#include <ansatz/world/save.hpp>
#include <ansatz/world/save_elements.hpp>

#include "tests/dice.hpp"
#include "tests/springs/support.hpp"

#include <sstream>

using namespace spring_tests;
using Catch::Matchers::ContainsSubstring;

namespace {
auto a_world() {
    World world{Verlet{}, Gravity{}, Springs<Breaking>{}, Ropes<Undamped>{}, Rest{}};
    return world;
}
auto filled() {
    auto world = a_world();
    const auto chain = hang_chain(world, 4, 0.1, 300, 0.2, 0.25);
    const auto gone = world.add(Spring{chain[0], chain[2], 1.0 * N_per_m});
    world.add(Spring{chain[0], chain[3], 1.0 * N_per_m}, breaks_at(40.0 * newton), breaks_at(0.5));
    world.add(Rope{chain[1], metres(0.5, 0, 0), 20.0 * N_per_m});
    world.remove(gone);
    run(world, 20, 0.01);
    return world;
}
} // namespace

TEST_CASE("a loaded world has the springs, their handles and their places, and continues to the bit",
          "[springs][save]") {
    auto world = filled();
    std::stringstream file;
    save(world, file);
    auto loaded = a_world();
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    CHECK(loaded.elements<Spring>().handles() == world.elements<Spring>().handles());
    run(world, 50, 0.01);
    run(loaded, 50, 0.01);
    CHECK(loaded.hash() == world.hash());
    const auto b = world.handles()[0];
    CHECK(world.add(Spring{b, metres(1, 0, 0), 1.0 * N_per_m}) ==
          loaded.add(Spring{b, metres(1, 0, 0), 1.0 * N_per_m}));
}

TEST_CASE("a world saved between a change and its next step continues to the bit, whatever forces read",
          "[springs][save]") {
    World world{Verlet{}, Gravity{}, Springs{}};
    const auto a = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(position(metres(1, 0.3, 0)), velocity(metres_per_second(0.5, 1, 0)), mass(2.0 * kilogram));
    world.add(Spring{metres(0, 1, 0), a, 50.0 * N_per_m, 1.0 * N_s_per_m});
    run(world, 5, 0.01);
    const auto v = world.velocity(b);
    const auto added = world.add(Spring{a, b, 200.0 * N_per_m, 3.0 * N_s_per_m, 0.5 * metre});
    CHECK(norm(world.velocity(b) - v).value() <= 1e-12);
    auto saved_and_loaded = [&] {
        std::stringstream file;
        save(world, file);
        World loaded{Verlet{}, Gravity{}, Springs{}};
        load(loaded, file);
        CHECK(loaded.hash() == world.hash());
        run(loaded, 3, 0.01);
        run(world, 3, 0.01);
        CHECK(loaded.hash() == world.hash());
    };
    saved_and_loaded();
    world.set_mass(b, 0.5 * kilogram);
    saved_and_loaded();
    world.remove(added);
    saved_and_loaded();
}

namespace {
using History = World<Verlet, Gravity, AppliedForces, Springs<>>;
/// One verb, drawn, for a world and for others that are to be as it is.
void change(ansatz::test::Dice& dice, std::vector<History*> worlds) {
    const auto handles = worlds[0]->handles();
    const auto springs = worlds[0]->elements<Spring>().handles();
    const auto what = dice.below(8);
    const auto body = handles[dice.below(handles.size())], other = handles[dice.below(handles.size())];
    const double x = dice.number(-2, 2), y = dice.number(-2, 2), z = dice.number(-2, 2);
    const auto link = springs.empty() ? 0 : dice.below(springs.size());
    for (auto* world : worlds) switch (what) {
        case 0:
            if (!(body == other)) world->add(Spring{body, other, 30.0 * N_per_m, 0.5 * N_s_per_m, 0.5 * metre});
            break;
        case 1:
            if (!springs.empty()) world->remove(springs[link]);
            break;
        case 2: world->apply_force(body, newtons(5 * x, 5 * y, 5 * z)); break;
        case 3: world->set_mass(body, (2.5 + x) * kilogram); break;
        case 4: world->set_position(body, metres(x, y, z)); break;
        case 5: world->set_velocity(body, metres_per_second(x, y, z)); break;
        case 6: world->add(position(metres(x, y, z)), mass(1.0 * kilogram)); break;
        default:
            if (handles.size() > 3) world->remove(body);
        }
}
} // namespace

TEST_CASE("a loaded world divides its steps as the saved one did, whatever its own StepLimit was set to",
          "[springs][save]") {
    using Limit = StepLimit<Divide>;
    World world{SemiImplicitEuler{}, Springs<>{}, Limit{.part = 0.25, .most_parts = 40, .measured = 3}};
    hang_chain(world, 3, 0.1, 3000, 0, 0.25);
    world.set_velocity(world.handles().back(), metres_per_second(1, 0, 0));
    std::stringstream file;
    save(world, file);
    World loaded{SemiImplicitEuler{}, Springs<>{}, Limit{}};
    load(loaded, file);
    CHECK(loaded.get<Limit>().part == 0.25);
    CHECK(loaded.get<Limit>().most_parts == 40);
    CHECK(loaded.get<Limit>().measured == 3);
    run(world, 5, 0.02);
    run(loaded, 5, 0.02);
    CHECK(loaded.tick() == world.tick());
    CHECK(loaded.hash() == world.hash());
}

TEST_CASE("a world is the same as the one loaded from it, whatever is changed between two steps before and after",
          "[springs][save]") {
    const auto empty = [] { return History{Verlet{}, Gravity{}, AppliedForces{}, Springs{}}; };
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        ansatz::test::Dice dice(seed);
        auto world = empty(), loaded = empty();
        for (int i = 0; i < 4; ++i) world.add(position(metres(i, 0.1 * i, 0)), mass((1.0 + i) * kilogram));
        auto copy = world;
        loaded = world;
        for (int step = 0; step < 60; ++step) {
            INFO("seed " << seed << ", step " << step);
            for (auto changes = dice.below(6); changes > 0; --changes) {
                change(dice, {&world, &copy, &loaded});
                if (dice.one_in(3)) {
                    std::stringstream file;
                    save(world, file);
                    load(loaded, file);
                    copy = world;
                }
                REQUIRE(copy.hash() == world.hash());
                REQUIRE(loaded.hash() == world.hash());
                for (const auto body : world.handles()) REQUIRE(loaded.velocity(body) == world.velocity(body));
            }
            for (auto* one : {&world, &copy, &loaded}) run(*one, 1, 0.01);
            REQUIRE(copy.hash() == world.hash());
            REQUIRE(loaded.hash() == world.hash());
        }
    }
}

TEST_CASE("the forces before a change, in a file that lies, are refused with their place", "[springs][save]") {
    History world{Verlet{}, Gravity{}, AppliedForces{}, Springs{}};
    const auto a = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram));
    std::stringstream first;
    save(world, first);
    run(world, 1, 0.01);
    world.add(Spring{a, b, 50.0 * N_per_m});
    std::stringstream file;
    save(world, file);
    const auto good = detail::Json::parse(file.str());
    const auto refused = [&](auto json, const std::string& sentence) {
        History loaded{Verlet{}, Gravity{}, AppliedForces{}, Springs{}};
        const auto before = loaded.hash();
        std::stringstream lies(json.dump());
        CHECK_THROWS_WITH(load(loaded, lies, "file"), ContainsSubstring(sentence));
        CHECK(loaded.hash() == before);
    };
    auto few = good;
    few["forces before a change"].erase(0);
    refused(few, "file: forces before a change is [[0.0,0.0,0.0]]; expected a list of 2 forces");
    auto flat = good;
    flat["forces before a change"][1] = {1.0, 2.0};
    refused(flat, "file: forces before a change[1] is [1.0,2.0]; expected a list of 3 numbers");
    auto none = good;
    none["forces before a change"] = true;
    refused(none, "file: forces before a change is true; expected a list of forces");
    auto unmoved = detail::Json::parse(first.str());
    unmoved["forces before a change"] = detail::Json::array();
    refused(unmoved, "file: forces before a change is []; expected nothing, because no step was taken");
}

TEST_CASE("a file of springs that cannot be is refused with its place, and the world is as it was", "[springs][save]") {
    auto world = filled();
    std::stringstream good;
    save(world, good);
    const auto text = good.str();
    auto refused = [&](const std::string& part, const std::string& by, const std::string& sentence) {
        auto bad = text;
        const auto elements = bad.find("\"elements\"");
        const auto at = bad.find(part, elements);
        REQUIRE(at != std::string::npos);
        bad.replace(at, part.size(), by);
        std::stringstream file(bad);
        auto loaded = a_world();
        const auto before = loaded.hash();
        INFO(part << " -> " << by);
        CHECK_THROWS_WITH(load(loaded, file, "saved"),
                          ContainsSubstring("saved: elements.Springs") && ContainsSubstring(sentence));
        CHECK(loaded.hash() == before);
    };
    refused("\"stiffness\": 300.0", "\"stiffness\": -300.0",
            ".stiffness is -300.0; expected a number that is not negative");
    refused("\"stiffness\": 300.0", "\"stiffness\": \"inf\"", ".stiffness is \"inf\"; expected a finite number");
    refused("\"break force\": \"inf\"", "\"break force\": 0.0", "a number greater than 0, or \"inf\"");
    refused("\"first\": 1", "\"first\": 17", ".first is 17");
    refused("\"first\": 1", "\"first\": 0", ".second is 0; expected another body than the first");
    refused("\"id\": 1", "\"id\": 0", ".id is 0; expected an id that no other element has");
    refused("\"rest length\": 0.25", "\"rest\": 0.25", "expected \"rest length\"");
    refused("\"point\"", "\"place\"", "expected \"point\"");
}

TEST_CASE("a world without springs does not read one with them, nor the other way round", "[springs][save]") {
    std::stringstream with, without;
    save(filled(), with);
    World plain{Verlet{}, Gravity{}, Keep<InverseMass>{}, Rest{}};
    CHECK_THROWS_AS(load(plain, with), std::invalid_argument);
    save(plain, without);
    auto springs = a_world();
    CHECK_THROWS_AS(load(springs, without), std::invalid_argument);
}
