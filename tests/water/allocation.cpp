// SPDX-License-Identifier: BSL-1.0
// No step of a surface allocates once warm, no filling of a map does, and no ring; a copy takes what it needs at once.

#include <ansatz/water.hpp>

#include "tests/operator_new.hpp"
#include "tests/water/support.hpp"

using namespace water_tests;

namespace {
std::size_t allocations = 0;
bool count(std::size_t) noexcept {
    ++allocations;
    return true;
}
template <class F> std::size_t during(F&& f) {
    allocations = 0;
    ansatz::test::before_allocation = count;
    f();
    ansatz::test::before_allocation = nullptr;
    return allocations;
}
template <class Policy> std::size_t in_warm_steps(const Policy& policy) {
    Surface water(policy, unequal(9, 7), 2.0 * metre);
    set_heights(water, [](double x, double z) { return 2 + 0.3 * std::sin(x) * std::cos(z); });
    water.step(0.01 * second);
    auto copy = water;
    return during([&] {
        for (int n = 0; n < 70; ++n) {
            water.step(0.01 * second);
            copy.step(0.01 * second);
        }
    });
}
} // namespace

TEST_CASE("a warm step allocates nothing", "[water]") {
    REQUIRE(during([] { std::vector<int>(3).at(0) = 1; }) > 0); // the count counts
    CHECK(in_warm_steps(WaterColumns{3.0 * mps, 0.1 / second}) == 0);
    CHECK(in_warm_steps(WaterColumns{.wave_speed = 3.0 * mps, .walls = Walls::all(Wall::absorbs)}) == 0);
    CHECK(in_warm_steps(ClampedColumns{{3.0 * mps}, {1.9 * metre, 2.1 * metre}}) == 0);
    CHECK(in_warm_steps(Pipes{}) == 0);
    CHECK(in_warm_steps(ShallowWater{}) == 0);
    CHECK(in_warm_steps(SecondOrderShallowWater{}) == 0);
}

TEST_CASE("heights of waves and rings allocate nothing", "[water]") {
    const Waves waves({{8.0 * metre, 0.2 * metre}, {3.0 * metre, 0.1 * metre, 1.0}});
    const GerstnerWaves sharp(waves, 0.8);
    std::vector<float> heights(100 * 20);
    Ripples rings(4);
    Ripples copy = rings;
    CHECK(during([&] {
              waves.fill(std::span<float>(heights), 100, 20, 0.0 * metre, 0.0 * metre, 0.1 * metre, 0.1 * metre,
                         1.0 * second);
              (void)sharp.height(1.0 * metre, 2.0 * metre, 3.0 * second);
              for (auto* some : {&rings, &copy})
                  for (int n = 0; n < 9; ++n) {
                      some->begin({.x = 0.0 * metre, .z = 0.0 * metre, .begun = double(n) * second});
                      (void)some->height(1.0 * metre, 0.0 * metre, double(n) * second);
                  }
              rings.forget_faded(100.0 * second);
          }) == 0);
}
