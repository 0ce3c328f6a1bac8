// SPDX-License-Identifier: BSL-1.0
// Queries of a world that was changed: what the forces between bodies are asked for them, and that a change of one body
// is no push for another.

#include <ansatz/motion/present.hpp>

#include "tests/motion/support.hpp"

#include <ansatz/springs.hpp>

#include <random>
#include <thread>
#include <vector>

using namespace motion_tests;

namespace {

int asked = 0;

/// Pulls each body to the next one, and counts how often it is asked.
template <bool Damped> struct Chain {
    using role = roles::Force;
    using reads = std::conditional_t<Damped, Columns<Position, Velocity>, Columns<Position>>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Chain&) {}
        void couple(auto& view, const auto&) const {
            ++asked;
            for (std::size_t i = 0; i + 1 < view.size(); ++i) {
                const auto apart = view.template get<Position>(i + 1) - view.template get<Position>(i);
                auto pull = (typename S::Scalar(3) * apart.value()).eval();
                if constexpr (Damped)
                    pull += typename S::Scalar(0.2) *
                            (view.template get<Velocity>(i + 1) - view.template get<Velocity>(i)).value();
                view.add_force_pair(i, i + 1, S::Force::from_value(pull));
            }
        }
    };
};

template <class I, bool Damped = true> auto a_chain(int n) {
    World world{I{}, Gravity{}, Chain<Damped>{}};
    for (int i = 0; i < n; ++i)
        world.add(position(metres(i, 0.1 * i * i, 0)), velocity(metres_per_second(0, 0.1 * i, 0)),
                  mass((1 + 0.1 * i) * kilogram));
    for (int i = 0; i < 5; ++i) world.step(1.0 / 60 * second);
    return world;
}

} // namespace

TEMPLATE_TEST_CASE("queries of a changed world ask the forces between bodies once for each change",
                   "[motion][coupling][V9]", Verlet, SemiImplicitEuler, ExplicitEuler, VelocityVerlet, RungeKutta4) {
    constexpr int n = 40;
    auto world = a_chain<TestType, false>(n);
    const auto accelerations = [&] {
        for (std::size_t i = 0; i < n; ++i) CHECK(is_finite(world.acceleration(world.body_at(i))));
    };
    world.set_position(world.body_at(3), metres(3, 2, 1));
    asked = 0;
    CHECK(is_finite(kinetic_energy(world)));
    CHECK(asked == 0); // no velocity is another
    accelerations();
    CHECK(asked == 1);
    accelerations();
    CHECK(is_finite(kinetic_energy(world)));
    CHECK(asked == 1);
    world.set_velocity(world.body_at(5), metres_per_second(1, 2, 3)); // which this force does not read
    accelerations();
    CHECK(asked == 1);
    world.set_position(world.body_at(5), metres(1, 2, 3));
    accelerations();
    CHECK(asked == 2);
    const auto copy = world;
    CHECK(copy.acceleration(copy.body_at(7)) == world.acceleration(world.body_at(7)));
    CHECK(asked == 3); // the copy's own
    world = copy;
    accelerations();
    CHECK(asked == 4);

    asked = 0; // many changes, and what was changed is read
    for (std::size_t i = 0; i < n; ++i) {
        world.set_position(world.body_at(i), metres(double(i), 1, 0));
        CHECK(is_finite(world.velocity(world.body_at(i))));
        world.set_mass(world.body_at(i), 2.0 * kilogram);
        CHECK(is_finite(world.velocity(world.body_at(i))));
    }
    CHECK(asked <= 1);
}

TEST_CASE("where a force reads velocities that a history holds, it is asked until they agree, for all queries at once",
          "[motion][coupling]") {
    auto world = a_chain<Verlet>(40);
    world.set_position(world.body_at(3), metres(3, 2, 1));
    asked = 0;
    CHECK(is_finite(kinetic_energy(world)));
    CHECK(asked == 0);
    for (std::size_t i = 0; i < 40; ++i) CHECK(is_finite(world.acceleration(world.body_at(i))));
    CHECK(asked <= 9); // motion/coupling.hpp: at most eight times more
}

TEST_CASE("a query is that of the world as it will go on", "[motion][coupling]") {
    // The acceleration that a changed world tells is the one that a world tells which was given this state.
    auto world = a_chain<VelocityVerlet>(7);
    world.set_position(world.body_at(2), metres(9, 8, 7));
    World fresh{VelocityVerlet{}, Gravity{}, Chain<true>{}};
    for (std::size_t i = 0; i < 7; ++i) {
        const auto body = world.body_at(i);
        fresh.add(position(world.position(body)), velocity(world.velocity(body)), mass(world.mass(body)));
    }
    for (std::size_t i = 0; i < 7; ++i)
        CHECK(world.acceleration(world.body_at(i)) == fresh.acceleration(fresh.body_at(i)));
}

TEMPLATE_TEST_CASE("a query sees what was changed since the last one, also what no force between bodies reads",
                   "[motion][coupling]", Verlet, SemiImplicitEuler, RungeKutta4) {
    World world{TestType{}, Gravity{}, AppliedForces{}, QuadraticDrag{}, Chain<false>{}, Rest{}};
    std::vector<Handle> all;
    for (int i = 0; i < 7; ++i)
        all.push_back(i % 3 == 2 ? world.add(position(metres(i, 0.1 * i * i, 0)), mass(1.0 * kilogram), resting)
                                 : world.add(position(metres(i, 0.1 * i * i, 0)), mass((1 + 0.1 * i) * kilogram)));
    const auto sees = [&](auto&& change) {
        world.set_position(all[6], metres(7, 6, 5));
        for (const auto body : all) CHECK(is_finite(world.acceleration(body)));
        change();
        const auto copy = world; // which has answered nothing yet
        for (const auto body : all) {
            CHECK(world.acceleration(body) == copy.acceleration(body));
            CHECK(world.velocity(body) == copy.velocity(body));
        }
    };
    for (int step = 0; step < 3; ++step) {
        sees([&] { world.apply_force(all[3], newtons(1, 2, 3)); });
        sees([&] { world.set_mass(all[3], 5.0 * kilogram); });
        sees([&] { world.set_velocity(all[3], metres_per_second(4, 5, 6)); });
        sees([&] { world.apply_impulse(all[1], newton_seconds(4, 5, 6)); });
        sees([&] { world.wake(all[5]); });
        sees([&] { world.remove(world.add(position(metres(1, 2, 3)), mass(1.0 * kilogram))); });
        world.step(1.0 / 60 * second);
    }
}

TEMPLATE_TEST_CASE("whatever is changed, and however often, no other body is pushed by it", "[motion][coupling]",
                   Verlet, SemiImplicitEuler) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const auto draw = [&](double low, double high) {
            return low + (high - low) * double(random()) / double(std::mt19937::max());
        };
        auto world = a_chain<TestType>(9);
        for (int i = 0; i < 60; ++i) {
            const auto size = std::uint32_t(world.size());
            const auto body = world.body_at(random() % size);
            std::vector<std::pair<Handle, Eigen::Vector3d>> before;
            world.for_each([&](Handle other) {
                if (other != body) before.emplace_back(other, world.velocity(other).value());
            });
            const auto verb = random() % 8;
            const double number = draw(0.5, 4);
            CAPTURE(i, verb, number);
            if (verb == 0) world.set_position(body, metres(number, 1, 0));
            if (verb == 1) world.set_velocity(body, metres_per_second(0, number, 0));
            if (verb == 2) world.set_mass(body, number * kilogram);
            if (verb == 3) world.apply_impulse(body, newton_seconds(0, 0, number));
            if (verb == 4 && size > 3) world.remove(body);
            if (verb == 5) world.add(position(metres(number, 5, 0)), mass(number * kilogram));
            if (verb == 6) world.hash(); // asks, and changes nothing
            if (verb == 7) world.set(Gravity{metres_per_second_squared(0, -number, 0)});
            for (const auto& [other, was] : before) {
                CAPTURE(other.id);
                REQUIRE((world.velocity(other).value() - was).norm() <= 1e-11 * (1 + was.norm()));
            }
            if (i % 7 == 6) world.step(1.0 / 60 * second);
        }
    }
}

TEST_CASE("several threads may ask a changed world at once", "[motion][coupling]") {
    auto world = a_chain<Verlet>(30);
    world.set_mass(world.body_at(3), 7.0 * kilogram);
    const auto& seen = std::as_const(world);
    const auto reference = world;
    std::vector<Eigen::Vector3d> said(4);
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < said.size(); ++t)
            threads.emplace_back([&, t] { said[t] = seen.acceleration(seen.body_at(4)).value(); });
    }
    for (const auto& a : said) CHECK(a == reference.acceleration(reference.body_at(4)).value());
}
