// SPDX-License-Identifier: BSL-1.0
#pragma once

// The same steps of the same bodies, as a World (`by_world`) and as the loop over lanes that somebody writes by hand
// who wants the fewest instructions (`by_hand`). instructions.sh compiles this file and counts with callgrind what each
// of the two executes, callees included; what goes before the steps is outside of both and not counted.

#include <ansatz/collision.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace ansatz::counted {

constexpr std::size_t bodies =
    20'000; // so that the 200 instructions of a step that do not depend on them are below 1 %
constexpr int steps = 100;
inline volatile double unknown_to_the_compiler = 1.0;

template <class T>
void free_flight(T* __restrict x, T* __restrict y, const T* __restrict vx, const T* __restrict vy, T dt) {
    for (std::size_t i = 0; i < bodies; ++i) {
        x[i] += vx[i] * dt;
        y[i] += vy[i] * dt;
    }
}
template <class T>
void free_flight(T* __restrict x, T* __restrict y, T* __restrict z, const T* __restrict vx, const T* __restrict vy,
                 const T* __restrict vz, T dt) {
    for (std::size_t i = 0; i < bodies; ++i) {
        x[i] += vx[i] * dt;
        y[i] += vy[i] * dt;
        z[i] += vz[i] * dt;
    }
}
template <class T> void fall(T* __restrict x, T* __restrict y, T* __restrict vx, T* __restrict vy, T gx, T gy, T dt) {
    for (std::size_t i = 0; i < bodies; ++i) {
        vx[i] += gx * dt;
        vy[i] += gy * dt;
        x[i] += vx[i] * dt;
        y[i] += vy[i] * dt;
    }
}
template <class T>
void fall(T* __restrict x, T* __restrict y, T* __restrict z, T* __restrict vx, T* __restrict vy, T* __restrict vz, T gx,
          T gy, T gz, T dt) {
    for (std::size_t i = 0; i < bodies; ++i) {
        vx[i] += gx * dt;
        vy[i] += gy * dt;
        vz[i] += gz * dt;
        x[i] += vx[i] * dt;
        y[i] += vy[i] * dt;
        z[i] += vz[i] * dt;
    }
}

// The lanes: all positions, then all velocities.
template <class T, int Dim> using Hand = std::array<std::vector<T>, 2 * Dim>;

template <class T, int Dim, bool Falling> [[gnu::noinline]] void by_hand(Hand<T, Dim>& lane, T g, T dt) {
    for (int s = 0; s < steps; ++s) {
        if constexpr (Dim == 2 && Falling)
            fall(lane[0].data(), lane[1].data(), lane[2].data(), lane[3].data(), T(0), g, dt);
        else if constexpr (Dim == 2) free_flight(lane[0].data(), lane[1].data(), lane[2].data(), lane[3].data(), dt);
        else if constexpr (Falling)
            fall(lane[0].data(), lane[1].data(), lane[2].data(), lane[3].data(), lane[4].data(), lane[5].data(), T(0),
                 g, T(0), dt);
        else
            free_flight(lane[0].data(), lane[1].data(), lane[2].data(), lane[3].data(), lane[4].data(), lane[5].data(),
                        dt);
    }
}

template <class T, int Dim, bool Falling, class World>
[[gnu::noinline]] void by_world(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}

template <class T, int Dim, bool Falling> void fly_both() {
    const double h = 0.01 * unknown_to_the_compiler;
    Hand<T, Dim> hand;
    for (auto& lane : hand) lane.assign(bodies, T(1));
    by_hand<T, Dim, Falling>(hand, T(-9.81 * unknown_to_the_compiler), T(h));

    auto world = [] {
        if constexpr (Falling) return World{Space<T, Dim>{}, SemiImplicitEuler{}, Gravity{}};
        else return World{Space<T, Dim>{}, SemiImplicitEuler{}};
    }();
    for (std::size_t i = 0; i < bodies; ++i) {
        if constexpr (Dim == 2) world.add(position(metres(1, 1)), velocity(metres_per_second(1, 1)));
        else world.add(position(metres(1, 1, 1)), velocity(metres_per_second(1, 1, 1)));
    }
    by_world<T, Dim, Falling>(world, h * second);

    // Both must have done the same work, to the bit.
    for (int k = 0; k < Dim; ++k)
        for (std::size_t i = 0; i < bodies; ++i)
            if (world.template lane<Position>(k)[i] != hand[std::size_t(k)][i]) {
                std::puts("the world and the loop written by hand came to different positions");
                std::exit(1);
            }
}

// ---------------------------------------------------------------- bodies that rest
// The same awake bodies, alone (`awake_alone`) and with as many that rest beside them (`awake_beside_resting`).

template <class World> [[gnu::noinline]] void awake_alone(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void awake_beside_resting(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}

template <class World> void rest_both(World alone) {
    const auto h = 0.01 * unknown_to_the_compiler * second;
    for (std::size_t i = 0; i < bodies; ++i)
        alone.add(position(metres(1, 1, 1)), velocity(metres_per_second(1, 1, 1)), mass(1.0 * kilogram));
    World both = alone;
    for (std::size_t i = 0; i < bodies; ++i) both.add(position(metres(1, 1, 1)), mass(1.0 * kilogram), resting);
    awake_alone(alone, h);
    awake_beside_resting(both, h);
    if (alone.count(Motion::awake) != bodies || both.count(Motion::awake) != bodies ||
        both.count(Motion::resting) != bodies) {
        std::puts("some body fell asleep or woke, so that there is nothing to compare");
        std::exit(1);
    }
}

// ---------------------------------------------------------------- bodies that collide, among others that stand still
// 200 balls that roll, alone (`rolling_alone`), with a level of 10,000 fixed ones out of their way
// (`rolling_in_a_level`), and with 10,000 that sleep on the same ground (`rolling_beside_sleepers`); and balls that all
// sleep on the ground, 1,000 (`asleep_few`) and 5,000 (`asleep_many`), of which one wakes, hops and falls asleep again
// (`waking_among_few`, `waking_among_many`).

template <class World> [[gnu::noinline]] void rolling_alone(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void rolling_in_a_level(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void rolling_beside_sleepers(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void asleep_few(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void asleep_many(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}

template <class World> void wake(World& world, Quantity<unit::Time> dt, Handle ball) {
    world.set_velocity(ball, metres_per_second(0, 0.3, 0));
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void waking_among_few(World& world, Quantity<unit::Time> dt, Handle ball) {
    wake(world, dt, ball);
}
template <class World> [[gnu::noinline]] void waking_among_many(World& world, Quantity<unit::Time> dt, Handle ball) {
    wake(world, dt, ball);
}

/// Balls on the ground, in rows of 20 along z.
template <class World, class... Property>
void add_balls(World& world, std::size_t count, double x, const Property&... property) {
    for (std::size_t i = 0; i < count; ++i)
        world.add(Sphere{0.5 * metre}, position(metres(x + 1.5 * double(i % 20), 0.5, 1.5 * double(i / 20))),
                  property...);
}
template <class World> void roll_both(World alone) {
    const auto h = 0.01 * unknown_to_the_compiler * second;
    alone.add(Plane::ground(), fixed);
    add_balls(alone, 200, 0, velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    World both = alone;
    add_balls(both, 10'000, 200, fixed);
    for (World* world : {&alone, &both}) world->step(h); // once, for what is done only once
    rolling_alone(alone, h);
    rolling_in_a_level(both, h);
    if (alone.count(Motion::awake) != 200 || alone.contacts().size() != both.contacts().size()) {
        std::puts("somebody fell asleep, or met the level, so that there is nothing to compare");
        std::exit(1);
    }
}
template <class World> void roll_beside_sleepers(World world) {
    const auto h = 0.01 * unknown_to_the_compiler * second;
    world.add(Plane::ground(), fixed);
    add_balls(world, 10'000, 200, mass(1.0 * kilogram));
    for (int s = 0; s < 200 && world.count(Motion::awake) > 0; ++s) world.step(h);
    add_balls(world, 200, 0, velocity(metres_per_second(1, 0, 0)), mass(1.0 * kilogram));
    for (int s = 0; s < 2; ++s) world.step(h);
    rolling_beside_sleepers(world, h);
    if (world.count(Motion::awake) != 200 || world.count(Motion::resting) != 10'000 ||
        world.contacts().size() != 10'200) {
        std::puts("somebody does not sleep, or not roll, so that there is nothing to compare");
        std::exit(1);
    }
}
template <class World> void sleep_both(World few) {
    const auto h = 0.01 * unknown_to_the_compiler * second;
    few.add(Plane::ground(), fixed);
    World many = few;
    add_balls(few, 1'000, 0, mass(1.0 * kilogram));
    add_balls(many, 5'000, 0, mass(1.0 * kilogram));
    for (World* world : {&few, &many}) {
        for (int s = 0; s < 200 && world->count(Motion::awake) > 0; ++s) world->step(h);
        for (int s = 0; s < 2; ++s) world->step(h);
    }
    asleep_few(few, h);
    asleep_many(many, h);
    if (few.count(Motion::resting) != 1'000 || many.count(Motion::resting) != 5'000) {
        std::puts("somebody does not sleep, so that there is nothing to compare");
        std::exit(1);
    }
    for (World* world : {&few, &many}) wake(*world, h, world->body_at(7)); // once, for what is done only once
    waking_among_few(few, h, few.body_at(few.size() / 2));
    waking_among_many(many, h, many.body_at(many.size() / 2));
    if (few.count(Motion::resting) != 1'000 || many.count(Motion::resting) != 5'000) {
        std::puts("who woke does not sleep again, so that there is nothing to compare");
        std::exit(1);
    }
}

template <class... Response> void collide_all(const Response&... response) {
    const World colliding{Space<float, 3>{}, SemiImplicitEuler{},          Gravity{},  Rest{},
                          UniformGrid{},     Narrowphase<Sphere, Plane>{}, response...};
    roll_both(colliding);
    roll_beside_sleepers(colliding);
    sleep_both(colliding);
}

// ---------------------------------------------------------------- bodies that swing, beside others that hang asleep
// 200 pendulums that swing on springs, alone (`swinging_alone`) and beside 10,000 that hang asleep
// (`swinging_beside_sleepers`); and pendulums that all sleep, 1,000 (`hanging_few`) and 5,000 (`hanging_many`).

template <class World> [[gnu::noinline]] void swinging_alone(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void swinging_beside_sleepers(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void hanging_few(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}
template <class World> [[gnu::noinline]] void hanging_many(World& world, Quantity<unit::Time> dt) {
    for (int s = 0; s < steps; ++s) world.step(dt);
}

/// Bodies on springs of their own, which hang still where nothing stretches them further.
template <class World>
void add_pendulums(World& world, const auto& shape, std::size_t count, double x, double stretched) {
    for (std::size_t i = 0; i < count; ++i) {
        const double at = x + 1.5 * double(i);
        const auto ball = world.add(shape, position(metres(at, -1 - 9.81 / 1000 - stretched, 0)), mass(1.0 * kilogram));
        world.add(Spring{.first = ball,
                         .second = metres(at, 0, 0),
                         .stiffness = 1000.0 * newton_per_metre,
                         .rest_length = 1.0 * metre});
    }
}
template <class World> void swing_and_hang(const World& empty, const auto& shape) {
    const auto h = 0.01 * unknown_to_the_compiler * second;
    const auto hang = [&](std::size_t count) {
        World world = empty;
        add_pendulums(world, shape, count, 0, 0);
        for (int s = 0; s < 200 && world.count(Motion::awake) > 0; ++s) world.step(h);
        for (int s = 0; s < 2; ++s) world.step(h);
        return world;
    };
    World alone = empty, few = hang(1'000), many = hang(5'000), beside = hang(10'000);
    for (World* world : {&alone, &beside}) {
        add_pendulums(*world, shape, 200, -400, 0.05);
        for (int s = 0; s < 3; ++s) world->step(h);
    }
    for (World* world : {&few, &many})
        for (int s = 0; s < 3; ++s) world->step(h);
    swinging_alone(alone, h);
    swinging_beside_sleepers(beside, h);
    hanging_few(few, h);
    hanging_many(many, h);
    if (alone.count(Motion::awake) != 200 || beside.count(Motion::awake) != 200 ||
        beside.count(Motion::resting) != 10'000 || few.count(Motion::resting) != 1'000 ||
        many.count(Motion::resting) != 5'000) {
        std::puts("somebody does not hang asleep, or not swing, so that there is nothing to compare");
        std::exit(1);
    }
}

inline void count_all() {
    fly_both<float, 2, false>();
    fly_both<float, 2, true>();
    fly_both<float, 3, false>();
    fly_both<float, 3, true>();
    fly_both<double, 2, false>();
    fly_both<double, 2, true>();
    fly_both<double, 3, false>();
    fly_both<double, 3, true>();
    rest_both(World{SemiImplicitEuler{}, Rest{}, AppliedForces{}});
    collide_all(Impulse{}, Projection{});
    collide_all(SoftSubsteps{});
    swing_and_hang(World{SemiImplicitEuler{}, Gravity{}, Springs{}, Rest{}}, shapeless);
    swing_and_hang(
        World{VelocityVerlet{}, Gravity{}, Springs{}, Rest{}, Narrowphase<Sphere>{}, UniformGrid{}, SoftSubsteps{}},
        Sphere{0.5 * metre});
}

} // namespace ansatz::counted
