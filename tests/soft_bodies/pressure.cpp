// SPDX-License-Identifier: BSL-1.0
// Pressure: the law against the motion that follows from it, and every solver against the balance of forces.
// Runs long with the sanitizers.

#include "tests/soft_bodies/fillings.hpp"

using namespace soft_tests;

TEST_CASE("The forces of a filling are minus the slope of its energy", "[soft_bodies][pressure]") {
    const auto filling = GENERATE(gas, firm, both);
    auto world = World{SemiImplicitEuler{}, Pressure{}};
    const auto mesh = potato();
    const auto all = add_bodies(world, mesh);
    world.add(Enclosure::of(all, mesh, filling));
    world.set_position(all[3], world.position(all[3]) + metres(0.1, 0.02, -0.05)); // no longer V_0
    const auto energy = [&](std::size_t i, int axis, double by) {
        auto there = world;
        auto x = there.position(all[i]).value();
        x[axis] += by;
        there.set_position(all[i], Space<>::Position::from_value(x));
        return potential_energy(there).value();
    };
    auto stepped = world;
    const double dt = 1e-3;
    stepped.step(dt * second);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const double force = stepped.velocity(all[i]).value()[axis] / dt / world.inverse_mass(all[i]).value();
            const double slope = (energy(i, axis, 1e-5) - energy(i, axis, -1e-5)) / 2e-5;
            CHECK(force == Approx(-slope).epsilon(1e-6).margin(1e-6));
        }
}

TEST_CASE("A damped filling takes energy by the square of the volume's rate", "[soft_bodies][pressure]") {
    auto world = World{SemiImplicitEuler{}, Pressure{}};
    const auto mesh = potato();
    const auto all = add_bodies(world, mesh);
    const auto which =
        world.add(Enclosure::of(all, mesh, {.stiffness = 1e-9 * pascal, .damping = 4.0 * pascal_second}));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const auto& body : all)
        world.set_velocity(body, metres_per_second(7 + number(random), number(random), number(random)));
    auto stepped = world;
    const double dt = 1e-6, before = enclosed_volume(world, which).value();
    stepped.step(dt * second);
    const double rate = (enclosed_volume(stepped, which).value() - before) / dt;
    const double power = (kinetic_energy(stepped).value() - kinetic_energy(world).value()) / dt;
    CHECK(std::abs(rate) > 0.01);
    CHECK(power == Approx(-4 / before * rate * rate).epsilon(1e-3));
}

TEST_CASE("A filling pushes nothing away and turns nothing", "[soft_bodies][pressure]") {
    auto world = solved<double>(); // a method that keeps both, whatever the step
    const auto mesh = potato(2).moved(metres(2, -3, 1));
    const auto all = add_bodies(world, mesh);
    for (const auto& [a, b] : mesh.edges())
        world.add(Spring{all[a], all[b], 200.0 * newton_per_metre, 0.5 * newton_second_per_metre});
    world.add(Enclosure::of(all, mesh, both));
    for (std::size_t i = 0; i < all.size(); ++i) world.set_velocity(all[i], metres_per_second(1, double(i % 3), -2));
    const auto momentum = total_momentum(world).value(), turning = total_angular_momentum(world).value();
    run(world, 500, 1.0 / 240);
    CHECK((total_momentum(world).value() - momentum).norm() < 1e-11 * momentum.norm());
    CHECK((total_angular_momentum(world).value() - turning).norm() < 1e-11 * turning.norm());
}

TEST_CASE("An octahedron breathes as the equation of its radius says", "[soft_bodies][pressure]") {
    // m r'' = p(V) dV/dr / 6 with V = 4/3 r^3, by the same method in the same steps.
    const auto filling = GENERATE(gas, stiff_gas);
    auto world = free_world();
    const auto which = add_balloon(world, filling, 0, 0);
    const detail::FillingLaw<double> law{filling.inside.value(), filling.outside.value(), filling.stiffness.value(),
                                         4.0 / 3 * 0.125};
    const auto a = [&](double r) { return law.excess(4.0 / 3 * r * r * r) * 4 * r * r / 6 / 0.2; };
    double r = 0.5, v = 0;
    const double h = 1e-3, energy = total_energy(world).value();
    for (int i = 0; i < 40; ++i) {
        world.step(h * second);
        const double v1 = v, a1 = a(r), v2 = v + h / 2 * a1, a2 = a(r + h / 2 * v1);
        const double v3 = v + h / 2 * a2, a3 = a(r + h / 2 * v2), v4 = v + h * a3, a4 = a(r + h * v3);
        r += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    CHECK(r > 0.55);
    CHECK(radius_of(world) == Approx(r).epsilon(1e-12));
    CHECK(enclosed_volume(world, which).value() == Approx(4.0 / 3 * r * r * r).epsilon(1e-12));
    CHECK(total_energy(world).value() == Approx(energy).epsilon(0).margin(1e-6 * kinetic_energy(world).value()));
}

TEST_CASE("Every solver comes to the balance of skin and filling", "[soft_bodies][pressure]") {
    const auto filling = GENERATE(gas, both);
    const double k = 150, rest = radius_at_rest(filling, k);
    CHECK(rest > 0.515);
    const auto settle = [&](auto world) {
        add_balloon(world, filling, k, 4);
        run(world, 300, 1.0 / 60);
        CHECK(world.status().ok());
        return radius_of(world);
    };
    CHECK(settle(free_world()) == Approx(rest).epsilon(1e-9));
    CHECK(settle(solved<double>(VertexBlockDescent{2, 40})) == Approx(rest).epsilon(1e-6));
    CHECK(settle(World{ImplicitEuler{}, Springs<>{}, Pressure{}}) == Approx(rest).epsilon(1e-9));
    CHECK(settle(solved<float>(Xpbd{16, 10})) == Approx(rest).epsilon(1e-4));
    // What moves in an iteration turns the gradients of what comes next: an error of the second order in the substep.
    const double eight = std::abs(settle(solved<double>(Xpbd{8, 20})) - rest);
    const double sixteen = std::abs(settle(solved<double>(Xpbd{16, 20})) - rest);
    CHECK(eight < 1e-4 * rest);
    CHECK(sixteen < eight / 3); // 3.2 where the two pressures nearly cancel, 3.9 for the gas
}

TEST_CASE("One substep of Xpbd with a filling alone is the paper's formula", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{1, 1});
    const auto which = add_balloon(world, firm, 0, 0);
    auto larger = world.get(which);
    larger.volume = 0.3 * cubic_metre;
    world.set(which, larger);
    for (const auto& body : world.handles())
        world.set_velocity(body, Space<>::Velocity::from_value(2 * world.position(body).value() / 0.5));
    const double h = 1.0 / 60, w = 1 / 0.2, r = 0.5 + h * 2, g = 4 * r * r / 6, k = 2000 / 0.3, c = 3 / 0.3;
    const double value = 4.0 / 3 * r * r * r - 0.3;
    const double change = -(h * h * k * value + h * c * h * 6 * g * 2) / (1 + (h * h * k + h * c) * 6 * w * g * g);
    world.step(h * second);
    CHECK(std::abs(w * g * change) > 1e-3);
    CHECK(radius_of(world) == Approx(r + w * g * change).epsilon(1e-12));
    CHECK(double(norm(world.velocity(world.handles()[3])).value()) == Approx(2 + w * g * change / h).epsilon(1e-12));
}

TEST_CASE("Iterated to the end, descent is implicit Euler for a filling that is a stiffness",
          "[soft_bodies][pressure]") {
    auto descent = solved<double>(VertexBlockDescent{1, 800});
    World implicit{ImplicitEuler{.tolerance = 1e-13}, Springs<>{}, Pressure{}};
    const auto fill = [](auto& world) {
        const auto mesh = potato(1);
        const auto all = add_bodies(world, mesh);
        for (const auto& [a, b] : mesh.edges()) world.add(Spring{all[a], all[b], 60.0 * newton_per_metre});
        world.add(Enclosure::of(all, mesh, firm));
        world.set_velocity(all[0], metres_per_second(1, -2, 0.5));
        world.set_velocity(all[5], metres_per_second(-3, 1, 0));
        return all;
    };
    const auto all = fill(descent);
    fill(implicit);
    for (int i = 0; i < 10; ++i) {
        descent.step(1.0 / 60 * second);
        implicit.step(1.0 / 60 * second);
    }
    CHECK(implicit.status().ok());
    for (const auto& body : all) CHECK(norm(descent.position(body) - implicit.position(body)).value() < 1e-10);
}

TEST_CASE("The derivative that an implicit step gets is that of the forces", "[soft_bodies][pressure]") {
    // Where the filling presses nothing, the part that is left out is none.
    World world{ImplicitEuler{}, Springs<>{}, Pressure{}};
    const auto mesh = potato(2); // more vertices than are handled at once
    const auto all = add_bodies(world, mesh);
    world.add(Enclosure::of(all, mesh, firm));
    const auto n = Eigen::Index(3 * all.size());
    Eigen::MatrixXd by_x = Eigen::MatrixXd::Zero(n, n), by_v = by_x;
    const Pressure::In<Space<>> law(Pressure{});
    const auto view = world.view<Pressure>();
    law.jacobian(view, world.context().restricted<false>(),
                 [&](std::size_t a, std::size_t b, const auto& x, const auto& v) {
                     const auto put = [&](Eigen::MatrixXd& into, const Eigen::Matrix3d& block) {
                         into.block<3, 3>(Eigen::Index(3 * a), Eigen::Index(3 * a)) += block;
                         if (b == view.size()) return;
                         into.block<3, 3>(Eigen::Index(3 * b), Eigen::Index(3 * b)) += block;
                         into.block<3, 3>(Eigen::Index(3 * a), Eigen::Index(3 * b)) -= block;
                         into.block<3, 3>(Eigen::Index(3 * b), Eigen::Index(3 * a)) -= block.transpose();
                     };
                     put(by_x, x);
                     put(by_v, v);
                 });
    Eigen::VectorXd gradient(n);
    const auto volume = [&](std::size_t i, int axis, double by) {
        auto places = std::vector<TriangleMesh::Point>(mesh.vertices().begin(), mesh.vertices().end());
        auto x = places[i].value();
        x[axis] += by;
        places[i] = TriangleMesh::Point::from_value(x);
        return TriangleMesh(places, {mesh.triangles().begin(), mesh.triangles().end()}).volume().value();
    };
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            gradient[Eigen::Index(3 * i) + axis] = (volume(i, axis, 1e-5) - volume(i, axis, -1e-5)) / 2e-5;
    const double v0 = mesh.volume().value();
    const Eigen::MatrixXd outer = gradient * gradient.transpose();
    CHECK((by_x + 2000 / v0 * outer).cwiseAbs().maxCoeff() < 1e-6);
    CHECK((by_v + 3 / v0 * outer).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("A filling counts in the stable step, on the safe side", "[soft_bodies][pressure]") {
    auto world = World{SemiImplicitEuler{}, Pressure{}};
    const auto mesh = potato(1);
    const auto all = add_bodies(world, mesh);
    world.add(Enclosure::of(all, mesh, {.stiffness = 2000.0 * pascal}));
    double sum = 0; // of w |g|^2: the only stiffness that is not zero, times k
    for (std::size_t i = 0; i < all.size(); ++i) {
        Vector<double, 3> g = Vector<double, 3>::Zero();
        for (const auto& [a, b, c] : mesh.triangles())
            if (a == i || b == i || c == i)
                g +=
                    cross(mesh.vertices()[b] - mesh.vertices()[a], mesh.vertices()[c] - mesh.vertices()[a]).value() / 6;
        sum += world.inverse_mass(all[i]).value() * g.squaredNorm();
    }
    const double exact = 2000 / mesh.volume().value() * sum;
    CHECK(measured_stiffness(world).value() == Approx(exact).epsilon(1e-6));
    CHECK(stiffness_of(world).largest.value() >= exact);
    CHECK(stiffness_of(world).largest.value() < 4 * exact);
}

TEST_CASE("A ball that is turned inside out comes out again", "[soft_bodies][pressure]") {
    auto world = solved<double>(Xpbd{10, 2});
    const auto which = add_balloon(world, gas, 150, 4);
    for (const auto& body : world.handles()) {
        const auto x = world.position(body);
        world.set_position(body, -0.3 * x + metres(0.001, 0, 0));
    }
    CHECK(enclosed_volume(world, which).value() < 0);
    run(world, 400, 1.0 / 60);
    CHECK(world.status().ok());
    for (const auto& body : world.handles()) CHECK(is_finite(world.position(body)));
    CHECK(enclosed_volume(world, which).value() > 0.1);
}
