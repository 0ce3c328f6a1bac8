// SPDX-License-Identifier: BSL-1.0
// A world of walkers as a value: copied, saved, loaded; and walks that end, are refused, or cannot be.

#include <ansatz/paths/walking/walkers.hpp>

#include <ansatz/world/save.hpp>

#include "tests/paths/walking/worlds.hpp"
#include "tests/refusal.hpp"
#include "tests/world/files.hpp"

#include <array>
#include <optional>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

using namespace ansatz::test;
using namespace walking_tests;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("a world of walkers is a value: copied, saved and loaded it goes on to the bit", "[walking]") {
    std::mt19937 random(8);
    for (int round = 0; round < 20; ++round) {
        Simple world;
        std::vector<Handle> bodies;
        std::vector<ElementHandle<Walk>> walks;
        for (int i = 0; i < 5; ++i) {
            bodies.push_back(world.add(position(metres(i, 0, 0))));
            walks.push_back(world.add(walk_of(bodies.back(), random_path(random, 3, 8), 1 + i, 2)));
        }
        const auto go_on = [&](Simple& w, unsigned seed) { // verbs at random
            std::mt19937 own(seed);
            for (int i = 0; i < 120; ++i) {
                const auto k = own() % 5;
                switch (own() % 12) {
                case 0: w.set_velocity(bodies[k], metres_per_second(1, -2, 0.5)); break;
                case 1:
                    if (w.contains(walks[k])) w.halt(walks[k], own() % 2 == 0);
                    break;
                case 2:
                    if (w.contains(walks[k])) w.set(walks[k], walk_of(bodies[k], random_path(own, 2, 5), 2, 3));
                    break;
                case 3:
                    if (own() % 8 == 0 && w.contains(walks[k])) w.remove(walks[k]);
                    break;
                default: break;
                }
                w.step(0.04 * second);
            }
        };
        go_on(world, unsigned(round));
        Simple copy = world, loaded;
        load_text(loaded, text_of(world));
        REQUIRE(loaded.hash() == world.hash());
        REQUIRE(copy.hash() == world.hash());
        go_on(world, 100), go_on(copy, 100), go_on(loaded, 100);
        CHECK(copy.hash() == world.hash());
        CHECK(loaded.hash() == world.hash());
        for (const auto walk : walks)
            if (world.contains(walk)) CHECK(loaded.walking(walk).left == world.walking(walk).left);
        const auto before = world.hash();
        for (const auto walk : walks)
            if (world.contains(walk)) {
                world.halt(walk, !world.walking(walk).halting);
                CHECK(world.hash() != before);
                break;
            }
    }
}

TEST_CASE("a walk ends with its body, and one that is there already has arrived", "[walking]") {
    Simple world;
    const auto one = world.add(position(metres(0, 0, 0))), other = world.add(position(metres(5, 0, 0)));
    const auto walk = world.add(walk_of(one, {{metres(9, 0, 0)}}, 1, 1));
    const auto here = world.add(walk_of(other, {{metres(5, 0, 0)}}, 1, 1));
    world.step(0.1 * second);
    CHECK(count(world, WalkNews::arrived) == 1);
    CHECK(world.walking(here).arrived);
    CHECK(world.position(other).value() == Eigen::Vector3d(5, 0, 0));
    CHECK(world.walking(here).left.value() == 0);
    world.remove(one);
    CHECK(!world.contains(walk));
    CHECK_THROWS_AS(world.walking(walk), std::out_of_range);
    CHECK_THROWS_AS(world.halt(walk), std::out_of_range);
    world.step(0.1 * second);
}

TEST_CASE("a body has one walk at a time: another is refused, whatever came, went and was loaded", "[walking]") {
    std::mt19937 random(23);
    const std::string twice = "Walk: body is one that has a walk; a body follows one at a time; set this one for the "
                              "handle of the other, or remove that";
    Simple world;
    std::vector<Handle> bodies;
    std::vector<std::pair<ElementHandle<Walk>, std::size_t>> walks; // with the body, by its place in the list
    const auto walker = [&](std::size_t k) {
        for (const auto& walk : walks)
            if (walk.second == k) return std::optional(walk.first);
        return std::optional<ElementHandle<Walk>>();
    };
    int refused = 0, exchanged = 0, loads = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto path = random_path(random, 2, 5);
        const std::size_t k = bodies.empty() ? 0 : random() % bodies.size();
        const std::size_t w = walks.empty() ? 0 : random() % walks.size();
        const auto verb = random() % 16;
        const auto before = world.hash();
        if (bodies.size() < 3 || (verb == 0 && bodies.size() < 30))
            bodies.push_back(world.add(position(metres(i, 0, 0))));
        else if (verb < 6) { // another walk
            std::optional<ElementHandle<Walk>> added;
            const auto said = refusal([&] { added = world.add(walk_of(bodies[k], path, 1, 1)); });
            REQUIRE(said == (walker(k) ? twice : "nothing"));
            if (added) walks.emplace_back(*added, k);
            else REQUIRE(world.hash() == before);
            refused += !added;
        } else if (verb < 11 && !walks.empty()) { // a walk for somebody, the same or another
            const bool may = !walker(k) || *walker(k) == walks[w].first;
            const auto said = refusal([&] { world.set(walks[w].first, walk_of(bodies[k], path, 1, 1)); });
            REQUIRE(said == (may ? "nothing" : twice));
            if (may) exchanged += walks[w].second != k, walks[w].second = k;
            else REQUIRE(world.hash() == before);
        } else if (verb < 13 && !walks.empty()) {
            world.remove(walks[w].first);
            walks.erase(walks.begin() + std::ptrdiff_t(w));
        } else if (verb == 13) {
            world.remove(bodies[k]);
            std::erase_if(walks, [&](const auto& walk) { return walk.second == k; });
            bodies.erase(bodies.begin() + std::ptrdiff_t(k));
            for (auto& walk : walks) walk.second -= walk.second > k;
        } else if (verb == 14 && i % 5 == 0) {
            Simple loaded;
            load_text(loaded, text_of(world));
            REQUIRE(loaded.hash() == world.hash());
            world = loaded;
            ++loads;
        } else world.step(0.05 * second);
        for (std::size_t n = 0; n < bodies.size(); ++n) REQUIRE(world.walk_of(bodies[n]) == walker(n));
    }
    CHECK(refused > 100);
    CHECK(exchanged > 100);
    CHECK(loads > 10);
    CHECK_THROWS_AS(world.walk_of(Handle{}), std::out_of_range);

    Simple two;
    const auto one = two.add(position(metres(0, 0, 0))), other = two.add(position(metres(0, 1, 0)));
    two.add(walk_of(one, {{metres(1, 0)}}, 1, 1)), two.add(walk_of(other, {{metres(1, 1)}}, 1, 1));
    std::string text = text_of(two);
    const auto at = text.rfind("\"body\"");
    REQUIRE(at != std::string::npos);
    text.replace(text.find('1', at), 1, "0");
    CHECK_THAT(refusal([&] { load_text(two, text); }),
               ContainsSubstring("the walks: the number of walks of body 0 is 2; one at most"));
}

TEST_CASE("a walk that cannot be is refused in a sentence, and nothing is changed", "[walking]") {
    Simple world;
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto stone = world.add(position(metres(0, 1, 0)), fixed);
    const auto good = walk_of(body, {{metres(1, 0, 0)}, {metres(2, 0, 0)}}, 1, 1);
    const auto kept = world.add(good);
    const auto hash = world.hash();
    const auto says = [&](auto&& change) {
        Walk bad = good;
        change(bad);
        const std::string added = refusal([&] { world.add(bad); });
        CHECK(refusal([&] { world.set(kept, bad); }) == added);
        CHECK(world.hash() == hash);
        return added;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(says([](Walk& w) { w.speed = {}; }) == "Walk: speed is 0 m/s; it must be finite and greater than zero");
    CHECK_THAT(says([](Walk& w) { w.acceleration = -1.0 * metre / second / second; }),
               ContainsSubstring("Walk: acceleration is -1 m/s^2; it must be finite and greater than zero"));
    CHECK_THAT(says([](Walk& w) { w.astray = {}; }), ContainsSubstring("Walk: astray is 0 m; it must be"));
    CHECK_THAT(says([](Walk& w) { w.path.clear(); }),
               ContainsSubstring("Walk: path is empty; it must have one way point at least"));
    CHECK_THAT(says([](Walk& w) { w.path[1].place = w.path[0].place; }),
               ContainsSubstring("Walk: way point 1 is (1, 0, 0) m; it must lie elsewhere than the one before"));
    CHECK_THAT(says([&](Walk& w) { w.path[1].place = metres(0, nan, 0); }), ContainsSubstring("Walk: way point 1 is"));
    CHECK_THAT(says([&](Walk& w) { w.path[0].cut = -1.0 * metre; }),
               ContainsSubstring("Walk: the cut of way point 0 is -1 m; it must be finite and not negative"));
    CHECK_THAT(says([&](Walk& w) { w.body = stone; }), ContainsSubstring("a walker must be free to move"));
    CHECK_THAT(refusal([] { Simple w(Walkers{.patience = 0.0 * second}); }),
               ContainsSubstring("Walkers: patience is 0 s"));
    Flat flat;
    const auto other = flat.add(position(metres(0, 0)));
    CHECK_THAT(refusal([&] { flat.add(walk_of(other, {{metres(1, 0, 1)}}, 1, 1)); }),
               ContainsSubstring("this world has two dimensions, so its third component must be 0"));

    // And a file whose numbers do not belong together.
    std::string text = text_of(world);
    const auto at = text.find("\"leg\"");
    REQUIRE(at != std::string::npos);
    text.replace(text.find('1', at), 1, "9");
    Simple loaded;
    CHECK_THAT(refusal([&] { load_text(loaded, text); }), ContainsSubstring("a walk: leg is 9; from 1 to 2"));
}
