// SPDX-License-Identifier: BSL-1.0
// Stacks and piles: hard cases R1, R3, R4, R6, R14 to R16, C21, C25 to C27, and what a pile is to the last bit.
// Compiled with optimisation: it lasts, and what a pile is to the last bit must not depend on the optimiser.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60, g = 9.81; // s, m/s^2
using Solver = SoftContacts<Space<>, false>;

/// Bodies one upon the other on the ground, their contacts from below: bodies[0] is the ground. The masses in kg.
Solver stack(const std::vector<double>& masses) {
    Solver solver;
    auto add = [&](double weight) {
        solver.bodies.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(0, double(solver.bodies.size()), 0), weight});
    };
    add(0);
    for (const double m : masses) {
        add(1 / m);
        Solver::Constraint c{};
        c.slot_a = std::uint32_t(solver.bodies.size() - 1);
        c.slot_b = c.slot_a - 1;
        c.a = c.slot_a, c.b = c.slot_b;
        c.normal = Eigen::Vector3d(0, 1, 0);
        c.touching = 1;
        solver.all.push_back(c);
    }
    solver.weigh();
    return solver;
}
/// What gravity does to them in a step.
void fall(Solver& solver) {
    for (std::size_t i = 1; i < solver.bodies.size(); ++i) solver.bodies[i].u = Eigen::Vector3d(0, -g * dt, 0);
}
/// The largest depth of two of these bodies, m.
template <class World_> double deepest(const World_& world) {
    double most = 0;
    for (const auto& c : world.contacts()) most = std::max(most, double(c.depth.value()));
    return most;
}
template <class World_> double fastest(const World_& world, const std::vector<Handle>& bodies) {
    double most = 0;
    for (const auto b : bodies) most = std::max(most, double(norm(world.velocity(b)).value()));
    return most;
}
} // namespace

TEST_CASE("R1: with each sweep the error of a heavy body on a light one shrinks by R / (R + 1)", "[collision][piles]") {
    for (const double ratio : {10.0, 100.0, 400.0, 1e3, 1e4}) {
        auto solver = stack({1, ratio});
        fall(solver);
        const double right = ratio * g * dt; // the impulse that holds the upper one
        double before = 0;
        for (int sweep = 0; sweep < 30; ++sweep) {
            solver.relax(1.0);
            const double error = right - solver.all[1].impulse;
            if (sweep > 0) CHECK(std::abs(error / before - ratio / (ratio + 1)) <= 1e-4);
            before = error;
        }
    }
}

TEST_CASE("R3: a warm start pays: ten bodies, a load of 100:1 on top, ten sweeps a step", "[collision][piles]") {
    auto residual_after = [](double load, bool warm, int steps) {
        std::vector<double> masses(9, 1.0);
        masses.push_back(load);
        auto solver = stack(masses);
        for (int n = 0; n < steps; ++n) {
            fall(solver);
            if (warm) solver.warm_start();
            else
                for (auto& c : solver.all) c.impulse = 0;
            for (int sweep = 0; sweep < 10; ++sweep) solver.relax(1.0);
        }
        double most = 0;
        for (const auto& body : solver.bodies) most = std::max(most, std::abs(body.u.y()) / (g * dt));
        return most;
    };
    for (const int steps : {1, 10, 60, 300}) CHECK(std::abs(residual_after(100, false, steps) - 0.996) <= 0.01);
    const std::vector<std::pair<int, double>> known{{1, 0.996}, {10, 0.907}, {60, 0.529}, {300, 0.040}};
    for (const auto& [steps, residual] : known) {
        INFO(steps << " steps");
        CHECK(std::abs(residual_after(100, true, steps) - residual) <= 0.01);
    }
    CHECK(std::abs(residual_after(1000, true, 300) - 0.72) <= 0.01);
}

TEST_CASE("R4: a heavy sphere on a light one is held", "[collision][piles]") {
    for (const double ratio : {60.0, 100.0}) {
        INFO(ratio << ":1");
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<>{});
        world.add(Plane::ground(), fixed);
        const auto light = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 0.5), mass(1.0 * kilogram));
        const auto heavy = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 1.5), mass(ratio * kilogram));
        double lowest = 1;
        for (int i = 0; i < 600; ++i) {
            world.step(dt * second);
            lowest = std::min(lowest, height_of(world, light));
        }
        CHECK(lowest >= 0.49);
        CHECK(deepest(world) <= 0.01); // while the load is new, for a tenth of a second: 1.08 cm with 100:1
        CHECK(height_of(world, heavy) >= 1.49);
        CHECK(fastest(world, {light, heavy}) <= 0.05);
    }
}

TEST_CASE("R6: fifteen boxes, each a little beside the one below and above it by a tenth, stand 20 s later",
          "[collision][piles]") {
    auto world = world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<Friction>{});
    world.add(Plane::ground(), fixed, friction(0.6));
    std::vector<Handle> boxes;
    for (int i = 0; i < 15; ++i)
        boxes.push_back(world.add(Box{metres(0.5, 0.5, 0.5)}, at<Space<>>(i % 2 == 0 ? 0.01 : -0.01, 0.55 + 1.1 * i),
                                  mass(1.0 * kilogram), friction(0.6)));
    run(world, 1200, dt);
    for (int i = 0; i < 15; ++i) {
        CHECK(std::abs(height_of(world, boxes[std::size_t(i)]) - (0.5 + i)) <= 0.02);
        CHECK(std::abs(x_of(world, boxes[std::size_t(i)])) <= 0.02);
    }
}

TEST_CASE("R14: in which order bodies are added makes no difference to where they come to lie", "[collision][piles]") {
    auto drop = [](const std::vector<int>& order, bool floor_first) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<>{});
        if (floor_first) world.add(Plane::ground(), fixed);
        std::vector<Handle> by_number(order.size());
        for (const int i : order)
            by_number[std::size_t(i)] = world.add(Sphere{0.5 * metre}, at<Space<>>(3.0 * (i % 5), 1 + 1.5 * (i / 5)),
                                                  mass((1.0 + i) * kilogram), restitution(0.1 * (i % 3)));
        if (!floor_first) world.add(Plane::ground(), fixed);
        run(world, 400, dt);
        std::vector<double> places;
        for (const auto b : by_number) places.push_back(x_of(world, b)), places.push_back(height_of(world, b));
        return places;
    };
    std::vector<int> order(15);
    std::iota(order.begin(), order.end(), 0);
    const auto reference = drop(order, true);
    auto compare = [&](const std::vector<double>& other) {
        for (std::size_t i = 0; i < reference.size(); ++i) CHECK(std::abs(other[i] - reference[i]) <= 1e-9);
    };
    compare(drop(order, false)); // columns of three are solved from below, or from above
    std::mt19937 random(7);
    for (int k = 0; k < 3; ++k) {
        for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
        compare(drop(order, k % 2 == 0));
    }
}

TEST_CASE("R14: under ten times the gravity a bouncing ball comes to rest without trembling", "[collision][piles]") {
    auto check = [](auto world) {
        world.set(Gravity{metres_per_second_squared(0, -100, 0)});
        world.add(Plane::ground(), fixed);
        const auto ball = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 2), mass(1.0 * kilogram), restitution(0.5));
        run(world, 300, dt);
        double sum = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(dt * second);
            sum += double(squared_norm(world.velocity(ball)).value()) / 60;
        }
        CHECK(std::sqrt(sum) < 0.01);
        CHECK(std::abs(height_of(world, ball) - 0.5) <= 0.01);
    };
    check(world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<>{}));
    Impulse<> impulse;
    impulse.threshold = 4.0 * metre_per_second; // 2 g dt and more: what a resting body gains in a step is no approach
    check(world_of(SemiImplicitEuler{}, Gravity{}, impulse, Projection{1e-3 * metre}));
}

TEST_CASE("R15: a million steps at rest, and nothing has sunk or drifted", "[collision][piles]") {
#ifdef NDEBUG
    const int steps = 1'000'000;
#else
    const int steps = 20'000; // with assertions and sanitizers a step takes fifty times as long
#endif
    auto check = [&](auto world, double slop, double depth) {
        world.add(Plane::ground(), fixed);
        const auto lower = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 0.5), mass(1.0 * kilogram));
        const auto upper = world.add(Sphere{0.5 * metre}, at<Space<>>(0, 1.5), mass(2.0 * kilogram));
        run(world, 600, dt);
        const double y = height_of(world, upper);
        run(world, steps, dt);
        CHECK(std::abs(height_of(world, upper) - y) <= slop);
        CHECK(std::abs(height_of(world, upper) - 1.5) <= depth);
        CHECK((x_of(world, upper) == 0 && x_of(world, lower) == 0));
    };
    check(world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<>{}), 1e-6, 1e-3);
    // One projection after another moves the lower ball down again: a column of two is held, but not at its place.
    check(world_of(SemiImplicitEuler{}, Gravity{}, Impulse<>{}, Projection{1e-3 * metre}), 3e-3,
          0.02); // the slop, and what it falls in a step
}

TEST_CASE("R16: lengths a thousand times smaller or larger, and everything else with them: the same motion",
          "[collision][piles]") {
    auto heights = [](double scale, double e, auto response) {
        response.threshold = 0.25 * scale * metre_per_second;
        if constexpr (requires { response.push_out; }) response.push_out = 3.0 * scale * metre_per_second;
        auto world = world_of(SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -g * scale, 0)}, response);
        world.add(Plane::ground(), fixed);
        std::vector<Handle> balls;
        for (int i = 0; i < 4; ++i)
            balls.push_back(world.add(Sphere{0.5 * scale * metre}, at<Space<>>(0, (1 + 1.3 * i) * scale),
                                      mass((1.0 + i) * kilogram), restitution(e)));
        std::vector<double> all;
        for (int i = 0; i < 240; ++i) {
            world.step(dt * second);
            for (const auto b : balls) all.push_back(height_of(world, b) / scale);
        }
        return all;
    };
    auto check = [&](double e, auto response, double least, double most_different, std::size_t from = 0) {
        const auto one = heights(1, e, response);
        for (const double scale : {least, 1 / least}) {
            const auto other = heights(scale, e, response);
            double most = 0;
            for (std::size_t i = from; i < one.size(); ++i) most = std::max(most, std::abs(one[i] - other[i]));
            INFO("lengths times " << scale << ", e = " << e);
            CHECK(most <= most_different);
        }
    };
    // A power of two changes no digit of any number: the same motion to the bit, whatever happens in it.
    check(0.5, Impulse<>{}, 1.0 / 1024, 0);
    check(0.5, SoftSubsteps<>{}, 1.0 / 1024, 0);
    check(0.5, Impulse<>{}, 1e-3, 1e-9);
    // Whether two that just touch are apart or not is decided by the last digit, and they are stopped at once or
    // softly: millimetres while the balls fall on each other, and the same place in the end.
    check(0, SoftSubsteps<>{}, 1e-3, 1e-9, 4 * 180);
}

TEST_CASE("C21: what was put into each other separates slowly, and does not jump", "[collision][piles]") {
    auto world = world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<Friction>{});
    world.add(Plane::ground(), fixed, friction(0.5));
    std::vector<Handle> boxes;
    std::vector<double> start;
    const double apart = 0.75; // of boxes of 1 m: a quarter of each lies in its neighbour
    for (int row = 0; row < 4; ++row)
        for (int k = 0; k < 4 - row; ++k) {
            start.push_back(apart * (k + 0.5 * row));
            boxes.push_back(world.add(Box{metres(0.5, 0.5, 0.5)}, at<Space<>>(start.back(), 0.5 + apart * row),
                                      mass(1.0 * kilogram), friction(0.5)));
        }
    double most = 0, aside = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(dt * second);
        most = std::max(most, fastest(world, boxes));
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) aside = std::max(aside, std::abs(x_of(world, boxes[i]) - start[i]));
    CHECK(most <= 3); // push_out is 1.5 m/s for a pair
    CHECK(deepest(world) <= 0.01);
    CHECK(aside <= 0.5);
}

TEST_CASE("C25: on a ramp friction holds what is not too steep, and slows what slides by its law",
          "[collision][piles]") {
    constexpr double slope = 0.25;
    struct Slid {
        double way, speed; // m, m/s, downhill
    };
    auto slide = [](auto response, double mu, double seconds) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, response);
        const Eigen::Vector3d up(-std::sin(slope), std::cos(slope), 0), down(-std::cos(slope), -std::sin(slope), 0);
        world.add(Plane{up, 0.0 * metre}, fixed, friction(mu));
        const auto ball = world.add(Sphere{0.5 * metre}, position(Eigen::Vector3d(0.5 * up) * metre),
                                    mass(3.0 * kilogram), friction(mu));
        run(world, int(std::lround(seconds / dt)), dt);
        return Slid{down.dot(world.position(ball).value() - 0.5 * up), down.dot(world.velocity(ball).value())};
    };
    for (const double mu : {0.75, 0.5, 0.35, 0.26, 0.25, 0.1, 0.0}) {
        INFO("mu = " << mu);
        const double a = std::max(0.0, g * (std::sin(slope) - mu * std::cos(slope))), t = 2;
        const auto soft = slide(SoftSubsteps<Friction>{}, mu, t), hard = slide(Impulse<Friction>{}, mu, t);
        CHECK(std::abs(soft.speed - a * t) <= 0.01 * t);
        CHECK(std::abs(soft.way - a * t * t / 2) <= 0.01 * t * t / 2 + a * t * dt);
        CHECK(std::abs(hard.speed - a * t) <= 0.01 * t);
        // Impulse stops a body behind its step: one that sticks creeps by what gravity moved it in each, g sin(slope)
        // h^2.
        CHECK(std::abs(hard.way - a * t * t / 2) <= 0.01 * t * t / 2 + a * t * dt + g * std::sin(slope) * dt * t);
    }
}

TEST_CASE("C25: friction that is taken away while a body hangs on it holds no longer", "[collision][piles]") {
    constexpr double slope = 0.25, t = 1;
    const auto check = [](double less, auto... policies) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, policies...);
        const Eigen::Vector3d up(-std::sin(slope), std::cos(slope), 0), down(-std::cos(slope), -std::sin(slope), 0);
        world.add(Plane{up, 0.0 * metre}, fixed, friction(0.8));
        const auto ball = world.add(Sphere{0.5 * metre}, position(Eigen::Vector3d(0.5 * up) * metre),
                                    mass(3.0 * kilogram), friction(0.8));
        run(world, 120, dt);
        CHECK(std::abs(down.dot(world.velocity(ball).value())) <= 0.01);
        world.template write<Friction>(ball, Quantity<unit::Dimensionless>(less));
        run(world, int(std::lround(t / dt)), dt);
        const double mu = std::sqrt(0.8 * less), a = g * (std::sin(slope) - mu * std::cos(slope));
        INFO("mu = " << mu);
        CHECK(std::abs(down.dot(world.velocity(ball).value()) - a * t) <= 0.01 * t);
    };
    for (const double less : {0.0, 0.01}) {
        check(less, SoftSubsteps<Friction>{});
        check(less, SoftSubsteps<Friction>{}, Rest{});
        check(less, SoftSubsteps<Friction, Coloured>{});
        check(less, Impulse<Friction>{}, Projection{});
    }
}

TEST_CASE("C26: 666 spheres without friction come to lie in each other by no more than half a percent of a radius",
          "[collision][piles]") {
    auto world = World{SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}};
    const double half = 3.6;
    for (const Eigen::Vector3d& inwards :
         {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 0, 1),
          Eigen::Vector3d(0, 0, -1)})
        world.add(Plane{inwards, (inwards.y() > 0 ? 0.0 : -half) * metre}, fixed);
    std::mt19937 random(5);
    auto beside = [&] { return 0.01 * (double(random() % 2001) / 1000 - 1); };
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            for (int k = 0; k < 6; ++k)
                world.add(Sphere{0.5 * metre},
                          position(metres(1.1 * (i - 2.5) + beside(), 0.6 + 1.1 * j, 1.1 * (k - 2.5) + beside())),
                          mass(10.0 * kilogram));
    run(world, 600, dt);
    CHECK(deepest(world) <= 0.005 * 0.5);
}

TEST_CASE("C27: 49 balls with e = 1 keep their energy for 100 s within one percent", "[collision][piles]") {
    auto check = [](auto... response) {
        auto world = world_of(SemiImplicitEuler{}, Gravity{}, response...);
        world.add(Plane::ground(), fixed);
        std::vector<Handle> balls;
        for (int i = 0; i < 49; ++i)
            balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(2.0 * (i % 7), 2 + 0.1 * i, 2.0 * (i / 7))),
                                      mass(10.0 * kilogram), restitution(1)));
        // The velocity of this scheme is half a step ahead of its position.
        auto energy = [&] {
            double sum = 0;
            for (const auto b : balls) {
                const double v = speed_along(world, b, 1) - 0.5 * g * dt;
                sum += 10 * (0.5 * v * v + g * (height_of(world, b) - 0.5));
            }
            return sum;
        };
        double start = 0;
        for (int i = 0; i < 49; ++i) start += 10 * g * (1.5 + 0.1 * i);
        double most = 0;
        for (int i = 0; i < 6000; ++i) {
            world.step(dt * second);
            most = std::max(most, std::abs(energy() / start - 1));
        }
        CHECK(most <= 0.01);
    };
    check(Impulse<>{}, Projection{});
    check(SoftSubsteps<>{});
}
