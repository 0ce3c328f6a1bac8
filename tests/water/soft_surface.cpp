// SPDX-License-Identifier: BSL-1.0
// The net of bodies and springs by itself: how it swings, how it rests, what is built, and what is refused.
// Runs long with the sanitizers.

#include <ansatz/springs.hpp>
#include <ansatz/water/soft_surface.hpp>
#include <ansatz/world.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {

constexpr double g = 9.81, sigma = 40, tension = 900, dx = 0.3, dz = 0.2;
const auto per_area = kilogram / square_metre;
SoftSurface net(const ColumnGrid& grid, double gamma = 0) {
    return {.grid = grid,
            .level = 1.5 * metre,
            .mass_per_area = sigma * per_area,
            .tension = tension * newton_per_metre,
            .damping = gamma / second};
}
using Net = World<SemiImplicitEuler, Gravity, Springs<>>;

} // namespace

TEST_CASE("a soft surface swings in the modes of its lattice", "[water]") {
    const std::size_t nx = 7, nz = 5;
    for (const auto& pq : {std::pair(1, 1), std::pair(2, 3), std::pair(7, 5)}) {
        const int p = pq.first, q = pq.second;
        Net world{{}, {}, {}};
        const auto parts = add_soft_surface(world, net(ColumnGrid(nx, nz, dx * metre, dz * metre)));
        auto mode = [&](std::size_t n) {
            return std::sin(pi * p * double(n % nx + 1) / double(nx + 1)) *
                   std::sin(pi * q * double(n / nx + 1) / double(nz + 1));
        };
        for (std::size_t n = 0; n < nx * nz; ++n) {
            const auto at = world.position(parts.bodies[n]).value();
            world.set_position(parts.bodies[n], metres(at[0], at[1] + 0.01 * mode(n), at[2]));
        }
        const double sx = std::sin(p * pi / double(2 * (nx + 1))), sz = std::sin(q * pi / double(2 * (nz + 1)));
        const double square = (1000 * g + tension * (4 * sx * sx / (dx * dx) + 4 * sz * sz / (dz * dz))) / sigma;
        // Semi-implicit Euler turns by theta in a step, 1 - cos theta = (omega h)^2 / 2; from rest its first height is
        // half a step late.
        const double h = 0.004, theta = std::acos(1 - square * h * h / 2);
        for (int step = 1; step <= 500; ++step) {
            world.step(h * second);
            const double now = 0.01 * std::cos((step + 0.5) * theta) / std::cos(0.5 * theta);
            for (const std::size_t n : {std::size_t(0), std::size_t(9), std::size_t(17)})
                REQUIRE(world.position(parts.bodies[n]).value()[1] - 1.5 == Approx(now * mode(n)).margin(1e-11));
        }
    }
}
TEST_CASE("a soft surface rests as it is built, in its own weight", "[water]") {
    Net world{{}, {}, {}};
    const auto parts =
        add_soft_surface(world, net(ColumnGrid(9, 6, dx * metre, dz * metre).at(2.0 * metre, -1.0 * metre)));
    CHECK(parts.bodies.size() == 54);
    CHECK(parts.level.size() == 54);
    CHECK(parts.tension.size() == 10 * 6 + 9 * 7); // along each line one more than bodies: the frame's
    CHECK(world.position(parts.bodies[9 + 2])
              .value()
              .isApprox(Vector<double, 3>(2 + 2.5 * dx, 1.5, -1 + 1.5 * dz), 1e-15));
    for (int i = 0; i < 200; ++i) world.step(0.01 * second);
    for (const auto& body : parts.bodies) CHECK(std::abs(world.position(body).value()[1] - 1.5) < 1e-13);
    for (const auto& body : parts.bodies) CHECK(world.velocity(body).value().norm() < 1e-12);
    // Whatever stands on every column with as much as the water of a centimetre lowers all but the border by that.
    Net loaded{{}, {}, {}};
    const auto deep = add_soft_surface(loaded, net(ColumnGrid(41, 41, dx * metre), 30));
    const double all = sigma * dx * dx;
    for (const auto& body : deep.bodies) loaded.set_mass(body, (all + 10 * dx * dx) * kilogram);
    for (int i = 0; i < 800; ++i) loaded.step(0.01 * second);
    CHECK(loaded.position(deep.bodies[20 * 41 + 20]).value()[1] == Approx(1.49).margin(1e-8));
}
TEST_CASE("a soft surface without tension is columns by themselves, and a channel has no springs across", "[water]") {
    Net world{{}, {}, {}};
    auto loose = net(ColumnGrid(4, 3, dx * metre));
    loose.tension = 0.0 * newton_per_metre;
    CHECK(add_soft_surface(world, loose).tension.empty());
    CHECK(add_soft_surface(world, net(ColumnGrid(8, 1, dx * metre))).tension.size() == 9);
    World<Space<float, 2>, VelocityVerlet, Gravity, Springs<>> flat{{}, {}, {}, {}};
    const auto parts = add_soft_surface(flat, net(ColumnGrid(8, 1, dx * metre), 3));
    for (int i = 0; i < 500; ++i) flat.step(0.01 * second);
    for (const auto& body : parts.bodies) CHECK(std::abs(flat.position(body).value()[1] - 1.5f) < 1e-5f);
    CHECK(refusal([&] { add_soft_surface(flat, net(ColumnGrid(8, 3, dx * metre))); }).find("a channel: 1") !=
          std::string::npos);
}
TEST_CASE("what a soft surface cannot be is refused, and the world is as it was", "[water]") {
    Net world{{}, {}, {}};
    add_soft_surface(world, net(ColumnGrid(3, 3, dx * metre)));
    const auto hash = world.hash();
    auto said = [&](auto&& change) {
        auto surface = net(ColumnGrid(3, 3, dx * metre));
        change(surface);
        const auto text = refusal([&] { add_soft_surface(world, surface); });
        CHECK(world.hash() == hash);
        return text;
    };
    auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    CHECK(has(said([](auto& s) { s.mass_per_area = 0.0 * per_area; }), "mass per area is 0 "));
    CHECK(has(said([](auto& s) { s.density = -1.0 * kilogram_per_cubic_metre; }), "density is -1 "));
    CHECK(has(said([](auto& s) { s.tension = -1.0 * newton_per_metre; }), "tension is -1"));
    CHECK(has(said([](auto& s) { s.damping = not_a_number * hertz; }), "damping is nan"));
    CHECK(has(said([](auto& s) { s.level = not_a_number * metre; }), "level is nan"));
    CHECK(has(said([](auto& s) { s.grid = unequal(3, 3); }), "all alike"));
    world.set(Gravity{metres_per_second_squared(0, 0, 0)});
    const auto text = refusal([&] { add_soft_surface(world, net(ColumnGrid(3, 3, dx * metre))); });
    CHECK(has(text, "downward part of Gravity is 0 "));
}
