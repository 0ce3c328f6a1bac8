// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Problems by what their force depends on (hard case I16): an integrator that is of second order for forces of
/// position may silently fall to first order for forces of velocity or time. Each problem makes a world for an
/// integrator, says where its body starts and where it is at T.

#include "tests/motion/support.hpp"

namespace motion_tests {

/// Free motion seen from axes that turn with angular velocity w: \f$ \mathbf a = w^2 \mathbf x + 2 w (\dot y, -\dot x) \f$.
/// Coriolis's force alone would only turn the velocity; with the centrifugal one the exact motion is a straight line in
/// the axes that do not turn.
struct TurningAxes {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    Parameter<unit::Frequency> w = 0.7 / second;

    template <class S> struct In {
        typename S::Scalar w;
        explicit In(const TurningAxes& t) : w(S::convert(t.w).value()) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const typename S::Velocity& v,
                                              const auto&) const {
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = w * w * x.value()[0] + 2 * w * v.value()[1];
            a[1] = w * w * x.value()[1] - 2 * w * v.value()[0];
            return S::Acceleration::from_value(a);
        }
        Jacobian<S> jacobian(const typename S::Position&, const typename S::Velocity&, const auto&) const {
            Jacobian<S> j{};
            auto by_x = j.position.value();
            auto by_v = j.velocity.value();
            by_x(0, 0) = by_x(1, 1) = w * w;
            by_v(0, 1) = 2 * w;
            by_v(1, 0) = -2 * w;
            j.position = decltype(j.position)::from_value(by_x);
            j.velocity = decltype(j.velocity)::from_value(by_v);
            return j;
        }
    };
};

/// A spring that a mass is measured with: omega = 4/s, along a diagonal, about a point that is not the origin.
struct SpringProblem {
    static constexpr double T = 2;
    static constexpr int coarsest_of_8 = 8; // steps where a method of order 8 still shows its order
    static constexpr int finer = 1;         // how many times finer the ladder of the others must begin than usual
    template <class I> static auto world() {
        return World{Space<double, 2>{}, I{}, PointSpring{40.0 * newton_per_metre, metres(1, -2)}};
    }
    static constexpr double kilograms = 2.5;
    static InAPlane at(double t) {
        const auto p = oscillator(4.0 / second, {0.3 * metre, -1.1 * metre_per_second}, t * second);
        const double x = p.x.value(), v = p.v.value();
        return {metres(1 + 0.6 * x, -2 - 0.8 * x), metres_per_second(0.6 * v, -0.8 * v)};
    }
};
struct KeplerProblem { // not linear; the body comes as near as 0.6 m to the centre
    static constexpr double T = 10, kilograms = 1;
    static constexpr int coarsest_of_8 = 40, finer = 8;
    template <class I> static auto world() { return World{Space<double, 2>{}, I{}, CentralGravity{}}; }
    static InAPlane at(double t) { return kepler(0.4, t); }
};
struct DampedProblem { // velocity, in one line with the motion
    static constexpr double T = 10, kilograms = 1;
    static constexpr int coarsest_of_8 = 8, finer = 1;
    template <class I> static auto world() {
        return World{Space<double, 2>{}, I{}, Oscillator{}, LinearDamping{0.4 / second}};
    }
    static OnALine at(double t) {
        return damped_oscillator(1.0 / second, 0.4 / second, {1.0 * metre, 0.5 * metre_per_second}, t * second);
    }
};
struct TurningProblem { // velocity, across the motion
    static constexpr double T = 4, kilograms = 1;
    static constexpr int coarsest_of_8 = 4, finer = 1;
    template <class I> static auto world() { return World{Space<double, 2>{}, I{}, TurningAxes{}}; }
    static InAPlane at(double t) {
        const double w = 0.7, c = std::cos(w * t), s = std::sin(w * t);
        const double X = 1 + 0.3 * t, Y = 0.5 - 0.2 * t; // in axes that stand still
        const double x = c * X + s * Y, y = -s * X + c * Y;
        return {metres(x, y), metres_per_second(c * 0.3 + s * -0.2 + w * y, -s * 0.3 + c * -0.2 - w * x)};
    }
};
struct DrivenProblem { // time
    static constexpr double T = 10, kilograms = 1;
    static constexpr int coarsest_of_8 = 16, finer = 1;
    template <class I> static auto world() {
        return World{Space<double, 2>{}, I{}, Oscillator{},
                     Forcing{metres_per_second_squared(1.5, 0, 0), 2.0 / second}};
    }
    static OnALine at(double t) {
        return driven_oscillator(1.0 / second, 0.0 / second, 1.5 * metre_per_second_squared, 2.0 / second,
                                 {1.0 * metre, 0.5 * metre_per_second}, t * second);
    }
};
struct DampedDrivenProblem { // position, velocity and time at once
    static constexpr double T = 10, kilograms = 1;
    static constexpr int coarsest_of_8 = 16, finer = 1;
    template <class I> static auto world() {
        return World{Space<double, 2>{}, I{}, Oscillator{}, LinearDamping{0.4 / second},
                     Forcing{metres_per_second_squared(1.5, 0, 0), 2.0 / second}};
    }
    static OnALine at(double t) {
        return driven_oscillator(1.0 / second, 0.4 / second, 1.5 * metre_per_second_squared, 2.0 / second,
                                 {1.0 * metre, 0.5 * metre_per_second}, t * second);
    }
};
struct FallProblem { // velocity, not linear, a force that needs the mass: v_t = 5 m/s
    static constexpr double T = 2, kilograms = 3;
    static constexpr int coarsest_of_8 = 4, finer = 1;
    static constexpr auto g = 9.81 * metre_per_second_squared;
    template <class I> static auto world() {
        return World{Space<double, 2>{}, I{}, Gravity{metres_per_second_squared(-9.81, 0, 0)},
                     QuadraticDrag::with_terminal_speed(5.0 * metre_per_second, 3.0 * kilogram, g)};
    }
    static OnALine at(double t) {
        const auto p = fall_with_quadratic_drag(5.0 * metre_per_second, g, t * second);
        return {-p.x, -p.v};
    }
};

/// The error of an integrator on a problem after `steps` equal steps, or steps of h, 2h, h, 2h ...
template <class Problem, class I, bool Alternating = false> double error_of(int steps) {
    auto world = Problem::template world<I>();
    const auto body = add_body(world, Problem::at(0), Problem::kilograms);
    if constexpr (Alternating) run_alternating(world, steps, Problem::T);
    else run(world, steps, Problem::T / steps);
    CHECK(world.status().ok());
    return distance(state(world, body), state(Problem::at(Problem::T)));
}

/// The first rung of a ladder of three.
template <class I> constexpr int usual_steps = I::order >= 4 ? 100 : I::order == 2 ? 400 : 1600;

template <class Problem> void check_order_of_all_integrators() {
    for_each_type(AllIntegrators{}, []<class I> {
        if constexpr (I::order >= 8) check_order(8, 0.75, Problem::coarsest_of_8, 4, error_of<Problem, I>);
        else
            check_order(I::order, I::order >= 4 ? 0.1 : 0.05, usual_steps<I> * Problem::finer, 3, error_of<Problem, I>);
    });
}

/// The same for h, 2h, h, 2h ... (hard case I12).
template <class Problem> void check_order_with_varying_step() {
    for_each_type(AllIntegrators{}, []<class I> {
        if constexpr (I::order >= 8) check_order(8, 0.75, Problem::coarsest_of_8, 4, error_of<Problem, I, true>);
        else
            check_order(I::order, I::order >= 4 ? 0.1 : 0.05, usual_steps<I> * Problem::finer, 3,
                        error_of<Problem, I, true>);
    });
}

} // namespace motion_tests
