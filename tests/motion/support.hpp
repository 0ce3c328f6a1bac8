// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of chapter 1 share: the integrators to go through, bodies in worlds of any scalar and dimension, and
/// the slope of a ladder of steps.
///
/// A tolerance here follows from the order and the step, or is a number of roundings; where a bound was measured, the
/// measured value stands beside it.

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/odeint.hpp>
#include <ansatz/world.hpp>

#include "chapters/1-motion/problems.hpp"
#include "tests/catch.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace motion_tests {

using namespace ansatz;
using namespace problems;

using OdeintRungeKutta4 = Odeint<boost::numeric::odeint::runge_kutta4<std::array<double, 6>>>;
using OdeintFehlberg78 = Odeint<boost::numeric::odeint::runge_kutta_fehlberg78<std::array<double, 6>>>;

template <class I> constexpr const char* name_of = "?";
template <> inline constexpr const char* name_of<ExplicitEuler> = "ExplicitEuler";
template <> inline constexpr const char* name_of<SemiImplicitEuler> = "SemiImplicitEuler";
template <> inline constexpr const char* name_of<ImplicitEuler> = "ImplicitEuler";
template <> inline constexpr const char* name_of<Verlet> = "Verlet";
template <> inline constexpr const char* name_of<VelocityVerlet> = "VelocityVerlet";
template <> inline constexpr const char* name_of<RungeKutta4> = "RungeKutta4";
template <> inline constexpr const char* name_of<OdeintRungeKutta4> = "Odeint<runge_kutta4>";
template <> inline constexpr const char* name_of<OdeintFehlberg78> = "Odeint<runge_kutta_fehlberg78>";

using Staged = Types<ExplicitEuler, SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4>;
using Explicit =
    Types<ExplicitEuler, SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4, OdeintRungeKutta4, OdeintFehlberg78>;
using AllIntegrators = Types<ExplicitEuler, SemiImplicitEuler, ImplicitEuler, Verlet, VelocityVerlet, RungeKutta4,
                             OdeintRungeKutta4, OdeintFehlberg78>;
using AllSpaces = Types<Space<double, 3>, Space<double, 2>, Space<float, 3>, Space<float, 2>>;

/// Calls `f.operator()<T>()` for each type of a list, naming integrators in the messages of a failure.
template <class... T, class F> void for_each_type(Types<T...>, F&& f) {
    auto one = [&]<class One>() {
        if constexpr (requires { One::dimension; }) {
            INFO("in Space<" << (std::is_same_v<typename One::Scalar, float> ? "float" : "double") << ", "
                             << One::dimension << ">");
            f.template operator()<One>();
        } else {
            INFO("with " << name_of<One>);
            f.template operator()<One>();
        }
    };
#ifdef ANSATZ_FEWER_TYPES // the sanitizers of .ci/run, for the time of compiling: the first and the last of a list
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        auto some = [&]<std::size_t Which, class One>() {
            if constexpr (Which == 0 || Which + 1 == sizeof...(T)) one.template operator()<One>();
        };
        (some.template operator()<I, T>(), ...);
    }(std::index_sequence_for<T...>{});
#else
    (one.template operator()<T>(), ...);
#endif
}

/// A vector of the space with the given first components; the others are zero.
template <class S, class Unit> typename S::template VectorOf<Unit> vector_in(double x, double y = 0, double z = 0) {
    auto v = S::template zero_vector<Unit>().value();
    const double all[] = {x, y, z};
    for (int i = 0; i < S::dimension; ++i) v[i] = static_cast<typename S::Scalar>(all[i]);
    return S::template VectorOf<Unit>::from_value(v);
}
template <class S> auto at(double x, double y = 0, double z = 0) {
    return position(vector_in<S, unit::Length>(x, y, z));
}
template <class S> auto going(double x, double y = 0, double z = 0) {
    return velocity(vector_in<S, unit::Velocity>(x, y, z));
}

/// Adds a body of 1 kg, or one without a mass where the world stores none.
template <class World_> Handle add_body(World_& world, const InAPlane& start, double kilograms = 1) {
    using S = typename World_::S;
    const auto x = at<S>(start.x.value()[0], start.x.value()[1]);
    const auto v = going<S>(start.v.value()[0], start.v.value()[1]);
    if constexpr (World_::composition::has_mass) return world.add(x, v, mass(kilograms * kilogram));
    else return world.add(x, v);
}
template <class World_> Handle add_body(World_& world, const OnALine& start, double kilograms = 1) {
    return add_body(world, InAPlane{metres(start.x.value(), 0), metres_per_second(start.v.value(), 0)}, kilograms);
}

template <class World_> void run(World_& world, int steps, double dt) {
    for (int i = 0; i < steps; ++i) world.step(dt * second);
}
/// Steps of h, 2h, h, 2h ... through the time `T`: `steps` of them, an even number.
template <class World_> void run_alternating(World_& world, int steps, double T) {
    const double h = T / (1.5 * steps);
    for (int i = 0; i < steps; ++i) world.step((i % 2 == 0 ? h : 2 * h) * second);
}

/// Position and velocity as plain numbers, one vector: what an error is measured on (m and m/s, added in squares).
template <class World_> std::array<double, 6> state(const World_& world, Handle body) {
    std::array<double, 6> s{};
    for (int i = 0; i < World_::S::dimension; ++i) {
        s[std::size_t(i)] = double(world.position(body).value()[i]);
        s[std::size_t(i) + 3] = double(world.velocity(body).value()[i]);
    }
    return s;
}
inline std::array<double, 6> state(const InAPlane& p) {
    return {p.x.value()[0], p.x.value()[1], 0, p.v.value()[0], p.v.value()[1], 0};
}
inline std::array<double, 6> state(const OnALine& p) { return {p.x.value(), 0, 0, p.v.value(), 0, 0}; }
inline double distance(const std::array<double, 6>& a, const std::array<double, 6>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

/// The order that two neighbours of a ladder of halved steps show.
inline double slope(double coarse, double fine) { return std::log2(coarse / fine); }

/// Halves the step `rungs - 1` times, beginning with `steps`, and checks the slope of the last two rungs.
/// \param error  the error after that many steps: double(int)
template <class Error> void check_order(double order, double tolerance, int steps, int rungs, Error&& error) {
    std::ostringstream ladder;
    double coarse = 0, fine = 0;
    for (int k = 0; k < rungs; ++k, steps *= 2) {
        coarse = fine;
        fine = error(steps);
        ladder << "\n  " << steps << " steps: error " << fine;
        if (k > 0) ladder << ", slope " << slope(coarse, fine);
    }
    INFO("a method of order " << order << " divides the error by " << std::pow(2.0, order)
                              << " when the step is halved; the last slope should be " << order << " within "
                              << tolerance << ladder.str());
    CHECK(std::abs(slope(coarse, fine) - order) <= tolerance);
}

/// Bits of a number, with one zero: what "bit-identical up to the sign of zero" compares.
template <class T> bool same_bits(const T& a, const T& b) { return a == b || (a != a && b != b); }

/// Are position and velocity of two bodies the same to the bit?
template <class A, class B> bool same_state(const A& a, Handle in_a, const B& b, Handle in_b) {
    for (int i = 0; i < A::S::dimension; ++i)
        if (!same_bits(a.position(in_a).value()[i], b.position(in_b).value()[i]) ||
            !same_bits(a.velocity(in_a).value()[i], b.velocity(in_b).value()[i]))
            return false;
    return true;
}

} // namespace motion_tests
