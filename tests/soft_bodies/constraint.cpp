// SPDX-License-Identifier: BSL-1.0
// Constraints: their gradients against differences, and one of a user's own in every solver.

#include "tests/soft_bodies/patches.hpp"
#include "tests/soft_bodies/solvers.hpp"

#include <ansatz/soft_bodies/constraint.hpp>
#include <ansatz/soft_bodies/constraint_system.hpp>
#include <ansatz/soft_bodies/module.hpp>
#include <ansatz/soft_bodies/roles.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/springs/constraint.hpp>

#include <Eigen/Geometry>

#include <random>

using namespace soft_bodies_tests;

namespace {

template <class S, class K> void check_gradient(const K& k, std::mt19937& random) {
    using Vec = Vector<double, S::dimension>;
    std::uniform_real_distribution<double> number(-1, 1);
    std::array<Vec, K::bodies> x, gradient, ignored;
    for (auto& one : x)
        for (int d = 0; d < S::dimension; ++d) one[d] = number(random);
    k.linearise(x, gradient);
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < K::bodies; ++i)
        for (int d = 0; d < S::dimension; ++d) {
            auto there = x, back = x;
            there[i][d] += step;
            back[i][d] -= step;
            const double slope = (k.linearise(there, ignored) - k.linearise(back, ignored)) / (2 * step);
            CHECK(gradient[i][d] == Approx(slope).epsilon(0).margin(1e-6));
        }
}
/// Of C's second derivative, by differences of its gradient.
template <class S, class K> void check_curvature(const K& k, std::mt19937& random) {
    using Vec = Vector<double, S::dimension>;
    std::uniform_real_distribution<double> number(-1, 1);
    std::array<Vec, K::bodies> x, gradient, ahead, behind;
    for (auto& one : x)
        for (int d = 0; d < S::dimension; ++d) one[d] = number(random);
    k.linearise(x, gradient);
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < K::bodies; ++i) {
        const auto curvature = k.curvature(i, x, gradient);
        for (int d = 0; d < S::dimension; ++d) {
            auto there = x, back = x;
            there[i][d] += step;
            back[i][d] -= step;
            k.linearise(there, ahead);
            k.linearise(back, behind);
            for (int e = 0; e < S::dimension; ++e)
                CHECK(curvature(e, d) == Approx((ahead[i][e] - behind[i][e]) / (2 * step)).epsilon(1e-6).margin(1e-6));
        }
    }
}

template <class... Solver> auto patch_world(const Solver&... solver) {
    return World{Space<double, 3>{}, SemiImplicitEuler{}, examples::Patches{}, solver...};
}
double area(const auto& world, const std::vector<Handle>& all) {
    const auto u = (world.position(all[1]) - world.position(all[0])).value();
    const auto v = (world.position(all[2]) - world.position(all[0])).value();
    return 0.5 * u.cross(v).norm();
}
std::vector<Handle> add_patch(auto& world) {
    std::vector<Handle> all{world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram)),
                            world.add(position(metres(1, 0, 0)), mass(2.0 * kilogram)),
                            world.add(position(metres(0, 1, 0.5)), mass(1.0 * kilogram))};
    world.add(examples::Patch{all[0], all[1], all[2], 1.0});
    return all;
}

} // namespace

TEST_CASE("Gradients of springs are their differences", "[soft_bodies]") {
    std::mt19937 random(7);
    using Flat = Space<double, 2>;
    using Deep = Space<double, 3>;
    constexpr auto both = springs::Acts::both_ways;
    for (int i = 0; i < 50; ++i) {
        check_gradient<Flat>(SpringConstraint<Flat, both>{{0, 1}, 0.7, 1, 0}, random);
        check_gradient<Deep>(SpringConstraint<Deep, both>{{0, 1}, 0.7, 1, 0}, random);
        check_gradient<Deep>(AnchoredSpringConstraint<Deep, both>{{0}, 0.7, 1, 0, {0.1, 2, 0.3}}, random);
        check_gradient<Deep>(examples::AreaConstraint<Deep>{{0, 1, 2}, 0.7, 1}, random);
        check_curvature<Flat>(SpringConstraint<Flat, both>{{0, 1}, 0.7, 1, 0}, random);
        check_curvature<Deep>(SpringConstraint<Deep, both>{{0, 1}, 0.7, 1, 0}, random);
        check_curvature<Deep>(AnchoredSpringConstraint<Deep, both>{{0}, 0.7, 1, 0, {0.1, 2, 0.3}}, random);
    }
}

TEST_CASE("Ends in one place have no axis, and nothing becomes infinite", "[soft_bodies]") {
    using Flat = Space<float, 2>;
    const SpringConstraint<Flat, springs::Acts::both_ways> k{{0, 1}, 0.5f, 1, 0};
    std::array<Vector<float, 2>, 2> x{Vector<float, 2>(1, 1), Vector<float, 2>(1, 1)}, gradient;
    CHECK(k.linearise(x, gradient) == -0.5f);
    CHECK((gradient[0].isZero(0) && gradient[1].isZero(0)));
    CHECK(k.curvature(0, x, gradient).isZero(0));
}

TEST_CASE("A constraint of a user's own is held by every solver, and is a force without one", "[soft_bodies]") {
    auto xpbd = patch_world(Xpbd{2, 4});
    auto descent = patch_world(VertexBlockDescent{2, 16});
    auto force = patch_world();
    const auto a = add_patch(xpbd), b = add_patch(descent), c = add_patch(force);
    const double before = area(xpbd, a);
    CHECK(before != Approx(1).margin(0.1));
    double lowest = 1e9, highest = 0;
    for (int i = 0; i < 1800; ++i) {
        xpbd.step(frame);
        descent.step(frame);
        force.step(frame);
        lowest = std::min(lowest, area(force, c));
        highest = std::max(highest, area(force, c));
    }
    // The force swings about the area for ever; solvers lose the energy of that.
    CHECK(lowest < 1);
    CHECK(highest > 1);
    CHECK(area(xpbd, a) == Approx(1).epsilon(1e-3));
    CHECK(area(descent, b) == Approx(1).epsilon(1e-3));
    CHECK(total_momentum(xpbd).value().norm() < 1e-12);
}

TEST_CASE("Springs and a constraint of a user's own are held together", "[soft_bodies]") {
    World world{SemiImplicitEuler{}, Springs<>{}, examples::Patches{}, Xpbd{10, 2}};
    const auto all = add_patch(world);
    world.add(Spring{all[0], all[1], 100.0 * newton_per_metre, 1.0 * newton_second_per_metre, 2.0 * metre});
    for (int i = 0; i < 1800; ++i) world.step(frame);
    CHECK(area(world, all) == Approx(1).epsilon(1e-3));
    CHECK(norm(world.position(all[1]) - world.position(all[0])).value() == Approx(2).epsilon(1e-3));
}
