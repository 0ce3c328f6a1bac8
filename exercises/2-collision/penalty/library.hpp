// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision.hpp>
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/world.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Speed = ansatz::Quantity<ansatz::unit::Velocity>;
using Newtons = ansatz::Quantity<ansatz::unit::Force>;
using Acceleration3 = ansatz::VectorQuantity<ansatz::unit::Acceleration, 3>;
using PerMass = ansatz::Quantity<ansatz::unit::InverseMass>;
using Direction = ansatz::Vector<double, 3>;

/// The library's response goes through all contacts of a world; this is what it sees of one with a single contact, of
/// which the second body is in the origin.
struct OneContact {
    using Pair = ansatz::PenaltyContacts<ansatz::Space<>>::Pair;
    ansatz::VectorQuantity<ansatz::unit::Length, 3> place;
    ansatz::VectorQuantity<ansatz::unit::Velocity, 3> velocity;
    std::vector<Pair> contacts;
    ansatz::VectorQuantity<ansatz::unit::Force, 3> on_first =
        ansatz::VectorQuantity<ansatz::unit::Force, 3>::from_value(Direction::Zero());

    const OneContact& state() const { return *this; }
    const std::vector<Pair>& pairs() const { return contacts; }
    template <class Column> auto get(std::size_t body) const {
        if constexpr (std::is_same_v<Column, ansatz::Position>) return (body == 0 ? 1.0 : 0.0) * place;
        else return (body == 0 ? 1.0 : 0.0) * velocity;
    }
    template <class F> void add_force_pair(std::size_t, std::size_t, const F& force) { on_first += force; }
};

inline Newtons pressing(Length depth, Speed parting, ansatz::Quantity<ansatz::unit::Stiffness> stiffness,
                        ansatz::Quantity<ansatz::unit::Damping> damping) {
    const Direction normal(1, 0, 0);
    const Direction none(0, 0, 0); // they touch along the normal, whatever their sizes
    OneContact view{-depth * normal, parting * normal, {{0, 1, true, 0.0, none, normal}}};
    ansatz::Penalty::In<ansatz::Space<>>(ansatz::Penalty{stiffness, damping}).couple(view, 0);
    return ansatz::x(view.on_first);
}

/// Two balls of 1 m at rest, so deep in each other that they press so hard: what one step of a world makes of them.
template <class World>
std::pair<ansatz::Handle, ansatz::Handle> add_two(World& world, const Direction& normal, Length depth, PerMass first,
                                                  PerMass second) {
    auto add = [&](const auto& place, PerMass inverse_mass) {
        const ansatz::Sphere ball{1.0 * ansatz::metre};
        if (inverse_mass.value() > 0) return world.add(ball, ansatz::position(place), ansatz::mass(1.0 / inverse_mass));
        return world.add(ball, ansatz::position(place), ansatz::fixed);
    };
    const auto apart = 2.0 * ansatz::metre - depth;
    const auto one = add(apart * normal, first);
    return {one, add(0.0 * apart * normal, second)};
}
inline std::pair<Acceleration3, Acceleration3> accelerations(const Direction& normal, Newtons pressing, PerMass first,
                                                             PerMass second) {
    const auto stiffness = pressing / (0.5 * ansatz::metre);
    ansatz::World world{ansatz::SemiImplicitEuler{}, ansatz::BoundingBoxes{}, ansatz::Narrowphase<ansatz::Sphere>{},
                        ansatz::Penalty{stiffness}};
    const auto [one, other] = add_two(world, normal, 0.5 * ansatz::metre, first, second);
    const auto h = 1.0 / 1024 * ansatz::second;
    world.step(h);
    return {world.velocity(one) / h, world.velocity(other) / h};
}
inline ansatz::Quantity<ansatz::unit::Time> largest_step(ansatz::Quantity<ansatz::unit::Stiffness> stiffness,
                                                         PerMass first, PerMass second) {
    ansatz::World world{ansatz::SemiImplicitEuler{}, ansatz::BoundingBoxes{}, ansatz::Narrowphase<ansatz::Sphere>{},
                        ansatz::Penalty{stiffness}};
    add_two(world, Direction(1, 0, 0), 0.5 * ansatz::metre, first, second);
    world.step(1e-9 * ansatz::second);
    return stable_step(world);
}

} // namespace exercise
