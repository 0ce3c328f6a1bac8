// SPDX-License-Identifier: BSL-1.0

// Films of the sections: every frame is there and where it belongs, nothing leaves the picture unsaid, what hides
// something is drawn behind it in the file, and the last digit of a compiler changes no letter.

#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/scratch.hpp"

#include "tools/film.hpp"

#include <ansatz/units.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ansatz::workbook;
using ansatz::degrees;
using ansatz::metre;
using ansatz::metres;
using ansatz::second;
using ansatz::test::refusal;

namespace {

using Place = ansatz::VectorQuantity<ansatz::unit::Length>;

/// 12.8 m wide, so that a metre has a hundred units: its middle is at (640, 60 + 360).
const View straight{.middle = metres(0, 0, 0), .width = 12.8 * metre, .height = 7.2 * metre};
const View askew{
    .middle = metres(0, 0, 0), .width = 6.0 * metre, .height = 5.0 * metre, .turn = degrees(30), .above = degrees(25)};

std::vector<std::string> lines_with(const std::string& text, const std::string& part) {
    std::vector<std::string> found;
    for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
        end = text.find('\n', at);
        const auto line = text.substr(at, end - at);
        if (line.find(part) != std::string::npos) found.push_back(line);
    }
    return found;
}
/// A sheet of 5 x 5 points that is symmetric in every way, and waves; each number a little off.
std::vector<Place> waving(double t, double off = 0) {
    std::vector<Place> points;
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
            points.push_back(metres(0.5 * i * (1 + off), 0.25 * std::cos(i) * std::cos(j) * t - off, 0.5 * j + off));
    return points;
}
std::string film_of(double off, std::size_t frames = 20) {
    Film film("1.1", "A sheet", "It waves.", askew);
    film.scenery().ground(metres(-1.5, -0.5, -1.5), metres(1.5, -0.5, 1.5), 0.5 * metre);
    for (std::size_t n = 0; n < frames; ++n)
        film.frame(double(n) * 0.05 * second)
            .shadow(waving(double(n) / 10, off), -0.5 * metre)
            .sheet(waving(double(n) / 10, off), 5, paints::cloth)
            .ball(metres(off, 1, 0.5 + off), 0.25 * metre, paints::ball);
    return film.text() + film.sheet();
}

} // namespace

TEST_CASE("a film has each of its frames, in order, each for its part of the time", "[film]") {
    Film film("1.1", "A ball & its <path>", "It falls.", straight);
    film.rate(10).hold(6);
    for (int n = 0; n < 14; ++n)
        film.frame(n * 0.1 * second).ball(metres(0, 3 - n * 0.25, 0), 0.5 * metre, paints::ball);
    const auto text = film.text();
    const auto frames = lines_with(text, "<g id=\"f");
    REQUIRE(frames.size() == 14);
    CHECK(text.find("animation:f 2s step-end infinite") != std::string::npos); // 14 frames and 6 at 10 a second
    CHECK(text.find("@keyframes f{0%{visibility:visible}5.1%,to{visibility:hidden}}") != std::string::npos);
    CHECK(text.find("@keyframes l{0%{visibility:visible}35.1%,to{visibility:hidden}}") != std::string::npos);
    CHECK(lines_with(text, "<use href=\"#scene\"/>").size() ==
          14); // each hides the one before it, which is seen a bit longer
    CHECK(text.find("<g id=\"scene\"><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>") != std::string::npos);
    std::size_t still = 0;
    for (std::size_t n = 0; n < 14; ++n) {
        CAPTURE(n, frames[n]);
        CHECK(frames[n].find("<g id=\"f" + std::to_string(n) + "\"") == 0);
        std::smatch found;
        REQUIRE(std::regex_search(frames[n], found, std::regex("animation-delay:-([0-9.]+)s")));
        // It began so long ago that its turn comes after n tenths of a second.
        CHECK(std::abs(std::fmod(std::stod(found[1]) + double(n) * 0.1, 2.0)) < 1e-9);
        REQUIRE(std::regex_search(frames[n], found, std::regex("cx=\"640\" cy=\"([0-9]+)\" r=\"50\"")));
        CHECK(std::stoi(found[1]) == 420 - 300 + 25 * int(n)); // y up, 100 units a metre
        still += frames[n].find("class=\"f still") != std::string::npos;
    }
    CHECK(frames[13].find(" l\"") != std::string::npos); // the last one stays
    CHECK(still == 1);                                   // what is seen where nothing moves
    CHECK(text.find("prefers-reduced-motion:reduce") != std::string::npos);
    CHECK(text.find("<title id=\"t\">A ball &amp; its &lt;path&gt;</title>") != std::string::npos);
    CHECK(text.find("<desc id=\"d\">It falls.</desc>") != std::string::npos);
}

TEST_CASE("a contact sheet has as many frames as asked, the first and the last among them", "[film]") {
    Film film("1.1", "A ball", "It falls.", straight);
    for (int n = 0; n < 14; ++n)
        film.frame(n * 0.1 * second).ball(metres(0, 3 - n * 0.25, 0), 0.5 * metre, paints::ball);
    for (const std::size_t asked : {1U, 2U, 6U, 14U, 20U}) {
        const auto pictures = lines_with(film.sheet(asked), "<g id=\"f");
        CHECK(pictures.size() == std::min<std::size_t>(asked, 14));
        CHECK(pictures.front().find("<g id=\"f0\"") != std::string::npos);
        if (asked > 1) CHECK(pictures.back().find("<g id=\"f13\"") != std::string::npos);
    }
    CHECK_THAT(refusal([&] { (void)film.sheet(0); }), Catch::Matchers::ContainsSubstring("its sheet has no picture"));
}

TEST_CASE("frames that are lost, places that are no numbers or outside, things of other sizes are refused by name",
          "[film]") {
    using Catch::Matchers::ContainsSubstring;
    Film film("1.1", "A ball", "It falls.", straight);
    CHECK_THAT(refusal([&] { (void)film.text(); }), ContainsSubstring("Film 1.1: it has no frame"));
    const std::vector square{metres(0, 0, 0), metres(1, 0, 0), metres(0, 1, 0), metres(1, 1, 0)};
    film.frame(0.0 * second).sheet(square, 2, paints::cloth);
    film.frame(0.1 * second).sheet(square, 2, paints::cloth);
    CHECK_THAT(refusal([&] { film.frame(0.3 * second); }),
               ContainsSubstring("frame 2 comes 0.2 s after the one before"));
    auto& third = film.frame(0.2 * second);

    auto bad = square;
    bad[2] = metres(0, std::numeric_limits<double>::quiet_NaN(), 0);
    CHECK_THAT(refusal([&] { third.sheet(bad, 2, paints::cloth); }),
               ContainsSubstring("Film 1.1: frame 2 (0.2 s): sheet: y of point 2 is nan"));
    bad[2] = metres(0, 1, -std::numeric_limits<double>::infinity());
    CHECK_THAT(refusal([&] { third.line(bad, paints::wire); }), ContainsSubstring("line: z of point 2 is -inf"));
    bad[2] = metres(6.41, 1, 0);
    CHECK_THAT(refusal([&] { third.line(bad, paints::wire); }),
               ContainsSubstring("line: point 2 is at 1281, 320 of a picture of 1280 x 780"));
    CHECK_THAT(refusal([&] { third.ball(metres(0, -3.2, 0), 0.5 * metre, paints::ball); }),
               ContainsSubstring("ball: point"));
    CHECK_THAT(refusal([&] { third.ball(metres(0, 0, 0), 0.0 * metre, paints::ball); }),
               ContainsSubstring("radius is 0"));
    CHECK_THAT(refusal([&] { third.sheet(square, 3, paints::cloth); }), ContainsSubstring("4 points are no rows of 3"));
    CHECK_THAT(refusal([&] {
                   third.mesh(square, std::vector{std::array{0, 1, 4}}, paints::cloth);
               }),
               ContainsSubstring("a triangle names point 4 of 4"));

    Film other("1.1", "A line", "It grows.", straight);
    other.frame(0.0 * second).line(square, paints::wire);
    other.frame(0.1 * second).line(std::vector{square[0], square[1]}, paints::wire);
    CHECK_THAT(refusal([&] { (void)other.text(); }),
               ContainsSubstring("frame 1 (0.1 s): thing 0 is a line of 2 points, and in frame 0 a line of 4"));
    other.may_change();
    CHECK(lines_with(other.text(), "<g id=\"f").size() == 2);
    CHECK_THAT(refusal([&] { Film("1.1", "", "", {.width = 0.0 * metre}); }), ContainsSubstring("0 m wide"));
}

TEST_CASE("the last digit of a number changes no letter of a film, of things that are symmetric as of others",
          "[film]") {
    const auto text = film_of(0);
    CHECK(text == film_of(0));
    CHECK(text == film_of(1e-12));
    CHECK(text == film_of(-1e-12));
    CHECK(text != film_of(0.05)); // and is no film of nothing
}

TEST_CASE("of two faces that lie over each other the nearer one comes later, however paths are put together",
          "[film]") {
    // Flat squares across the view, at depths and in paints of their own, so that what is where in the file tells both.
    std::mt19937 draw(7);
    std::uniform_real_distribution<double> across(-5, 5), high(-2.5, 2.5);
    for (int scene = 0; scene < 20; ++scene) {
        Film film("1.1", "Squares", "They lie over each other.", straight);
        auto& frame = film.frame(0.0 * second);
        struct Square {
            int x, y, depth;
        };
        std::vector<Square> squares;
        for (int k = 0; k < 40; ++k) {
            const double to_the_right = across(draw), up = high(draw); // one after the other
            const double x = std::round(10 * to_the_right) / 10, y = std::round(10 * up) / 10;
            const int depth = int(draw() % 1000);
            const Square here{int(std::lround(640 + 100 * x)), int(std::lround(420 - 100 * y)), depth};
            if (std::any_of(squares.begin(), squares.end(),
                            [&](const Square& other) { return other.x == here.x && other.y == here.y; }))
                continue; // two that begin at one place are not told apart
            squares.push_back(here);
            const double z = depth / 100.0;
            frame.sheet(std::vector{metres(x, y, z), metres(x + 1, y, z), metres(x, y + 1, z), metres(x + 1, y + 1, z)},
                        2, k % 2 == 0 ? paints::cloth : paints::flag);
        }
        // Where each of them begins, in the order of the file.
        const auto line = lines_with(film.text(), "<g id=\"f0\"").at(0);
        std::vector<std::array<int, 2>> order;
        const std::regex path("d=\"([^\"]*)\""), move("([Mm])(-?[0-9]+) ?(-?[0-9]+)");
        for (std::sregex_iterator p(line.begin(), line.end(), path), end; p != end; ++p) {
            const std::string d = (*p)[1];
            std::array at{0, 0};
            for (std::sregex_iterator m(d.begin(), d.end(), move); m != end; ++m) {
                at = {at[0] + std::stoi((*m)[2]), at[1] + std::stoi((*m)[3])};
                order.push_back(at);
            }
        }
        REQUIRE(order.size() == squares.size());
        const auto place = [&](const Square& s) {
            return std::find(order.begin(), order.end(), std::array{s.x, s.y}) - order.begin();
        };
        for (const auto& a : squares)
            for (const auto& b : squares) {
                const bool over = std::abs(a.x - b.x) < 100 && std::abs(a.y - b.y) < 100;
                if (!over || a.depth >= b.depth) continue;
                CAPTURE(scene, a.x, a.y, a.depth, b.x, b.y, b.depth);
                CHECK(place(a) < place(b));
            }
    }
}

TEST_CASE("a film is written with its sheet, whole, and not larger than a page wants it", "[film]") {
    const auto folder = ansatz::test::scratch_path("film");
    const char* before = std::getenv("ANSATZ_PICTURES");
    const std::string kept = before == nullptr ? "" : before;
    ::setenv("ANSATZ_PICTURES", folder.c_str(), 1);
    Film film("1.1-sheet_of_5", "A sheet", "It waves.", askew);
    for (std::size_t n = 0; n < 20; ++n)
        film.frame(double(n) * 0.05 * second).sheet(waving(double(n) / 10), 5, paints::cloth);
    CHECK(film.write());
    std::ifstream stream(folder / "1.1-sheet_of_5-film.svg");
    CHECK(std::string(std::istreambuf_iterator<char>(stream), {}) == film.text());
    CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 2); // and nothing else, no part of a file

    Film large("1.2", "Too much", "It waves.", askew);
    for (std::size_t n = 0; n < 800; ++n) large.frame(double(n) * 0.05 * second).sheet(waving(1), 5, paints::cloth);
    CHECK_THAT(refusal([&] { large.write(); }), Catch::Matchers::ContainsSubstring("1.2-film.svg has"));
    CHECK(!std::filesystem::exists(folder / "1.2-film.svg"));
    std::filesystem::remove_all(folder);
    kept.empty() ? ::unsetenv("ANSATZ_PICTURES") : ::setenv("ANSATZ_PICTURES", kept.c_str(), 1);
}
