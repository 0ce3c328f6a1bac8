// SPDX-License-Identifier: BSL-1.0
// Implicit steps without a matrix: the same equation as ImplicitEuler's, solved as accurately as was asked for.

#include <ansatz/motion/coupled_system.hpp>
#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/world/save.hpp>

#include "tests/springs/support.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <random>
#include <sstream>

using namespace spring_tests;

namespace {

using Quick = ImplicitEulerBy<MatrixFree>;

Cloth sheet_of(std::size_t n, std::size_t m) {
    const auto k = 200.0 * N_per_m;
    return {.mesh = TriangleMesh::grid(n, m, metres(1, 0, 0), metres(0, 0, 1)),
            .mass_per_area = 0.15 * kilogram / square_metre,
            .structural = {k},
            .shear = {k},
            .bend = {k},
            .pins = {0, std::uint32_t(n - 1)}};
}
template <class World_> std::vector<Eigen::Vector3d> places(const World_& world, const std::vector<Handle>& bodies) {
    std::vector<Eigen::Vector3d> all;
    for (const Handle body : bodies) all.push_back(world.position(body).value());
    return all;
}
double rms_distance(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
    return std::sqrt(sum / double(a.size()));
}
/// |M (v' - v) - h f(x', v')|, each row by the square root of its mass, for bodies that were as in `before`.
template <class World_> double left(const World_& before, const World_& after, double h) {
    double sum = 0;
    for (const Handle body : after.handles()) {
        if (after.motion(body) != Motion::awake) continue;
        const Eigen::Vector3d a = after.acceleration(body).value();
        const Eigen::Vector3d off = (after.velocity(body) - before.velocity(body)).value() - h * a;
        sum += after.mass(body).value() * off.squaredNorm();
    }
    return std::sqrt(sum);
}
/// The same before anything was solved: every body goes on as it did.
template <class World_> double left_at_first(const World_& before, double h) {
    auto after = before;
    for (const Handle body : before.handles())
        if (before.motion(body) == Motion::awake)
            after.set_position(body, before.position(body) + h * second * before.velocity(body));
    return left(before, after, h);
}

} // namespace

TEST_CASE("conjugate gradients over pairs solve what the dense matrix solves, and say when they cannot",
          "[springs][implicit]") {
    using Block = Eigen::Matrix3d;
    constexpr int bodies = 30;
    PairMatrix<double, 3> m;
    m.clear(bodies);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(3 * bodies, 3 * bodies);
    std::mt19937 random(3);
    for (int n = 0; n < 3 * bodies; ++n) {
        const int a = int(random() % bodies), b = (a + 1 + int(random() % (bodies - 1))) % bodies;
        const Eigen::Vector3d axis = Eigen::Vector3d::Random();
        const Block along = axis * axis.transpose(), k = 100 * along;
        m.add(a, k);
        m.add(b, k);
        m.add(a, b, Block(-k));
        for (const auto& [i, j, sign] : {std::tuple{a, a, 1}, {b, b, 1}, {a, b, -1}, {b, a, -1}})
            dense.block<3, 3>(3 * i, 3 * j) += sign * k;
    }
    for (int i = 0; i < bodies; ++i) m.add(i, Block(Block::Identity()));
    m.finish();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3 * bodies, -1, 2),
                          weight = Eigen::VectorXd::LinSpaced(3 * bodies, 1, 5);
    MatrixFree::Solver<double> solver;
    Eigen::VectorXd x;
    Eigen::Index before = 0;
    const auto size = [&](const Eigen::VectorXd& of) { return std::sqrt(of.cwiseAbs2().dot(weight)); };
    for (const double leave : {0.1, 1e-4, 1e-12}) {
        REQUIRE(solver.solve(m, b, weight, x, leave));
        CHECK(size(b - dense * x) <= leave * size(b) * (1 + 1e-3));
        CHECK(solver.iterations() > before); // no more than it must
        before = solver.iterations();
    }
    CHECK((x - dense.ldlt().solve(b)).norm() <= 1e-9 * x.norm());

    CHECK(solver.solve(m, Eigen::VectorXd::Zero(3 * bodies), weight, x));
    CHECK(x == Eigen::VectorXd::Zero(3 * bodies));
    m.clear(1);
    m.add(0, Block(Block::Identity() * NAN));
    m.finish();
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(3);
    CHECK_FALSE(solver.solve(m, one, one, x));
    m.clear(1);
    m.add(0, Block(-Block::Identity()));
    m.finish();
    CHECK_FALSE(solver.solve(m, one, one, x)); // not definite
    CHECK(x.allFinite());
}

TEST_CASE("a step leaves no more of its equation than was asked for", "[springs][implicit]") {
    const double h = 1.0 / 60;
    for (const double tolerance : {0.0, 1e-4, 1e-9}) {
        CAPTURE(tolerance);
        World world{Quick{.tolerance = tolerance}, Gravity{}, Springs<>{}};
        auto cloth = sheet_of(8, 8);
        cloth.shear.damping = 0.5 * N_s_per_m;
        const auto parts = add_cloth(world, cloth);
        world.set_velocity(parts.bodies[36], metres_per_second(1, 2, 3));
        for (int i = 0; i < 30; ++i) {
            const auto before = world;
            world.step(h * second);
            REQUIRE(world.status().unsolved == 0);
            const double asked = tolerance > 0 ? tolerance : MatrixFree::tolerance;
            REQUIRE(left(before, world, h) <= asked * left_at_first(before, h) * (1 + 1e-6));
        }
    }
}

TEST_CASE("asked for all, it comes to what the direct solver comes to", "[springs][implicit]") {
    auto end = []<class I>(const I& integrator) {
        World world{integrator, Gravity{}, Springs<>{}, Drag{0.3 / second}};
        const auto chain = hang_chain(world, 12, 0.05, 800, 0.3, 0.1);
        world.add(Spring{chain[3], metres(1, 0, 0.2), 30.0 * N_per_m, 0.1 * N_s_per_m, 0.7 * metre});
        world.set_velocity(chain[5], metres_per_second(1, 2, 0));
        for (int i = 0; i < 100; ++i) world.step(1.0 / 60 * second);
        CHECK(world.status().unsolved == 0);
        return state(world, chain.back());
    };
    CHECK(distance(end(Quick{.tolerance = 1e-12}), end(ImplicitEulerDirect{})) <= 1e-7);
}

TEST_CASE("a cloth of 50 x 50 steps at 60 Hz with nothing unsolved, near to what a closer solution does",
          "[springs][implicit]") {
    const auto end = [](const Quick& integrator) {
        World world{integrator, Gravity{}, Springs<>{}};
        const auto parts = add_cloth(world, sheet_of(50, 50));
        CHECK(world.elements<Spring>().size() == 14502);
        for (int i = 0; i < 10; ++i) world.step(1.0 / 60 * second);
        CHECK(world.status().unsolved == 0);
        return places(world, parts.bodies);
    };
    const double off = rms_distance(end(Quick{}), end(Quick{.tolerance = 1e-4}));
    CHECK(off > 0);
    CHECK(off < 5e-4); // of the 15 cm that it has fallen
}

TEST_CASE("with one iteration it is the step of Baraff and Witkin: one linear system, solved", "[springs][implicit]") {
    const double h = 1.0 / 60;
    World world{Quick{.tolerance = 1e-12, .most_iterations = 1}, Gravity{}, Springs<>{}};
    std::vector<Handle> bodies;
    const std::vector<double> masses{0.3, 1, 0.05};
    for (const auto& at : {metres(0, 0, 0), metres(1.2, 0.1, 0), metres(0.4, 1.1, 0.3)})
        bodies.push_back(world.add(position(at), mass(masses[bodies.size()] * kilogram),
                                   velocity(metres_per_second(0.5 * double(bodies.size()), -1, 0.2))));
    const double k = 700, c = 3, rest = 0.8; // all of them stretched, so that the Jacobian is the whole of it
    for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 0}})
        world.add(Spring{bodies[std::size_t(a)], bodies[std::size_t(b)], k * N_per_m, c * N_s_per_m, rest * metre});
    // By hand: (M - h D - h^2 K) dv = h f(x + h v, v), with the Jacobians there.
    Eigen::VectorXd x(9), v(9), f(9);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(9, 9);
    for (int i = 0; i < 3; ++i) {
        v.segment<3>(3 * i) = world.velocity(bodies[std::size_t(i)]).value();
        x.segment<3>(3 * i) = world.position(bodies[std::size_t(i)]).value() + h * v.segment<3>(3 * i);
        A.block<3, 3>(3 * i, 3 * i) = masses[std::size_t(i)] * Eigen::Matrix3d::Identity();
        f.segment<3>(3 * i) = masses[std::size_t(i)] * Eigen::Vector3d(0, -9.81, 0);
    }
    for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 0}}) {
        const Eigen::Vector3d to = x.segment<3>(3 * b) - x.segment<3>(3 * a), n = to.normalized();
        const double length = to.norm(),
                     pull = k * (length - rest) + c * n.dot(v.segment<3>(3 * b) - v.segment<3>(3 * a));
        f.segment<3>(3 * a) += pull * n;
        f.segment<3>(3 * b) -= pull * n;
        const Eigen::Matrix3d along = n * n.transpose();
        const Eigen::Matrix3d block =
            h * c * along + h * h * (k * along + k * (length - rest) / length * (Eigen::Matrix3d::Identity() - along));
        A.block<3, 3>(3 * a, 3 * a) += block;
        A.block<3, 3>(3 * b, 3 * b) += block;
        A.block<3, 3>(3 * a, 3 * b) -= block;
        A.block<3, 3>(3 * b, 3 * a) -= block;
    }
    const Eigen::VectorXd after = v + A.ldlt().solve(h * f);
    world.step(h * second);
    CHECK(world.status().unsolved == 0); // although the equation is not solved by it
    for (int i = 0; i < 3; ++i)
        CHECK((world.velocity(bodies[std::size_t(i)]).value() - after.segment<3>(3 * i)).norm() <= 1e-10);
}

TEST_CASE("a sheet pressed together at a hundred times its stiffness is solved, and ends at rest",
          "[springs][implicit]") {
    const int once = GENERATE(0, 1);
    World world{once ? Quick{.most_iterations = 1} : Quick{}, Gravity{}, Springs<>{}, Drag{1.0 / second}};
    auto cloth = sheet_of(10, 10);
    for (auto* kind : {&cloth.structural, &cloth.shear, &cloth.bend}) kind->stiffness = 20000.0 * N_per_m;
    const auto parts = add_cloth(world, cloth);
    std::mt19937 random(7);
    for (const Handle body : parts.bodies) // every one is a tenth of a cell away
        if (world.motion(body) == Motion::awake) {
            auto x = world.position(body).value();
            for (int k = 0; k < 3; ++k) x[k] += 0.01 * (double(random()) / double(random.max()) - 0.5);
            world.set_position(body, Space<>::Position::from_value(x));
        }
    double speed = 0;
    for (int i = 0; i < 1200; ++i) world.step(1.0 / 60 * second);
    for (const Handle body : parts.bodies) speed = std::max(speed, norm(world.velocity(body)).value());
    CHECK(world.status().unsolved == 0);
    CHECK(speed < 1e-2);
    CHECK(world.position(parts.bodies.back()).value()[1] < -0.9);
}

TEST_CASE("bodies and springs come, go, break and sleep, and copies and loaded worlds go on alike",
          "[springs][implicit]") {
    World world{Quick{}, Gravity{}, Springs<Breaking>{}, Ropes<Undamped>{}, Rest{}};
    auto chain = hang_chain(world, 6, 0.1, 500, 2, 0.2);
    run(world, 10, 0.02);
    const auto extra = world.add(Spring{chain[0], chain[5], 100.0 * N_per_m});
    world.add(Rope{chain[1], chain[4], 100.0 * N_per_m, {}, 3.0 * metre}); // slack
    run(world, 10, 0.02);
    world.remove(extra);
    world.remove(chain[2]);
    run(world, 10, 0.02);
    const auto fresh = world.add(position(metres(3, 0, 0)), mass(0.5 * kilogram));
    world.add(Spring{fresh, chain[5], 10.0 * N_per_m}, breaks_at(1.0 * newton));
    auto copy = world;
    std::stringstream file;
    save(world, file);
    World loaded{Quick{}, Gravity{}, Springs<Breaking>{}, Ropes<Undamped>{}, Rest{}};
    load(loaded, file);
    for (auto* one : {&world, &copy, &loaded}) run(*one, 300, 0.02);
    CHECK(world.hash() == copy.hash());
    CHECK(world.hash() == loaded.hash());
    CHECK(world.status().ok());
}

TEST_CASE("what dies away by it is solved to the end", "[springs][implicit]") {
    using S = Space<float, 2>;
    World world{Quick{.tolerance = 1e-5}, S{}, Springs{}};
    const auto body = world.add(at<S>(1e-3), mass(0.01 * kilogram));
    world.add(Spring{point(world, 0), body, 1.0 * N_per_m, {}, 0.0 * metre});
    double expected = 1e-3, v = 0;
    const double smallest = 1e3 * double(std::numeric_limits<float>::min());
    for (int n = 0; n < 2500; ++n) {
        world.step(0.1 * second);
        v = (v - 0.1 * 100 * expected) / 2;
        expected += 0.1 * v;
        REQUIRE(world.status().ok());
        const double size = std::abs(expected) + 0.1 * std::abs(v);
        REQUIRE(std::abs(double(world.position(body).value()[0]) - expected) <= 1e-3 * (size + smallest));
    }
}
