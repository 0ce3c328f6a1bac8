// SPDX-License-Identifier: BSL-1.0
// Implicit Euler of coupled bodies: one system of equations, by either solver.

#include <ansatz/motion/coupled_system.hpp>
#include <ansatz/motion/integrators/block_matrix.hpp>
#include <ansatz/motion/integrators/cholesky.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/motion/integrators/implicit_system.hpp>
#include <ansatz/motion/integrators/matrix_free.hpp>

#include "tests/springs/support.hpp"

#include <Eigen/Dense>

#include <random>

using namespace spring_tests;

namespace {
/// A sparse, symmetric, positive definite matrix of blocks, and the same as a dense one.
template <class Scalar, int d> auto random_matrix(int bodies, unsigned seed) {
    std::mt19937 random(seed);
    auto number = [&] { return Scalar(double(random()) / double(random.max()) - 0.5); };
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < 2 * bodies; ++i) {
        const int a = int(random() % unsigned(bodies)), b = int(random() % unsigned(bodies));
        if (a != b) pairs.emplace_back(a, b);
    }
    const auto springs = pairs;
    BlockMatrix<Scalar, d> sparse;
    sparse.make_pattern(bodies, pairs);
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> dense = decltype(dense)::Identity(bodies * d, bodies * d);
    using Block = Eigen::Matrix<Scalar, d, d>;
    for (int i = 0; i < bodies; ++i) CHECK(sparse.add(i, i, Block(Block::Identity())));
    for (const auto& [a, b] : springs) {
        const Eigen::Matrix<Scalar, d, 1> n = Eigen::Matrix<Scalar, d, 1>::NullaryExpr(number);
        const Block k = Scalar(10) * n * n.transpose();
        CHECK(
            (sparse.add(a, a, k) && sparse.add(b, b, k) && sparse.add(a, b, Block(-k)) && sparse.add(b, a, Block(-k))));
        dense.template block<d, d>(a * d, a * d) += k;
        dense.template block<d, d>(b * d, b * d) += k;
        dense.template block<d, d>(a * d, b * d) -= k;
        dense.template block<d, d>(b * d, a * d) -= k;
    }
    return std::pair(sparse, dense);
}
} // namespace

TEMPLATE_TEST_CASE_SIG("a block matrix is the dense one, and both solvers solve it", "[springs][implicit]",
                       ((class T, int d), T, d), (double, 3), (double, 2), (float, 3), (float, 2)) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const int bodies = 1 + int(seed);
        const auto both = random_matrix<T, d>(bodies, seed);
        const auto& sparse = both.first;
        const auto& dense = both.second;
        CHECK((Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>(sparse.matrix()) - dense).cwiseAbs().maxCoeff() <=
              1e-5f);
        using Column = Eigen::Matrix<T, Eigen::Dynamic, 1>;
        const Column b = Column::LinSpaced(bodies * d, T(-1), T(2));
        const Column truth = dense.ldlt().solve(b);
        const T close = std::is_same_v<T, float> ? T(1e-3) : T(1e-7);
        Column x;
        ConjugateGradient::Solver<T> iterative;
        REQUIRE(iterative.solve(sparse.matrix(), b, x));
        CHECK((x - truth).norm() <= close * truth.norm());
        Cholesky::Solver<T> direct;
        direct.pattern(sparse.matrix());
        REQUIRE(direct.solve(sparse.matrix(), b, x));
        CHECK((x - truth).norm() <= close * truth.norm());
        // A pattern that has grown old holds zeros, and they change nothing.
        std::vector<std::pair<int, int>> all;
        for (int i = 0; i < bodies; ++i)
            for (int j = 0; j < i; ++j) all.emplace_back(i, j);
        BlockMatrix<T, d> old;
        old.make_pattern(bodies, all);
        for (int i = 0; i < bodies; ++i)
            for (int j = 0; j < bodies; ++j)
                CHECK(old.add(i, j, Eigen::Matrix<T, d, d>(dense.template block<d, d>(i * d, j * d))));
        BlockMatrix<T, d> exact;
        auto pairs = all;
        std::erase_if(
            pairs, [&](const auto& p) { return dense.template block<d, d>(p.first * d, p.second * d).isZero(T(0)); });
        exact.make_pattern(bodies, pairs);
        for (int i = 0; i < bodies; ++i)
            for (int j = 0; j < bodies; ++j)
                if (i == j || !dense.template block<d, d>(i * d, j * d).isZero(T(0)))
                    CHECK(exact.add(i, j, Eigen::Matrix<T, d, d>(dense.template block<d, d>(i * d, j * d))));
        Column with_zeros, without;
        iterative.solve(old.matrix(), b, with_zeros);
        iterative.solve(exact.matrix(), b, without);
        CHECK(with_zeros == without);
    }
}

TEST_CASE("a block without a place in the pattern is refused", "[springs][implicit]") {
    BlockMatrix<double, 3> m;
    std::vector<std::pair<int, int>> pairs{{0, 1}};
    m.make_pattern(3, pairs);
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
    CHECK(m.add(0, 1, one));
    CHECK(m.add(2, 2, one));
    CHECK_FALSE(m.add(0, 2, one));
    CHECK_FALSE(m.add(2, 1, one));
}

TEST_CASE("conjugate gradients that cannot converge say so", "[springs][implicit]") {
    BlockMatrix<double, 2> m;
    std::vector<std::pair<int, int>> none;
    m.make_pattern(1, none);
    m.add(0, 0, Eigen::Matrix2d(Eigen::Matrix2d::Identity() * NAN));
    Eigen::VectorXd x;
    ConjugateGradient::Solver<double> solver;
    CHECK_FALSE(solver.solve(m.matrix(), Eigen::VectorXd::Ones(2), x));
    CHECK(solver.solve(m.matrix(), Eigen::VectorXd::Zero(2), x));
    CHECK(x == Eigen::VectorXd::Zero(2));
}

TEST_CASE("the end of an implicit step satisfies its equation, however the springs turn", "[springs][implicit]") {
    for_each_type(Types<ImplicitEuler, ImplicitEulerDirect>{}, [&]<class I>() {
        World world{I{}, Gravity{}, Springs{}};
        const auto a = world.add(position(metres(1, 0, 0)), velocity(metres_per_second(0, 3, 1)), mass(1.0 * kilogram));
        const auto b =
            world.add(position(metres(1, 1, 0)), velocity(metres_per_second(-2, 0, 5)), mass(0.1 * kilogram));
        world.add(Spring{metres(0, 0, 0), a, 1e4 * N_per_m, 3.0 * N_s_per_m, 0.7 * metre});
        world.add(Spring{a, b, 2e3 * N_per_m, 1.0 * N_s_per_m, 1.4 * metre}); // pressed
        const auto h = 0.02 * second;
        for (int i = 0; i < 50; ++i) {
            const auto xa = world.position(a);
            const auto vb = world.velocity(b);
            world.step(h);
            // v1 - v0 = h a(x1, v1), x1 - x0 = h v1, of every body
            REQUIRE(norm(world.velocity(b) - vb - h * world.acceleration(b)).value() <= 1e-7 * (1 + norm(vb).value()));
            REQUIRE(norm(world.position(a) - xa - h * world.velocity(a)).value() <= 1e-12);
        }
        CHECK(world.status().ok());
    });
}

TEMPLATE_TEST_CASE("a body falls into its rope as far from the origin as near to it", "[springs]", ImplicitEuler,
                   ImplicitEulerDirect, ImplicitEulerBy<MatrixFree>) {
    // In a step it falls by less than 4000 digits of its place, and the rope is taut at the end of it.
    const auto fall = [](double height, double above) {
        World world{Space<float, 3>{}, TestType{}, Gravity{}, Ropes<>{}};
        const auto body = world.add(position(metres(0, height - 1 + above, 0)), mass(1.0 * kilogram));
        world.add(Rope{body, metres(0, height, 0), 1e4 * N_per_m, {}, 1.0 * metre});
        std::vector<double> speeds;
        for (int i = 0; i < 60; ++i) {
            world.step(1.0 / 60 * second);
            speeds.push_back(double(world.velocity(body).value()[1]));
        }
        CHECK(world.status().ok());
        CHECK(double(world.position(body).value()[1]) - height + 1 == Approx(-9.81e-4).margin((height + 1) * 1.2e-7));
        return speeds;
    };
    const double above = GENERATE(0., 0.125);
    const auto near = fall(0, above);
    for (const double height : {16., 128., 512.}) {
        CAPTURE(above, height);
        const auto far = fall(height, above);
        // What a digit of its place is to the rope: k dt^2 / m = 2.8 times as much of a way, in a step.
        const double digit = height * 1.2e-7;
        for (std::size_t i = 0; i < 4; ++i) CHECK(far[i] == Approx(near[i]).margin(16 * digit * 60));
    }
}

TEST_CASE("both solvers come to the same chain, and a chain of bodies by themselves is what each body alone would do",
          "[springs][implicit]") {
    auto end = []<class I>(I) {
        World world{I{}, Gravity{}, Springs{}};
        const auto chain = hang_chain(world, 12, 0.05, 800, 0.3, 0.1);
        world.set_velocity(chain[5], metres_per_second(1, 0, 2));
        run(world, 200, 1.0 / 60);
        return state(world, chain.back());
    };
    CHECK(distance(end(ImplicitEuler{}), end(ImplicitEulerDirect{})) <= 1e-7);

    // A spring of no stiffness makes the world one system; per body laws are solved with it as they are alone.
    World together{ImplicitEuler{}, problems::Pendulum{}, Springs{}};
    World alone{ImplicitEuler{}, problems::Pendulum{}, Keep<InverseMass>{}};
    for (auto* w : {&together})
        w->add(position(metres(1, 0.5, 0)), velocity(metres_per_second(0, 1, 0)), mass(2.0 * kilogram));
    alone.add(position(metres(1, 0.5, 0)), velocity(metres_per_second(0, 1, 0)), mass(2.0 * kilogram));
    together.add(Spring{together.handles()[0], metres(0, 0, 0), 0.0 * N_per_m});
    run(together, 100, 0.02);
    run(alone, 100, 0.02);
    CHECK(distance(state(together, together.handles()[0]), state(alone, alone.handles()[0])) <= 1e-11);
}

TEMPLATE_TEST_CASE("what dies away is solved to the end: no square of a small number is taken for nothing",
                   "[springs][implicit]", float, double) {
    for_each_type(Types<ImplicitEuler, ImplicitEulerDirect>{}, [&]<class I>() {
        using S = Space<TestType, 2>;
        World world{I{}, S{}, Springs{}};
        const auto body = world.add(at<S>(1e-3), mass(0.01 * kilogram));
        world.add(Spring{point(world, 0), body, 1.0 * N_per_m, {}, 0.0 * metre});
        double expected = 1e-3, v = 0;
        const double smallest = 1e3 * double(std::numeric_limits<TestType>::min());
        for (int n = 0; n < 2500;
             ++n) { // h^2 k/m = 1: it loses half of its energy in a step, and is at rest in double behind 2200
            world.step(0.1 * second);
            v = (v - 0.1 * 100 * expected) / 2;
            expected += 0.1 * v;
            REQUIRE(world.status().ok());
            const double size = std::abs(expected) + 0.1 * std::abs(v);
            REQUIRE(std::abs(double(world.position(body).value()[0]) - expected) <= 1e-3 * (size + smallest));
        }
    });
}

TEST_CASE("springs added, removed and broken, bodies added, removed and asleep: the pattern follows",
          "[springs][implicit]") {
    for_each_type(Types<ImplicitEuler, ImplicitEulerDirect>{}, [&]<class I>() {
        World world{I{}, Gravity{}, Springs<Breaking>{}};
        auto chain = hang_chain(world, 6, 0.1, 500, 2, 0.2);
        run(world, 10, 0.02);
        const auto extra = world.add(Spring{chain[0], chain[5], 100.0 * N_per_m});
        run(world, 10, 0.02);
        world.remove(extra);
        world.remove(chain[2]);
        run(world, 10, 0.02);
        const auto fresh = world.add(position(metres(3, 0, 0)), mass(0.5 * kilogram));
        world.add(Spring{fresh, chain[5], 10.0 * N_per_m}, breaks_at(1.0 * newton));
        auto copy = world;
        run(world, 40, 0.02);
        run(copy, 40, 0.02);
        CHECK(world.hash() == copy.hash()); // although the copy found its pattern anew
        CHECK(world.status().ok());
    });
}

TEST_CASE("the Jacobian of a spring is what differences of its force say, where it is stretched",
          "[springs][implicit]") {
    World world{RungeKutta4{}, Springs{}};
    const auto a = world.add(position(metres(0.1, 0.2, 0.3)), mass(1.0 * kilogram)),
               b = world.add(position(metres(1.1, -0.7, 0.9)), mass(1.0 * kilogram));
    world.add(Spring{a, b, 70.0 * N_per_m, 3.0 * N_s_per_m, 0.4 * metre});
    const detail::Bound<Springs<>, Space<>> force((Springs<>()));
    int calls = 0;
    force.jacobian(world.view<Springs<>>(), world.context(),
                   [&](std::size_t, std::size_t, const Eigen::Matrix3d& by_x, const Eigen::Matrix3d& by_v) {
                       ++calls;
                       for (int k = 0; k < 3; ++k) {
                           const double e = 1e-6;
                           auto pull = [&](double dx, double dv) {
                               auto w = world;
                               auto p = w.position(a).value(), v = w.velocity(a).value();
                               p[k] += dx;
                               v[k] += dv;
                               w.set_position(a, Space<>::Position::from_value(p));
                               w.set_velocity(a, Space<>::Velocity::from_value(v));
                               return Eigen::Vector3d(w.acceleration(a).value());
                           };
                           CHECK(((pull(e, 0) - pull(-e, 0)) / (2 * e) - by_x.col(k)).norm() <= 1e-6);
                           CHECK(((pull(0, e) - pull(0, -e)) / (2 * e) - by_v.col(k)).norm() <= 1e-6);
                       }
                   });
    CHECK(calls == 1);
}
