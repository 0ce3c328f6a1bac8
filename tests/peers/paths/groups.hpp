// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Scenes of chapter 6 that have no other library to be held against: what is held against each other are ways to do
/// it. Many walkers to one goal, the tick of a crowd, estimates that are not consistent, weights, and gates.

#include "tests/peers/contest.hpp"

#include <ansatz/paths.hpp>
#include <ansatz/paths/walking.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace peers {

using namespace ansatz;
using namespace ansatz::paths;

/// Ends the program where two ways to do one thing do not agree.
inline void require_equal(const char* what, double a, double b) {
    if (std::abs(a - b) <= 1e-9 * std::abs(a)) return;
    std::cerr << what << " are " << a << " and " << b << "; their times mean nothing\n";
    std::exit(1);
}
/// Tiles from which there is a way to the goal.
inline std::vector<Cell> walkers_on(const Grid<>& map, Cell goal, std::size_t count, std::mt19937& random) {
    FlowField field{map, Buckets{}};
    field.aim(goal);
    std::vector<Cell> all;
    while (all.size() < count) {
        const Cell at{std::uint16_t(random() % map.width()), std::uint16_t(random() % map.height())};
        if (field.reaches(at) && !(at == goal)) all.push_back(at);
    }
    return all;
}
/// A thousand to one goal: a search each, or a field for all, with the path of each read from it.
inline void to_one_goal(Contest& contest, const std::string& name, const Grid<>& map, Cell goal, std::mt19937& random) {
    const auto starts = walkers_on(map, goal, 1000, random);
    AStar heap{map};
    AStar buckets{map, Buckets{}};
    FlowField field{map, Buckets{}};
    std::vector<Cell> path;
    double by_search = 0, by_field = 0;
    const auto searches = [&](auto& search) {
        by_search = 0;
        for (const Cell start : starts) {
            search.find(start, goal);
            by_search += double(search.cost());
        }
    };
    const auto fields = [&] {
        field.aim(goal);
        by_field = 0;
        for (const Cell start : starts) {
            field.path(start, path);
            by_field += double(field.cost(start));
        }
    };
    searches(buckets), fields();
    require_equal("the costs of all by searches and by a field", by_search, by_field);
    contest.play("1000 walkers to one goal, " + name, 1000, "ms for all", 1e6,
                 {{"ansatz search each, heap", [&] { searches(heap); }},
                  {"ansatz search each, bucket", [&] { searches(buckets); }},
                  {"ansatz field", fields, "with the path of each"}});
}
/// What a tick costs a walker: on the tiles of a field, and as a body of a world that follows its way.
inline void tick(Contest& contest, const Grid<>& map, Cell goal, std::mt19937& random) {
    const auto starts = walkers_on(map, goal, 1000, random);
    FlowField field{map, Buckets{}};
    field.aim(goal);
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Walkers{}};
    std::vector<Cell> path;
    for (const Cell start : starts) {
        field.path(start, path);
        const auto body = world.add(position(map.position(start)));
        world.add(Walk{.body = body,
                       .path = way_points(map, path, 0.3 * metre),
                       .speed = 2.0 * metre / second,
                       .acceleration = 4.0 * metre / second / second,
                       .up = {},
                       .astray = 0.5 * metre});
    }
    World bare{Space<double, 2>{}, SemiImplicitEuler{}};
    for (const Cell start : starts) bare.add(position(map.position(start)), velocity(metres_per_second(0.1, 0)));
    constexpr int ticks = 60;
    auto at = starts;
    const auto steps = [](auto& w) {
        return [&w] {
            for (int i = 0; i < ticks; ++i) w.step(1.0 / 60 * second);
        };
    };
    contest.play("a tick of a crowd", 1000, "ns a walker", 1000.0 * ticks,
                 {{"ansatz field, tile to tile",
                   [&] {
                       at = starts;
                       for (int i = 0; i < ticks; ++i)
                           for (Cell& c : at) c = field.next(c);
                   }},
                  {"ansatz walkers", steps(world), "bodies on ways with corners"},
                  {"ansatz world without walkers", steps(bare), "what a body costs anyway"}});
}
/// An estimate that is never too much and jumps from tile to tile, on larger and larger maps.
inline void inconsistent(Contest& contest) {
    for (const std::size_t side : {128, 256}) {
        std::mt19937 random(3);
        Grid map(side, side);
        std::vector<std::uint8_t> free(map.size());
        for (auto& f : free) f = random() % 5 != 0;
        map.set_passable(free);
        const auto jumps = By{[](Cell v, Cell goal) {
            const std::uint32_t noise = (v.x * 2654435761u ^ v.y * 2246822519u) >> 30; // 0 to 3
            return Octile::of<std::uint32_t>(ansatz::paths::detail::Apart(v, goal), 33461, 47321) / 4 * (1 + noise);
        }};
        AStar heap{map, jumps};
        AStar buckets{map, jumps, Buckets{}};
        const Cell goal{std::uint16_t(side - 2), std::uint16_t(side - 2)};
        const auto starts = walkers_on(map, goal, 10, random);
        double a = 0, b = 0;
        const auto find = [&](auto& search, double& sum) {
            sum = 0;
            for (const Cell start : starts) search.find(start, goal), sum += double(search.cost());
        };
        find(heap, a), find(buckets, b);
        require_equal("the costs with a heap and with buckets", a, b);
        contest.play("an inconsistent estimate, by the map's side", int(side), "us a query", 1e3 * 10,
                     {{"ansatz heap", [&] { find(heap, a); }, std::to_string(heap.expanded()) + " nodes the last"},
                      {"ansatz bucket", [&] { find(buckets, b); }, std::to_string(buckets.expanded()) + " nodes"}});
    }
}
/// The same map with and without weights, all of them 1.
inline void weights(Contest& contest, const std::string& name, const Grid<>& map, Cell goal, std::mt19937& random) {
    Grid<Eight<>, Terrain> uneven(map.width(), map.height());
    std::vector<std::uint8_t> free(map.size());
    for (std::size_t i = 0; i < free.size(); ++i)
        free[i] = map.passable({std::uint16_t(i % map.width()), std::uint16_t(i / map.width())});
    uneven.set_passable(free);
    const auto starts = walkers_on(map, goal, 20, random);
    AStar even_heap{map};
    AStar uneven_heap{uneven};
    AStar even_buckets{map, Buckets{}};
    AStar uneven_buckets{uneven, Buckets{}};
    double sums[4]{};
    const auto find = [&](auto& search, double& sum) {
        return [&] {
            sum = 0;
            for (const Cell start : starts) search.find(start, goal), sum += double(search.cost());
        };
    };
    find(even_heap, sums[0])(), find(uneven_heap, sums[1])();
    require_equal("the costs on even ground and with weights of 1", sums[0], sums[1]);
    contest.play("weights of 1, " + name, 20, "us a query", 1e3 * 20,
                 {{"ansatz heap, even", find(even_heap, sums[0])},
                  {"ansatz heap, Terrain", find(uneven_heap, sums[1])},
                  {"ansatz bucket, even", find(even_buckets, sums[2])},
                  {"ansatz bucket, Terrain", find(uneven_buckets, sums[3])}});
}
/// The longest tenth of a map's scenarios, from gate to gate and on the tiles.
inline void gates(Contest& contest, const std::string& name, const Grid<>& map, std::vector<Scenario> all) {
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.length < b.length; });
    std::vector<Scenario> longest;
    const std::size_t tenth = all.size() / 10;
    for (std::size_t k = all.size() - tenth; k < all.size(); k += std::max<std::size_t>(1, tenth / 20))
        longest.push_back(all[k]);
    GateSearch search{map};
    AStar heap{map};
    AStar buckets{map, Buckets{}};
    double worst = 0;
    for (const auto& s : longest) {
        search.find(s.start, s.goal);
        worst = std::max(worst, search.cost() / s.length - 1);
    }
    const auto find = [&](auto& one) {
        return [&] {
            for (const auto& s : longest) one.find(s.start, s.goal);
        };
    };
    contest.play("longest tenth, " + name, int(longest.size()), "us a query", 1e3 * double(longest.size()),
                 {{"ansatz hierarchy", find(search), "up to " + std::to_string(100 * worst) + " % longer"},
                  {"ansatz heap", find(heap)},
                  {"ansatz bucket", find(buckets)}});
}

} // namespace peers
