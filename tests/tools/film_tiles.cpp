// SPDX-License-Identifier: BSL-1.0

// Tiles of a film: every one is seen, in its place and once, however they are put together into lines.

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include "tools/film.hpp"

#include <ansatz/units.hpp>

#include <algorithm>
#include <array>
#include <random>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ansatz::workbook;
using ansatz::metre;
using ansatz::metres;
using ansatz::second;
using ansatz::test::refusal;

namespace {

using Place = ansatz::VectorQuantity<ansatz::unit::Length>;

/// A tile of 10 units: 128 x 72 of them, the first in the upper left corner, at 0 | 60.
const View map{.middle = metres(64, -36, 0), .width = 128.0 * metre, .height = 72.0 * metre};
constexpr Paint grass{0x009e73, 0};

Place middle(int x, int y) { return metres(x + 0.5, -y - 0.5, 0); }

/// The tiles that are seen in the paths of a class, by the dashes of their lines: 8 units, and a gap of 2.
std::multiset<std::array<int, 2>> seen(const std::string& text, const std::string& style) {
    std::multiset<std::array<int, 2>> tiles;
    const std::regex path("<path class=\"" + style + "\" d=\"M([^\"]*)\""), number("-?[0-9]+");
    for (std::sregex_iterator p(text.begin(), text.end(), path), end; p != end; ++p) {
        const std::string d = (*p)[1];
        std::vector<int> numbers;
        for (std::sregex_iterator n(d.begin(), d.end(), number); n != end; ++n) numbers.push_back(std::stoi(n->str()));
        REQUIRE(numbers.size() % 4 == 0); // of each line where it begins, from the end of the last one, and its way
        std::array at{0, 0};
        for (std::size_t i = 0; i < numbers.size(); i += 4) {
            at = {at[0] + numbers[i], at[1] + numbers[i + 1]};
            REQUIRE(numbers[i + 3] == 0);
            for (int x = 0; x < numbers[i + 2]; x += 10) tiles.insert({(at[0] + x - 1) / 10, (at[1] - 65) / 10});
            REQUIRE((numbers[i + 2] + 2) % 10 == 0); // it ends with a whole tile
            at[0] += numbers[i + 2];
        }
    }
    return tiles;
}

} // namespace

TEST_CASE("each tile of a film is seen once, in its place", "[film]") {
    std::mt19937 draw(7);
    for (const unsigned of_ten : {1U, 5U, 9U}) {
        std::vector<Place> places;
        std::multiset<std::array<int, 2>> expected;
        for (int y = 0; y < 72; ++y)
            for (int x = 0; x < 128; ++x)
                if (draw() % 10 < of_ten) places.push_back(middle(x, y)), expected.insert({x, y});
        std::shuffle(places.begin(), places.end(), draw);
        places.push_back(places.front()); // named twice
        Film film("1.1", "A map", "It is there.", map);
        film.frame(0.0 * second).tiles(places, 1.0 * metre, grass);
        CHECK(seen(film.text(), "at10") == expected);
        CHECK(film.text().find(".at10{fill:none;stroke-width:8;stroke-dasharray:8 2;stroke:#009e73}") !=
              std::string::npos);
    }
}

TEST_CASE("a row of tiles is one line, whatever order they come in", "[film]") {
    const auto size_of = [](int tiles) {
        Film film("1.1", "A map", "It is there.", map);
        std::vector<Place> places;
        for (int x = tiles; x > 0; --x) places.push_back(middle(x, 3));
        film.frame(0.0 * second).tiles(places, 1.0 * metre, grass);
        return film.text().size();
    };
    CHECK(size_of(99) - size_of(10) <= 2); // digits of its length
}

TEST_CASE("a film that counts says what, in whole numbers", "[film]") {
    Film film("1.1", "A search", "It grows.", map);
    film.counts("turns");
    for (int n = 0; n < 3; ++n) film.frame(10.0 * n * second).tiles(std::vector{middle(n, 0)}, 1.0 * metre, grass);
    CHECK(film.text().find(">20 turns</text>") != std::string::npos);
    CHECK(film.sheet().find(">10 turns</text>") != std::string::npos);
    CHECK(film.text().find(" s</text>") == std::string::npos);
}

TEST_CASE("tiles that are no whole number of units, seen askew or outside are refused", "[film]") {
    using Catch::Matchers::ContainsSubstring;
    const std::vector one{middle(0, 0)};
    Film film("1.1", "A map", "It is there.", map);
    auto& frame = film.frame(0.0 * second);
    CHECK_THAT(refusal([&] { frame.tiles(one, 1.01 * metre, grass); }),
               ContainsSubstring("tiles: they are 10.1 units wide"));
    CHECK_THAT(refusal([&] { frame.tiles(one, 0.1 * metre, grass); }), ContainsSubstring("four at least"));
    CHECK_THAT(refusal([&] { frame.tiles(std::vector<Place>{}, 1.0 * metre, grass); }),
               ContainsSubstring("tiles of no point"));
    CHECK_THAT(refusal([&] { frame.tiles(std::vector{middle(128, 0)}, 1.0 * metre, grass); }),
               ContainsSubstring("tiles: point 0 is at 1281"));
    View from_above = map;
    from_above.above = ansatz::degrees(30);
    Film other("1.1", "A map", "It is there.", from_above);
    CHECK_THAT(refusal([&] { other.frame(0.0 * second).tiles(one, 1.0 * metre, grass); }),
               ContainsSubstring("tiles are seen from the front only"));
}
