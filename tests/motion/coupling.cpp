// SPDX-License-Identifier: BSL-1.0
// The sums of the forces between bodies: summed once where they can be, and anew where they must.

#include <ansatz/motion/bound_motion.hpp>
#include <ansatz/motion/coupling.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

using namespace ansatz;
using namespace ansatz::test;

namespace {
int asked = 0;
struct Counting {
    using role = roles::Force;
    using reads = Columns<Position, InverseMass>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Counting&) {}
        void couple(auto& view, const auto&) const {
            ++asked;
            view.add_force(0, S::template zero_vector<unit::Force>());
        }
    };
};
template <class W> int asked_in(W& world, int steps, Quantity<unit::Time> dt) {
    asked = 0;
    for (int i = 0; i < steps; ++i) world.step(dt);
    return asked;
}
} // namespace

TEMPLATE_TEST_CASE("a step asks the forces between bodies once for each stage, the sums of its end serve the next",
                   "[world][coupled]", SemiImplicitEuler, VelocityVerlet, RungeKutta4) {
    World world{TestType{}, Counting{}};
    const auto body = world.add(mass(1.0 * kilogram));
    const int stages = TestType::stages;
    CHECK(asked_in(world, 1, 0.5 * second) == stages + 1);
    CHECK(asked_in(world, 10, 0.5 * second) == 10 * stages);
    CHECK(asked_in(world, 1, 0.25 * second) == stages + 1); // another step: a force may depend on its length
    asked = 0;
    (void)world.acceleration(body);
    CHECK(asked == 0);
    world.set_position(body, metres(1, 0, 0));
    (void)world.acceleration(body);
    CHECK(asked == 1);
    CHECK(asked_in(world, 1, 0.25 * second) == stages + 1);
    world.set_velocity(body, metres_per_second(1, 0, 0)); // which this force does not see
    CHECK(asked_in(world, 1, 0.25 * second) == stages);
}

namespace {
struct Shake { // before the forces, in the position, which the force sees
    using role = roles::Effect;
    using writes = Columns<Position>;
    static constexpr Place place = Place::before_forces;
    template <class S> struct In {
        explicit In(const Shake&) {}
        void apply(auto& x, const auto&) const { x = -x; }
    };
};
} // namespace

TEST_CASE("an effect before the forces makes the sums stale only if a force sees what it writes", "[world][coupled]") {
    World drawn{SemiImplicitEuler{}, Counting{}, Interpolation{}};
    drawn.add(mass(1.0 * kilogram));
    CHECK(asked_in(drawn, 1, 0.5 * second) == 2);
    CHECK(asked_in(drawn, 10, 0.5 * second) == 10);
    World shaken{SemiImplicitEuler{}, Counting{}, Shake{}};
    shaken.add(mass(1.0 * kilogram));
    CHECK(asked_in(shaken, 10, 0.5 * second) == 20);
}

TEST_CASE("Verlet asks once in a step, and once more for the start of a history", "[world][coupled][history]") {
    World world{Verlet{}, Counting{}};
    const auto body = world.add(mass(1.0 * kilogram));
    CHECK(asked_in(world, 1, 0.5 * second) == 2);
    CHECK(asked_in(world, 10, 0.5 * second) == 10);
    world.apply_impulse(body, newton_seconds(1, 0, 0));
    CHECK(asked_in(world, 1, 0.5 * second) == 1);
}
