// SPDX-License-Identifier: BSL-1.0
// MovingAI's maps and scenarios: the lengths that they print, and what is wrong with a file.
// Compiled with optimisation: it finds some ten thousand ways through large maps.
// Runs long with the sanitizers.

#include "tests/paths/support.hpp"
#include "tests/rounds.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/jump_points.hpp>
#include <ansatz/paths/moving_ai.hpp>

#include <cmath>
#include <sstream>

using namespace paths_tests;

namespace {
/// Every scenario of a map, or one part of them, by buckets, and some of them by a heap.
void check_scenarios(const std::string& name, std::size_t part = 0, std::size_t parts = 1) {
    const std::string folder = data_folder();
    if (folder.empty())
        SKIP("no data: there is no folder shared/data beside the project, and ANSATZ_TEST_DATA names none");
    const std::string file = folder + "/movingai/" + name + ".map";
    const auto map = read_moving_ai_map(file);
    const auto grid = map.grid();
    AStar buckets{grid, Buckets{}};
    AStar heap{grid};
    AStar jumping{grid, JumpPoints{}};
    const auto scenarios = read_moving_ai_scenarios(file + ".scen");
    REQUIRE(scenarios.size() > 100);
    for (std::size_t k = part; k < scenarios.size(); k += parts * test::one_in) {
        const auto& s = scenarios[k];
        require_map(s, map);
        buckets.find(s.start, s.goal);
        INFO(map.name << ", line " << s.line << ": " << buckets.why());
        REQUIRE(std::abs(grid.tiles(buckets.path()) - s.length) <= s.tolerance);
        jumping.find(s.start, s.goal);
        REQUIRE(std::abs(grid.tiles(jumping.path()) - s.length) <= s.tolerance);
        if (k % 40 > 1 && scenarios.size() > 200) continue;
        heap.find(s.start, s.goal);
        REQUIRE(std::abs(grid.tiles(heap.path()) - s.length) <= s.tolerance);
        REQUIRE(cost_along(grid, heap.path()) == grid.tiles(buckets.path()));
    }
}
} // namespace

// A case for each, for they take their time.
TEST_CASE("MovingAI: every scenario exact to the digits printed: arena", "[paths][data]") { check_scenarios("arena"); }
TEST_CASE("MovingAI: every scenario exact to the digits printed: brc202d", "[paths][data]") {
    check_scenarios("brc202d");
}
TEST_CASE("MovingAI: every scenario exact to the digits printed: AR0011SR", "[paths][data]") {
    check_scenarios("AR0011SR");
}
TEST_CASE("MovingAI: every scenario exact to the digits printed: rooms", "[paths][data]") {
    check_scenarios("16room_000");
}
TEST_CASE("MovingAI: every scenario exact to the digits printed: random", "[paths][data]") {
    check_scenarios("random512-10-0");
}
TEST_CASE("MovingAI: every scenario exact to the digits printed: maze, first half", "[paths][data]") {
    check_scenarios("maze512-8-0", 0, 2);
}
TEST_CASE("MovingAI: every scenario exact to the digits printed: maze, second half", "[paths][data]") {
    check_scenarios("maze512-8-0", 1, 2);
}

TEST_CASE("MovingAI's files: what is wrong is said with file, line and what was expected", "[paths]") {
    auto map_of = [](const std::string& text) {
        std::istringstream in(text);
        return read_moving_ai_map(in, "dir/small.map");
    };
    const std::string good = "type octile\r\nheight 2\r\nwidth 3\r\nmap\r\n.@G\r\nTSW\r\n";
    const auto small = map_of(good);
    CHECK(small.name == "small.map");
    CHECK(small.tiles == ".@GTSW");
    CHECK(small.grid().passable(Cell{1, 1}));
    CHECK_FALSE(small.grid().passable(Cell{2, 1}));
    auto refused = [&](const std::string& text) { return test::refusal([&] { map_of(text); }); };
    CHECK(refused("") == "dir/small.map:0: the file is empty; expected \"type octile\"");
    CHECK_THAT(refused("type hex\n"), ContainsSubstring("small.map:1: \"type hex\"; expected"));
    CHECK_THAT(refused("type octile\nheight x\n"),
               ContainsSubstring("small.map:2: \"height x\"; expected height from 1 to 65535"));
    CHECK_THAT(refused("type octile\nheight 2\nwidth 99999999999999999999\n"), ContainsSubstring("small.map:3:"));
    CHECK_THAT(refused("type octile\nheight 2\nwidth 70000\nmap\n"),
               ContainsSubstring("expected width from 1 to 65535"));
    CHECK_THAT(refused("type octile\nheight 2\nwidth 3\nmap\n...\n"),
               ContainsSubstring("small.map:5: the file ends after 1 rows; expected 2 rows"));
    CHECK_THAT(refused("type octile\nheight 2\nwidth 3\nmap\n...\n....\n"),
               ContainsSubstring("small.map:6: row 1 has 4 tiles; expected 3"));
    CHECK_THAT(refused("type octile\nheight 1\nwidth 3\nmap\n..x\n"),
               ContainsSubstring("small.map:5: column 3 is 'x'"));
    CHECK_THAT(refused("type octile\nheight 1\nwidth 3\nmap\n...\n...\n"),
               ContainsSubstring("small.map:6: there are more rows; expected 1"));
    using namespace std::string_literals; // a file of bytes: the sentence goes on behind a zero
    CHECK(refused("type\0octile\n"s) == "dir/small.map:1: \"type?octile\"; expected \"type octile\"");
    CHECK(refused("type octile\nheight 1\nwidth 3\nmap\n.\0.\n"s) ==
          "dir/small.map:5: column 2 is '?'; expected one of . G S @ O T W");
    CHECK_THAT(refused("type octile\nheight \x1b[2J\n"), ContainsSubstring("\"height ?[2J\"; expected height"));
    CHECK_THAT(test::refusal([] { read_moving_ai_map("/nowhere/x.map"); }),
               ContainsSubstring("/nowhere/x.map: cannot be opened"));

    auto scenarios_of = [](const std::string& text) {
        std::istringstream in(text);
        return read_moving_ai_scenarios(in, "small.scen");
    };
    const auto one = scenarios_of("version 1\n0\tmaps/small.map\t3\t2\t0\t0\t1\t1\t1.41421\n").at(0);
    CHECK(one.length == 1.41421);
    CHECK(one.tolerance == Approx(5e-6).epsilon(0.1));
    CHECK(scenarios_of("version 1\n0 small.map 3 2 0 0 1 1 6\n").at(0).tolerance ==
          Approx(5e-6).epsilon(0.2)); // six digits: 6.00000
    CHECK(scenarios_of("version 1.0\n0 small.map 3 2 0 0 1 1 244.95\n").at(0).tolerance == Approx(5e-3).epsilon(0.1));
    CHECK(scenarios_of("version 1\n0 small.map 3 2 0 0 1 1 12.65685425\n").at(0).tolerance < 2e-6);
    require_map(one, small);
    auto refused_scenario = [&](const std::string& line) {
        return test::refusal([&] { scenarios_of("version 1\n" + line + "\n"); });
    };
    CHECK_THAT(refused_scenario("0 a.map 3 2 0 0 1 1"),
               ContainsSubstring("small.scen:2: a line of 8 fields; expected 9"));
    CHECK_THAT(refused_scenario("0 a.map 3 2 0 0 1 2 1"), ContainsSubstring("outside the map"));
    CHECK_THAT(refused_scenario("0 a.map 3 2 0 -1 1 1 1"), ContainsSubstring("the start's row is \"-1\""));
    CHECK_THAT(refused_scenario("0 a.map 3 2 0 0 1 1 nan"), ContainsSubstring("the length is \"nan\""));
    CHECK_THAT(test::refusal([&] { scenarios_of("version 2\n"); }), ContainsSubstring("\"version 2\"; expected"));
    auto other = one;
    other.map = "maps/large.map";
    CHECK(test::refusal([&] { require_map(other, small); }) ==
          "the scenario in line 2 is for the map maps/large.map; this is small.map");
    other = one;
    other.width = 9;
    CHECK_THAT(test::refusal([&] { require_map(other, small); }),
               ContainsSubstring("is for a map of 9 x 2 tiles; small.map has 3 x 2"));
}
