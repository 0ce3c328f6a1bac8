// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/world.hpp>

#include <type_traits>

namespace exercise {

using Speed = ansatz::Quantity<ansatz::unit::Velocity>;
using Velocity3 = ansatz::VectorQuantity<ansatz::unit::Velocity, 3>;
using NewtonSeconds = ansatz::Quantity<ansatz::unit::Impulse>;
using PerMass = ansatz::Quantity<ansatz::unit::InverseMass>;
using Direction = ansatz::Vector<double, 3>;
struct Body {
    Velocity3 velocity;
    PerMass inverse_mass;
};

/// The library's response asks a body for its columns.
struct Columns : Body {
    ansatz::Quantity<ansatz::unit::Dimensionless> restitution;
    template <class Column> auto& get() {
        if constexpr (std::is_same_v<Column, ansatz::Velocity>) return velocity;
        else if constexpr (std::is_same_v<Column, ansatz::InverseMass>) return inverse_mass;
        else return restitution;
    }
};
/// And the world, in which here nothing pulls.
struct ContactContext {
    ansatz::Quantity<ansatz::unit::Time> dt = 1.0 * ansatz::second;
    double leads = 0;
    bool parted = false;
    static ansatz::Quantity<ansatz::unit::Acceleration> pull() { return {}; }
};

inline NewtonSeconds impulse(Speed parting, PerMass first, PerMass second, double e) {
    const Direction normal(1, 0, 0);
    return ansatz::collision_impulse(Velocity3(parting * normal), Velocity3(0.0 * parting * normal), first, second,
                                     normal, e);
}
/// It has no word for the speed of separation: of 1 kg and a wall, the impulse that stops an approach tells it, in N s.
inline Speed parting_speed(const Velocity3& first, const Velocity3& second, const Direction& normal) {
    auto approach = [&](const Direction& n) {
        return ansatz::collision_impulse(first, second, 1.0 / ansatz::kilogram, 0.0 / ansatz::kilogram, n, 0.0);
    };
    return (approach(-normal) - approach(normal)) / (1.0 * ansatz::kilogram);
}
/// Nor for e: a body that it throws back from a wall tells.
inline double bounce(double first, double second, Speed parting, Speed threshold) {
    const Direction normal(1, 0, 0);
    Columns a{{Velocity3(parting * normal), 1.0 / ansatz::kilogram}, first},
        wall{{Velocity3(0.0 * parting * normal), 0.0 / ansatz::kilogram}, second};
    ansatz::Impulse<>::In<ansatz::Space<>>(ansatz::Impulse<>{threshold})
        .respond(ansatz::Touch<ansatz::Space<>>{{}, normal, {}}, a, wall, ContactContext{});
    return -ansatz::x(a.velocity).value() / parting.value();
}
/// Such an impulse stops bodies of these masses that approach with J (w1 + w2), and nobody bounces.
inline void apply(Body& first, Body& second, const Direction& normal, NewtonSeconds impulse) {
    const Velocity3 approach = -(first.inverse_mass + second.inverse_mass) * impulse * normal;
    Columns a{{approach, first.inverse_mass}, 0.0}, b{{Velocity3(0.0 * approach), second.inverse_mass}, 0.0};
    ansatz::Impulse<>::In<ansatz::Space<>>(ansatz::Impulse<>{})
        .respond(ansatz::Touch<ansatz::Space<>>{{}, normal, {}}, a, b, ContactContext{});
    first.velocity += a.velocity - approach;
    second.velocity += b.velocity;
}

} // namespace exercise
