// SPDX-License-Identifier: BSL-1.0
// VertexBlockDescent: at the end of its iterations it is implicit Euler, and before it it is on the way there.
// Runs long with the sanitizers.

#include "tests/soft_bodies/solvers.hpp"

#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/world/save.hpp>

#include <algorithm>
#include <limits>
#include <sstream>

using namespace soft_bodies_tests;

namespace {

/// Two corners stay where they are.
template <class World_> std::vector<Handle> hang_sheet(World_& world, double stiffness, double damping) {
    const auto sheet = lay_sheet(world, 8, 0.7, 0, 0.02, stiffness, damping);
    world.add(Spring{sheet[0], metres(0, 0, 0), 1e3 * newton_per_metre, 0.1 * newton_second_per_metre});
    world.add(Spring{sheet[7], metres(0, 0, 0.7), 1e3 * newton_per_metre, 0.1 * newton_second_per_metre});
    return sheet;
}
double largest_difference(const auto& a, const auto& b, const std::vector<Handle>& all) {
    double most = 0;
    for (const auto& body : all) most = std::max(most, double(norm(a.position(body) - b.position(body)).value()));
    return most;
}

} // namespace

TEST_CASE("Iterated to the end it is implicit Euler", "[soft_bodies]") {
    const double stiffness = GENERATE(50., 400.), damping = GENERATE(0., 0.3);
    auto descent = world_of<double>(VertexBlockDescent{1, 1000});
    World implicit{ImplicitEuler{.tolerance = 1e-13}, Gravity{}, Springs<>{}};
    const auto sheet = hang_sheet(descent, stiffness, damping);
    hang_sheet(implicit, stiffness, damping);
    double most = 0;
    for (int i = 0; i < 20; ++i) {
        descent.step(frame);
        implicit.step(frame);
        most = std::max(most, largest_difference(descent, implicit, sheet));
    }
    CAPTURE(stiffness, damping);
    CHECK(most < 5e-12);
    CHECK(norm(implicit.position(sheet[63]) - descent.position(sheet[0])).value() > 0.1); // it has moved
}

TEST_CASE("The more iterations, the nearer to it", "[soft_bodies]") {
    World implicit{ImplicitEuler{.tolerance = 1e-13}, Gravity{}, Springs<>{}};
    const auto sheet = hang_sheet(implicit, 200, 0.1);
    for (int i = 0; i < 20; ++i) implicit.step(frame);
    double last = std::numeric_limits<double>::infinity();
    for (int iterations = 5; iterations <= 320; iterations *= 4) {
        auto world = world_of<double>(VertexBlockDescent{1, iterations});
        hang_sheet(world, 200, 0.1);
        for (int i = 0; i < 20; ++i) world.step(frame);
        const double off = largest_difference(world, implicit, sheet);
        CAPTURE(iterations, off, last);
        CHECK(off < last / 3);
        last = off;
    }
}

TEMPLATE_TEST_CASE("It never explodes, however stiff and however long the step", "[soft_bodies]", double, float) {
    const double stiffness = GENERATE(1e2, 1e8);
    auto world = world_of<TestType>(VertexBlockDescent{1, 4});
    const auto sheet = hang_sheet(world, stiffness, 0);
    for (int i = 0; i < 200; ++i) world.step(0.1 * second);
    CHECK(world.status().ok());
    // What is stiff moves by little in an iteration: with four of them the stiffer sheet falls, as if nothing held it.
    const double free = 0.5 * 9.81 * 20 * 20.1;
    for (const auto& body : sheet) CHECK(double(norm(world.position(body)).value()) < (stiffness > 1e3 ? free : 10.));
}

TEMPLATE_TEST_CASE("A free body falls as a point does, whatever it hangs together by", "[soft_bodies]", double, float) {
    auto world = world_of<TestType>(VertexBlockDescent{2, 6});
    const auto sheet = lay_sheet(world, 5, 1, 0, 0.1, 300, 0.1);
    for (int i = 0; i < 120; ++i) world.step(frame);
    const double h = 1.0 / 120, falls = -0.5 * 9.81 * 2 * (2 + h);
    const double digits = std::numeric_limits<TestType>::epsilon() * 4e4;
    for (const auto& body : sheet)
        CHECK(double(world.position(body).value()[1]) == Approx(falls).epsilon(0).margin(digits));
}

TEST_CASE("A rope between two bodies pulls and does not push", "[soft_bodies]") {
    World world{SemiImplicitEuler{}, Ropes<>{}, VertexBlockDescent{1, 30}};
    const auto a = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram), velocity(metres_per_second(-1, 0, 0)));
    const auto b = world.add(position(metres(0.5, 0, 0)), mass(3.0 * kilogram));
    world.add(Rope{a, b, 500.0 * newton_per_metre, 1.0 * newton_second_per_metre, 1.0 * metre});
    double longest = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        longest = std::max(longest, double(norm(world.position(a) - world.position(b)).value()));
        const auto momentum = total_momentum(world).value();
        CHECK(momentum[0] == Approx(-1).epsilon(0).margin(1e-12));
    }
    CHECK(longest > 1);
    CHECK(longest < 1.1);
}

namespace {
/// Pulls a free sheet apart that moves, or half of it. \return by how much its momentum changes at most, of the first
template <class T> double momentum_lost(VertexBlockDescent solver, double stiffness, bool pinned = false) {
    using S = Space<T, 3>;
    World world{S{}, SemiImplicitEuler{}, Springs<>{}, solver};
    const auto parts = add_cloth(world, {.mesh = TriangleMesh::grid(8, 8, metres(0.7, 0, 0), metres(0, 0.7, 0)),
                                         .mass_per_area = 1.0 * kilogram / square_metre,
                                         .structural = {stiffness * newton_per_metre, 0.1 * newton_second_per_metre},
                                         .velocity = metres_per_second(1, 0, 0)});
    world.set_velocity(parts.bodies[27], scalar_cast<T>(metres_per_second(5, 3, 1)));
    if (pinned) // another one, which hangs on a point
        world.add(
            Spring{.first = parts.bodies[0], .second = metres(-0.2, 0, 0), .stiffness = stiffness * newton_per_metre});
    const auto momentum = [&] {
        Vector<double, 3> sum = Vector<double, 3>::Zero();
        for (const auto body : parts.bodies)
            sum += double(world.mass(body).value()) * world.velocity(body).value().template cast<double>();
        return sum;
    };
    const auto before = momentum();
    double most = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(scalar_cast<T>(frame));
        most = std::max(most, (momentum() - before).norm());
    }
    return most / before.norm();
}
} // namespace

TEMPLATE_TEST_CASE("A body hangs still on a rope that stretches by less than rounding can tell", "[soft_bodies]",
                   double, float) {
    const int iterations = GENERATE(1, 2, 20, 21);
    const bool to_a_point = GENERATE(true, false);
    const double height = GENERATE(0., 4., 100.), part = GENERATE(10., 0.1, 1e-3); // of a digit, by 1 kg
    CAPTURE(iterations, to_a_point, height, part);
    const double digit = double(std::numeric_limits<TestType>::epsilon()) * std::max(1., height);
    const auto stiffness = 9.81 / (part * digit) * newton_per_metre;
    World world{Space<TestType, 3>{}, SemiImplicitEuler{}, Gravity{}, Ropes<>{}, VertexBlockDescent{1, iterations}};
    const auto hook = world.add(position(metres(0, height, 0)), fixed);
    const auto body = world.add(position(metres(0, height - 1, 0)), mass(1.0 * kilogram));
    if (to_a_point) world.add(Rope{body, metres(0, height, 0), stiffness});
    else world.add(Rope{hook, body, stiffness});
    double most = 0;
    for (int step = 0; step < 600; ++step) {
        world.step(frame);
        most = std::max(most, std::abs(double(world.position(body).value()[1]) - (height - 1)));
    }
    CHECK(most <= (2 * part + 4) * digit); // dropped, it is stretched twice as far as at rest
}

TEST_CASE("A sheet alone in space does not drive itself along, however few the iterations", "[soft_bodies]") {
    for (const double stiffness : {20.0, 5000.0})
        for (const auto& solver : {VertexBlockDescent{1, 1}, VertexBlockDescent{1, 4}, VertexBlockDescent{1, 20},
                                   VertexBlockDescent{10, 1}}) {
            INFO(solver.substeps << " x " << solver.iterations << ", " << stiffness << " N/m");
            CHECK(momentum_lost<double>(solver, stiffness) < 1e-13);
            CHECK(momentum_lost<float>(solver, stiffness) < 1e-5);
            CHECK(momentum_lost<double>(solver, stiffness, true) > 1e-3); // what holds it takes some away
        }
}

TEST_CASE("A rope that hangs slack ties no body to any body", "[soft_bodies]") {
    // A stiff row of bodies of which one is pushed, a lone body, and a rope between them, or to a point, that is slack.
    for (const int tied : {0, 1, 2}) {
        World world{SemiImplicitEuler{}, Springs<>{}, Ropes<>{}, VertexBlockDescent{1, 2}};
        std::vector<Handle> row;
        for (int i = 0; i < 12; ++i) {
            row.push_back(world.add(position(metres(0.1 * i, 0, 0)), mass(1.0 * kilogram)));
            if (i > 0)
                world.add(Spring{.first = row[std::size_t(i) - 1],
                                 .second = row[std::size_t(i)],
                                 .stiffness = 5000.0 * newton_per_metre});
        }
        const auto alone = world.add(position(metres(50, 0, 0)), mass(1.0 * kilogram));
        Rope rope{.first = row[0], .stiffness = 1000.0 * newton_per_metre, .rest_length = 500.0 * metre};
        if (tied == 1) rope.second = alone;
        else rope.second = metres(0, 1, 0);
        if (tied > 0) world.add(rope);
        world.set_velocity(row[3], metres_per_second(5, 0, 0));
        double most = 0;
        for (int i = 0; i < 120; ++i) {
            world.step(frame);
            Vector<double, 3> sum(-5, 0, 0);
            for (const auto body : row) sum += world.velocity(body).value();
            most = std::max(most, sum.norm());
        }
        CAPTURE(tied);
        CHECK(most < 1e-13);
        CHECK(world.velocity(alone).value().norm() == 0);
    }
}

TEST_CASE("What it keeps is no state: copied, saved and loaded worlds go on alike", "[soft_bodies]") {
    auto world = world_of<double>(VertexBlockDescent{2, 5});
    const auto sheet = hang_sheet(world, 200, 0.1);
    for (int i = 0; i < 20; ++i) world.step(frame);
    world.remove(sheet[20]);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = world_of<double>(VertexBlockDescent{});
    load(loaded, file);
    for (int i = 0; i < 20; ++i) {
        world.step(frame);
        copy.step(frame);
        loaded.step(frame);
    }
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    CHECK_THROWS_WITH(world.set(VertexBlockDescent{1, 0}),
                      Catch::Contains("iterations") && Catch::Contains("at least 1"));
}
