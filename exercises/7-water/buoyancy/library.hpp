// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/water.hpp>
#include <ansatz/world.hpp>

#include <limits>

namespace exercise {

inline ansatz::Quantity<ansatz::unit::Volume> submerged(ansatz::Quantity<ansatz::unit::Length> radius,
                                                        ansatz::Quantity<ansatz::unit::Length> depth) {
    return ansatz::submerged(ansatz::Sphere{radius}, depth).volume;
}

/// A body that floats in a pool of its own, so deep that just that volume of it is under water.
inline ansatz::Quantity<ansatz::unit::Acceleration> acceleration(ansatz::Quantity<ansatz::unit::Mass> mass,
                                                                 ansatz::Quantity<ansatz::unit::Volume> volume,
                                                                 ansatz::Quantity<ansatz::unit::Density> density,
                                                                 ansatz::Quantity<ansatz::unit::Acceleration> g) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -g.value(), 0)}, Pools<WaterColumns>{},
                Buoyancy{}};
    world.add(Pool{Surface{WaterColumns{1.0 * metre_per_second}, ColumnGrid(5, 5, 4.0 * metre), 2.0 * metre}, density});
    // A box of that volume, all of it under water.
    const double half = 0.5 * std::cbrt(volume.value());
    const auto body = world.add(position(metres(10, 1, 10)), ansatz::mass(mass));
    if (half > 0) world.add(Floating{body, Box{metres(half, half, half)}});
    return y(world.acceleration(body));
}

struct Spring {
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
    ansatz::Quantity<ansatz::unit::Length> breaks_at;
    bool broken = false;
};

/// What the row of a world that keeps such a spring says to a body of so much depth.
inline ansatz::Quantity<ansatz::unit::Force> pull(Spring& spring, ansatz::Quantity<ansatz::unit::Length> depth) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    world.add(Pool{Surface{WaterColumns{1.0 * metre_per_second}, ColumnGrid(5, 5, 4.0 * metre), 20.0 * metre}});
    const auto body = world.add(position(metres(10, 20 - depth.value(), 10)), fixed);
    if (spring.broken) return 0.0 * newton;
    const auto held =
        world.add(Floating{.body = body,
                           .by = SurfaceSpring{.stiffness = spring.stiffness, .breaks_at = spring.breaks_at},
                           .presses = false});
    world.step(1e-3 * second);
    spring.broken = world.afloat(held).broken;
    return y(world.afloat(held).lift);
}

/// The water that weighs what the spring carries.
inline ansatz::Quantity<ansatz::unit::Volume> pressed_up(Spring& spring, ansatz::Quantity<ansatz::unit::Length> depth,
                                                         ansatz::Quantity<ansatz::unit::Density> density,
                                                         ansatz::Quantity<ansatz::unit::Acceleration> g) {
    return pull(spring, depth) / (density * g);
}

/// A body of 1 kg at a depth of a pool, lifted by the library's FixedLift.
inline ansatz::Quantity<ansatz::unit::Acceleration>
fixed_acceleration(ansatz::Quantity<ansatz::unit::Length> depth, ansatz::Quantity<ansatz::unit::Acceleration> lift,
                   ansatz::Quantity<ansatz::unit::Acceleration> g) {
    using namespace ansatz;
    World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -g.value(), 0)}, Pools<WaterColumns>{},
                Buoyancy{}};
    world.add(Pool{Surface{WaterColumns{1.0 * metre_per_second}, ColumnGrid(5, 5, 4.0 * metre), 20.0 * metre}});
    const auto body = world.add(position(metres(10, 20 - depth.value(), 10)), ansatz::mass(1.0 * kilogram));
    world.add(Floating{.body = body, .by = FixedLift{lift}, .presses = false});
    return y(world.acceleration(body));
}

/// Where the same acceleration has taken the speed, and for how far it had to.
inline ansatz::Quantity<ansatz::unit::Length> deepest(ansatz::Quantity<ansatz::unit::Velocity> speed,
                                                      ansatz::Quantity<ansatz::unit::Acceleration> lift,
                                                      ansatz::Quantity<ansatz::unit::Acceleration> g) {
    using namespace ansatz;
    const auto up = fixed_acceleration(1.0 * metre, lift, g);
    if (!(up > 0.0 * metre_per_second_squared)) return std::numeric_limits<double>::infinity() * metre;
    const Quantity<unit::Time> until = speed / up;
    return speed * until - 0.5 * up * until * until;
}

} // namespace exercise
