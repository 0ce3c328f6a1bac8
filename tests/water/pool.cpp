// SPDX-License-Identifier: BSL-1.0
// Pools at the edges: without weight, without water, in float, in files that were changed by hand.

#include <ansatz/springs.hpp>
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

TEMPLATE_TEST_CASE("water that weighs nothing is asked for, saved and given back", "[water]", WaterColumns, Pipes,
                   ShallowWater, SecondOrderShallowWater) {
    const auto policy = [] {
        if constexpr (std::is_same_v<TestType, WaterColumns>) return WaterColumns{3.0 * mps};
        else return TestType{};
    }();
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, Pools<TestType>{}};
    Surface water(policy, ColumnGrid(12, 9, 0.5 * metre), 2.0 * metre);
    set_heights(water, [](double x, double z) { return 2 + 0.1 * std::sin(x) * std::cos(z); });
    const auto pool = world.add(Pool{water});
    for (int i = 0; i < 20; ++i) world.step(0.02 * second);
    const auto got = world.get(pool);
    CHECK(got.surface.state() == world.water(pool).surface().state());
    std::stringstream file;
    save(world, file);
    World loaded{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 0)}, Pools<TestType>{}};
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    world.set(pool, got);
    CHECK(loaded.hash() == world.hash());
    // As heavy as the world's gravity makes it from now on, whatever it was.
    for (auto* one : {&world, &loaded}) {
        one->set(Gravity{});
        for (int i = 0; i < 20; ++i) one->step(0.02 * second);
    }
    CHECK(loaded.hash() == world.hash());
    // Where nothing weighs, only columns that pull at each other move.
    CHECK((got.surface.state() == water.state()) != std::is_same_v<TestType, WaterColumns>);
}
TEST_CASE("a world in float takes the longest step that it names", "[water]") {
    int rounded_up = 0;
    for (int k = 1; k <= 40; ++k) {
        const Surface water{WaterColumns{(1 + 0.1 * k) * mps}, ColumnGrid(4, 3, 0.37 * metre), 1.0 * metre};
        World<Space<float, 3>, SemiImplicitEuler, Gravity, Pools<WaterColumns>> world{{}, {}, {}, {}};
        world.add(Pool{water});
        const auto exact = water.longest_step();
        const auto longest = world.longest_step_of_water();
        rounded_up += float(exact.value()) > exact.value();
        CHECK(longest <= exact);
        CHECK(longest.value() == Approx(exact.value()).epsilon(1.2e-7));
        CHECK_NOTHROW(world.step(longest));
    }
    CHECK(rounded_up > 5);
}
TEST_CASE("a step of more substeps than its control allows is refused, however fast the water is", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Springs<>{},
                StepLimit<Divide>{.most_parts = 20}};
    Surface water{WaterColumns{3.0 * mps}, ColumnGrid(12, 9, 0.5 * metre), 2.0 * metre};
    const auto pool = world.add(Pool{water});
    const auto hash = world.hash();
    const auto said = refusal([&] { world.step(20.5 * water.longest_step()); });
    CHECK(said.find("Courant's limit), and it is divided into 20 substeps at most") != std::string::npos);
    CHECK(world.hash() == hash);
    world.pour(pool, 1.0 * metre, 1.0 * metre, 0.1 * cubic_metre);
    water.set_height(2, 2, water.height(2, 2) + 0.4 * metre);
    world.step(19.5 * water.longest_step());
    const auto part = 19.5 * water.longest_step() / 20.0;
    for (int i = 0; i < 20; ++i) water.step(part);
    CHECK(world.water(pool).surface().state() == water.state());
    // Whether it may be taken is asked before each step, without memory.
    for (int i = 0; i < 3; ++i) world.step(19.5 * water.longest_step());
    largest = 0;
    before_allocation = measure;
    for (int i = 0; i < 3; ++i) world.step(19.5 * water.longest_step());
    before_allocation = nullptr;
    CHECK(largest == 0);
}
