// SPDX-License-Identifier: BSL-1.0

// Drag: exp(-c dt), whatever the step and the frame rate; hard cases I7 and I23.

#include "tests/motion/support.hpp"

using namespace motion_tests;

TEST_CASE("I7 drag only: exp(-c h) survives every step, monotone and without a change of sign", "[motion][I7]") {
    for_each_type(AllIntegrators{}, []<class I> {
        for_each_type(Types<Space<double, 2>, Space<float, 2>>{}, []<class S> {
            for (const double ch : {1e-3, 0.5, 1.9, 2.1, 50.0, 800.0, 1e6}) {
                World world{S{}, I{}, Drag{100.0 / second}};
                const auto body = add_body(world, OnALine{0.0 * metre, 1.0 * metre_per_second});
                double before = 1;
                bool monotone = true;
                for (int i = 0; i < 20; ++i) {
                    world.step(ch / 100 * second);
                    const double now = double(world.velocity(body).value()[0]);
                    monotone = monotone && now >= 0 && now <= before;
                    before = now;
                }
                INFO("c h = " << ch << ": ends with " << before << " m/s");
                CHECK(monotone);
                CHECK(world.status().ok());
            }
        });
    });
}

TEST_CASE("I7 drag only: as an explicit law it diverges beyond h = 2 / c, as an implicit one never", "[motion][I7]") {
    auto speed_after_100 = []<class I>(I integrator, double ch) {
        World world{Space<double, 2>{}, integrator, LinearDamping{100.0 / second}};
        const auto body = add_body(world, OnALine{0.0 * metre, 1.0 * metre_per_second});
        run(world, 100, ch / 100);
        return std::abs(world.velocity(body).value()[0]);
    };
    CHECK(speed_after_100(SemiImplicitEuler{}, 1.9) < 1e-4);
    CHECK(speed_after_100(SemiImplicitEuler{}, 2.1) > 1e4); // negative control
    CHECK(speed_after_100(ImplicitEuler{}, 1e6) < 1e-300);
}

TEST_CASE("I23 frame-rate independent damping: after a second the same velocity at 30, 60, 120 Hz and in uneven steps",
          "[motion][I23][drag]") {
    for_each_type(AllIntegrators{}, []<class I> {
        auto after_a_second = []<class S>(S space, auto&& steps) {
            World world{space, I{}, Drag{0.6 / second}};
            const auto body = world.add(going<S>(3, -4));
            for (const double dt : steps) world.step(dt * second);
            return world.velocity(body);
        };
        const double left = std::exp(-0.6);
        for (const int rate : {1, 7, 30, 60, 120}) {
            const auto wide = after_a_second(Space<double, 2>{}, std::vector<double>(std::size_t(rate), 1.0 / rate));
            INFO(rate << " Hz: (" << wide.value()[0] << ", " << wide.value()[1] << ") m/s, should be (" << 3 * left
                      << ", " << -4 * left << ") m/s");
            CHECK(std::abs(wide.value()[0] - 3 * left) <= 1e-9);
            CHECK(std::abs(wide.value()[1] + 4 * left) <= 1e-9);
        }
        const auto uneven = after_a_second(Space<double, 2>{}, std::vector<double>{0.01, 0.5, 0.09, 0.3, 0.1});
        CHECK(std::abs(uneven.value()[0] - 3 * left) <= 1e-9);
        const auto narrow = after_a_second(Space<float, 2>{}, std::vector<double>(60, 1.0 / 60));
        // 60 roundings of the factor and of the product; Verlet's velocity is a difference of positions near 1 m over
        // 1/60 s.
        CHECK(std::abs(double(narrow.value()[0]) - 3 * left) <=
              (std::is_same_v<I, Verlet> ? 60 * 60 * std::pow(2.0, -22) : 120 * std::pow(2.0, -23)));
    });
}

TEST_CASE("drag is one factor for all components, and its path is the sum of them", "[motion][drag]") {
    // x after n steps: v0 h (q + q^2 + ... + q^n) where the effect acts after the integrator moved the body with the
    // old v.
    World world{SemiImplicitEuler{}, Drag{2.0 / second}};
    const auto body = world.add(velocity(metres_per_second(1, -2, 0.5)));
    const double h = 0.1, q = std::exp(-0.2);
    run(world, 50, h);
    const double path = h * (1 - std::pow(q, 50)) / (1 - q);
    const auto x = world.position(body);
    INFO("x = " << x.value()[0] << " m, should be " << path << " m");
    CHECK(std::abs(x.value()[0] - path) <= 1e-13);
    CHECK(std::abs(x.value()[1] + 2 * path) <= 1e-13);
    CHECK(std::abs(x.value()[2] - 0.5 * path) <= 1e-13);
}

TEST_CASE("drag refuses a negative and an infinite rate", "[motion][drag]") {
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Drag{-0.1 / second}}), std::invalid_argument);
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Drag{std::numeric_limits<double>::infinity() / second}}),
                    std::invalid_argument);
    CHECK_THROWS_AS((World{SemiImplicitEuler{}, Drag{std::numeric_limits<double>::quiet_NaN() / second}}),
                    std::invalid_argument);
}
