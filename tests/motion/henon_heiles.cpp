// SPDX-License-Identifier: BSL-1.0

// Hard case I14: Henon and Heiles' galaxy from x = (0.1, 0), v = (0, 0.5), E = 0.13 m^2/s^2, in steps of 0.1 s up to
// 1e4 s. Chaos, so no trajectory can be right for long; what can be right is the energy.

#include "tests/motion/support.hpp"

using namespace motion_tests;

namespace {

struct Swing {
    double to_1e2 = 0, to_1e3 = 0, to_1e4 = 0; // max |dE| up to that time, in m^2/s^2
    double farthest = 0;                       // m
};

template <class S, class I> Swing swing() {
    World world{S{}, I{}, HenonHeiles{}};
    const auto body = add_body(world, InAPlane{metres(0.1, 0), metres_per_second(0, 0.5)});
    const detail::Bound<HenonHeiles, Space<double, 2>> galaxy(HenonHeiles{});
    auto E = [&] {
        const auto s = state(world, body);
        return 0.5 * (s[3] * s[3] + s[4] * s[4]) + galaxy.potential(metres(s[0], s[1]), 0).value();
    };
    const double E0 = E();
    Swing result;
    double most = 0;
    for (int i = 1; i <= 100000; ++i) {
        world.step(0.1 * second);
        most = std::max(most, std::abs(E() - E0));
        const auto s = state(world, body);
        result.farthest = std::max(result.farthest, std::hypot(s[0], s[1]));
        if (!(result.farthest < 1e3)) break;
        if (i == 1000) result.to_1e2 = most;
        if (i == 10000) result.to_1e3 = most;
    }
    result.to_1e4 = most;
    return result;
}

} // namespace

TEST_CASE("I14 Henon-Heiles: velocity Verlet and Verlet keep the energy for ever", "[motion][I14]") {
    for_each_type(Types<VelocityVerlet, Verlet>{}, []<class I> {
        const auto s = swing<Space<double, 2>, I>();
        INFO("max |dE| to 1e2 s " << s.to_1e2 << ", to 1e4 s " << s.to_1e4);
        CHECK(s.to_1e4 <= 5e-4); // measured 3.77e-4
        CHECK(s.to_1e4 / s.to_1e2 <= 1.02);
    });
}

TEST_CASE("I14 Henon-Heiles: semi-implicit Euler too, twenty times coarser", "[motion][I14]") {
    const auto s = swing<Space<double, 2>, SemiImplicitEuler>();
    INFO("max |dE| to 1e2 s " << s.to_1e2 << ", to 1e4 s " << s.to_1e4);
    CHECK(s.to_1e4 <= 1e-2); // measured 7.89e-3
    CHECK(s.to_1e4 / s.to_1e2 <= 1.02);
}

TEST_CASE("I14 Henon-Heiles: Runge-Kutta's energy drifts, ten times as far in ten times the time", "[motion][I14]") {
    const auto s = swing<Space<double, 2>, RungeKutta4>();
    INFO("max |dE| to 1e2, 1e3, 1e4 s: " << s.to_1e2 << ", " << s.to_1e3 << ", " << s.to_1e4);
    CHECK(s.to_1e2 <= 4e-6); // measured 2.9e-6
    CHECK(s.to_1e3 / s.to_1e2 > 7);
    CHECK(s.to_1e3 / s.to_1e2 < 14);
    CHECK(s.to_1e4 / s.to_1e3 > 7);
    CHECK(s.to_1e4 / s.to_1e3 < 14);
}

TEST_CASE("I14 Henon-Heiles: with explicit Euler the star escapes", "[motion][I14]") {
    CHECK(swing<Space<double, 2>, ExplicitEuler>().farthest >= 1e3); // negative control
}

TEST_CASE("I14 Henon-Heiles: float and three dimensions", "[motion][I14]") {
    const auto narrow = swing<Space<float, 2>, VelocityVerlet>();
    INFO("float: max |dE| to 1e4 s " << narrow.to_1e4);
    CHECK(narrow.to_1e4 <= 5e-4);
    const auto deep = swing<Space<double, 3>, VelocityVerlet>();
    CHECK(deep.to_1e4 <= 5e-4);
}
