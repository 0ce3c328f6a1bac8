// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// An eventful life of a world, the same each time: bodies that fall asleep and wake, forces that wait for the next
/// step, teleports, impulses, removals, additions, steps of changing length. Tests of copies, of files and of hashes
/// live it in parts and compare.

#include "tests/world/worlds.hpp"

#include <vector>

namespace ansatz::test {

/// What a life needs: bodies with masses that can be pushed and can rest, and a force that begins later.
template <class S, class I> using Eventful = World<S, I, Later, Drag, AppliedForces, Rest, Interpolation, Keep<Heat>>;

template <class S, class I> Eventful<S, I> eventful() {
    return Eventful<S, I>{S{},
                          I{},
                          Later{0.65 * second},
                          Drag{0.5 / second},
                          AppliedForces{},
                          Rest{0.05 * metre_per_second, 0.1 * second},
                          Interpolation{},
                          Keep<Heat>{}};
}

/// Takes step number `i` of the life, with what happens before it. A pending force is part of the state between steps.
template <class W> void live(W& world, int i) {
    auto v = [](double x, double y, double z) { return velocity(vec<W>(metre_per_second, x, y, z)); };
    auto x = [](double px, double py, double pz) { return position(vec<W>(metre, px, py, pz)); };
    const auto all = world.handles();
    if (i == 0) {
        world.add(x(0, 1, 2), v(1, -2, 0.5), mass(1.0 * kilogram), with<Heat>(3.0 * joule));
        world.add(x(5, 0, 0), v(0.01, 0, 0), mass(2.5 * kilogram)); // slow: falls asleep
        world.add(x(-3, 1, 0), v(0, 0.3, 0), moving);
        world.add(x(0, -1, 0), fixed);
        world.add(x(7, 7, 7), resting, mass(0.3 * kilogram));
        world.add(x(8, 7, 6), v(0.02, 0.02, 0), mass(9.0 * kilogram));
    }
    if (i == 3) world.apply_impulse(all[0], vec<W>(newton_second, 0.1, 0.2, 0.3));
    if (i == 12) world.set_position(all[1], vec<W>(metre, 1, 1, 1));
    if (i == 16) world.remove(all[4]);
    if (i == 18) world.add(x(1, 2, 3), v(3, 2, 1), mass(0.1 * kilogram)); // takes the id that has become free
    if (i == 21) world.set_velocity(all[0], vec<W>(metre_per_second, -1, 0, 1));
    if (i == 25) world.template write<Heat>(all[2], 1.0 * joule);
    if (i == 36) world.set(Drag{0.2 / second});
    if (i == 44) world.set_mass(all[0], 3.0 * kilogram);
    if (i == 50) world.remove(all[0]);
    world.step((i % 7 == 6 ? 1.0 / 120 : 1.0 / 60) * second);
    if (i % 10 == 9) world.apply_force(world.handles()[1], vec<W>(newton, 0.5, -0.5, 0.25)); // waits for the next step
}
template <class W> void live(W& world, int from, int to) {
    for (int i = from; i < to; ++i) live(world, i);
}

/// Are two worlds the same to the last bit, in all that a program can read? (Signs of zeros too, unlike hashes.)
template <class W> bool same_to_the_bit(const W& a, const W& b) {
    if (a.handles() != b.handles() || a.tick() != b.tick() || !same_bits(a.time(), b.time()) || a.hash() != b.hash())
        return false;
    for (const Handle h : a.handles()) {
        if (a.motion(h) != b.motion(h) || !same_bits(a.velocity(h), b.velocity(h)) ||
            !same_bits(a.acceleration(h), b.acceleration(h)))
            return false;
        bool same = true;
        [&]<class... C>(Columns<C...>) {
            ((same = same && same_bits(a.template read<C>(h), b.template read<C>(h))), ...);
        }(typename W::composition::state{});
        if (!same) return false;
    }
    return true;
}

} // namespace ansatz::test
