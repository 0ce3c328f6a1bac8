// SPDX-License-Identifier: BSL-1.0
// Forces of springs between bodies that rest are kept from step to step. A copy of a world keeps nothing yet: whatever
// is done to chains of which most hang asleep, it goes on to the same bits.

#include "tests/dice.hpp"
#include "tests/springs/support.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/motion/still_forces.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

using namespace spring_tests;
using ansatz::test::Dice;

namespace {

constexpr double dt = 1.0 / 60;

/// Thirty chains of one to four links on hooks of their own, some of them tied to their neighbours, and what happens to
/// them.
template <class World_, class E> class Chains {
public:
    using S = typename World_::S;

    Chains(const World_& empty, std::uint64_t seed) : world(empty), dice_(seed) {
        for (int i = 0; i < 30; ++i) {
            auto above =
                i % 3 == 0 ? world.add(shapeless, at<S>(i, 0), moving) : world.add(shapeless, at<S>(i, 0), fixed);
            const int links = 1 + i % 4;
            for (int k = 1; k <= links; ++k) {
                const auto link = world.add(shapeless, at<S>(i, -0.3 * k), mass(0.5 * kilogram));
                tie(above, link);
                if (i % 5 == 0 && k == 1 && i > 0)
                    world.add(E{.first = link, .second = point(world, i, -0.8), .stiffness = 20.0 * N_per_m});
                above = link;
            }
        }
    }
    /// Whatever a program may do to one of them.
    void do_something() {
        const auto all = world.handles();
        const auto one = all[dice_.below(all.size())];
        const auto ties = world.template elements<E>().handles();
        const bool is_free = world.motion(one) == Motion::awake || world.motion(one) == Motion::resting;
        switch (dice_.below(12)) {
        case 0: return world.set_position(one, world.position(one) + vector_in<S, unit::Length>(0.01, -0.02));
        case 1:
            return world.motion(one) == Motion::fixed
                       ? void()
                       : world.set_velocity(one, vector_in<S, unit::Velocity>(0.02, 0.1));
        case 2: return is_free ? world.set_mass(one, 0.6 * kilogram) : void();
        case 3: return is_free ? world.wake(one) : void();
        case 4: return all.size() > 60 ? world.remove(one) : void();
        case 5: return ties.size() > 50 ? world.remove(ties[dice_.below(ties.size())]) : void();
        case 6: {
            const auto which = ties[dice_.below(ties.size())];
            auto changed = world.get(which);
            changed.stiffness = changed.stiffness * 1.1;
            return world.set(which, changed);
        }
        case 7: return tie(one, world.add(shapeless, at<S>(dice_.below(30), -2), mass(0.2 * kilogram)));
        case 8: {
            const auto other = all[dice_.below(all.size())];
            if (!(other == one) && norm(world.position(one) - world.position(other)).value() < 1.5) tie(one, other);
            return;
        }
        case 9: return static_cast<void>(world.add(shapeless, at<S>(dice_.below(30), 3), fixed));
        case 10:
            return world.motion(one) == Motion::moving ? world.set_velocity(one, vector_in<S, unit::Velocity>(0, 0))
                                                       : void();
        default: {
            auto copy = world; // which has tested no body, and is assigned to one that has
            world = copy;
        }
        }
    }

    World_ world;

private:
    void tie(Handle a, Handle b) {
        world.add(E{.first = a,
                    .second = b,
                    .stiffness = 200.0 * N_per_m,
                    .damping = 4.0 * N_s_per_m,
                    .rest_length = 0.3 * metre});
    }
    Dice dice_;
};

template <class E, class... P> void goes_on_as_a_copy_does(std::uint64_t seed, P... policies) {
    Chains<World<P...>, E> chains(World{policies...}, seed);
    Dice dice(seed + 1);
    int most_sleep = 0, nobody_moves = 0;
    for (int step = 0; step < 3000; ++step) {
        if (step > 600 && dice.one_in(step % 1000 < 500 ? 150 : 8)) chains.do_something();
        auto& world = chains.world;
        auto copy = world;
        world.step(dt * second);
        copy.step(dt * second);
        INFO("step " << step);
        REQUIRE(world.hash() == copy.hash());
        REQUIRE(std::equal(world.events().begin(), world.events().end(), copy.events().begin(), copy.events().end()));
        for (int k = 0; k < Chains<World<P...>, E>::S::dimension; ++k) { // of fixed ends, too
            const auto forces = world.template lane<CoupledForce>(k), fresh = copy.template lane<CoupledForce>(k);
            REQUIRE(std::equal(forces.begin(), forces.end(), fresh.begin(), fresh.end()));
        }
        most_sleep += world.count(Motion::resting) > 2 * world.count(Motion::awake);
        nobody_moves += world.count(Motion::awake) == 0;
    }
    CHECK(most_sleep > 250); // or nothing was tested
    CHECK(nobody_moves < 2700);
}
} // namespace

TEST_CASE("forces that are kept between sleepers are those that a copy sums anew", "[springs][rest]") {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        SECTION("semi-implicit, seed " + std::to_string(seed)) {
            goes_on_as_a_copy_does<Spring>(seed, SemiImplicitEuler{}, Gravity{}, Drag{2.0 / second}, Springs{}, Rest{});
        }
        SECTION("with history, of float, in a plane, seed " + std::to_string(seed)) {
            goes_on_as_a_copy_does<Spring>(seed, Space<float, 2>{}, Verlet{}, Gravity{}, Drag{2.0 / second}, Springs{},
                                           Rest{});
        }
        SECTION("in stages, seed " + std::to_string(seed)) {
            goes_on_as_a_copy_does<Spring>(seed, RungeKutta4{}, Gravity{}, Drag{2.0 / second}, Springs<Breaking>{},
                                           Rest{});
        }
        SECTION("ropes, undamped, seed " + std::to_string(seed)) {
            goes_on_as_a_copy_does<Rope>(seed, VelocityVerlet{}, Gravity{}, Drag{3.0 / second}, Ropes{}, Rest{});
        }
        SECTION("as one system, seed " + std::to_string(seed)) {
            goes_on_as_a_copy_does<Spring>(seed, ImplicitEuler{}, Gravity{}, Drag{2.0 / second}, Springs{}, Rest{});
        }
        SECTION("where bodies collide, seed " + std::to_string(seed)) {
            goes_on_as_a_copy_does<Spring>(seed, SemiImplicitEuler{}, Gravity{}, Drag{2.0 / second}, Springs{}, Rest{},
                                           SoftSubsteps<>{}, BoundingBoxes{}, Narrowphase<Sphere, Plane>{});
        }
    }
}

namespace {
/// Lifts the body of id 0 by a centimetre in the hundredth step.
struct Lift {
    using role = roles::System;
    static constexpr std::string_view name = "Lift";
    template <class S> struct State {
        int steps = 0;
        static void fields(auto& self, auto&& field) { field("steps", self.steps); }
    };
    template <class S> struct Raise {
        using writes = Columns<Position>;
        static constexpr Phase phase = phases::begin;
        static constexpr std::string_view name = "lift";
        explicit Raise(const Lift&) {}
        void run(auto& view, const auto&) const {
            if (++view.state().steps != 100) return;
            const auto slot = view.slot_of_id(0);
            view.template set<Position>(slot, view.template get<Position>(slot) + metres(0, 0.01, 0));
        }
    };
    template <class S> using systems = Types<Raise<S>>;
};
} // namespace

TEST_CASE("what hangs on a hook that a system lifts wakes", "[springs][rest][R11]") {
    World world{SemiImplicitEuler{}, Gravity{}, Springs{}, Rest{}, Lift{}};
    std::vector<Handle> hang;
    for (int i = 0; i < 40; ++i) {
        const auto hook = world.add(position(metres(i, 0, 0)), fixed);
        hang.push_back(world.add(position(metres(i, -1 - 9.81e-3, 0)), mass(1.0 * kilogram)));
        world.add(Spring{
            .first = hook, .second = hang[std::size_t(i)], .stiffness = 1000.0 * N_per_m, .rest_length = 1.0 * metre});
    }
    run(world, 99, dt);
    REQUIRE(world.count(Motion::resting) == 40);
    run(world, 1, dt);
    CHECK(world.motion(hang[0]) == Motion::awake);
    CHECK(world.count(Motion::resting) == 39);
}

TEST_CASE("a rope that comes taut wakes bodies that hang asleep on it, as in a copy", "[springs][rest][R11]") {
    // Slow enough to be on its way to sleep itself, or so fast that it wakes the body that it is tied to.
    for (const double speed : {0.04, 0.045, 0.5, 2.0}) {
        World world{SemiImplicitEuler{}, Ropes{}, Rest{}};
        std::vector<Handle> still;
        for (int i = 0; i < 40; ++i) {
            still.push_back(world.add(position(metres(i, 0, 0)), mass(1.0 * kilogram)));
            world.add(Rope{.first = still.back(),
                           .second = metres(i, 1, 0),
                           .stiffness = 100.0 * N_per_m,
                           .rest_length = 2.0 * metre});
        }
        const auto leaves = world.add(position(metres(20, 0, 1)), mass(1.0 * kilogram));
        world.add(
            Rope{.first = leaves, .second = still[20], .stiffness = 100.0 * N_per_m, .rest_length = 1.01 * metre});
        run(world, 60, dt);
        REQUIRE(world.count(Motion::resting) == 41);
        world.set_velocity(leaves, metres_per_second(0, 0, speed));
        int step = 0;
        for (; step < 60 && world.motion(still[20]) == Motion::resting; ++step) {
            auto copy = world;
            world.step(dt * second);
            copy.step(dt * second);
            INFO(speed << " m/s, step " << step);
            REQUIRE(world.hash() == copy.hash());
        }
        CHECK(world.motion(still[20]) == Motion::awake);
        CHECK(step >= int(0.01 / speed / dt)); // not before it is taut
        CHECK(world.count(Motion::resting) == 39);
    }
}
