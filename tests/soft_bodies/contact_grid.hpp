// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Every way to hold springs beside a response: what both must agree on is what velocity comes out.

#include "tests/soft_bodies/solvers.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>

#include <algorithm>
#include <random>
#include <tuple>

namespace soft_bodies_tests {

/// A way to hold springs: its policies, its step, and how wildly its sheet may begin. Explicit methods swing with
/// energy of their own, so that theirs begins flat.
template <class... Policies> struct Way {
    const char* name;
    double h, wild; // s, m/s
    std::tuple<Policies...> policies;
};
template <class F> void each_way(F&& f) {
    f(Way<SemiImplicitEuler>{"explicit", 1.0 / 480, 0, {}});
    f(Way<ImplicitEulerBy<MatrixFree>>{"implicit", 1.0 / 60, 0.3, {}});
    f(Way<SemiImplicitEuler, Xpbd>{"Xpbd", 1.0 / 60, 0.3, {{}, {10, 1}}});
    f(Way<SemiImplicitEuler, VertexBlockDescent>{"VertexBlockDescent", 1.0 / 60, 0.3, {{}, {4, 10}}});
}
/// A world of a way and responses, with nothing in it.
template <class... Policies, class... Response>
auto world_of(const Way<Policies...>& way, const Response&... response) {
    return std::apply(
        [&](const auto&... policy) {
            return World{policy...,  Gravity{}, Springs<>{}, SortAndSweep{}, Narrowphase<Sphere, Plane, Box>{},
                         response...};
        },
        way.policies);
}
/// The same with the ground at y = 0, as a plane or as the top of a box.
template <class World_> World_ on_plane(World_ world, const auto&... property) {
    world.add(Plane::ground(), fixed, property...);
    return world;
}
template <class World_> World_ on_box(World_ world, const auto&... property) {
    world.add(Box{metres(3, 0.5, 3)}, position(metres(0.3, -0.5, 0.3)), fixed, property...);
    return world;
}
struct Allowed {
    double lowest;    ///< m, of the particles' centres: their radius is 0.02 m
    double swing = 0; ///< J, by which an integrator's energy differs from what it keeps
};
/// A sheet falls, lies still in the end, and has no more energy at any time than at the beginning.
template <class W, class World_>
void falls_and_lies(const W& way, const World_& empty, const Allowed& allowed, const auto&... property) {
    for (const double stiffness : {200., 5000.})
        for (const double height : {0.02, 0.5}) {
            CAPTURE(way.name, stiffness, height);
            auto world = empty;
            const auto sheet =
                lay_sheet(world, 8, 0.7, height, 0.01, stiffness, 0.02, Sphere{0.02 * metre}, property...);
            std::mt19937 random(5);
            // Stiff ones begin flat: what a response does to one end of a stiff spring strains it, which the page tells
            // of.
            const double wild = stiffness < 1000 ? way.wild : 0;
            std::uniform_real_distribution<double> push(-wild, wild);
            for (const Handle body : sheet)
                world.set_velocity(body, metres_per_second(push(random), push(random), push(random)));
            const double start = total_energy(world).value();
            double most = start, speed = 0, lowest = 1;
            const int steps = int(8 / way.h);
            for (int i = 0; i < steps; ++i) {
                world.step(way.h * second);
                most = std::max(most, double(total_energy(world).value()));
                for (const Handle body : sheet) {
                    lowest = std::min(lowest, double(world.position(body).value()[1]));
                    if (i > steps * 7 / 8) speed = std::max(speed, double(norm(world.velocity(body)).value()));
                }
            }
            CHECK(world.status().ok());
            CHECK(speed <= 1e-3);
            CHECK(most <= start + allowed.swing + 1e-6);
            CHECK(lowest > allowed.lowest);
        }
}
/// Two particles on a slack spring hit the ground, and leave it with e times their speed.
template <class W, class World_> void bounces(const W& way, const World_& empty) {
    for (const double e : {0., 0.5, 1.}) {
        CAPTURE(way.name, e);
        auto world = empty;
        const auto a =
            world.add(Sphere{0.1 * metre}, position(metres(0, 1.1, 0)), mass(1.0 * kilogram), restitution(e));
        const auto b =
            world.add(Sphere{0.1 * metre}, position(metres(1, 1.1, 0)), mass(1.0 * kilogram), restitution(e));
        world.add(Spring{a, b, 100.0 * newton_per_metre});
        double down = 0, up = 0;
        for (int i = 0; i < int(1 / way.h) && up == 0; ++i) {
            const double before = world.velocity(a).value()[1];
            world.step(way.h * second);
            const double after = world.velocity(a).value()[1];
            if (before < 0 && after >= 0) {
                down = -before;
                up = after;
            }
        }
        CHECK(down > 4);
        // Gravity acts in the step of the impact, too: before it or behind it, by part of a step.
        CHECK(up == Approx(e * down).epsilon(0).margin(9.81 * way.h * (1 + e)));
    }
}

} // namespace soft_bodies_tests
