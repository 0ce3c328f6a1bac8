// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise: its constraint of a spring, and its solver with one body that moves.
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/springs/constraint.hpp>
#include <ansatz/world.hpp>

#include <array>
#include <vector>

namespace exercise {

using Place = ansatz::VectorQuantity<ansatz::unit::Length, 3>;

struct Body {
    ansatz::Quantity<ansatz::unit::Mass> mass;
    Place flown;
};
struct Spring {
    Place neighbour;
    ansatz::Quantity<ansatz::unit::Length> rest_length;
    ansatz::Quantity<ansatz::unit::Stiffness> stiffness;
};

using Constraint = ansatz::SpringConstraint<ansatz::Space<>, ansatz::springs::Acts::both_ways>;
using Ends = std::array<ansatz::Vector<double, 3>, 2>;

/// With the neighbour as its first end; C and its gradient at x.
inline double linearised(const Spring& spring, const Place& x, Ends& ends, Ends& gradient, Constraint& constraint) {
    ends = {spring.neighbour.value(), x.value()};
    constraint = {{1, 0}, spring.rest_length.value(), spring.stiffness.value(), 0.0};
    return constraint.linearise(ends, gradient);
}

inline ansatz::VectorQuantity<ansatz::unit::Force, 3>
slope(const Body& body, const Place& x, const std::vector<Spring>& springs, ansatz::Quantity<ansatz::unit::Time> h) {
    ansatz::VectorQuantity<ansatz::unit::Force, 3> sum = body.mass / (h * h) * (x - body.flown);
    for (const Spring& spring : springs) {
        Ends ends, gradient;
        Constraint constraint{};
        const double value = linearised(spring, x, ends, gradient, constraint);
        sum += ansatz::VectorQuantity<ansatz::unit::Force, 3>::from_value(constraint.stiffness * value * gradient[1]);
    }
    return sum;
}

inline Eigen::Matrix3d curvature(const Body& body, const Place& x, const std::vector<Spring>& springs,
                                 ansatz::Quantity<ansatz::unit::Time> h) {
    Eigen::Matrix3d sum = (body.mass / (h * h)).value() * Eigen::Matrix3d::Identity();
    for (const Spring& spring : springs) {
        Ends ends, gradient;
        Constraint constraint{};
        const double value = linearised(spring, x, ends, gradient, constraint);
        sum += constraint.stiffness * gradient[1] * gradient[1].transpose();
        if (value > 0) sum += constraint.stiffness * value * constraint.curvature(1, ends, gradient);
    }
    return sum;
}

/// What the solver of a world sees of it: here, a body and its neighbours, which nothing moves.
struct Star {
    using Vec = ansatz::Vector<double, 3>;
    double mass, step;
    std::vector<Vec> places;
    std::vector<Constraint> springs;

    double h() const { return step; }
    std::size_t awake() const { return places.size(); }
    std::size_t room() const { return places.size(); }
    Vec position(std::size_t i) const { return places[i]; }
    Vec velocity(std::size_t) const { return Vec(0, 0, 0); }
    double weight(std::size_t i) const { return i == 0 ? 1 / mass : 0.0; }
    void move(std::size_t i, const Vec& by) { places[i] += by; }
    template <class F> void each(F&& f) const {
        for (const Constraint& spring : springs) f(spring);
    }
    template <class F> void each_by_id(F&& f) const {
        for (std::size_t i = 0; i < places.size(); ++i) f(i);
    }
};

inline Place solve(const Body& body, const std::vector<Spring>& springs, ansatz::Quantity<ansatz::unit::Time> h,
                   int iterations) {
    Star star{body.mass.value(), h.value(), {body.flown.value()}, {}};
    for (const Spring& s : springs) {
        star.springs.push_back({{star.places.size(), 0}, s.rest_length.value(), s.stiffness.value(), 0.0});
        star.places.push_back(s.neighbour.value());
    }
    using Solver = ansatz::VertexBlockDescent::In<ansatz::Space<>>;
    Solver::Kept<ansatz::Types<Constraint>> room;
    Solver(ansatz::VertexBlockDescent{.substeps = 1, .iterations = iterations}).solve(star, room);
    return Place::from_value(star.places[0]);
}

} // namespace exercise
