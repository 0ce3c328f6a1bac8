// SPDX-License-Identifier: BSL-1.0
// What went wrong inside steps is a status that is polled: a state that is no number, an equation that was not solved.

#include <ansatz/world/data.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <sstream>

using namespace ansatz;
using namespace ansatz::test;

TEST_CASE("a world whose numbers are finite is well, an infinite one says which", "[world][data]") {
    World world{SemiImplicitEuler{}, AppliedForces{}, Keep<Heat>{}};
    const auto first = world.add(mass(1.0 * kilogram)), fast = world.add(mass(1.0 * kilogram)),
               faster = world.add(mass(1.0 * kilogram));
    CHECK(world.status().ok());
    world.set_velocity(fast, metres_per_second(1e308, 0, 0));
    world.set_velocity(faster, metres_per_second(0, -1e308, 0));
    CHECK(world.status().ok());
    world.step(100.0 * second); // 1e310 m: the step neither throws nor hides it
    const auto status = world.status();
    CHECK_FALSE(status.ok());
    CHECK(status.not_finite == 2);
    CHECK(status.first_not_finite == fast);
    CHECK(status.unsolved == 0);
    std::ostringstream text;
    text << status;
    CHECK(text.str() == "2 bodies not finite, the first is body 1");
    CHECK(describe(Status{false, 3, 0, {}}) == "3 body steps unsolved");
    CHECK(describe(Status{false, 3, 1, first}) == "3 body steps unsolved, 1 bodies not finite, the first is body 0");
    CHECK(describe(Status{true, 0, 0, {}}) == "a step was broken off by an exception");
    CHECK(describe(Status{}) == "ok");
    CHECK(world.position(first) == metres(0, 0, 0)); // and the others are not drawn into it
    world.remove(fast);
    CHECK(world.status().first_not_finite == faster);
    world.set_position(faster, metres(0, 0, 0));
    CHECK(world.status().ok());
}

namespace {
/// a = c x^2 with its derivative: x' = v', v' = c x^2 has no implicit solution for a large step.
struct Explosive {
    using role = roles::Force;
    using reads = Columns<Position>;
    template <class S> struct In {
        explicit In(const Explosive&) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            auto a = x.value();
            for (int i = 0; i < S::dimension; ++i) a[i] *= a[i];
            return S::Acceleration::from_value(a);
        }
        Jacobian<S> jacobian(const typename S::Position& x, const auto&) const {
            Jacobian<S> j{};
            auto m = j.position.value();
            for (int i = 0; i < S::dimension; ++i) m(i, i) = 2 * x.value()[i];
            j.position = decltype(j.position)::from_value(m);
            return j;
        }
    };
};
} // namespace

TEST_CASE("an equation without a solution is counted, and the step goes on", "[world][data]") {
    // x1 = x0 + dt^2 x1^2 has no real root when 4 dt^2 x0 > 1.
    World world{ImplicitEuler{}, Explosive{}};
    world.add(position(metres(10, 0, 0)));
    const auto still = world.add(position(metres(0.01, 0, 0)));
    world.step(1.0 * second);
    CHECK(world.status().unsolved == 1);
    CHECK_FALSE(world.status().ok());
    // The other has the smaller root of x = 0.01 + x^2.
    CHECK(world.position(still).value()[0] == Catch::Approx((1 - std::sqrt(1 - 0.04)) / 2).epsilon(1e-14));
    world.step(0.0 * second);
    CHECK(world.status().unsolved == 1);
}

TEMPLATE_TEST_CASE("what was set is what is read, before, between and after steps", "[world][data]", SemiImplicitEuler,
                   Verlet) {
    World world{TestType{}, ToOrigin{}, Keep<InverseMass>{}};
    const auto body = world.add(position(metres(1, 2, 3)), velocity(metres_per_second(4, 5, 6)), mass(2.0 * kilogram));
    CHECK(world.velocity(body) ==
          metres_per_second(4, 5, 6)); // also where the integrator keeps history, before it has any
    CHECK(world.acceleration(body) == metres_per_second_squared(-1, -2, -3));
    for (int i = 0; i < 3; ++i) {
        world.step(1.0 / 60 * second);
        world.set_velocity(body, metres_per_second(7, 8, 9));
        CHECK(same_bits(world.velocity(body), metres_per_second(7, 8, 9)));
        const auto x = world.position(body);
        CHECK(same_bits(world.position(body), x)); // a new velocity does not move it
        world.set_position(body, metres(i, 2, 3));
        CHECK(same_bits(world.position(body), metres(i, 2, 3)));
        CHECK((world.velocity(body) - metres_per_second(7, 8, 9)).value().norm() == 0); // and a teleport is no velocity
        world.set_mass(body, 0.5 * kilogram);
        world.apply_impulse(body, newton_seconds(1, 0, 0));
        CHECK(world.velocity(body) == metres_per_second(9, 8, 9));
    }
    const auto row = world.row(body);
    CHECK(row.template get<Position>() == world.position(body));
    CHECK(row.template get<Velocity>() == world.velocity(body));
    CHECK(row.template get<InverseMass>() == 2.0 / kilogram);
}
