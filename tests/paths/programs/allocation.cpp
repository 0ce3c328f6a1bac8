// SPDX-License-Identifier: BSL-1.0
// Warm searches, a route, a planner and a world of walkers. The script of this name says what it shows.
#include <ansatz/paths.hpp>
#include <ansatz/paths/walking.hpp>
#include <ansatz/world.hpp>

#include <boost/graph/adjacency_list.hpp>

#include "tests/operator_new.hpp"
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

/// While this holds, an allocation ends the program.
static bool forbidden = false;
static bool allowed(std::size_t) noexcept {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    return true;
}

using namespace ansatz;
using namespace ansatz::paths;

template <class Work> void twice(const char* name, Work work) {
    work();
    forbidden = true;
    work();
    forbidden = false;
    std::printf("%s: nothing allocated\n", name);
}

int main() {
    test::before_allocation = allowed;
    Grid<Eight<>, Terrain> map(60, 60);
    for (std::uint16_t y = 0; y < 50; ++y) map.set_passable(Cell{30, y}, false);
    map.set_weight(Cell{20, 20}, 7);
    auto cross = [&](auto& search) {
        return [&] {
            for (std::uint16_t y = 0; y < 60; y += 7) {
                if (search.find(Cell{2, y}, Cell{58, std::uint16_t(59 - y)}) != Outcome::found) std::exit(2);
                search.begin(Cell{2, y}, Cell{58, y});
                while (search.advance(13) == Outcome::running) {
                }
                search.find(Cell{2, y}, Cell{58, y}, 20);
            }
        };
    };
    AStar heap{map};
    AStar buckets{map, Buckets{}};
    AStar doubles{map, CostIn<double>{}, Maximum{Weighted{Octile{}, 1.0}, Euclid{}}, Buckets{}};
    twice("Heap", cross(heap));
    twice("Buckets", cross(buckets));
    twice("CostIn<double>, Maximum", cross(doubles));

    AStar nearest{map, AnyGoal{}};
    const std::vector<Cell> starts{{2, 2}, {2, 50}}, goals{{58, 2}, {58, 30}, {50, 58}};
    twice("AnyGoal, several starts", [&] {
        if (nearest.find(starts, goals) != Outcome::found) std::exit(2);
        if (nearest.find(starts[0], std::span(goals).first(2)) != Outcome::found) std::exit(2);
    });
    FlowField field{map, Buckets{}};
    std::vector<Cell> way;
    twice("FlowField", [&] {
        if (field.aim(goals) != Outcome::found || field.aim(starts) != Outcome::found) std::exit(2);
        field.path(Cell{58, 2}, way);
    });

    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                        boost::property<boost::edge_weight_t, int>>;
    Graph graph(100);
    for (int i = 0; i < 400; ++i) boost::add_edge(i % 100, (i * 37 + 11) % 100, i % 9, graph);
    AStar roads{graph, By{[](std::size_t v) { return int(v % 3); }}}; // inconsistent
    twice("adjacency_list", [&] {
        for (std::size_t v = 0; v < 100; ++v) roads.find(0, v);
    });

    Route route{heap};
    twice("Route", [&] {
        route.go(Cell{2, 2}, Cell{58, 2});
        for (int i = 0; i < 40; ++i) {
            route.step();
            map.set_passable(route.next(), false);
            route.renew();
            map.set_passable(Cell{40, 40}, true);
        }
        for (std::uint16_t x = 0; x < 30; ++x)
            for (std::uint16_t y = 0; y < 60; ++y) map.set_passable(Cell{x, y}, true);
    });

    goap::Domain<> domain;
    for (int i = 0; i < 12; ++i)
        domain.action("a" + std::to_string(i), 1 + i % 3).makes(domain.fact("f" + std::to_string(i)));
    goap::Planner planner{domain};
    goap::Condition<> goal;
    goal.care.bits[0] = goal.value.bits[0] = 0xfff;
    twice("Planner", [&] {
        if (planner.plan({}, goal) != Outcome::found) std::exit(2);
    });

    World world{Space<double, 2>{}, SemiImplicitEuler{}, Walkers{}};
    for (int i = 0; i < 3; ++i)
        world.add(Walk{.body = world.add(position(metres(0, i))),
                       .path = {{metres(5 + i, i), 1.0 * metre}, {metres(5, 7 + i), 0.0 * metre}, {metres(0, 9)}},
                       .speed = 2.0 * metre / second,
                       .acceleration = 3.0 * metre / second / second,
                       .up = {},
                       .astray = 0.5 * metre});
    world.step(0.1 * second);
    forbidden = true;
    for (int i = 0; i < 200; ++i) world.step(0.1 * second); // past way points, and at rest
    forbidden = false;
    std::puts("Walkers: nothing allocated");
}
