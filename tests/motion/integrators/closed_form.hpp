// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a scheme does to an oscillator, in closed form: for x'' = -omega^2 x every one-step method is a matrix,
/// (x, v)_{n+1} = M(omega h) (x, v)_n, so that its n-th state is known without running it. The matrices are those of
/// the schemes as they are published, in long double; a world must agree to rounding, in each scalar and dimension.

#include "tests/motion/support.hpp"

#include <functional>

namespace motion_tests {

/// One step of a scheme on (x, v): first row for x, second for v.
struct Amplification {
    long double xx, xv, vx, vv;
};

/// Runs the world and the matrix beside each other.
/// \param matrix  the scheme's matrix for (omega, h)
template <class I> void check_closed_form(const std::function<Amplification(long double, long double)>& matrix) {
    for_each_type(AllSpaces{}, [&]<class S> {
        for (const double omega : {0.5, 1.0, 3.0})
            for (const double h : {0.01, 0.1, 0.3}) {
                const auto [xx, xv, vx, vv] = matrix(omega, h);
                World world{S{}, I{}, Oscillator{omega / second}};
                // In the plane (x, y) two different motions at once.
                const auto body = world.add(at<S>(1, -0.25), going<S>(0.5, 2));
                long double x = 1, v = 0.5, y = -0.25, w = 2, size = 0;
                for (int i = 0; i < 50; ++i) {
                    world.step(h * second);
                    const long double next = xx * x + xv * v, next_y = xx * y + xv * w;
                    v = vx * x + vv * v;
                    w = vx * y + vv * w;
                    x = next;
                    y = next_y;
                    size = std::max({size, std::abs(x), std::abs(v), std::abs(y), std::abs(w)});
                }
                const auto s = state(world, body);
                // Ten roundings a step, of numbers no larger than `size` and, in the difference that is Verlet's
                // velocity, 1 / h times that.
                const long double rounding =
                    10 * 50 * std::numeric_limits<typename S::Scalar>::epsilon() * size * std::max(1.0, 1 / h);
                INFO("omega " << omega << "/s, h " << h << " s: x " << s[0] << ", should be " << double(x) << "; v "
                              << s[3] << ", should be " << double(v));
                CHECK(std::abs(s[0] - x) <= rounding);
                CHECK(std::abs(s[3] - v) <= rounding);
                CHECK(std::abs(s[1] - y) <= rounding);
                CHECK(std::abs(s[4] - w) <= rounding);
            }
    });
}

/// How often a step asks the forces.
struct Asked {
    using role = roles::Force;
    using reads = Columns<Position>;
    int* times = nullptr;
    template <class S> struct In {
        int* times;
        explicit In(const Asked& a) : times(a.times) {}
        typename S::Acceleration acceleration(const typename S::Position&, const auto&) const {
            ++*times;
            return S::template zero_vector<unit::Acceleration>();
        }
    };
};

/// The number of evaluations in one step of one body, not counting the first step, which may have a start to complete.
template <class I> int evaluations_of_a_step() {
    int times = 0;
    World world{I{}, Asked{&times}};
    world.add(velocity(metres_per_second(1, 2, 3)));
    world.step(0.1 * second);
    times = 0;
    run(world, 10, 0.1);
    return times / 10;
}

} // namespace motion_tests
