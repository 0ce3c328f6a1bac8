// SPDX-License-Identifier: BSL-1.0
// Pools in files that were changed by hand: refused, before there is memory for what they name.

#include <ansatz/water.hpp>
#include <ansatz/water/pool.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/before_allocation.hpp"
#include "tests/water/support.hpp"

#include <sstream>

using namespace water_tests;

namespace {

using Both = World<SemiImplicitEuler, Gravity, Pools<WaterColumns>, Pools<Pipes>>;
std::size_t largest = 0;
bool measure(std::size_t bytes) noexcept {
    largest = std::max(largest, bytes);
    return true;
}

} // namespace

TEST_CASE("a file names no more columns than it holds, and no numbers that water has not", "[water]") {
    Both saved{{}, {}, {}, {}};
    saved.add(Pool{Surface{WaterColumns{3.0 * mps}, ColumnGrid(12, 9, 0.5 * metre), 2.0 * metre}});
    saved.add(Pool{Surface{Pipes{}, ColumnGrid(12, 9, 0.5 * metre), 2.0 * metre}});
    saved.step(0.02 * second);
    std::stringstream file;
    save(saved, file);
    // The first pool of a kind with other numbers in some of its lists.
    using Lists = std::vector<std::pair<std::string, std::string>>;
    const auto refused = [&](const std::string& kind, const Lists& lists) {
        std::string text = file.str();
        for (const auto& [name, numbers] : lists) {
            const auto at = text.find('"' + name + '"', text.find("Pools of " + kind, text.find("\"elements\"")));
            REQUIRE(at != std::string::npos);
            const auto from = text.find('[', at) + 1;
            text.replace(from, text.find(']', from) - from, numbers);
        }
        std::stringstream other(text);
        Both world{{}, {}, {}, {}};
        const auto empty = world.hash();
        const auto said = refusal([&] { load(world, other); });
        CHECK((said == "nothing" || world.hash() == empty));
        return said;
    };
    const auto row = [](std::size_t count, const std::string& number) {
        std::string all = number;
        for (std::size_t n = 1; n < count; ++n) all += ", " + number;
        return all;
    };
    std::string faces = "0.0";
    for (int i = 1; i <= 20000; ++i) faces += ", " + std::to_string(i) + ".0";
    Lists many{
        {"widths_x", row(20000, "1.0")}, {"faces_x", faces}, {"widths_z", row(20000, "1.0")}, {"faces_z", faces}};
    for (const std::string held : {"108", "0"}) {
        if (held == "0") many.emplace_back("height", "");
        largest = 0;
        before_allocation = measure;
        const auto said = refused("WaterColumns", many);
        before_allocation = nullptr;
        CHECK(said.find("the number of height is " + held + "; there is one for each of the 400000000 columns") !=
              std::string::npos);
        CHECK(largest < 10'000'000);
    }
    const auto all_but_one = row(107, "1.0");
    CHECK(refused("Pipes", {{"height", all_but_one + ", 1e999"}}) != "nothing");
    CHECK(refused("Pipes", {{"height", all_but_one + ", -0.1"}}).find("the height at column (11, 8) is -0.1 m") !=
          std::string::npos);
    for (const std::string bad : {"-0.1", "1e999"})
        CHECK(refused("Pipes", {{"pressed", all_but_one + ", " + bad}}) != "nothing");
    CHECK(refused("WaterColumns", {{"faces_x", "0.0, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0"}})
              .find("face 1 along x is 1 m") != std::string::npos);
    CHECK(refused("WaterColumns", {}) == "nothing");
}
