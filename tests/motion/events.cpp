// SPDX-License-Identifier: BSL-1.0
// Events are polled: what slept and what woke, in the last step and since the one before it.

#include <ansatz/motion/events.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {
template <class W> std::vector<Event> events_of(const W& world) {
    return {world.events().begin(), world.events().end()};
}
using List = std::vector<Event>;
} // namespace

TEMPLATE_TEST_CASE("falling asleep and waking are told once, with the body", "[world][events]", SemiImplicitEuler,
                   Verlet, ImplicitEuler) {
    World world{TestType{}, AppliedForces{}, Rest{0.05 * metre_per_second, 0.5 / 64 * second}};
    const auto other = world.add(velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    const auto body = world.add(mass(1.0 * kilogram));
    CHECK(world.events().empty());
    world.step(1.0 / 64 * second);
    CHECK(events_of(world) == List{{Event::Kind::slept, body}});
    CHECK(world.motion(body) == Motion::resting);
    world.step(1.0 / 64 * second);
    CHECK(world.events().empty());
    world.apply_force(body, newtons(100, 0, 0));
    CHECK(world.events().empty()); // what happens between steps is told together with the next one
    world.wake(body);              // awake already
    world.wake(other);
    world.step(1.0 / 64 * second);
    CHECK(events_of(world) == List{{Event::Kind::woke, body}});
    world.set_velocity(other, metres_per_second(0, 0, 0));
    world.step(1.0 / 64 * second);
    CHECK(events_of(world) == List{{Event::Kind::slept, other}});
}

TEST_CASE("a body can wake and fall asleep in one step, and both are told in that order", "[world][events]") {
    World world{SemiImplicitEuler{}, Rest{0.05 * metre_per_second, 0.0 * second}};
    const auto body = world.add(resting);
    world.wake(body);
    world.step(1.0 / 64 * second);
    CHECK(events_of(world) == List{{Event::Kind::woke, body}, {Event::Kind::slept, body}});
}

TEST_CASE("a body that a later force wakes within the step is told", "[world][events]") {
    World world{SemiImplicitEuler{}, Later{2.5 / 64 * second}, Rest{}};
    const auto first = world.add(resting), ground = world.add(fixed), second_one = world.add(resting);
    for (int i = 0; i < 3; ++i) {
        world.step(1.0 / 64 * second);
        CHECK(world.events().empty());
    }
    world.step(1.0 / 64 * second);
    CHECK(world.events().size() == 2);
    CHECK(world.motion(first) == Motion::awake);
    CHECK(world.motion(second_one) == Motion::awake);
    CHECK(world.motion(ground) == Motion::fixed);
}

TEST_CASE("events are kept by a step of zero, copied with the world, and empty where no body rests",
          "[world][events]") {
    World world{SemiImplicitEuler{}, Rest{0.05 * metre_per_second, 0.0 * second}};
    const auto body = world.add();
    world.step(1.0 / 64 * second);
    world.step(0.0 * second);
    const auto copy = world;
    CHECK(events_of(copy) == List{{Event::Kind::slept, body}});
    world.wake(body);
    auto waiting = world; // told in the copy's next step as well
    waiting.step(1.0 / 64 * second);
    CHECK(waiting.events().front() == Event{Event::Kind::woke, body});
    World restless{SemiImplicitEuler{}};
    restless.add();
    restless.step(1.0 / 64 * second);
    CHECK(restless.events().empty());
}

TEST_CASE("the buffers by themselves: what is between steps comes first", "[world][events]") {
    Events events;
    events.reserve(2);
    events.between_steps({Event::Kind::woke, Handle{1, 0}});
    CHECK(events.now().empty());
    events.begin_step();
    events.in_step({Event::Kind::slept, Handle{2, 0}});
    REQUIRE(events.now().size() == 2);
    CHECK(events.now()[0] == Event{Event::Kind::woke, Handle{1, 0}});
    CHECK(events.now()[1] == Event{Event::Kind::slept, Handle{2, 0}});
    events.begin_step();
    CHECK(events.now().empty());
}
