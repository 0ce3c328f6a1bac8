// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/world.hpp>

#include <type_traits>
#include <utility>

namespace exercise {

using Length = ansatz::Quantity<ansatz::unit::Length>;
using Place = ansatz::VectorQuantity<ansatz::unit::Length, 3>;
using PerMass = ansatz::Quantity<ansatz::unit::InverseMass>;
using Direction = ansatz::Vector<double, 3>;

/// The library's response asks a body for its columns.
struct Body {
    Place position;
    PerMass inverse_mass;
    template <class Column> auto& get() {
        if constexpr (std::is_same_v<Column, ansatz::Position>) return position;
        else return inverse_mass;
    }
};

inline void push_apart_by(const ansatz::Projection& projection, Body& first, Body& second, const Direction& normal,
                          Length depth) {
    ansatz::Projection::In<ansatz::Space<>>(projection)
        .respond(ansatz::Touch<ansatz::Space<>>{Place{}, normal, depth}, first, second, 0);
}
inline void push_apart(Body& first, Body& second, const Direction& normal, Length depth) {
    push_apart_by(ansatz::Projection{}, first, second, normal, depth);
}
/// It has no word for the shares and for the correction: pushed apart by 1 m, or against a wall, bodies tell them.
inline std::pair<double, double> shares(PerMass first, PerMass second) {
    Body a{ansatz::metres(0, 0, 0), first}, b{ansatz::metres(0, 0, 0), second};
    push_apart(a, b, Direction(1, 0, 0), Length::from_value(1));
    return {ansatz::x(a.position).value(), -ansatz::x(b.position).value()};
}
inline Length correction(Length depth, Length slop, double share) {
    Body a{ansatz::metres(0, 0, 0), PerMass::from_value(1)}, wall{ansatz::metres(0, 0, 0), PerMass::from_value(0)};
    push_apart_by({slop, share}, a, wall, Direction(1, 0, 0), depth);
    return ansatz::x(a.position);
}

} // namespace exercise
