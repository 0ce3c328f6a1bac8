// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include <cmath>
#include <vector>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Force = ansatz::Quantity<ansatz::unit::Force>;
using Frequency = ansatz::Quantity<ansatz::unit::Frequency>;

struct Chain {
    int links;
    ansatz::Quantity<ansatz::unit::Mass> mass;
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
    Length rest_length;
};

/// A world that holds the chain asks each link for its force: it is stretched so far that it holds up what is below it.
inline Length hangs_at(int body, const Chain& chain, ansatz::Quantity<ansatz::unit::Acceleration> g) {
    const Length metre = 1.0 * ansatz::metre;
    Length below = 0.0 * metre;
    Force carried = 0.0 * ansatz::newton;
    for (int link = chain.links; link >= 1; --link) {
        carried += chain.mass * g;
        if (link > body) continue;
        const Force of_a_metre =
            ansatz::springs::tension(chain.rest_length + metre, chain.rest_length, 0.0 * ansatz::metre_per_second,
                                     chain.stiffness, 0.0 * ansatz::newton_second_per_metre);
        below += chain.rest_length + double(carried / of_a_metre) * metre;
    }
    return below;
}
/// Bodies of one kilogram that are let go: after a step from rest the velocity is the acceleration.
inline std::vector<Force> forces(const std::vector<Length>& moved,
                                 ansatz::Quantity<ansatz::unit::Stiffness> stiffness) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Springs<Undamped>{}};
    const Length rest_length = 1000.0 * metre; // so long that no body passes another
    std::vector<Handle> chain;
    SpringEnd above = metres(0, 0, 0);
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const double at = (double(i + 1) * rest_length + moved[i]).value();
        chain.push_back(world.add(position(metres(0, at, 0)), mass(1.0 * kilogram)));
        world.add(Spring{above, chain.back(), stiffness, {}, rest_length});
        above = chain.back();
    }
    world.step(1.0 * second);
    std::vector<Force> on;
    for (const Handle& body : chain) on.push_back(1.0 * kilogram * (y(world.velocity(body)) / (1.0 * second)));
    return on;
}
/// By the energy of one body and one link: where all bodies pass where they hang, with omega, all of it moves; the
/// links hold as much, who are stretched by up to 2 sin(kappa / 2).
inline Frequency angular_frequency(double angle, const Chain& chain) {
    const Length one = 1.0 * ansatz::metre;
    const auto held = ansatz::springs::energy(chain.stiffness, 2 * std::sin(angle / 2) * one);
    return ansatz::sqrt(2.0 * held / (chain.mass * one * one));
}
inline Frequency group_speed(double angle, const Chain& chain) {
    const double by = 1e-4;
    // Below zero the energy no longer tells the sign.
    const double less = angle - by < 0 ? -1 : 1;
    return (angular_frequency(angle + by, chain) - less * angular_frequency(angle - by, chain)) / (2 * by);
}

} // namespace exercise
