// SPDX-License-Identifier: BSL-1.0

// Hard cases I17 and I18: stiff and soft in one world, and an implicit method that is not one.

#include "tests/motion/support.hpp"

using namespace motion_tests;

namespace {

/// A spring to the origin that is hard along one direction of the plane and soft across it: the Jacobian is a full
/// matrix.
struct TwoStiffnesses {
    using role = roles::Force;
    using reads = Columns<Position>;
    double hard = 1e6, soft = 1; // 1/s^2
    double angle = 0.5;

    template <class S> struct In {
        Eigen::Matrix<double, 2, 2> K;
        explicit In(const TwoStiffnesses& t) {
            Eigen::Matrix<double, 2, 2> turn;
            turn << std::cos(t.angle), -std::sin(t.angle), std::sin(t.angle), std::cos(t.angle);
            K = turn * Eigen::Vector2d(t.hard, t.soft).asDiagonal() * turn.transpose();
        }
        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            return S::Acceleration::from_value(Eigen::Vector2d(-K * x.value()));
        }
        Jacobian<S> jacobian(const typename S::Position&, const auto&) const {
            return {S::template MatrixOf<unit::FrequencySquared>::from_value(-K), {}};
        }
    };
};

/// "Implicit" Euler by repeating its formula a few times: the negative control.
template <int Sweeps> struct FixedPointEuler {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int order = 1;
    static bool solve(auto& x, auto& v, const auto& laws, const auto& dt) {
        auto next_x = x;
        auto next_v = v;
        for (int i = 0; i < Sweeps; ++i) {
            next_v = v + laws(next_x, next_v, 1.0) * dt;
            next_x = x + next_v * dt;
        }
        x = next_x;
        v = next_v;
        return true;
    }
};

/// |x| in units of the start plus |v| / omega, after 60 steps of k = 1e4 /s^2 at 60 Hz.
template <class I> double size_after_60() {
    World world{Space<double, 2>{}, I{}, Oscillator{100.0 / second}};
    const auto body = add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second});
    run(world, 60, 1.0 / 60);
    const auto s = state(world, body);
    return std::hypot(s[0], s[3] / 100);
}

} // namespace

TEST_CASE("I17 stiff and soft: implicit Euler, two bodies on one spring constant", "[motion][I17]") {
    // k = 1 N/m with 1 kg and with one milligram: omega = 1/s and 1000/s, omega h = 16.7 at 60 Hz.
    World world{Space<double, 2>{}, ImplicitEuler{}, PointSpring{1.0 * newton_per_metre}};
    const auto slow = add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second}, 1);
    const auto fast = add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second}, 1e-6);
    World alone{Space<double, 2>{}, ImplicitEuler{}, PointSpring{1.0 * newton_per_metre}};
    const auto reference = add_body(alone, OnALine{1.0 * metre, 0.0 * metre_per_second}, 1);
    double most = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(1.0 / 60 * second);
        alone.step(1.0 / 60 * second);
        most = std::max(most, std::abs(world.position(fast).value()[0]));
    }
    CHECK(most <= 1);
    CHECK(same_state(world, slow, alone, reference)); // bodies do not know of each other
    CHECK(world.status().ok());
}

TEST_CASE("I17 stiff and soft: implicit Euler, both in one body, not along the axes", "[motion][I17]") {
    auto soft_mode = [](const TwoStiffnesses& springs, double& most_hard) {
        World world{Space<double, 2>{}, ImplicitEuler{}, springs};
        const double c = std::cos(springs.angle), s = std::sin(springs.angle);
        const auto body = add_body(world, InAPlane{metres(c - s, s + c), metres_per_second(0, 0)}); // 1 m along each
        most_hard = 0;
        for (int i = 0; i < 600; ++i) {
            world.step(1.0 / 60 * second);
            const auto x = world.position(body);
            most_hard = std::max(most_hard, std::abs(c * x.value()[0] + s * x.value()[1]));
        }
        CHECK(world.status().ok());
        const auto x = world.position(body);
        return -s * x.value()[0] + c * x.value()[1];
    };
    double hard = 0, ignored = 0;
    const double exact = std::cos(10.0), both = soft_mode({}, hard), own = soft_mode({1, 1, 0.5}, ignored);
    INFO("slow mode: error " << both - exact << " beside the stiff one, " << own - exact
                             << " by itself; stiff mode: largest " << hard << " m");
    CHECK(hard <= 1);
    CHECK(std::abs(both - exact) <= 2 * std::abs(own - exact));
}

TEST_CASE("I17 stiff and soft: explicit schemes say that they diverged, and hold below 2 ms", "[motion][I17]") {
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet, RungeKutta4>{}, []<class I> {
        auto world_after = [](double h) {
            World world{Space<double, 2>{}, I{}, PointSpring{1.0 * newton_per_metre}};
            add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second}, 1);
            add_body(world, OnALine{1.0 * metre, 0.0 * metre_per_second}, 1e-6);
            run(world, 1200, h);
            return world;
        };
        const auto diverged = world_after(1.0 / 60);
        INFO("at 60 Hz omega h = 16.7, far beyond 2: World::status must name the body that is not finite any more, and "
             "only it");
        CHECK(diverged.status().not_finite == 1);
        CHECK(diverged.status().first_not_finite == diverged.handles()[1]);
        CHECK(std::abs(diverged.position(diverged.handles()[0]).value()[0]) <= 1.01); // the soft one does not notice
        const auto sub_stepped = world_after(1.0 / 600);
        CHECK(sub_stepped.status().ok());
        CHECK(std::abs(sub_stepped.position(sub_stepped.handles()[1]).value()[0]) <= 2);
    });
}

TEST_CASE("I18 implicit that is not: fixed-point iterations diverge, the solve does not", "[motion][I18]") {
    // omega h = 1.67: an iteration multiplies the error by 2.78. The exact solution shrinks by sqrt(1 + omega^2 h^2) a
    // step.
    CHECK_FALSE(size_after_60<FixedPointEuler<2>>() <= 1e30); // negative controls
    CHECK_FALSE(size_after_60<FixedPointEuler<5>>() <= 1e30);
    CHECK_FALSE(size_after_60<FixedPointEuler<20>>() <= 1e30);
    const double exact = std::pow(1 + 1e4 / 3600, -30.0), solved = size_after_60<ImplicitEuler>();
    INFO("solved " << solved << ", should be " << exact);
    CHECK(std::abs(solved / exact - 1) <= 1e-11); // 60 solves, each to a few roundings
    CHECK(std::abs(solved - 4.8e-18) <= 1e-19);
}
