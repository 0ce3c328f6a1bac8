// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its solver, with two bodies and one spring.
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/constraint.hpp>
#include <ansatz/world.hpp>

#include <array>

namespace exercise {

struct End {
    ansatz::VectorQuantity<ansatz::unit::Length, 3> position;
    ansatz::VectorQuantity<ansatz::unit::Velocity, 3> velocity;
    ansatz::Quantity<ansatz::unit::InverseMass> inverse_mass;
};
struct Spring {
    ansatz::Quantity<ansatz::unit::Length> rest_length;
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
};
using Multiplier = decltype(ansatz::Quantity<ansatz::unit::Mass>() * ansatz::Quantity<ansatz::unit::Length>());

/// What the solver of a world sees of it: here, a spring and its two ends.
struct Pair {
    using S = ansatz::Space<>;
    using Vec = ansatz::Vector<double, 3>;
    std::array<End*, 2> ends;
    ansatz::SpringConstraint<S, ansatz::springs::Acts::both_ways> spring;
    double step, given = 0; // h, and N s^2

    Pair(End& first, End& second, const Spring& s, ansatz::Quantity<ansatz::unit::Time> h)
        : ends{&first, &second}, spring{{0, 1}, s.rest_length.value(), s.stiffness.value(), 0.0}, step(h.value()) {}
    double h() const { return step; }
    Vec position(std::size_t i) const { return ends[i]->position.value(); }
    Vec velocity(std::size_t i) const { return ends[i]->velocity.value(); }
    double weight(std::size_t i) const { return ends[i]->inverse_mass.value(); }
    void move(std::size_t i, const Vec& by) {
        const Vec to = position(1) - position(0);
        if (weight(i) > 0 && (i == 1 || !(weight(1) > 0)))
            given += (i == 1 ? 1 : -1) * by.dot(to.normalized()) / weight(i);
        ends[i]->position += ansatz::VectorQuantity<ansatz::unit::Length, 3>::from_value(by);
        ends[i]->velocity += ansatz::VectorQuantity<ansatz::unit::Velocity, 3>::from_value(by / step);
    }
    template <class F> void each(F&& f) const { f(spring); }
    Multiplier solve(int iterations) {
        ansatz::Xpbd::In<S>::Kept<int> room;
        ansatz::Xpbd::In<S>(ansatz::Xpbd{.substeps = 1, .iterations = iterations}).solve(*this, room);
        return Multiplier::from_value(given);
    }
};

/// A spring that has given something is as one of another rest length that has given nothing: h^2 k times the
/// difference is that.
inline Spring as_fresh(const Spring& spring, Multiplier multiplier, ansatz::Quantity<ansatz::unit::Time> h) {
    return {spring.rest_length - multiplier / (h * h * spring.stiffness), spring.stiffness};
}

inline Multiplier hold(End& first, End& second, const Spring& spring, Multiplier multiplier,
                       ansatz::Quantity<ansatz::unit::Time> h) {
    return multiplier + Pair(first, second, as_fresh(spring, multiplier, h), h).solve(1);
}

inline Multiplier change(ansatz::Quantity<ansatz::unit::Length> stretch, Multiplier multiplier,
                         ansatz::Quantity<ansatz::unit::Stiffness> stiffness,
                         ansatz::Quantity<ansatz::unit::InverseMass> weights, ansatz::Quantity<ansatz::unit::Time> h) {
    using namespace ansatz;
    const auto still = metres_per_second(0, 0, 0);
    End first{metres(0, 0, 0), still, 0.5 * weights}, second{metres(1, 0, 0), still, 0.5 * weights};
    return hold(first, second, {1.0 * metre - stretch, stiffness}, multiplier, h) - multiplier;
}

inline void step(End& first, End& second, const Spring& spring,
                 const ansatz::VectorQuantity<ansatz::unit::Acceleration, 3>& gravity,
                 ansatz::Quantity<ansatz::unit::Time> dt, int substeps, int iterations) {
    const auto h = dt / double(substeps);
    for (int part = 0; part < substeps; ++part) {
        for (End* end : {&first, &second}) {
            if (end->inverse_mass.value() > 0) end->velocity += h * gravity;
            end->position += h * end->velocity;
        }
        Pair(first, second, spring, h).solve(iterations);
    }
}

} // namespace exercise
