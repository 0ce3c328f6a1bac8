// SPDX-License-Identifier: BSL-1.0

// What is handed to gnuplot: sections' plots and the work-precision pictures. Beauty is judged by eye;
// here it is held that nothing is dropped, mislabelled, or drawn without its unit.

#include "tests/catch.hpp"
#include "tests/scratch.hpp"

#include "tools/costs/picture.hpp"
#include "tools/graphviz.hpp"
#include "tools/plot.hpp"

#include <ansatz/units.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz::workbook;
using ansatz::metre;
using ansatz::second;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t times = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
    return times;
}

Row point(const std::string& choice, double error, double work) {
    Row r;
    r.axis = "integrator";
    r.problem = "oscillator";
    r.choice = choice;
    r.error = error;
    r.error_norm = "max |x| (m)";
    r.work = work;
    r.work_unit = "force evaluations";
    r.time = 3 * work;
    r.time_unit = "ns per step";
    return r;
}

} // namespace

TEST_CASE("an axis carries the unit of its quantities", "[plot]") {
    const std::vector times{0.0 * second, 1.0 * second};
    const std::vector heights{2.0 * metre, 3.0 * metre};
    const std::string script = Plot{"1.5", "A claim"}.x("time").y("height").line("fall", times, heights).script();
    CHECK(contains(script, "set xlabel 'time (s)'"));
    CHECK(contains(script, "set ylabel 'height (m)'"));
    CHECK(contains(script, "1 3\n"));
}

TEST_CASE("tiles are squares of their size, all of them, in a colour that curves do not use", "[plot]") {
    std::vector<ansatz::Quantity<ansatz::unit::Length>> east, north;
    for (int i = 0; i < 4000; ++i) east.push_back(i * metre), north.push_back(i % 7 * metre);
    const std::string script = Plot{"6.1", "A map"}
                                   .equal_axes()
                                   .x_range(0.0 * metre, 4000.0 * metre)
                                   .tiles("wall", east, north, 0.5 * metre)
                                   .line("path", east, north)
                                   .script();
    CHECK(contains(script, "$curve0 using 1:2:(0.25):(0.25) with boxxyerror fs solid 1 noborder lc rgb '#59616b'"));
    CHECK(contains(script, "set xrange [0:4000]"));
    CHECK(!contains(script, "autoscale")); // which would undo the range
    const auto begin = script.find("$curve0 << END"), end = script.find("$curve1 << END");
    CHECK(std::count(script.begin() + std::ptrdiff_t(begin), script.begin() + std::ptrdiff_t(end), '\n') == 4002);
    const std::string alone = Plot{"6.1", "A map"}.line("path", east, north).script();
    const auto colour = alone.substr(alone.rfind("lc rgb"));
    CHECK(script.substr(script.rfind("lc rgb")) == colour);
    Plot plot{"6.1", "A map"};
    CHECK_THROWS_AS(plot.tiles("wall", east, north, 1.0 * second), std::invalid_argument);
}

TEST_CASE("a second unit on one axis is refused", "[plot]") {
    const std::vector times{0.0 * second, 1.0 * second};
    const std::vector heights{2.0 * metre, 3.0 * metre};
    Plot plot{"1.5", "A claim"};
    plot.line("fall", times, heights);
    CHECK_THROWS_AS(plot.line("swapped", heights, heights), std::invalid_argument);
    CHECK_THROWS_AS(plot.line("a speed", times, std::vector{1.0 * metre / second, 2.0 * metre / second}),
                    std::invalid_argument);
    CHECK_THROWS_AS(plot.vertical(1.0 * metre, "here"), std::invalid_argument);
    CHECK_NOTHROW(plot.vertical(1.0 * second, "here"));
}

TEST_CASE("a curve has as many values as places, or is a function of them", "[plot]") {
    const std::vector times{0.0 * second, 1.0 * second, 2.0 * second};
    const std::vector heights{2.0 * metre, 3.0 * metre};
    Plot plot{"1.5", "A claim"};
    CHECK_THROWS_AS(plot.line("short", times, heights), std::invalid_argument);
    CHECK_THROWS_AS(plot.line("long", heights, times), std::invalid_argument);
    const std::string script =
        Plot{"1.5", "A claim"}.reference("law", times, [](auto t) { return t * (7.0 * metre / second); }).script();
    CHECK(contains(script, "2 14\n"));
}

TEST_CASE("what is not finite is a gap, and quotes cannot leave their string", "[plot]") {
    CHECK(number(std::nan("")) == "NaN");
    CHECK(number(1.0 / 3.0) == "0.333333333");
    CHECK(in_quotes("Newton's\nfirst") == "'Newton''s first'");
    const std::vector<double> x{0, 1, 2}, y{1, std::nan(""), 3};
    CHECK(contains(Plot{"1", "t"}.line("l", x, y).script(), "1 NaN\n"));
}

TEST_CASE("a long curve is thinned without losing its peaks", "[plot]") {
    std::vector<std::pair<double, double>> points;
    for (int i = 0; i < 100000; ++i) points.emplace_back(i, std::sin(0.001 * i));
    points[54321].second = 50;
    points[54322].second = -50;
    const auto kept = thinned(points, 3000);
    CHECK(kept.size() <= 3002);
    CHECK(kept.front() == points.front());
    CHECK(kept.back() == points.back());
    double low = 0, high = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        low = std::min(low, kept[i].second);
        high = std::max(high, kept[i].second);
        if (i > 0) REQUIRE(kept[i].first >= kept[i - 1].first);
    }
    CHECK(low == -50);
    CHECK(high == 50);
}

TEST_CASE("units are printed as in books", "[plot]") {
    CHECK(with_superscripts("kg m^2/s^2") == "kg m²/s²");
    CHECK(with_superscripts("m^12") == "m¹²");
    CHECK(with_superscripts("m^(1/2)") == "m^(1/2)"); // no such letter: left as it is
    CHECK(with_superscripts("") == "");
}

TEST_CASE("a logarithmic axis shows what it can of its data, and labels it", "[plot]") {
    const std::vector<double> steps{0.0125, 0.025, 0.05, 0.1}, errors{0.0, 1e-9, 1e-5, 1e-1};
    const std::string script = Plot{"1.6", "t"}.log_x().log_y().linked_points("l", steps, errors).script();
    CHECK(contains(script, "set xrange [0.011"));
    CHECK(contains(script, "2e-2, 5e-2, 1e-1"));       // one decade: 1, 2, 5
    CHECK(contains(script, "set format y '10^{%L}'")); // eight decades: powers
    CHECK_FALSE(contains(script, "set yrange [0:"));   // zero has no place on it
}

TEST_CASE("a diverged run is a cross in the strip, never dropped", "[costs][picture]") {
    Rows rows{point("Euler", 1e-1, 10), point("Euler", 1e-2, 100), point("Verlet", 1e-4, 100)};
    CHECK_FALSE(contains(work_precision_script(rows), "diverged"));
    Row diverged = point("Euler", 1, 5);
    diverged.error = {};
    diverged.diverged = true;
    rows.push_back(diverged);
    const std::string script = work_precision_script(rows);
    CHECK(count(script, "'diverged'") == 2);  // one strip a panel
    CHECK(count(script, "point pt 2 ") == 2); // one cross a panel
    CHECK(contains(script, "ns per step"));
    CHECK(contains(script, "force evaluations"));
}

TEST_CASE("a fitted order stands in the legend beside the known one", "[costs][picture]") {
    Rows rows{point("Euler", 1e-1, 10), point("Euler", 1e-2, 100)};
    rows[1].order = 1.034;
    rows[1].known_order = 1.0;
    CHECK(contains(work_precision_script(rows), "'Euler, order 1.03 (1)'"));
}

TEST_CASE("an error of zero has a strip of its own, and rows without error make no picture", "[costs][picture]") {
    Rows rows{point("Euler", 1e-1, 10), point("Exact", 0, 100)};
    CHECK(count(work_precision_script(rows), "'error is zero'") == 2);
    rows[0].error = {};
    CHECK(work_precision_script({rows[0]}).empty());
    CHECK(work_precision_script({}).empty());
}

TEST_CASE("a picture's file name suits every system", "[costs][picture]") {
    CHECK(file_name("motion-integrator-oscillator, T = 100 s (x)") == "motion-integrator-oscillator-t-100-s-x");
}

TEST_CASE("gnuplot draws what it is given", "[plot]") {
    if (!gnuplot_installed()) {
        WARN("gnuplot is not installed: nothing drawn, nothing checked");
        return;
    }
    const auto folder = ansatz::test::scratch_path("pictures of gnuplot");
    ::setenv("ANSATZ_PICTURES", folder.c_str(), 1);
    const std::vector<double> x{1e-3, 1e-2, 1e-1}, y{1e-6, 1e-4, 1e-2};
    CHECK(Plot{"1.6", "Newton's claim: 100 % _right_ {^}"}
              .x("step", "s")
              .y("error", "m")
              .log_x()
              .log_y()
              .linked_points("it's \"second\" order", x, y)
              .vertical(0.02, "a mark")
              .horizontal(1e-3, "another")
              .note(1e-2, 1e-4, "here")
              .write());
    CHECK(std::filesystem::file_size(folder / "1.6.svg") > 1000);
    // Nothing that the axes can show: said, not drawn.
    CHECK_FALSE(Plot{"1.7", "None"}.log_y().line("below zero", x, std::vector<double>{-1, -1, -1}).write());
    CHECK_FALSE(std::filesystem::exists(folder / "1.7.svg"));

    Rows rows{point("Euler", 1e-1, 10), point("Euler", 1e-2, 100), point("Exact", 0, 50), point("Lost", 1, 1)};
    rows.back().error = {};
    rows.back().diverged = true;
    CHECK(draw_pictures(folder, "motion", rows).size() == 1);
    // Whole or not at all: no half-written neighbours stay.
    CHECK(std::distance(std::filesystem::directory_iterator{folder}, {}) == 2);
    ::unsetenv("ANSATZ_PICTURES");
    std::filesystem::remove_all(folder);
}

TEST_CASE("Graphviz draws what it is given, and where it is missing that is said", "[plot]") {
    const auto folder = ansatz::test::scratch_path("a machine's pictures");
    ::setenv("ANSATZ_PICTURES", folder.c_str(), 1);
    std::ostringstream said;
    auto* before = std::clog.rdbuf(said.rdbuf());
    CHECK_FALSE(draw_graph("5.1", "digraph { a -> b }", "no-such-program"));
    CHECK(contains(said.str(), "picture skipped: Graphviz is not installed (its program is no-such-program)"));
    CHECK_FALSE(std::filesystem::exists(folder));
    if (graphviz_installed()) {
        CHECK(draw_graph("5.1", "digraph { \"it's\" -> b [label=\"[x < 3 m]\"] }"));
        CHECK(contains(said.str(), "picture: " + (folder / "5.1.svg").string()));
        std::ifstream picture(folder / "5.1.svg");
        const std::string svg{std::istreambuf_iterator<char>(picture), {}};
        CHECK(contains(svg, "</svg>"));
        CHECK(contains(svg, "[x &lt; 3 m]"));
        CHECK_FALSE(draw_graph("5.2", "digraph { a -> ")); // whole or not at all
        CHECK(contains(said.str(), "5.2.svg: Graphviz could not draw it"));
        CHECK(std::distance(std::filesystem::directory_iterator{folder}, {}) == 1);
    } else WARN("Graphviz is not installed: nothing drawn, nothing checked");
    std::clog.rdbuf(before);
    ::unsetenv("ANSATZ_PICTURES");
    std::filesystem::remove_all(folder);
}
