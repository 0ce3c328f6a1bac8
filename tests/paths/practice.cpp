// SPDX-License-Identifier: BSL-1.0
// Walking a path: searching again only when needed, groups, straight lines (notes 6.3).

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/dimacs.hpp>
#include <ansatz/paths/formation.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/heuristics/checked.hpp>
#include <ansatz/paths/heuristics/landmarks.hpp>
#include <ansatz/paths/heuristics/maximum.hpp>
#include <ansatz/paths/route.hpp>
#include <ansatz/paths/smoothing.hpp>
#include <ansatz/paths/waypoints.hpp>

#include <limits>
#include <sstream>

using namespace paths_tests;

TEST_CASE("a path is searched again when its rest is touched, and not for anything else", "[paths]") {
    auto map = grid_from<Grid<Four, Terrain>>({".....", ".....", "....."});
    AStar search{map};
    Route route{search};
    CHECK_FALSE(route.needs_new_path());
    CHECK(route.go(Cell{0, 0}, Cell{4, 0}) == Outcome::found);
    CHECK(route.searches() == 1);
    const std::vector<Cell> straight(route.ahead().begin(), route.ahead().end());
    CHECK(straight.size() == 5);
    const Cell first = route.next();
    CHECK(route.step() == first);
    map.set_passable(straight[0], false); // behind
    CHECK_FALSE(route.renew());
    map.set_passable(Cell{2, 2}, false); // elsewhere
    map.set_weight(Cell{3, 2}, 5);
    CHECK_FALSE(route.renew());
    map.set_weight(Cell{4, 2}, 0.5); // cheaper, elsewhere
    CHECK_FALSE(route.renew());
    CHECK(route.searches() == 1);
    map.set_weight(straight[3], 9); // ahead, dearer
    CHECK(route.needs_new_path());
    CHECK(route.renew());
    CHECK(route.searches() == 2);
    CHECK(route.here() == first);
    CHECK_FALSE(route.renew());                             // once for each change
    map.set_wall(route.ahead()[0], route.ahead()[1], true); // an edge ahead
    CHECK(route.renew());
    while (!route.arrived()) route.step();
    CHECK(route.here() == Cell{4, 0});
    CHECK(route.step() == Cell{4, 0});
    CHECK_FALSE(route.renew());
    // A start that is not on the map leaves the walker where it is.
    CHECK(route.go(route.here(), Cell{0, 2}) == Outcome::found);
    const Cell next = route.next();
    CHECK_THAT(test::refusal([&] { route.go(Cell{9, 9}, Cell{0, 2}); }), ContainsSubstring("start is (9, 9)"));
    CHECK_THAT(test::refusal([&] { route.go(Cell{0, 0}, Cell{9, 9}); }), ContainsSubstring("goal is (9, 9)"));
    CHECK(route.here() == Cell{4, 0});
    CHECK(route.next() == next);
    map.set_passable(next, false);
    CHECK(route.renew());
    while (!route.arrived()) route.step();
    CHECK(route.here() == Cell{0, 2});
}

TEST_CASE("by choice it is searched again when anything got cheaper, and an unreachable goal when something opens",
          "[paths]") {
    auto map = grid_from<Grid<Four>>({".#.", ".#.", "..."});
    AStar search{map, Buckets{}};
    Route thrifty{search, Replan::also_when_cheaper};
    Route content{search};
    thrifty.go(Cell{0, 0}, Cell{2, 0});
    content.go(Cell{0, 0}, Cell{2, 0});
    CHECK(thrifty.ahead().size() == 7);
    map.set_passable(Cell{1, 0}, true); // a short cut
    CHECK_FALSE(content.renew());
    CHECK(content.ahead().size() == 7); // still a path, no longer the best
    CHECK(thrifty.renew());
    CHECK(thrifty.ahead().size() == 3);
    map.set_passable(Cell{1, 0}, false);
    map.set_passable(Cell{1, 2}, false);
    CHECK(content.renew());
    CHECK(content.outcome() == Outcome::no_path);
    map.set_passable(Cell{2, 1}, false);
    CHECK_FALSE(content.renew()); // nothing has opened
    map.set_passable(Cell{1, 2}, true);
    CHECK(content.renew());
    CHECK(content.outcome() == Outcome::no_path);

    Waypoints<> ways; // the same on another graph
    for (int x = 0; x < 3; ++x) ways.add(metres(x, 0, 0));
    const auto one = ways.connect(0, 1), other = ways.connect(1, 2);
    ways.connect(0, 2, 5.0 * metre);
    AStar among{ways};
    Route walk{among};
    walk.go(0, 2);
    CHECK(walk.step() == 1);
    ways.set_road_passable(one, false);
    CHECK_FALSE(walk.renew());
    ways.set_length(other, 3.0 * metre);
    CHECK(walk.renew());
    CHECK(walk.outcome() == Outcome::found);
}

TEST_CASE("a walker that renews always walks a path that is there, through random changes", "[paths]") {
    std::mt19937 random(12);
    int arrived = 0, spared = 0;
    for (int k = 0; k < 60; ++k) {
        auto map = random_map(random, 24, 24, 0.2);
        const Cell a = random_cell(random, 24, 24), b = random_cell(random, 24, 24);
        AStar search{map};
        Route route{search};
        if (route.go(a, b) != Outcome::found) continue;
        for (int step = 0; step < 200 && !route.arrived(); ++step) {
            const Cell c = random_cell(random, 24, 24);
            if (c != route.here() && c != b) map.set_passable(c, false), spared += 1;
            spared -= route.renew();
            if (route.outcome() != Outcome::found) break;
            const Cell from = route.here(), to = route.step();
            REQUIRE((from == to || map.passable(from, to)));
        }
        arrived += route.arrived();
    }
    CHECK(arrived > 20);
    CHECK(spared > 100); // most changes needed no search
}

TEST_CASE("a group: one search, everybody at an offset, who has no place is told", "[paths]") {
    const auto map = grid_from<Grid<>>({".....", "..#..", "....."});
    const Formation squad({{0, 0}, {-1, 0}, {0, 1}, {2, 0}});
    const auto open = squad.at(map, Cell{1, 0});
    CHECK(open[0].cell == Cell{1, 0});
    CHECK(open[1].cell == Cell{0, 0});
    CHECK(open[2].cell == Cell{1, 1});
    CHECK(open[3].cell == Cell{3, 0});
    for (const auto& slot : open) CHECK_FALSE(slot.blocked);
    const auto tight = squad.at(map, Cell{2, 0});
    CHECK(tight[2].blocked); // a wall
    CHECK(tight[2].cell == Cell{2, 0});
    CHECK_FALSE(tight[3].blocked);
    CHECK(squad.at(map, Cell{0, 0})[1].blocked);               // outside
    CHECK(Formation({{2, 0}}).at(map, Cell{1, 1})[0].blocked); // free, but behind the wall
    const auto [group, centre] = Formation::around_centre({{0, 0}, {2, 0}, {1, 2}, {1, 2}});
    CHECK(centre == Cell{1, 1});
    CHECK(group.offsets() == std::vector<Offset>{{-1, -1}, {1, -1}, {0, 1}, {0, 1}});
    CHECK_THAT(test::refusal([] { Formation::around_centre({}); }), ContainsSubstring("the number of members is 0"));
}

TEST_CASE("straight lines: seen both ways alike, walkable, never longer than the path", "[paths]") {
    const auto map = grid_from<Grid<>>({".....", "..#..", "....."});
    CHECK(line_of_sight(map, Cell{0, 0}, Cell{4, 0}));
    CHECK_FALSE(line_of_sight(map, Cell{0, 1}, Cell{4, 1}));
    CHECK_FALSE(line_of_sight(map, Cell{1, 0}, Cell{3, 2})); // through the wall
    CHECK_FALSE(line_of_sight(map, Cell{2, 0}, Cell{3, 1})); // past its corner: both must be free
    CHECK(line_of_sight(map, Cell{1, 1}, Cell{1, 1}));
    std::mt19937 random(13);
    int shorter = 0;
    for (int k = 0; k < 200; ++k) {
        const auto walls = random_map(random, 32, 32, 0.15);
        const Cell a = random_cell(random, 32, 32), b = random_cell(random, 32, 32);
        CHECK(line_of_sight(walls, a, b) == line_of_sight(walls, b, a));
        AStar search{walls};
        if (search.find(a, b) != Outcome::found) continue;
        const auto corners = smooth(walls, search.path());
        REQUIRE(corners.front() == a);
        REQUIRE(corners.back() == b);
        for (std::size_t i = 1; i < corners.size(); ++i) REQUIRE(line_of_sight(walls, corners[i - 1], corners[i]));
        REQUIRE(straight_tiles(corners) <= walls.tiles(search.path()) + 1e-9);
        shorter += straight_tiles(corners) < walls.tiles(search.path()) - 1e-6;
    }
    CHECK(shorter > 50);
    // On uneven ground a line does not leave the road that was found.
    auto mud = grid_from<Grid<Eight<>, Terrain>>({"1999", "1119", "9911"});
    AStar search{mud};
    REQUIRE(search.find(Cell{0, 0}, Cell{3, 2}) == Outcome::found);
    for (const Cell c : smooth(mud, search.path())) CHECK(mud.weight(c) == 1);
    CHECK(smooth(mud, {}).empty());
}

TEMPLATE_TEST_CASE("landmarks are never too much, help where the straight line misleads, and stay right", "[paths]",
                   std::uint32_t, double) {
    std::mt19937 random(31);
    std::size_t plain = 0, helped = 0;
    for (int k = 0; k < 15; ++k) {
        auto map = random_map<Grid<Eight<>, Terrain>>(random, 24, 24, 0.3);
        for (int i = 0; i < 100; ++i) map.set_weight(random_cell(random, 24, 24), 0.5 * double(1 + random() % 6));
        const Landmarks<TestType> marks(map, 6);
        CHECK(marks.count() == 6);
        AStar octile{map, CostIn<TestType>{}};
        AStar by_marks{map, CostIn<TestType>{}, Maximum{Octile{}, marks}};
        const Cell a = random_cell(random, 24, 24), b = random_cell(random, 24, 24);
        REQUIRE_FALSE(check_heuristic<TestType>(map, marks, b));
        REQUIRE(octile.find(a, b) == by_marks.find(a, b));
        if (octile.outcome() != Outcome::found) continue;
        REQUIRE(double(by_marks.cost()) == Approx(double(octile.cost())).epsilon(1e-12));
        plain += octile.expanded(), helped += by_marks.expanded();
        map.set_weight(by_marks.path()[by_marks.path().size() / 2],
                       0); // cheaper: the tables are out of date, and say nothing
        REQUIRE_FALSE(check_heuristic<TestType>(map, marks, b));
    }
    CHECK(2 * helped < plain);
    Roads roads(3); // of a graph that has grown since they say nothing
    boost::add_edge(0, 1, 1, roads), boost::add_edge(1, 2, 1, roads);
    const Landmarks<int> before(roads, 2);
    for (std::size_t v = 3; v < 100; ++v) boost::add_edge(v - 1, v, 1, roads);
    REQUIRE_FALSE(check_heuristic<int>(roads, before, std::size_t(99)));
    CHECK_THAT(test::refusal([] { Landmarks<>(Grid(2, 2), 5); }), ContainsSubstring("Landmarks: their number is 5"));
}

TEST_CASE("road maps of DIMACS: read, searched with landmarks, refused with their line", "[paths]") {
    auto read = [](const std::string& text) {
        std::istringstream in(text);
        return read_dimacs(in, "small.gr");
    };
    std::mt19937 random(32);
    std::string text = "c a map at random\np sp 60 240\n";
    for (int i = 0; i < 240; ++i)
        text += "a " + std::to_string(1 + random() % 60) + " " + std::to_string(1 + random() % 60) + " " +
                std::to_string(random() % 50) + "\n";
    const auto roads = read(text);
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                        boost::property<boost::edge_weight_t, std::uint32_t>>;
    const auto g = roads.graph<Graph>();
    CHECK(num_vertices(g) == 60);
    CHECK(num_edges(g) == 240);
    AStar search{g, Landmarks<std::uint32_t>(g, 4)};
    for (std::size_t v = 0; v < 60; ++v) {
        const auto best = true_costs<std::uint32_t>(g, v)[0];
        REQUIRE((search.find(0, v) == Outcome::found) == (best != std::numeric_limits<std::uint32_t>::max()));
        REQUIRE(search.cost() == best);
    }
    auto refused = [&](const std::string& bad) { return test::refusal([&] { read(bad); }); };
    CHECK_THAT(refused(""), ContainsSubstring("small.gr:0: the file ends; expected \"p sp"));
    CHECK_THAT(refused("a 1 2 3\n"), ContainsSubstring("small.gr:1: \"a 1 2 3\"; expected \"p sp"));
    CHECK_THAT(refused("p sp 2 1\na 1 3 3\n"),
               ContainsSubstring("small.gr:2: an arc from 1 to 3; expected vertices from 1 to 2"));
    CHECK_THAT(refused("p sp 2 1\na 1 2 -3\n"), ContainsSubstring("none negative"));
    CHECK_THAT(refused("p sp 2 2\na 1 2 3\n"), ContainsSubstring("the file ends with 1 arcs; expected 2"));
}
