// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Hard case I1: every integrator converges with the order that it claims, in the real World. Built once for each
/// dimension (global_order_2d.cpp, global_order_3d.cpp), because a world for each integrator and scalar takes its time.

#include "tests/motion/support.hpp"

namespace motion_tests {

/// x'' = -x from a start with position *and* velocity: from a symmetric one semi-implicit Euler shows order 2.
template <int Dim> struct GlobalOrder {
    static constexpr double T = 10;
    static inline const OnALine start{1.0 * metre, 0.5 * metre_per_second};

    template <class Scalar, class I> static auto state_after(int steps) {
        World world{Space<Scalar, Dim>{}, I{}, Oscillator{}};
        const auto body = add_body(world, start);
        run(world, steps, T / steps);
        return state(world, body);
    }
    template <class Scalar, class I> static double error_after(int steps) {
        return distance(state_after<Scalar, I>(steps), state(oscillator(1.0 / second, start, T * second)));
    }

    template <class I> static void in_double() {
        if constexpr (I::order >= 8) // rounding is reached before a hundred steps
            check_order(I::order, 0.2, 8, 3, error_after<double, I>);
        else check_order(I::order, I::order >= 2 ? 0.01 : 0.05, 100, 6, error_after<double, I>);
    }
    /// float shows the order while the error of the method is above rounding.
    template <class I> static void in_float() {
        if constexpr (I::order >= 8)
            CHECK(error_after<float, I>(20) <= 1e-5); // nothing but rounding is left (measured below 2e-6)
        else
            check_order(I::order, I::order >= 4 ? 0.25 : 0.05,
                        I::order >= 4   ? 16
                        : I::order == 2 ? 100
                                        : 400,
                        3, error_after<float, I>);
    }
    /// float and double go the same way, apart by roundings alone.
    template <class I> static void the_same_way() {
        for (const int steps : {100, 400, 1600}) {
            const double apart = distance(state_after<float, I>(steps), state_after<double, I>(steps));
            // A step rounds x and v a few times, by at most 2^-24 of a number of size about 1; roundings that all
            // pushed the same way would give this. Position Verlet keeps the velocity as a difference of positions: a
            // rounding of x is a kick of 2^-24 / h there, which acts for all the time that is left.
            const double h = T / steps,
                         bound = steps * 8 * std::pow(2.0, -24) * (std::is_same_v<I, Verlet> ? 1 / h : 1);
            INFO(steps << " steps: apart by " << apart << ", roundings explain " << bound);
            CHECK(apart <= bound);
        }
    }
};

} // namespace motion_tests
