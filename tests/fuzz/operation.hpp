// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a scene is to the fuzzer: a list of operations, each a plain value. So a scene can be played again, in another
/// world, without some of its operations, or with rounder numbers; and it can be printed as a program.

#include <array>
#include <cmath>
#include <vector>

namespace fuzz {

enum class Verb {
    add,
    remove,
    set_position,
    set_velocity,
    set_mass,
    set_restitution,
    apply_force,
    apply_impulse,
    wake,
    add_spring,
    remove_spring,
    step,
    copy, ///< from here on a copy lives beside the world
    load, ///< and so does what was saved and loaded
    again ///< a step is taken, taken back, and taken once more
};
enum class Shape { sphere, box, plane, none };
enum class Kind { awake, fixed, moving, resting };
using Numbers = std::array<double, 3>;

/// One line of a scene. Bodies and springs have numbers of their own, so that what is left out renames no body.
struct Operation {
    Verb verb = Verb::step;
    int body = -1;             ///< the body that it is done to; of `add` its name
    int second = -1;           ///< the other end of a spring; -1 is the point `place`
    int spring = -1;           ///< the name of a spring
    Shape shape = Shape::none; ///< of `add`
    Kind kind = Kind::awake;   ///< of `add`
    int axis = 1;              ///< which way the plane of an `add` faces
    Numbers place{};           ///< m
    Numbers vector{};          ///< m/s, N or N s
    double mass = 1;           ///< kg
    double size = 0.5;         ///< m, a radius or half a width
    double restitution = 0;    ///< 1
    double stiffness = 0;      ///< N/m
    double damping = 0;        ///< N s/m
    double dt = 0;             ///< s
    int times = 1;             ///< how often: steps
};
using Scene = std::vector<Operation>;

/// The numbers of an operation that mean something, for code that makes them rounder, or one of them bad.
inline std::vector<double*> numbers_of(Operation& o, int dimension) {
    std::vector<double*> all;
    const auto vector = [&](Numbers& v) {
        for (int k = 0; k < dimension; ++k) all.push_back(&v[std::size_t(k)]);
    };
    switch (o.verb) {
    case Verb::add:
        if (o.shape == Shape::plane) return {&o.size};
        vector(o.place);
        if (o.shape != Shape::none) all.push_back(&o.size);
        if (o.shape != Shape::none && o.kind == Kind::awake) all.push_back(&o.restitution);
        if (o.kind == Kind::awake || o.kind == Kind::moving) vector(o.vector);
        if (o.kind == Kind::awake || o.kind == Kind::resting) all.push_back(&o.mass);
        break;
    case Verb::set_position: vector(o.place); break;
    case Verb::set_velocity:
    case Verb::apply_force:
    case Verb::apply_impulse: vector(o.vector); break;
    case Verb::set_mass: all.push_back(&o.mass); break;
    case Verb::set_restitution: all.push_back(&o.restitution); break;
    case Verb::add_spring:
        all = {&o.stiffness, &o.damping};
        if (o.second < 0) vector(o.place);
        break;
    case Verb::step:
    case Verb::again: all.push_back(&o.dt); break;
    case Verb::remove:
    case Verb::wake:
    case Verb::remove_spring:
    case Verb::copy:
    case Verb::load: break;
    }
    return all;
}

/// Whether its numbers are such that a world takes them. What is not must be refused.
inline bool acceptable(Operation o, int dimension) {
    for (const double* number : numbers_of(o, dimension)) {
        if (!std::isfinite(*number)) return false;
        if ((number == &o.mass || (number == &o.size && o.shape != Shape::plane)) && !(*number > 0)) return false;
        if ((number == &o.dt || number == &o.stiffness || number == &o.damping) && *number < 0) return false;
        if (number == &o.restitution && (*number < 0 || *number > 1)) return false;
    }
    return true;
}

} // namespace fuzz
