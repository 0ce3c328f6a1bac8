// SPDX-License-Identifier: BSL-1.0
// Paths of any angle: through no wall, never shorter than the best by brute force, never longer than the smoothed path,
// on random maps and on the shared ones.
// Runs long with the sanitizers.

#include <ansatz/paths/any_angle.hpp>
#include <ansatz/paths/lazy_theta.hpp>

#include <ansatz/paths.hpp>

#include "tests/paths/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace paths_tests;
using namespace ansatz::test;

namespace {

/// The shortest path of any angle between centres of tiles: all tiles that see each other are neighbours.
template <class Map> double shortest_of_any_angle(const Map& map, Cell start, Cell goal) {
    const std::size_t n = map.size(), w = map.width();
    std::vector<double> best(n, std::numeric_limits<double>::infinity());
    std::vector<bool> done(n, false);
    best[map.index(start)] = 0;
    for (;;) {
        std::size_t p = n;
        for (std::size_t i = 0; i < n; ++i)
            if (!done[i] && best[i] < std::numeric_limits<double>::infinity() && (p == n || best[i] < best[p])) p = i;
        if (p == n) return best[map.index(goal)];
        done[p] = true;
        const Cell a{std::uint16_t(p % w), std::uint16_t(p / w)};
        if (a == goal) return best[p];
        for (std::size_t i = 0; i < n; ++i) {
            const Cell b{std::uint16_t(i % w), std::uint16_t(i / w)};
            if (!done[i] && line_of_sight(map, a, b))
                best[i] = std::min(best[i], best[p] + std::hypot(double(a.x) - b.x, double(a.y) - b.y));
        }
    }
}
/// Whether a walk along these corners is outside of all walls, tested place by place.
template <class Map> bool keeps_out_of_walls(const Map& map, std::span<const Cell> corners) {
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const double dx = double(corners[i].x) - corners[i - 1].x, dy = double(corners[i].y) - corners[i - 1].y;
        const int parts = 1 + int(20 * std::hypot(dx, dy));
        for (int k = 0; k <= parts; ++k) {
            const double x = corners[i - 1].x + 0.5 + dx * k / parts, y = corners[i - 1].y + 0.5 + dy * k / parts;
            const double fx = x - std::floor(x), fy = y - std::floor(y);
            if (fx < 1e-6 || fy < 1e-6 || fx > 1 - 1e-6 || fy > 1 - 1e-6) continue; // between tiles
            if (!map.passable(Cell{std::uint16_t(x), std::uint16_t(y)})) return false;
        }
    }
    return true;
}

/// How often which path is the shorter, and by how much than the best along the tiles.
struct Shares {
    int paths = 0, theta_shorter = 0, smooth_shorter = 0;
    double along = 0, smoothed = 0, theta = 0, best = 0, most = 0;
    void add(double tiles, double by_smoothing, double by_theta, double shorter) {
        if (!(tiles > 0)) return;
        ++paths;
        theta_shorter += by_theta < by_smoothing * (1 - 1e-9), smooth_shorter += by_smoothing < by_theta * (1 - 1e-9);
        along += tiles, smoothed += by_smoothing, theta += by_theta, best += shorter;
        most = std::max(most, by_theta / by_smoothing - 1);
    }
    void print(const std::string& map) const {
        std::printf("| %s | %d | %.1f, %.1f | %.2f | %.2f | %.2f | %.1f |\n", map.c_str(), paths,
                    100.0 * theta_shorter / paths, 100.0 * smooth_shorter / paths, 100 * (1 - smoothed / along),
                    100 * (1 - theta / along), 100 * (1 - best / along), 100 * most);
    }
};

} // namespace

TEMPLATE_TEST_CASE("a path of any angle lies between the best and the smoothed one", "[any angle]", Grid<>,
                   Grid<Eight<NoneFree>>, Grid<Four>) {
    std::mt19937 random(61);
    int found = 0, shorter = 0, best = 0;
    for (int i = 0; i < 250; ++i) {
        const auto map = random_map<TestType>(random, 14, 11, 0.25);
        AnyAngle search{map};
        const Cell start = random_cell(random, 14, 11), goal = random_cell(random, 14, 11);
        const Outcome outcome = search.find(start, goal);
        CHECK(search.theta().outcome() == outcome);
        if (outcome != Outcome::found) {
            CHECK(search.path().empty());
            continue;
        }
        ++found;
        const auto path = search.path();
        REQUIRE(path.front() == start);
        REQUIRE(path.back() == goal);
        const auto theta = search.theta().path();
        for (std::size_t k = 1; k < theta.size(); ++k) CHECK(line_of_sight(map, theta[k - 1], theta[k]));
        CHECK(keeps_out_of_walls(map, theta));
        CHECK(search.theta().cost() == Approx(straight_tiles(theta)).margin(1e-12));
        const double least = shortest_of_any_angle(map, start, goal);
        CHECK(search.tiles() >= least * (1 - 1e-12));
        CHECK(straight_tiles(theta) >= least * (1 - 1e-12));
        CHECK(search.tiles() <= straight_tiles(smooth(map, search.a_star().path())));
        CHECK(search.tiles() <= straight_tiles(theta));
        CHECK(search.tiles() <= map.tiles(search.a_star().path()) * (1 + 1e-12));
        shorter += search.by_theta();
        best += search.tiles() <= least * (1 + 1e-12);
    }
    CHECK(found > 100);
    CHECK(shorter > 0);
    CHECK(best > found / 3);
}

TEST_CASE("on an open field it is the straight line, in one turn", "[any angle]") {
    const Grid<> map(40, 30);
    AStar search{map, LazyTheta{}};
    REQUIRE(search.find(Cell{2, 3}, Cell{37, 20}) == Outcome::found);
    CHECK(search.path().size() == 2);
    CHECK(search.cost() == std::hypot(35.0, 17.0));
    REQUIRE(search.find(Cell{4, 4}, Cell{4, 4}) == Outcome::found);
    CHECK(search.path().size() == 1);
    CHECK(search.cost() == 0);
}

TEST_CASE("thin walls and drops hold it, too, and slices and several goals are the same search", "[any angle]") {
    std::mt19937 random(67);
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        auto map = random_map(random, 12, 12, 0.1);
        for (int k = 0; k < 40; ++k) {
            const Cell c = random_cell(random, 11, 11);
            map.set_passable(c, Cell{std::uint16_t(c.x + 1), std::uint16_t(c.y + random() % 2)}, false);
        }
        AStar search{map, LazyTheta{}};
        const Cell start = random_cell(random, 12, 12), goal = random_cell(random, 12, 12);
        AStar along{map};
        const Outcome outcome = search.find(start, goal);
        CHECK(outcome == along.find(start, goal));
        if (outcome != Outcome::found) continue;
        ++found;
        const std::vector<Cell> whole(search.path().begin(), search.path().end());
        for (std::size_t k = 1; k < whole.size(); ++k) CHECK(line_of_sight(map, whole[k - 1], whole[k]));
        search.begin(start, goal);
        while (search.advance(3) == Outcome::running) {
        }
        CHECK(std::equal(whole.begin(), whole.end(), search.path().begin(), search.path().end()));
        AStar any{map, LazyTheta{}, AnyGoal{}};
        REQUIRE(any.find(start, std::vector<Cell>{goal, goal}) == Outcome::found);
        CHECK(any.cost() == search.cost());
    }
    CHECK(found > 100);
}

TEST_CASE("on the shared maps it is through no wall and never longer than the smoothed path", "[any angle]") {
    const auto folder = data_folder();
    if (folder.empty()) {
        WARN("the maps of MovingAI are not there; see docs/paths.md");
        return;
    }
    // Ten scenarios of each map; all of them, with a table, where ANSATZ_ALL_SCENARIOS is set: docs/paths.md shows it.
    const bool all = std::getenv("ANSATZ_ALL_SCENARIOS") != nullptr;
    std::mt19937 random(71);
    int maps = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/movingai")) {
        if (entry.path().extension() != ".map") continue;
        ++maps;
        const auto map = read_moving_ai_map(entry.path().string()).grid();
        AnyAngle search{map, Buckets{}};
        const auto scenarios = read_moving_ai_scenarios(entry.path().string() + ".scen");
        Shares shares;
        for (std::size_t i = 0; i < (all ? scenarios.size() : 10); ++i) {
            const auto& s = all ? scenarios[i] : scenarios[random() % scenarios.size()];
            INFO(entry.path().filename().string() << " line " << s.line);
            REQUIRE(search.find(s.start, s.goal) == Outcome::found);
            const auto theta = search.theta().path();
            for (std::size_t k = 1; k < theta.size(); ++k) REQUIRE(line_of_sight(map, theta[k - 1], theta[k]));
            CHECK(keeps_out_of_walls(map, search.path()));
            CHECK(search.tiles() <= straight_tiles(search.smoothed()));
            CHECK(search.tiles() <= s.length + s.tolerance); // the best along the tiles
            CHECK(search.tiles() >= std::hypot(double(s.start.x) - s.goal.x, double(s.start.y) - s.goal.y) - 1e-9);
            shares.add(s.length, straight_tiles(search.smoothed()), straight_tiles(theta), search.tiles());
        }
        if (all) shares.print(entry.path().stem().string());
    }
    CHECK(maps > 0);
}
