// SPDX-License-Identifier: BSL-1.0
// From the map to the body: room for discs by brute force, discs that touch no wall on the shared maps, and routes that
// are searched again when the notes' rule says so.
// Runs long with the sanitizers.

#include <ansatz/paths/walking/traveller.hpp>

#include <ansatz/paths.hpp>
#include <ansatz/paths/walking/clearance.hpp>
#include <ansatz/paths/walking/way_point.hpp>
#include <ansatz/world.hpp>

#include "tests/paths/support.hpp"
#include "tests/paths/walking/clearance_of.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

using namespace paths_tests;
using namespace ansatz::test;

namespace {

struct Plane : World<Space<double, 2>, SemiImplicitEuler, Walkers> {
    Plane() : World(Space<double, 2>{}, SemiImplicitEuler{}, Walkers{}) {}
};

Gait gait(double speed, double acceleration, double radius) {
    return {.speed = speed * metre / second,
            .acceleration = acceleration * metre / second / second,
            .radius = radius * metre,
            .up = {},
            .astray = 0.5 * metre};
}
template <class Map> auto place_of(const Map& map, Cell c) { return position(map.position(c)); }

} // namespace

namespace {

/// Walks a path of a map, and holds every place against the walls. \return the time over that of its profile
template <class Map>
double walked(const Map& map, const std::vector<WayPoint>& points, Cell start, double radius, double speed,
              double acceleration, double dt) {
    Plane world;
    const auto body = world.add(place_of(map, start));
    const double tile = map.tile().value();
    const auto walk = world.add(Walk{.body = body,
                                     .path = points,
                                     .speed = speed * metre / second,
                                     .acceleration = acceleration * metre / second / second,
                                     .up = {},
                                     .astray = 0.5 * metre});
    const double ideal = world.walking(walk).time_left.value();
    double time = 0;
    while (!world.walking(walk).arrived && time < 2 * ideal + 10 * dt) {
        world.step(dt * second);
        time += dt;
        const Eigen::Vector2d x = world.position(body).value() / tile;
        REQUIRE(clearance(map, x[0], x[1]) >= radius / tile - 1e-9);
        REQUIRE(!world.walking(walk).off);
    }
    REQUIRE(world.walking(walk).arrived);
    return (time - 2 * dt) / ideal;
}

} // namespace

TEST_CASE("a disc that walks touches no wall, on random maps, at any step", "[walking]") {
    std::mt19937 random(41);
    int walks = 0;
    for (int i = 0; i < 150; ++i) {
        const double radius = std::uniform_real_distribution<double>(0.05, 1.2)(random);
        const auto map = random_map(random, 20, 20, 0.12);
        const auto own = map_for(map, radius * metre);
        AStar search{own};
        const Cell start = random_cell(random, 20, 20), goal = random_cell(random, 20, 20);
        if (search.find(start, goal) != Outcome::found || start == goal) continue;
        ++walks;
        const auto points = way_points(map, search.path(), radius * metre);
        const double dt = std::array{0.01, 0.1, 1.0}[std::size_t(i) % 3];
        CHECK(walked(map, points, start, radius, 2, 1.5, dt) <= 1.01);
    }
    CHECK(walks > 40);
}

TEST_CASE("a disc that walks touches no wall of the shared maps", "[walking]") {
    const auto folder = data_folder();
    if (folder.empty()) {
        WARN("the maps of MovingAI are not there; see docs/paths.md");
        return;
    }
    std::mt19937 random(43);
    int maps = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/movingai")) {
        if (entry.path().extension() != ".map") continue;
        ++maps;
        const auto map = read_moving_ai_map(entry.path().string()).grid();
        AStar search{map, Buckets{}};
        const auto scenarios = read_moving_ai_scenarios(entry.path().string() + ".scen");
        for (int i = 0; i < 3; ++i) {
            const auto& s = scenarios[random() % scenarios.size()];
            if (search.find(s.start, s.goal) != Outcome::found || s.start == s.goal) continue;
            INFO(entry.path().filename().string() << " line " << s.line);
            const auto points = way_points(map, search.path(), 0.45 * metre);
            CHECK(walked(map, points, s.start, 0.45, 3, 4, 0.05) <= 1.01);
        }
    }
    CHECK(maps > 0);
}

TEST_CASE("a traveller searches again when what is ahead is blocked, and not else", "[walking]") {
    auto map = grid_from<Grid<>>({"............", ".##########.", ".#........#.", ".##########.", "............"});
    AStar search{map};
    Plane world;
    const auto body = world.add(place_of(map, Cell{0, 2}));
    Traveller fox{search, body, gait(2, 2, 0.4)};
    REQUIRE(fox.go(world, Cell{11, 2}));
    CHECK(fox.route().searches() == 1);
    const auto go_on = [&](double time) {
        int searched = 0;
        for (double t = 0; t < time; t += 0.05) {
            world.step(0.05 * second);
            searched += fox.update(world);
            const auto x = world.position(body).value();
            REQUIRE(clearance(map, x[0], x[1]) >= 0.4 - 1e-9);
        }
        return searched;
    };
    CHECK(go_on(2.5) == 0);
    const bool above = world.position(body).value()[1] < 2.5;
    map.set_passable(Cell{3, 2}, false); // elsewhere
    CHECK(go_on(0.5) == 0);
    CHECK(fox.route().searches() == 1);
    map.set_passable(Cell{9, std::uint16_t(above ? 0 : 4)}, false); // ahead
    CHECK(go_on(0.1) == 1);
    CHECK(fox.route().searches() == 2);
    CHECK(go_on(30) == 0);
    CHECK(fox.arrived(world));
    CHECK(norm(world.position(body) - map.position(Cell{11, 2})).value() < 1e-9);
    CHECK((above ? world.position(body).value()[1] : 0) == (above ? 2.5 : 0));

    // No way at all: it stops, and goes on when there is one again.
    REQUIRE(fox.go(world, Cell{0, 2}));
    CHECK(go_on(1) == 0);
    map.set_passable(Cell{3, std::uint16_t(above ? 4 : 0)}, false);
    CHECK(go_on(5) == 1);
    CHECK(fox.route().outcome() == Outcome::no_path);
    CHECK(world.velocity(body).value().norm() == 0);
    CHECK(go_on(1) == 0);
    map.set_passable(Cell{3, std::uint16_t(above ? 4 : 0)}, true);
    CHECK(go_on(40) >= 1);
    CHECK(fox.arrived(world));
}

TEST_CASE("a line that is walked is tested, too, where no tile of the path lies on it", "[walking]") {
    Grid<> map(20, 12);
    AStar search{map};
    Plane world;
    const auto body = world.add(place_of(map, Cell{0, 0}));
    Traveller fox{search, body, gait(2, 2, 0.4)};
    REQUIRE(fox.go(world, Cell{19, 8}));
    REQUIRE(fox.points().size() == 1); // straight
    for (int i = 0; i < 20; ++i) world.step(0.05 * second), fox.update(world);
    // A tile on the line that is none of the path's.
    Cell stone{};
    for (std::uint16_t x = 8; x < 19 && stone == Cell{}; ++x) {
        const Cell on{x, std::uint16_t((x + 0.5 - 0.5) * 8 / 19 + 0.5)};
        const auto ahead = fox.route().ahead();
        if (std::find(ahead.begin(), ahead.end(), on) == ahead.end()) stone = on;
    }
    REQUIRE(!(stone == Cell{}));
    map.set_passable(stone, false);
    world.step(0.05 * second);
    CHECK(fox.update(world));
    for (int i = 0; i < 600 && !fox.arrived(world); ++i) {
        world.step(0.05 * second);
        fox.update(world);
        const auto x = world.position(body).value();
        REQUIRE(clearance(map, x[0], x[1]) >= 0.4 - 1e-9);
    }
    CHECK(fox.arrived(world));
}

TEST_CASE("on maps that change while it walks a traveller touches nothing that it could know of", "[walking]") {
    std::mt19937 random(47);
    int arrived = 0, tried = 0;
    for (int i = 0; i < 60; ++i) {
        auto map = random_map(random, 24, 24, 0.1);
        AStar search{map};
        const Cell start = random_cell(random, 24, 24), goal = random_cell(random, 24, 24);
        if (search.find(start, goal) != Outcome::found) continue;
        ++tried;
        Plane world;
        const auto body = world.add(place_of(map, start));
        Traveller fox{search, body, gait(3, 4, 0.45), i % 2 == 0 ? Replan::when_touched : Replan::also_when_cheaper};
        REQUIRE(fox.go(world, goal));
        for (int k = 0; k < 1500 && !fox.arrived(world); ++k) {
            const auto at = world.position(body).value();
            const Cell c = random_cell(random, 24, 24);
            // Farther than it needs to stop, v^2/2a with turns in between; no other walker is asked to plan ahead.
            if (k % 20 == 0 && k < 400 && std::hypot(c.x + 0.5 - at[0], c.y + 0.5 - at[1]) > 6 && !(c == goal))
                map.set_passable(c, !map.passable(c));
            world.step(0.04 * second);
            fox.update(world);
            const auto x = world.position(body).value();
            REQUIRE(clearance(map, x[0], x[1]) >= 0.45 - 1e-9);
        }
        arrived += fox.arrived(world);
        if (!fox.arrived(world)) CHECK(search.find(map.cell_at(world.position(body)), goal) != Outcome::found);
    }
    CHECK(tried > 30);
    CHECK(arrived > 25);
}

TEST_CASE("pushed behind a wall a traveller finds its way back", "[walking]") {
    auto map = grid_from<Grid<>>({"......", ".####.", "......", ".####.", "......"});
    AStar search{map};
    World world{SemiImplicitEuler{}, Walkers{}};
    const auto body = world.add(position(metres(0.5, 7, 2.5)));
    auto how = gait(2, 2, 0.4);
    how.up = Eigen::Vector3d(0, 1, 0); // rows lie along z
    Traveller fox{search, body, how};
    REQUIRE(fox.go(world, Cell{5, 2}));
    for (int i = 0; i < 30; ++i) {
        world.step(0.05 * second);
        CHECK(!fox.update(world));
    }
    world.set_position(body, metres(2.5, 7, 0.5)); // thrown over the wall
    bool searched = false;
    for (int i = 0; i < 600 && !fox.arrived(world); ++i) {
        world.step(0.05 * second);
        searched = fox.update(world) || searched;
        const auto x = world.position(body).value();
        REQUIRE(clearance(map, x[0], x[2]) > 0.1); // it came at speed, and may slip, but through no wall
        CHECK(x[1] == 7);
    }
    CHECK(searched);
    CHECK(fox.arrived(world));
}

TEST_CASE("after a search in vain a traveller goes to the goal that was asked for last", "[walking]") {
    auto map = grid_from<Grid<>>({"......#.", "......##", "........"});
    AStar search{map};
    Plane world;
    const auto body = world.add(place_of(map, Cell{2, 0}));
    Traveller fox{search, body, gait(2, 2, 0.2)};
    const auto go_on = [&](double time) {
        for (double t = 0; t < time; t += 0.05) world.step(0.05 * second), fox.update(world);
    };
    REQUIRE(fox.go(world, Cell{0, 0}));
    go_on(0.3);
    REQUIRE(!fox.go(world, Cell{7, 0}));
    go_on(3);
    CHECK(world.velocity(body).value().norm() == 0);
    const auto halted = world.position(body);
    map.set_passable(Cell{3, 2}, false);
    map.set_passable(Cell{3, 2}, true); // freed, but it opens no way
    go_on(3);
    CHECK(norm(world.position(body) - halted).value() < 1e-9);
    CHECK(!fox.arrived(world));
    map.set_passable(Cell{7, 1}, true);
    go_on(15);
    CHECK(fox.arrived(world));
    CHECK(norm(world.position(body) - map.position(Cell{7, 0})).value() < 1e-9);
}

TEST_CASE("pushed off the map a traveller comes back, searches and arrives", "[walking]") {
    for (const double far : {-3.0, -1e12}) {
        Grid<> map(12, 3);
        AStar search{map};
        Plane world;
        const auto body = world.add(place_of(map, Cell{0, 1}));
        Traveller fox{search, body, gait(2, 2, 0.2)};
        REQUIRE(fox.go(world, Cell{11, 1}));
        for (int i = 0; i < 20; ++i) world.step(0.05 * second), fox.update(world);
        world.set_position(body, metres(4, far));
        for (int i = 0; i < 10; ++i) {
            world.step(0.05 * second);
            if (i == 5) map.set_passable(Cell{9, 1}, false); // ahead, while it is away
            CHECK(!fox.update(world));
        }
        CHECK(fox.route().searches() == 1);
        if (far < -3) continue; // that would take it some time
        for (int i = 0; i < 600 && !fox.arrived(world); ++i) world.step(0.05 * second), fox.update(world);
        CHECK(fox.route().searches() >= 2);
        CHECK(fox.arrived(world));
        CHECK(norm(world.position(body) - map.position(Cell{11, 1})).value() < 1e-9);
    }
}

TEST_CASE("what a traveller cannot do it says", "[walking]") {
    Grid<> map(4, 4);
    AStar search{map};
    Plane world;
    const auto body = world.add(position(metres(1, 1)));
    CHECK_THAT(refusal([&] {
                   Traveller{search, body, gait(0, 1, 0)};
               }),
               ContainsSubstring("Traveller: speed is 0 m/s; it must be finite and greater than zero"));
    CHECK_THAT(refusal([&] { Traveller{search, body, gait(1, 1, -1)}; }), ContainsSubstring("radius is -1 m"));
    auto tilted = gait(1, 1, 0);
    tilted.up = Eigen::Vector3d(1, 0, 0);
    CHECK_THAT(refusal([&] {
                   Traveller{search, body, tilted};
               }),
               ContainsSubstring("along the second or the third axis"));
    auto along_rows = gait(1, 1, 0);
    along_rows.up = Eigen::Vector3d(0, 1, 0);
    Traveller flat{search, body, along_rows};
    CHECK_THAT(refusal([&] {
                   flat.go(world, Cell{3, 3});
               }),
               ContainsSubstring("Traveller: up is (0, 1, 0)") && ContainsSubstring("in a world of two dimensions"));
    Traveller fox{search, body, gait(1, 1, 0)};
    CHECK_THROWS_AS(fox.go(world, Cell{9, 9}), std::invalid_argument);
    CHECK(!fox.arrived(world));
    REQUIRE(fox.go(world, Cell{3, 3}));
    Traveller second_one{search, body, gait(1, 1, 0)};
    const auto one_walk = world.hash();
    CHECK_THAT(refusal([&] {
                   second_one.go(world, Cell{0, 3});
               }),
               ContainsSubstring("Traveller: body is one that has a walk of somebody else; a body follows one at a"));
    CHECK(world.hash() == one_walk);
    CHECK(!second_one.update(world));
    world.remove(fox.walk());
    CHECK(second_one.go(world, Cell{0, 3}));
    world.remove(second_one.walk());
    REQUIRE(fox.go(world, Cell{3, 3}));
    world.set_position(body, metres(-5, 1));
    const auto hash = world.hash();
    CHECK_THROWS_AS(fox.go(world, Cell{0, 0}), std::invalid_argument);
    CHECK(world.hash() == hash);
}
