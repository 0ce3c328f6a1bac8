// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Two worlds that must move alike, lived through together.

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

namespace ansatz::test {

/// Lives the same hundred steps in both worlds; whatever has masses gets them.
template <class A, class B> bool same_motion(A a, B b, int steps = 100) {
    Dice dice(5);
    auto add = [](auto& world, const auto& x, const auto& v, double m) {
        if constexpr (std::remove_reference_t<decltype(world)>::composition::has_mass)
            world.add(x, v, mass(m * kilogram));
        else world.add(x, v);
    };
    for (int i = 0; i < 17; ++i) { // enough for the vectorised loop and its remainder
        double c[6];
        for (auto& number : c) number = dice.number(-3, 3);
        const auto x = position(vec<A>(metre, c[0], c[1], c[2]));
        const auto v = velocity(vec<A>(metre_per_second, c[3], c[4], c[5]));
        const double m = dice.number(0.1, 9);
        add(a, x, v, m);
        add(b, x, v, m);
    }
    const auto all = a.handles();
    for (int i = 0; i < steps; ++i) {
        const auto dt = (i % 10 == 9 ? 1.0 / 120 : 1.0 / 60) * second;
        if (i == 40) {
            a.set_velocity(all[3], vec<A>(metre_per_second, 1, 2, 3));
            b.set_velocity(all[3], vec<A>(metre_per_second, 1, 2, 3));
            a.set_position(all[5], vec<A>(metre, 1, 2, 3));
            b.set_position(all[5], vec<A>(metre, 1, 2, 3));
        }
        a.step(dt);
        b.step(dt);
        for (const auto h : all)
            if (!(a.position(h) == b.position(h)) || !(a.velocity(h) == b.velocity(h)) ||
                !(a.acceleration(h) == b.acceleration(h))) {
                UNSCOPED_INFO("body " << h.id << " differs after step " << i);
                return false;
            }
    }
    return a.status().ok();
}

inline const ToOrigin spring{4.0 / (second * second)};

} // namespace ansatz::test
