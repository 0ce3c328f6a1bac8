// SPDX-License-Identifier: BSL-1.0
// What a field of a user's own does, of field.hpp.

#include "tests/world/systems/field.hpp"

#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

using namespace examples;

namespace {

template <class I> auto pool_with_blocks() {
    World world{I{}, Gravity{}, Pool{}};
    world.fill();
    world.add(position(metres(4, 2.4, 0)), mass(50.0 * kilogram), with<Tall>(0.4 * metre));
    const auto block = world.add(position(metres(11, 3, 0)), mass(60.0 * kilogram), with<Tall>(0.4 * metre));
    return std::pair(world, block);
}

} // namespace

TEMPLATE_TEST_CASE("A field of a user's own carries bodies, is pressed by them and keeps its volume", "[systems]",
                   SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4) {
    auto [world, block] = pool_with_blocks<TestType>();
    const double at_first = world.water();
    double farthest = 0;
    for (int i = 0; i < 3000; ++i) {
        world.step(0.005 * second);
        farthest = std::max(farthest, std::abs(world.water() - at_first));
    }
    CHECK(world.status().ok());
    CHECK(farthest / at_first < 1e-12);
    // Archimedes: 60 kg under 0.25 m^2 of water sink 0.24 m below the level around them, which both have raised.
    CHECK(world.level_at(11) - (world.position(block).value()[1] - 0.2) == Approx(0.24).margin(0.005));
    CHECK(world.level_at(11) > 2.001);
}
TEST_CASE("A world with such a field is a value", "[systems]") {
    auto [world, block] = pool_with_blocks<VelocityVerlet>();
    for (int i = 0; i < 50; ++i) world.step(0.005 * second);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto [loaded, ignored] = pool_with_blocks<VelocityVerlet>();
    CHECK(loaded.hash() != world.hash());
    load(loaded, file);
    for (auto* one : {&world, &copy, &loaded})
        for (int i = 0; i < 50; ++i) one->step(0.005 * second);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    // A number of the field that is another is another hash, or is refused.
    std::string text = file.str();
    const auto flow = text.find("\"flow\"");
    REQUIRE(flow != std::string::npos);
    const auto digit = text.find_first_of("123456789", flow);
    text[digit] = text[digit] == '1' ? '2' : '1';
    std::stringstream changed(text);
    auto [other, ignored_too] = pool_with_blocks<VelocityVerlet>();
    load(other, changed);
    std::stringstream whole(file.str());
    auto [same, ignored_again] = pool_with_blocks<VelocityVerlet>();
    load(same, whole);
    CHECK(other.hash() != same.hash());
}
