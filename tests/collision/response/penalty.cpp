// SPDX-License-Identifier: BSL-1.0
// Penalty: hard cases C22 and C23, R8, the third law, energy from nothing (V3), and the step that it allows.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/penalty.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/springs/step_limit.hpp>
#include <ansatz/world/save.hpp>

#include <random>
#include <sstream>

using namespace collision_tests;

namespace {
constexpr auto N_per_m = 1.0 * newton_per_metre;
constexpr auto N_s_per_m = 1.0 * newton_second_per_metre;

/// The coefficient of restitution with which two bodies of 1 kg part that met at 1 m/s each, with 50 steps in a
/// contact.
template <class I, class S> double restitution_of(double zeta, double k = 1e4) {
    const double mu = 0.5, omega = std::sqrt(k / mu);
    auto world = world_of(I{}, S{}, Penalty{k * N_per_m, 2 * zeta * std::sqrt(k * mu) * N_s_per_m});
    const auto a = world.add(Sphere{0.5 * metre}, at<S>(0), going<S>(1), mass(1.0 * kilogram));
    const auto b = world.add(Sphere{0.5 * metre}, at<S>(1.01), going<S>(-1), mass(1.0 * kilogram));
    for (int i = 0; i < 400; ++i) {
        world.step(M_PI / omega / 50 * second);
        CHECK(std::abs(speed_along(world, a) + speed_along(world, b)) <=
              (std::is_same_v<typename S::Scalar, float> ? 1e-5 : 1e-12)); // C22: F_a = -F_b
    }
    return (speed_along(world, b) - speed_along(world, a)) / 2;
}
} // namespace

TEST_CASE("C23: a damped contact bounces as its damping ratio says, and less with more of it", "[collision][penalty]") {
    // While nothing is clamped e = exp(-pi zeta / sqrt(1 - zeta^2)). A contact never pulls: it lets go where k p = c v,
    // a little earlier, and gives back a little more.
    auto clamped = [](double zeta) { // the damped oscillator from p = 0 until its force is zero, stepped finely
        double p = 0, v = 1;
        const double h = 1e-6;
        for (;;) {
            const double f = -p - 2 * zeta * v; // k = m = 1
            if (p > 0 && f >= 0) return -v;
            v += h * f;
            p += h * v;
        }
    };
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, RungeKutta4>{}, [&]<class I>() {
        double before = 1.1;
        for (const double zeta : {0.0, 0.1, 0.21545, 0.5}) {
            const double e = restitution_of<I, Space<double, 3>>(zeta);
            INFO("zeta " << zeta << ": e = " << e);
            CHECK(std::abs(e - (zeta > 0 ? clamped(zeta) : 1)) <= 0.02);
            CHECK(e < before);
            before = e;
        }
        CHECK(std::abs(restitution_of<I, Space<float, 2>>(0.21545) - clamped(0.21545)) <= 0.02);
    });
    CHECK(std::abs(clamped(0.1) - 0.7441) < 1e-3); // the figures that others have measured
    CHECK(std::abs(clamped(0.5) - 0.2984) < 1e-3);
}

namespace {
/// How far a pair that is pressed together by a constant force strays from where it would lie still, m.
template <class S, class... P> double stray(double k, double other, int steps, P... policies) {
    auto world = world_of(SemiImplicitEuler{}, S{}, AppliedForces{}, Penalty{k * N_per_m, {}}, policies...);
    const double pressed = 100, still = 1 - pressed / k;
    const auto a = world.add(Sphere{0.5 * metre}, at<S>(0), mass(1.0 * kilogram));
    const auto b = world.add(Sphere{0.5 * metre}, at<S>(still - 1e-4 * (1 - still)), mass(other * kilogram));
    double most = 0;
    for (int i = 0; i < steps; ++i) {
        world.apply_force(a, vector_in<S, unit::Force>(pressed));
        world.apply_force(b, vector_in<S, unit::Force>(-pressed));
        world.step(1.0 / 60 * second);
        most = std::max(most, std::abs(x_of(world, b) - x_of(world, a) - still));
    }
    return most / (1 - still);
}
} // namespace

TEST_CASE("C22: two bodies that are pressed together are stable up to k = 4 mu / h^2, and not beyond",
          "[collision][penalty]") {
    for_each_type(Types<Space<double, 3>, Space<float, 2>>{}, []<class S>() {
        for (const double other : {1.0, 1000.0}) {
            const double limit = 4 * other / (1 + other) * 3600;
            CHECK(std::abs(limit - (other == 1 ? 7200 : 14385.6)) < 1);
            CHECK(stray<S>(0.99 * limit, other, 300) < 1e-2);
            CHECK(stray<S>(1.01 * limit, other, 300) > 0.5);
        }
    });
}

TEST_CASE("the stable step of a contact is known, and a StepLimit refuses or divides what is beyond it",
          "[collision][penalty]") {
    using S = Space<double, 2>;
    auto world = world_of(SemiImplicitEuler{}, S{}, Penalty{7200.0 * N_per_m, {}}, StepLimit<Refuse>{});
    two_spheres(world, 0, 0);
    world.step(1e-6 * second);
    CHECK(std::abs(stable_step(world).value() * 60 - 1) <= 1e-9);
    const auto sentence = refusal([&] { world.step(1.0 / 50 * second); });
    INFO(sentence);
    CHECK(sentence.find("the longest that is stable for these springs is 0.01666 s") != std::string::npos);
    CHECK(stray<S>(1.5 * 7200, 1, 300, StepLimit<Divide>{}) < 1e-2);
}

TEST_CASE("R8: on a soft floor a body lies mg/k deep, with every integrator that a step of 1/240 s suits",
          "[collision][penalty]") {
    for_each_type(Types<SemiImplicitEuler, ImplicitEuler, Verlet, VelocityVerlet, RungeKutta4>{}, []<class I>() {
        for (const double k : {1e3, 1e4, 5e4}) {
            auto world = world_of(I{}, Gravity{}, Penalty{k * N_per_m, 0.4 * std::sqrt(k) * N_s_per_m});
            const auto ball = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 0.6), mass(1.0 * kilogram));
            world.add(Plane::ground(), fixed);
            run(world, 50 * 240, 1.0 / 240);
            INFO("k = " << k);
            CHECK(std::abs(0.5 - height_of(world, ball) - 9.81 / k) <= 1e-10);
        }
    });
}

namespace {
/// The largest relative change of energy over the first bounce on a soft floor, from 16 heights, so that every part of
/// a step is one in which a ball comes to touch.
template <class I, class S = Space<>> double changed_by_a_bounce(double h, double k = 1e4) {
    double most = 0;
    for (int i = 0; i < 16; ++i) {
        auto world = world_of(I{}, S{}, Gravity{}, Penalty{k * N_per_m, {}});
        const auto ball = world.add(Sphere{0.05 * metre}, at<S>(0, 0.15 + 0.0005 * i), mass(1.0 * kilogram));
        world.add(Plane::ground(), fixed);
        const double before = total_energy(world).value();
        while (speed_along(world, ball, 1) <= 0) world.step(h * second);
        while (height_of(world, ball) < 0.06) world.step(h * second);
        most = std::max(most, std::abs(total_energy(world).value() / before - 1));
    }
    return most;
}
} // namespace

TEST_CASE("a bounce on a soft floor keeps the order of its integrator in the step that it begins in, too",
          "[collision][penalty]") {
    // omega h = 0.2, 0.1, 0.05. The force has a kink where they come to touch, so that no method is better than of
    // second order there: velocity Verlet, in contact for the time s of a step, makes omega^2 s (h - s) of the energy
    // wrong, at most (omega h)^2 / 4, and the other way round where they separate. Found a step late, the spring would
    // begin v h deep: four times as much, and always a gain.
    for_each_type(Types<VelocityVerlet, RungeKutta4>{}, []<class I>() {
        const double h = 0.002;
        const double errors[] = {changed_by_a_bounce<I>(h), changed_by_a_bounce<I>(h / 2),
                                 changed_by_a_bounce<I>(h / 4)};
        INFO(errors[0] << ' ' << errors[1] << ' ' << errors[2]);
        CHECK(errors[0] <= 0.2 * 0.2 / 4);
        CHECK(errors[0] / errors[2] >= 12);
        CHECK(changed_by_a_bounce<I, Space<float, 2>>(h) <= 0.2 * 0.2 / 4);
    });
}

TEST_CASE(
    "StepLimit divides the step in which two come to touch, and what happened in a part of it is news of the step",
    "[collision][penalty]") {
    Handle ball;
    auto make = [&] {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, Penalty{1e6 * N_per_m, {}}, StepLimit<Divide>{0.1});
        ball = world.add(Sphere{0.05 * metre}, at<Space<>>(0, 0.15), mass(1.0 * kilogram));
        world.add(Plane::ground(), fixed);
        return world;
    };
    auto world = make();
    const double drop = 0.1 * 9.81, h = 1.0 / 60;
    int begun = 0, over = 0, turned = 0;
    double fell = -1;
    for (int i = 0; i < 600; ++i) {
        std::stringstream file;
        save(world, file);
        auto loaded = make();
        load(loaded, file);
        loaded.step(h * second);
        world.step(h * second);
        REQUIRE(loaded.hash() == world.hash());
        REQUIRE(loaded.contacts().size() == world.contacts().size());
        for (const auto& contact : world.contacts()) begun += contact.begins();
        over += int(world.contacts_ended().size());
        const double v = speed_along(world, ball, 1);
        turned += fell < 0 && v > 0;
        fell = v;
        // At one part in ten of the largest stable step, omega h = 0.2: semi-implicit Euler swings by that much of the
        // energy.
        REQUIRE(total_energy(world).value() <= 1.2 * drop + 9.81 * 0.05);
    }
    CHECK(turned >= 30);
    CHECK(over >= turned - 1);
    CHECK(over <= turned + 1);
    CHECK(begun <= over + 1);
}

namespace {
/// What became of the energy, that of the springs included, of a gas in a closed box without gravity, relative to the
/// start.
struct Course {
    double most = 0;  // above the start, ever
    double apart = 0; // above the last time that no body touched, whenever no body does
};
struct PenaltyGas {
    double omega_h; // of a body against a wall, or of two that meet: of the stiffest pair
    double zeta;
    double radii_a_step;
    int bodies;
    bool boxes; // every other one
    unsigned seed = 7;
};
template <class I, class S> Course course(const PenaltyGas& gas) {
    constexpr double k = 1e4, r = 0.1, mu = 0.5;
    const double omega = std::sqrt(k / mu), h = gas.omega_h / omega, speed = gas.radii_a_step * r / h;
    const double half = 0.25 * std::cbrt(gas.bodies) + 0.35 + (S::dimension == 2 ? 0.3 : 0.0);
    World world{I{}, S{}, UniformGrid{}, Narrowphase<Sphere, Plane, Box>{},
                Penalty{k * N_per_m, 2 * gas.zeta * std::sqrt(k * mu) * N_s_per_m}};
    for (int d = 0; d < S::dimension; ++d)
        for (const double side : {-1.0, 1.0})
            world.add(Plane{Eigen::Vector3d(-side * Eigen::Vector3d::Unit(d)), -half * metre}, fixed);
    std::mt19937 random(gas.seed);
    std::uniform_real_distribution<double> between(-1, 1);
    const int row = int(std::ceil(std::pow(double(gas.bodies), 1.0 / S::dimension)));
    for (int i = 0; i < gas.bodies; ++i) {
        const auto place = [&](int n) { return ((n + 0.5) / row * 2 - 1) * (half - 0.12); };
        const double x = between(random), y = between(random), z = S::dimension == 3 ? between(random) : 0;
        Eigen::Vector3d v(x, y, z);
        v *= speed / v.norm();
        const auto where = at<S>(place(i % row), place(i / row % row), place(i / row / row));
        const auto how = velocity(vector_in<S, unit::Velocity>(v[0], v[1], v[2]));
        const auto m = mass((i % 4 == 0 ? 4.0 : 1.0) * kilogram);
        if (gas.boxes && i % 2 == 1) world.add(Box{vector_in<S, unit::Length>(0.8 * r, 0.9 * r, r)}, where, how, m);
        else world.add(Sphere{r * metre}, where, how, m);
    }
    const double start = double(total_energy(world).value());
    Course result;
    double last_apart = start;
    for (int i = 0; i < 2000; ++i) {
        world.step(h * second);
        const double now = double(total_energy(world).value());
        result.most = std::max(result.most, now / start - 1);
        bool touch = false;
        for (const auto& contact : world.contacts()) touch = touch || contact.depth.value() > 0;
        if (touch) continue;
        result.apart = std::max(result.apart, (now - last_apart) / start);
        last_apart = now;
    }
    return result;
}
/// Slow and fast ones, up to three radii a step, two bodies and thirty.
template <class F> void for_each_gas(double zeta, F&& f) {
    for (const double omega_h : {0.05, 0.2})
        for (const double radii : {0.01, 0.1, 0.5, 3.0})
            for (const int bodies : {2, 30})
                for (const bool boxes : {false, true}) {
                    INFO(bodies << " bodies, omega h = " << omega_h << ", " << radii << " radii a step"
                                << (boxes ? ", boxes" : ""));
                    f(PenaltyGas{omega_h, zeta, radii, bodies, boxes});
                }
}
} // namespace

TEST_CASE(
    "V3: an undamped penalty whose contacts are resolved has the energy that it had, but for its integrator's swing",
    "[collision][penalty]") {
    // What semi-implicit Euler keeps is E - (h / 2) F . v, and |F . v| = k p v_N <= omega E: it swings by omega h / 2.
    // Where contacts begin and end each method errs by up to (omega h)^2 / 4 of what is in the contact, either way; of
    // a few thousand (omega h)^2.
    for_each_gas(0, [](const PenaltyGas& gas) {
        const double ends = gas.omega_h * gas.omega_h, swing = gas.omega_h / 2;
        CHECK(course<VelocityVerlet, Space<>>(gas).most <= ends);
        CHECK(course<SemiImplicitEuler, Space<>>(gas).most <= swing + ends);
        CHECK(course<RungeKutta4, Space<float, 2>>(gas).most <= ends);
    });
}

TEST_CASE("V3: when all have separated, a damped one has no more than before they met, but for what a graze errs by",
          "[collision][penalty]") {
    // What touches for about a step is pressed in by no more than v_N h: (omega h)^2 of the energy is in the contact,
    // of which its beginning and its end err by up to (omega h)^2 / 4, and damping has had no time to take that.
    // Whatever touches longer loses more than that.
    const auto graze = [](double omega_h) { return std::pow(omega_h, 4) / 4; };
    for (const double zeta : {0.1, 0.2, 0.7})
        for_each_gas(zeta, [&](const PenaltyGas& gas) {
            const auto check = [&](const Course& seen, double most) {
                CHECK(seen.most <= most);
                CHECK(seen.apart <= graze(gas.omega_h));
            };
            check(course<VelocityVerlet, Space<>>(gas), gas.omega_h * gas.omega_h / 4); // where one begins
            check(course<SemiImplicitEuler, Space<>>(gas), gas.omega_h / 2);
            check(course<RungeKutta4, Space<float, 2>>(gas), std::max(1e-5, gas.omega_h * gas.omega_h / 4));
        });
    double most = 0; // two that fly in a box, wherever they began: some graze, and the law has no room to spare
    for (const double omega_h : {0.05, 0.2})
        for (unsigned seed = 1; seed <= 30; ++seed) {
            CAPTURE(omega_h, seed);
            const auto seen = course<VelocityVerlet, Space<>>({omega_h, 0.05, 3.0, 2, true, seed});
            CHECK(seen.apart <= graze(omega_h));
            most = std::max(most, seen.apart / graze(omega_h));
        }
    CHECK(most > 0.1);
}

TEST_CASE("what passes by a corner feels nothing of it", "[collision][penalty]") {
    // Found early, an edge is no wall: neither the one of a box that another passes at its corner, nor that which a
    // ball flies around.
    for_each_type(Types<Space<double, 3>, Space<float, 2>>{}, []<class S>() {
        auto box = [](double half) {
            return S::dimension == 2 ? Box{metres(half, half)} : Box{metres(half, half, half)};
        };
        auto passes = [&](auto shape, double from, double to) {
            auto world = world_of(VelocityVerlet{}, S{}, Penalty{1e4 * N_per_m, {}});
            world.add(box(0.5), at<S>(0, 0), fixed);
            const auto mover = world.add(shape, at<S>(from, to), going<S>(3, -3), mass(1.0 * kilogram));
            run(world, 100, 1.0 / 60);
            return world.velocity(mover) == vector_in<S, unit::Velocity>(3, -3);
        };
        // A body on the way (1, -1) whose nearest point to the corner (0.5, 0.5) is 1 mm away.
        const double gap = 0.001;
        CHECK(passes(Sphere{0.25 * metre}, -1 + (0.25 + gap) / std::sqrt(2.0), 2 + (0.25 + gap) / std::sqrt(2.0)));
        CHECK(passes(box(0.25), -1 + 0.25 + gap, 2 + 0.25 + gap));
        CHECK_FALSE(
            passes(Sphere{0.25 * metre}, -1 + (0.25 - gap) / std::sqrt(2.0), 2 + (0.25 - gap) / std::sqrt(2.0)));
    });
}

TEST_CASE("a damper that would stop a body before it touches leaves an implicit step without a solution, and says so",
          "[collision][penalty]") {
    // A ball comes towards a fixed one without gravity. The velocity v_1 at the end of the step has to be
    // v_0 + (h / m) F(v_1), and the two touch there if v_1 is faster than v_c = gap / h. Where they just touch the
    // damper pushes with c v_c at once, beside which nothing is there: F jumps. If that push takes more than v_0 - v_c,
    // the ball neither touches (it has v_0 then, and would) nor does not. So there is a solution just where (h c + m)
    // v_c <= m v_0.
    constexpr double h = 0.01, m = 1, v = 3, gap = 0.02, k = 100;
    constexpr double limit = m * (v - gap / h) / gap; // of c: 50 N s/m
    const auto unsolved = [&](auto integrator, double c) {
        auto world = world_of(integrator, Penalty{k * N_per_m, c * N_s_per_m});
        world.add(Sphere{0.5 * metre}, position(metres(0, 0, 0)), fixed);
        const auto ball = world.add(Sphere{0.5 * metre}, position(metres(1 + gap, 0, 0)),
                                    velocity(metres_per_second(-v, 0, 0)), mass(m * kilogram));
        world.step(h * second);
        CHECK(std::isfinite(speed_along(world, ball)));
        CHECK(speed_along(world, ball) >= -v * 1.0001); // whatever is left, nothing was given to it
        CHECK(speed_along(world, ball) <= 0);
        return world.status().unsolved;
    };
    CHECK(unsolved(ImplicitEuler{}, 0.98 * limit) == 0);
    CHECK(unsolved(ImplicitEuler{}, 1.02 * limit) > 0);
    CHECK(unsolved(ImplicitEuler{}, 20 * limit) > 0);
}
