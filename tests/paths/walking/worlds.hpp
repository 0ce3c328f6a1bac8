// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Worlds of walkers, and the ways that they go.

#include <ansatz/paths/walking.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace walking_tests {

using namespace ansatz;
using namespace ansatz::paths;

struct Simple : World<SemiImplicitEuler, Walkers> {
    explicit Simple(const Walkers& walkers = {}) : World(SemiImplicitEuler{}, walkers) {}
};
struct Flat : World<Space<float, 2>, Verlet, Walkers> {
    Flat() : World(Space<float, 2>{}, Verlet{}, Walkers{}) {}
};
struct Third : World<Space<double, 2>, RungeKutta4, Walkers> {
    Third() : World(Space<double, 2>{}, RungeKutta4{}, Walkers{}) {}
};
struct Solved : World<Space<float, 3>, ImplicitEuler, Walkers> {
    Solved() : World(Space<float, 3>{}, ImplicitEuler{}, Walkers{}) {}
};
/// What else acts on a walker.
struct Ground : World<SemiImplicitEuler, Gravity, Drag, Walkers> {
    Ground() : World(SemiImplicitEuler{}, Gravity{}, Drag{0.3 / second}, Walkers{}) {}
};

/// Pushes of a user's own policy, by the library's verb.
struct Apart {
    using role = ansatz::roles::Force;
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position>;
    static constexpr std::string_view name = "Apart";
    static void parameters(auto&, auto&&) {}
    template <class S> struct In {
        explicit In(const Apart&) {}
        void couple(auto& view, const auto&) const {
            const auto reach = 2.0 * metre;
            const auto strength = 30.0 * newton;
            view.for_each([&](std::size_t i) {
                view.for_each([&](std::size_t k) {
                    if (view.id(i) < view.id(k))
                        view.add_force_pair(i, k,
                                            separation(view.template get<Position>(i), view.template get<Position>(k),
                                                       reach, strength));
                });
            });
        }
    };
};

/// Way points at random, in the plane of the first two axes.
inline std::vector<WayPoint> random_path(std::mt19937& random, int n, double size) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<WayPoint> path;
    for (int i = 0; i < n; ++i)
        path.push_back({.place = metres(uniform(-size, size), uniform(-size, size)),
                        .cut = (i % 3 == 2 ? 0.0 : uniform(0.1, 2)) * metre});
    return path;
}
inline Walk walk_of(Handle body, std::vector<WayPoint> path, double speed, double acceleration) {
    return {.body = body,
            .path = std::move(path),
            .speed = speed * metre / second,
            .acceleration = acceleration * metre / second / second,
            .up = {},
            .astray = 0.5 * metre};
}
template <class W> int count(const W& world, WalkNews news) {
    int n = 0;
    for (const auto& event : world.walk_events()) n += event.news == news;
    return n;
}

} // namespace walking_tests
