// SPDX-License-Identifier: BSL-1.0
// Area: gradient and curvature by differences, a triangle that breathes as its equation says, every solver, and a
// triangle of a plane that was turned inside out.

#include <ansatz/soft_bodies/area.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>
#include <sstream>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

namespace {

template <class Scalar, int Dim, class... P> auto films(const P&... policies) {
    return World{Space<Scalar, Dim>{}, Area{}, policies...};
}
/// An equilateral triangle about the origin, of corners r from it, anticlockwise.
template <class World_> std::vector<Handle> add_triangle(World_& world, double r) {
    std::vector<Handle> all;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.0943951023931953 * i, x = r * std::cos(angle), y = r * std::sin(angle);
        if constexpr (World_::S::dimension == 2) all.push_back(world.add(position(metres(x, y)), mass(0.5 * kilogram)));
        else all.push_back(world.add(position(metres(x, y, 0)), mass(0.5 * kilogram)));
    }
    return all;
}
Membrane film(const std::vector<Handle>& all, double k, double c) {
    return {.corners = {all[0], all[1], all[2]}, .stiffness = k * N_per_m, .damping = c * N_s_per_m};
}
const double per_r2 = 3 * std::sqrt(3.0) / 4; // the area of that triangle, by r^2

template <class S> void check_differences(std::mt19937& random) {
    using Vec = Vector<double, S::dimension>;
    std::uniform_real_distribution<double> number(-1, 1);
    const AreaConstraint<S> k{{0, 1, 2}, 0.3, 1, 0};
    std::array<Vec, 3> x, gradient, ahead, behind;
    for (Vec& one : x)
        for (int d = 0; d < S::dimension; ++d) one[d] = number(random);
    k.linearise(x, gradient);
    double largest = 1;
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, k.curvature(i, x, gradient).norm());
    for (std::size_t i = 0; i < 3; ++i)
        for (int d = 0; d < S::dimension; ++d) {
            constexpr double step = 1e-6;
            auto there = x, back = x;
            there[i][d] += step;
            back[i][d] -= step;
            const double slope = (k.linearise(there, ahead) - k.linearise(back, behind)) / (2 * step);
            CHECK(gradient[i][d] == Approx(slope).epsilon(0).margin(1e-6));
            for (int e = 0; e < S::dimension; ++e)
                CHECK(k.curvature(i, x, gradient)(e, d) ==
                      Approx((ahead[i][e] - behind[i][e]) / (2 * step)).epsilon(0).margin(1e-6 * largest * largest));
        }
}

} // namespace

TEST_CASE("Gradient and curvature of an area are its differences", "[soft_bodies][area]") {
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        check_differences<Space<double, 2>>(random);
        check_differences<Space<double, 3>>(random);
    }
}

TEST_CASE("A triangle breathes as the equation of its radius says", "[soft_bodies][area]") {
    // m r'' = -K/A_0 (A - A_0) dA/dr / 3, by the same method in the same steps.
    auto world = films<double, 3>(RungeKutta4{});
    const auto all = add_triangle(world, 0.6);
    auto one = film(all, 40, 0);
    one.area = 1.2 * per_r2 * 0.36 * square_metre;
    world.add(one);
    const double a0 = 1.2 * per_r2 * 0.36, h = 2e-3;
    CHECK(potential_energy(world).value() == Approx(0.5 * 40 * a0 * 0.04 / 1.44).epsilon(1e-12));
    const auto a = [&](double r) { return -40 / a0 * (per_r2 * r * r - a0) * 2 * per_r2 * r / 3 / 0.5; };
    double r = 0.6, v = 0;
    for (int i = 0; i < 100; ++i) {
        world.step(h * second);
        const double v1 = v, a1 = a(r), v2 = v + h / 2 * a1, a2 = a(r + h / 2 * v1);
        const double v3 = v + h / 2 * a2, a3 = a(r + h / 2 * v2), v4 = v + h * a3, a4 = a(r + h * v3);
        r += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    CHECK(std::abs(r - 0.6) > 0.02);
    for (const auto& body : all) CHECK(norm(world.position(body)).value() == Approx(r).epsilon(1e-12));
}

TEST_CASE("Every solver keeps an area, and nothing is pushed away by it", "[soft_bodies][area]") {
    const auto settle = [](auto world) {
        const auto all = add_triangle(world, 0.6);
        auto one = film(all, 60, 10);
        one.area = 0.6 * square_metre;
        world.add(one);
        run(world, 400, 1.0 / 60);
        CHECK(world.status().ok());
        CHECK(total_momentum(world).value().norm() < 1e-6);
        const double r = double(norm(world.position(all[1])).value());
        return per_r2 * r * r;
    };
    CHECK(settle(films<double, 3>(SemiImplicitEuler{})) == Approx(0.6).epsilon(1e-9));
    CHECK(settle(films<float, 2>(SemiImplicitEuler{})) == Approx(0.6).epsilon(1e-5));
    CHECK(settle(films<double, 3>(SemiImplicitEuler{}, Xpbd{3, 2})) == Approx(0.6).epsilon(1e-9));
    CHECK(settle(films<double, 3>(SemiImplicitEuler{}, VertexBlockDescent{1, 20})) == Approx(0.6).epsilon(1e-9));
    CHECK(settle(films<double, 3>(ImplicitEuler{})) == Approx(0.6).epsilon(1e-9));
}

TEST_CASE("In a plane an area has a sign: a triangle that is turned inside out comes back", "[soft_bodies][area]") {
    auto world = films<float, 2>(SemiImplicitEuler{});
    const auto all = add_triangle(world, 0.6);
    world.add(film(all, 60, 10));
    world.set_position(all[0], metres(-0.7f, 0.05f)); // beyond the opposite side
    run(world, 1200, 1.0 / 1000);                     // not for long: nothing holds its shape, and it grows long
    const auto u = (world.position(all[1]) - world.position(all[0])).value();
    const auto v = (world.position(all[2]) - world.position(all[0])).value();
    CHECK(double(u[0] * v[1] - u[1] * v[0]) / 2 == Approx(per_r2 * 0.36).epsilon(0.01));
}

TEST_CASE("Membranes are saved and loaded; bad ones are refused", "[soft_bodies][area]") {
    auto world = films<double, 3>(SemiImplicitEuler{}, Xpbd{3, 2});
    const auto all = add_triangle(world, 0.6);
    const auto which = world.add(film(all, 60, 1));
    world.set_velocity(all[2], metres_per_second(1, 2, 3));
    std::stringstream file;
    save(world, file);
    auto loaded = films<double, 3>(SemiImplicitEuler{}, Xpbd{});
    load(loaded, file);
    run(world, 20, 1.0 / 60);
    run(loaded, 20, 1.0 / 60);
    CHECK(loaded.hash() == world.hash());
    CHECK(world.get(which).area->value() == Approx(per_r2 * 0.36).epsilon(1e-12));
    const auto hash = world.hash();
    const auto says = [&](auto&& change) {
        auto bad = film(all, 60, 1);
        change(bad);
        return refusal([&] { world.add(bad); });
    };
    CHECK(says([](Membrane& m) { m.stiffness = -2.0 * N_per_m; }) ==
          "World::add: stiffness is -2 N/m; it must be finite and not negative");
    CHECK_THAT(says([](Membrane& m) { m.damping = NAN * N_s_per_m; }), ContainsSubstring("damping is nan"));
    CHECK_THAT(says([](Membrane& m) { m.area = 0.0 * square_metre; }), ContainsSubstring("area is 0 m^2"));
    CHECK_THAT(says([](Membrane& m) { m.area = 1e-310 * square_metre; }),
               ContainsSubstring("area is 1e-310 m^2") && ContainsSubstring("than the world's scalar can hold"));
    CHECK_THAT(says([](Membrane& m) { m.corners[1] = m.corners[0]; }), ContainsSubstring("three different"));
    CHECK(world.hash() == hash);
    auto flat = films<float, 2>(SemiImplicitEuler{});
    auto corners = add_triangle(flat, 0.6);
    std::swap(corners[0], corners[1]);
    CHECK_THAT(refusal([&] { flat.add(film(corners, 1, 0)); }), ContainsSubstring("anticlockwise"));
    world.remove(all[1]);
    CHECK(world.elements<Membrane>().size() == 0);
}
