// SPDX-License-Identifier: BSL-1.0
// How an answer is recognised as a known mistake (tools/exercises/main.hpp).

#include "tests/catch.hpp"
#include "tools/exercises/main.hpp"
#include "tools/exercises/play.hpp"
#include "tools/exercises/todo.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

using namespace ansatz::workbook;

TEST_CASE("numbers are equal but for rounding", "[exercises]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK(same_numbers({1, 2}, {1 + 1e-12, 2 - 1e-12}));
    CHECK_FALSE(same_numbers({1, 2}, {1, 2.001}));
    CHECK_FALSE(same_numbers({1}, {1, 1}));
    CHECK(same_numbers({nan, inf, 0}, {nan, inf, -0.0}));
    CHECK_FALSE(same_numbers({nan}, {1}));
    CHECK_FALSE(same_numbers({inf}, {-inf}));
    CHECK_FALSE(same_numbers({1e-300}, {2e-300})); // no absolute tolerance: small numbers are numbers
    CHECK_FALSE(same_numbers({0}, {1e-300}));
    // Where terms cancel, what is left of the rounding is small against the others, and against zero it is infinitely
    // much.
    CHECK(same_numbers({1, 0}, {1, -1e-16}));
    CHECK(same_numbers({0, -40, 7}, {3e-15, -40, 7}));
    CHECK(same_numbers({nan, 0, 1e3}, {nan, 2e-14, 1e3}));
    CHECK_FALSE(same_numbers({1, 0}, {1, 1e-9}));
    CHECK_FALSE(same_numbers({1, 1e-6}, {1, 1.001e-6}));      // small, but no rounding
    CHECK_FALSE(same_numbers({1e5, 1e-9}, {1e5, 1.0025e-9})); // the smaller root, from which the digits are gone
    CHECK_FALSE(same_numbers({inf, 0}, {inf, 1e-16}));        // what is infinite is no measure
}

TEST_CASE("a mistake is recognised in the tasks where it is made, whatever the others are", "[exercises]") {
    const Probes solution{{1, {1, 2}}, {2, {3}}};
    const Probes wrong{{1, {1, 5}}, {2, {3}}};
    CHECK(same_mistake({{1, {1, 5}}, {2, {3}}}, solution, wrong));
    CHECK(same_mistake({{1, {1, 5}}, {2, {99}}}, solution, wrong)); // another mistake besides
    CHECK(same_mistake({{1, {1, 5}}}, solution, wrong));            // task 2 is not done yet
    CHECK_FALSE(same_mistake({{1, {1, 2}}, {2, {3}}}, solution, wrong));
    CHECK_FALSE(same_mistake({{1, {1, 6}}, {2, {3}}}, solution, wrong));
    CHECK_FALSE(same_mistake({{2, {3}}}, solution, wrong));
    CHECK_FALSE(same_mistake(wrong, solution, solution)); // what is right is no mistake
    CHECK_FALSE(same_mistake({}, solution, {}));

    const Probes both{{1, {7}}, {2, {8}}}; // a mistake that shows in two tasks must show in both
    CHECK(same_mistake({{1, {7}}, {2, {8}}}, solution, both));
    CHECK_FALSE(same_mistake({{1, {7}}, {2, {3}}}, solution, both));
}

TEST_CASE("probes are read as they were written; what threw or broke off is left out", "[exercises]") {
    const std::string file = "probes-of-a-test.txt"; // in the folder of the build
    std::ofstream(file) << "1 0x1.8p+0 -0x1p-3 inf nan\n2 threw\n3\n4 0x1p+0\nrubbish\n";
    const Probes probes = read_probes(file);
    std::remove(file.c_str());
    REQUIRE(probes.size() == 2);
    CHECK(same_numbers(probes.at(1), {1.5, -0.125, std::numeric_limits<double>::infinity(),
                                      std::numeric_limits<double>::quiet_NaN()}));
    CHECK(probes.at(4) == std::vector<double>{1});
    CHECK(read_probes("/no/such/file").empty());
}

TEST_CASE("a task that is not done says which it is, whatever must be returned", "[exercises]") {
    auto number = []() -> double { return todo(3); };
    auto nothing = [] { todo(12); };
    CHECK_THROWS_WITH(number(), "not done yet: task 3");
    CHECK_THROWS_WITH(nothing(), "not done yet: task 12");
}

TEST_CASE("a scene says what its times are for, and that it is over", "[exercises]") {
    std::ostringstream shown, log;
    std::streambuf* const cout = std::cout.rdbuf(shown.rdbuf());
    std::streambuf* const clog = std::clog.rdbuf(log.rdbuf());
    Play table("a call of a function", {"its number"});
    table.timed("ns a call");
    for (const char* who : {"yours", "library"}) table.row(who, {1.5}, 1, [] {});
    table.print();
    std::cout.rdbuf(cout);
    std::clog.rdbuf(clog);
    using Catch::Matchers::ContainsSubstring;
    CHECK_THAT(shown.str(), ContainsSubstring("ns a call") && !ContainsSubstring("ns a body and step"));
    CHECK(log.str() == "the scene is over\n");
}
