// SPDX-License-Identifier: BSL-1.0
// What a query of all bodies costs after a change, beside what it costs after a step: where velocities are derived from
// a history, they follow from forces between bodies that the change has made stale.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world.hpp>

#include "tests/performance/race.hpp"

#include <cmath>
#include <memory>

using namespace ansatz;
using namespace ansatz::test;

namespace {

constexpr int bodies = 4000;

auto a_net() {
    using W = World<Verlet, Gravity, Springs<>>;
    auto world = std::make_shared<W>(Verlet{}, Gravity{}, Springs<>{});
    for (int i = 0; i < bodies; ++i)
        world->add(position(metres(0.1 * (i % 63), 0, 0.1 * (i / 63))), mass(0.1 * kilogram));
    for (std::size_t i = 0; i + 1 < bodies; ++i)
        world->add(
            Spring{world->body_at(i), world->body_at(i + 1), 100.0 * newton_per_metre, 0.1 * newton_second_per_metre});
    for (int i = 0; i < 10; ++i) world->step(1e-3 * second);
    return world;
}
double sink = 0;

} // namespace

TEST_CASE("the kinetic energy of a changed world costs at most twice what it costs after a step",
          "[springs][performance][V9]") {
    Race race;
    auto stepped = a_net();
    auto& after_a_step = race.add("kinetic_energy after a step", bodies, [stepped](int times) {
        for (int i = 0; i < times; ++i) sink += kinetic_energy(*stepped).value();
    });
    auto changed = a_net();
    auto& after_a_change = race.add("kinetic_energy after a set_position", bodies, [changed](int times) {
        for (int i = 0; i < times; ++i) {
            changed->set_position(changed->body_at(std::size_t(i) % bodies), metres(0.01 * (i % 7), 1, 0));
            sink += kinetic_energy(*changed).value();
        }
    });
    auto read = a_net();
    auto& a_read = race.add("a velocity of each body", bodies, [read](int times) {
        for (int i = 0; i < times; ++i)
            for (std::size_t k = 0; k < bodies; ++k) sink += std::abs(read->velocity(read->body_at(k)).value()[1]);
    });
    auto written = a_net();
    auto& a_write = race.add("each body is moved, and its velocity read", bodies, [written](int times) {
        for (int i = 0; i < times; ++i)
            for (std::size_t k = 0; k < bodies; ++k) {
                const auto body = written->body_at(k);
                written->set_position(body, metres(0.01 * (i % 7), 1, 0));
                sink += std::abs(written->velocity(body).value()[1]);
            }
    });
    race.bound("after a change over after a step", after_a_change, {&after_a_step}, 2);
    race.bound("a write and a read over a read", a_write, {&a_read}, 4);
    race.run();
    CHECK(sink > 0);
}
