// SPDX-License-Identifier: BSL-1.0
// How fast a step is, beside what it can be compared with (race.hpp).
//
//   build/tests/test_performance_perf            prints the table
//
// The instructions of the same steps are counted exactly, and without any noise, by instructions.sh.

#include <ansatz/world.hpp>

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>

#include <boost/numeric/odeint/external/eigen/eigen.hpp> // after the steppers, on which it leans

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tests/performance/race.hpp"

using namespace ansatz;
using namespace ansatz::test;
namespace odeint = boost::numeric::odeint;

namespace {

// ---------------------------------------------------------------- the subjects

template <class W>
std::function<void(int)> stepping(W world, std::size_t awake, [[maybe_unused]] std::size_t asleep = 0) {
    auto kept = std::make_shared<W>(std::move(world));
    kept->reserve(awake + asleep);
    auto add = [&](const auto&... properties) {
        if constexpr (W::composition::has_mass)
            kept->add(position(metres(1, 1, 1)), mass(1.0 * kilogram), properties...);
        else kept->add(position(metres(1, 1, 1)), properties...);
    };
    for (std::size_t i = 0; i < awake; ++i) add(velocity(metres_per_second(1, 2, 3)));
    if constexpr (W::composition::rests)
        for (std::size_t i = 0; i < asleep; ++i) add(resting);
    return [kept](int steps) {
        for (int s = 0; s < steps; ++s) kept->step(0.001 * second);
    };
}

/// The limit: reads and writes the lanes of positions and velocities in place, with one addition each.
[[gnu::noinline]] void touch(float* __restrict a, float* __restrict b, float* __restrict c, float* __restrict d,
                             float* __restrict e, float* __restrict f, std::size_t n, float by) {
    for (std::size_t i = 0; i < n; ++i) {
        a[i] += by;
        b[i] += by;
        c[i] += by;
        d[i] += by;
        e[i] += by;
        f[i] += by;
    }
}
std::function<void(int)> probing(std::size_t n) {
    using Storage = Lanes<Space<float, 3>, Columns<Position, Velocity>>;
    auto lanes = std::make_shared<Storage>();
    lanes->reserve(n);
    for (std::size_t i = 0; i < n; ++i) lanes->push_back();
    return [lanes, n](int steps) {
        for (int s = 0; s < steps; ++s)
            touch(lanes->lane_at(0), lanes->lane_at(1), lanes->lane_at(2), lanes->lane_at(3), lanes->lane_at(4),
                  lanes->lane_at(5), n, 1e-3f);
    };
}

constexpr float g = -9.81f, dt = 0.001f;

/// odeint's Euler on all bodies at once: one vector with a lane for each component.
std::function<void(int)> euler_of_a_vector(std::size_t n) {
    using State = std::vector<float>;
    auto state = std::make_shared<State>(6 * n, 1.f);
    auto stepper = std::make_shared<odeint::euler<State, float, State, float>>();
    return [=](int steps) {
        auto fall = [n](const State& y, State& slope, float) {
            const float* v = y.data() + 3 * n;
            float* to = slope.data();
            for (std::size_t i = 0; i < 3 * n; ++i) to[i] = v[i];
            std::fill(to + 3 * n, to + 4 * n, 0.f);
            std::fill(to + 4 * n, to + 5 * n, g);
            std::fill(to + 5 * n, to + 6 * n, 0.f);
        };
        for (int s = 0; s < steps; ++s) stepper->do_step(fall, *state, 0.f, dt);
    };
}
/// The same with an array of Eigen's.
std::function<void(int)> euler_of_eigen(std::size_t bodies) {
    using State = Eigen::Array<float, Eigen::Dynamic, 1>;
    const auto n = Eigen::Index(bodies);
    auto state = std::make_shared<State>(State::Constant(6 * n, 1.f));
    auto stepper = std::make_shared<odeint::euler<State, float, State, float, odeint::vector_space_algebra>>();
    return [=](int steps) {
        auto fall = [n](const State& y, State& slope, float) {
            slope.head(3 * n) = y.tail(3 * n);
            slope.segment(3 * n, n).setZero();
            slope.segment(4 * n, n).setConstant(g);
            slope.tail(n).setZero();
        };
        for (int s = 0; s < steps; ++s) stepper->do_step(fall, *state, 0.f, dt);
    };
}
/// A stepper of odeint on one body after the other.
template <template <class...> class Stepper, class Slope>
std::function<void(int)> body_after_body(std::size_t n, Slope slope) {
    using State = std::array<float, 6>;
    auto states = std::make_shared<std::vector<State>>(n, State{1, 1, 1, 1, 1, 1});
    auto inverse_masses = std::make_shared<std::vector<float>>(n, 1.f);
    return [=](int steps) {
        Stepper<State, float, State, float, odeint::array_algebra, odeint::default_operations, odeint::never_resizer>
            stepper;
        for (int s = 0; s < steps; ++s)
            for (std::size_t i = 0; i < n; ++i) {
                const float inverse_mass = (*inverse_masses)[i];
                stepper.do_step([=](const State& y, State& to, float) { slope(y, to, inverse_mass); }, (*states)[i],
                                0.f, dt);
            }
    };
}
// The bound that clang misses. What it makes of odeint's arrays keeps the processor's arithmetic busy without a gap
// (8.5 ns a body for 110 operations and four roots; g++: 33). Vectors of eight floats win a factor of two over that
// (4.2 ns; 3.9 in a loop by hand): the four roots wait for each other, and one body's chain of operations is as long as
// what the processor looks ahead. Two bodies at a time would be 3.3 ns, still not four times.
#ifdef __clang__
constexpr double missed_by_clang = 1 / 1.8;
#else
constexpr double missed_by_clang = 0;
#endif

constexpr auto fall = [](const std::array<float, 6>& y, std::array<float, 6>& to, float) {
    to = {y[3], y[4], y[5], 0, g, 0};
};
constexpr auto fall_in_air = [](const std::array<float, 6>& y, std::array<float, 6>& to, float inverse_mass) {
    const float k = -0.1f * std::sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5]) * inverse_mass;
    to = {y[3], y[4], y[5], k * y[3], k * y[4] + g, k * y[5]};
};

} // namespace

TEST_CASE("A step is as fast as the memory, and faster than odeint") {
#ifndef __OPTIMIZE__
    SKIP("compiled without optimisation; what is measured is the Release build");
#endif
    Race race;
    for (const std::size_t n : {10'000, 30'000, 100'000}) {
        const std::string many = " (" + std::to_string(n) + " bodies)";
        auto& world = race.add("World: SemiImplicitEuler, Gravity", n,
                               stepping(World{Space<float, 3>{}, SemiImplicitEuler{}, Gravity{}}, n));
        auto& probe = race.add("probe: the same lanes read and written", n, probing(n));
        // Three additions a body more than the probe, which the memory hides and a count does not.
        race.bound("gravity: at least 85 % of the probe's rate" + many, world, {&probe}, 1 / 0.85, 0, 1.6);

        auto& euler = race.add("World: ExplicitEuler, Gravity", n,
                               stepping(World{Space<float, 3>{}, ExplicitEuler{}, Gravity{}}, n));
        auto& vector = race.add("odeint euler, one vector of lanes", n, euler_of_a_vector(n));
        auto& eigen = race.add("odeint euler, Eigen::Array", n, euler_of_eigen(n));
        auto& array = race.add("odeint euler, an array for each body", n, body_after_body<odeint::euler>(n, fall));
        race.bound("Euler: 2 times faster than the best form of odeint's" + many, euler, {&vector, &eigen, &array},
                   1 / 2.0);

        auto& rk4 = race.add("World: RungeKutta4, Gravity, QuadraticDrag", n,
                             stepping(World{Space<float, 3>{}, RungeKutta4{}, Gravity{}, QuadraticDrag{}}, n));
        auto& generic = race.add("odeint runge_kutta4, an array for each body", n,
                                 body_after_body<odeint::runge_kutta4>(n, fall_in_air));
        auto& classic = race.add("odeint runge_kutta4_classic, the same", n,
                                 body_after_body<odeint::runge_kutta4_classic>(n, fall_in_air));
        race.bound("Runge-Kutta with quadratic drag: 4 times faster than odeint's" + many, rk4, {&generic, &classic},
                   1 / 4.0, missed_by_clang);
    }
    race.run();
}

TEST_CASE("Bodies that rest cost nothing") {
#ifndef __OPTIMIZE__
    SKIP("compiled without optimisation; what is measured is the Release build");
#endif
    Race race;
    const World world{Space<float, 3>{}, SemiImplicitEuler{}, Rest{}};
    auto& alone = race.add("10,000 awake", 10'000, stepping(world, 10'000));
    auto& beside = race.add("10,000 awake beside 10,000 that rest", 10'000, stepping(world, 10'000, 10'000));
    race.bound("10,000 resting bodies add less than 1 %", beside, {&alone}, 1.01);
    race.run();
}
