// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Fillings, and balloons that hold them, for the tests of enclosures and of their pressure.

#include <ansatz/soft_bodies/enclosure.hpp>
#include <ansatz/soft_bodies/pressure.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/closed_meshes.hpp>
#include <ansatz/soft_bodies/soft_ball.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>

namespace soft_tests {

inline constexpr Filling gas{.inside = 300.0 * pascal, .outside = 100.0 * pascal};
inline constexpr Filling firm{.stiffness = 2000.0 * pascal, .damping = 3.0 * pascal_second};
inline constexpr Filling stiff_gas{.inside = 300.0 * pascal, .stiffness = 400.0 * pascal};
inline constexpr Filling both{
    .inside = 300.0 * pascal, .outside = 120.0 * pascal, .stiffness = 700.0 * pascal, .damping = 5.0 * pascal_second};

inline auto free_world() { return World{RungeKutta4{}, Springs<>{}, Pressure{}}; }
template <class Scalar, class... Solver> auto solved(const Solver&... solver) {
    return World{Space<Scalar, 3>{}, SemiImplicitEuler{}, Springs<>{}, Pressure{}, solver...};
}

/// The bodies of a mesh, of unequal masses from `lightest` on, without springs.
template <class World_>
std::vector<Handle> add_bodies(World_& world, const TriangleMesh& mesh, double lightest = 0.1, double more = 0.01) {
    std::vector<Handle> all;
    for (const auto& x : mesh.vertices())
        all.push_back(world.add(position(x), mass((lightest + more * double(all.size())) * kilogram)));
    return all;
}
/// An octahedron of equal masses on the axes, with springs along its edges.
template <class World_>
ElementHandle<Enclosure> add_balloon(World_& world, const Filling& filling, double k, double c, double radius = 0.5) {
    const auto mesh = ball_mesh(radius * metre, 0);
    const auto all = add_bodies(world, mesh, 0.2, 0);
    for (const auto& [a, b] : mesh.edges())
        world.add(Spring{all[a], all[b], k * newton_per_metre, c * newton_second_per_metre});
    return world.add(Enclosure::of(all, mesh, filling));
}
/// A ball with its vertices out of their places, so that nothing is symmetric.
inline TriangleMesh potato(int divisions = 1) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-0.08, 0.08);
    const auto ball = ball_mesh(0.5 * metre, divisions);
    std::vector<TriangleMesh::Point> places(ball.vertices().begin(), ball.vertices().end());
    for (auto& x : places) x += metres(number(random), number(random), number(random));
    return {places, {ball.triangles().begin(), ball.triangles().end()}};
}
inline double radius_of(const auto& world) { return double(norm(world.position(world.handles()[0])).value()); }

/// The balance of an octahedron: what presses a vertex outwards, p dV/dr / 6, is what its four springs pull inwards.
inline double radius_at_rest(const Filling& f, double k, double r0 = 0.5) {
    const double v0 = 4.0 / 3 * r0 * r0 * r0, root = std::sqrt(2.0);
    const auto outwards = [&](double r) {
        const double v = 4.0 / 3 * r * r * r;
        const double p = f.inside.value() * v0 / v - f.outside.value() + f.stiffness.value() * (1 - v / v0);
        return p * 4 * r * r / 6 - 4 * k * (root * r - root * r0) / root;
    };
    double low = r0 / 2, high = 3 * r0;
    for (int i = 0; i < 200; ++i) (outwards((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return (low + high) / 2;
}

} // namespace soft_tests
