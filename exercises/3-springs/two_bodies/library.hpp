// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

namespace exercise {

using Mass = ansatz::Quantity<ansatz::unit::Mass>;
using Length = ansatz::Quantity<ansatz::unit::Length>;
using Velocity = ansatz::Quantity<ansatz::unit::Velocity>;
using Time = ansatz::Quantity<ansatz::unit::Time>;
using Stiffness = ansatz::Quantity<ansatz::unit::Stiffness>;

struct Body {
    Mass mass;
    Length place;
    Velocity velocity;
};
struct Pair {
    Body first, second;
    Stiffness stiffness;
    Length rest_length;
};

inline Time period(Mass first, Mass second, Stiffness stiffness) {
    return 1.0 / ansatz::springs::frequency(stiffness, ansatz::springs::reduced_mass(first, second));
}
/// The library has one spring; of several it adds the forces of one displacement, or the displacements of one force.
inline Stiffness beside(const std::vector<Stiffness>& springs) {
    const Length x = 1.0 * ansatz::metre;
    auto force = 0.0 * ansatz::newton;
    for (const Stiffness& k : springs) force -= ansatz::springs::force(k, x);
    return force / x;
}
inline Stiffness in_a_row(const std::vector<Stiffness>& springs) {
    const auto pull = 1.0 * ansatz::newton;
    Length stretched = 0.0 * ansatz::metre;
    for (const Stiffness& k : springs) {
        Length less = 0.0 * ansatz::metre, more = 1e6 * ansatz::metre;
        for (int i = 0; i < 200; ++i) {
            const Length x = 0.5 * (less + more);
            (-ansatz::springs::force(k, x) < pull ? less : more) = x;
        }
        stretched += less;
    }
    return pull / stretched;
}
/// A world takes steps, so small here that nobody sees them.
inline Pair after(const Pair& pair, Time time) {
    using namespace ansatz;
    World world{VelocityVerlet{}, Springs<Undamped>{}};
    auto add = [&](const Body& body) {
        return world.add(position(metres(body.place.value(), 0, 0)),
                         velocity(metres_per_second(body.velocity.value(), 0, 0)), mass(body.mass));
    };
    const auto a = add(pair.first), b = add(pair.second);
    world.add(Spring{a, b, pair.stiffness, {}, pair.rest_length});
    const auto swing = period(pair.first.mass, pair.second.mass, pair.stiffness);
    const int steps = 1 + int(std::ceil(20000 * double(time / swing)));
    if (time.value() > 0)
        for (int i = 0; i < steps; ++i) world.step(time / double(steps));
    Pair then = pair;
    then.first.place = x(world.position(a)), then.second.place = x(world.position(b));
    then.first.velocity = x(world.velocity(a)), then.second.velocity = x(world.velocity(b));
    return then;
}

} // namespace exercise
