// SPDX-License-Identifier: BSL-1.0
// Rows of joints, by themselves: what they ask, what they keep, and which way they push.

#include <ansatz/collision.hpp>
#include <ansatz/collision/response/solver_rows.hpp>
#include <ansatz/collision/substep_driver.hpp>
#include <ansatz/world.hpp>

#include <catch2/catch.hpp>

#include <random>

using namespace ansatz;

namespace {

template <class S> struct Solver {
    using Raw = typename SolverRows<S>::Raw;
    std::vector<SolverBody<S>> bodies;
    std::vector<Raw> before, kicks;
    SolverRows<S> rows;
    Softness<typename S::Scalar> soft = Softness<typename S::Scalar>::of(60, 5, typename S::Scalar(1.0 / 240));

    void body(const Raw& velocity, double weight) {
        bodies.push_back({velocity, Raw::Zero(), typename S::Scalar(weight)});
        before.push_back(velocity);
        kicks.push_back(Raw::Zero());
    }
    void solve() {
        rows.warm_start(bodies, before, kicks);
        rows.solve(bodies, typename S::Scalar(1.0 / 240), soft, kicks);
    }
    auto momentum() const {
        Raw sum = Raw::Zero();
        for (const auto& one : bodies)
            if (one.weight > 0) sum += one.u / one.weight;
        return sum;
    }
};
using S = Space<double, 3>;
using Push = SolverRow<S>::Impulse;
auto metre_of(double x) { return S::Length::from_value(x); }

} // namespace

TEST_CASE("A row keeps momentum, takes away its part of what is wrong, and relaxing takes it all", "[rows]") {
    std::mt19937 random(3);
    auto number = [&] { return double(random()) / double(random.max()) - 0.5; };
    for (int round = 0; round < 100; ++round) {
        Solver<S> solver;
        for (int i = 0; i < 2; ++i) solver.body({number(), number(), number()}, 0.1 + std::abs(number()));
        const Vector<double, 3> direction = Vector<double, 3>(number(), number(), number()).normalized();
        const double off = 0.01 * number();
        Push impulse{};
        solver.rows.add({0, 1, direction, metre_of(off), &impulse}, solver.bodies);
        const auto along = [&] { return dot(Vector<double, 3>(solver.bodies[0].u - solver.bodies[1].u), direction); };
        const double wrong = along() + solver.soft.rate * off;
        const Vector<double, 3> momentum = solver.momentum();
        solver.solve();
        CHECK((solver.momentum() - momentum).norm() < 1e-14);
        CHECK(along() + solver.soft.rate * off == Approx((1 - solver.soft.mass) * wrong).margin(1e-14));
        const Vector<double, 3> by = solver.bodies[0].u - solver.before[0];
        CHECK((by - solver.bodies[0].weight * impulse.value() * direction).norm() <
              1e-14);                                 // what it keeps is what it did
        CHECK((solver.kicks[0] - by).norm() < 1e-14); // and contacts know
        solver.rows.relax(solver.bodies, 1.0 / 240);
        CHECK(along() == Approx(0).margin(1e-14));
        CHECK((solver.momentum() - momentum).norm() < 1e-14);
    }
}
TEST_CASE("A rope only pulls, a strut only pushes, and each as late as it is reached", "[rows]") {
    struct Case {
        double off, velocity, least, most, after;
    };
    constexpr double inf = std::numeric_limits<double>::infinity(), h = 1.0 / 240;
    const Case cases[] = {
        {-0.1, 5, -inf, 0, 5},        // slack, and not reached in this substep
        {-0.1, 30, -inf, 0, 0.1 / h}, // reached: it is let come so far
        {-0.1, -30, -inf, 0, -30},    // slack
        {0.1, -5, 0, inf, -5},        // apart
        {0.1, -30, 0, inf, -0.1 / h}, // met
        {0.1, 30, 0, inf, 30},
    };
    for (const auto& one : cases) {
        Solver<S> solver;
        solver.body({one.velocity, 0, 0}, 2.0);
        Push impulse{};
        solver.rows.add({0, SolverRow<S>::point, {1, 0, 0}, metre_of(one.off), &impulse, one.least, one.most},
                        solver.bodies);
        solver.solve();
        CHECK(solver.bodies[0].u[0] == Approx(one.after));
        CHECK(impulse.value() == Approx((one.after - one.velocity) / 2).margin(1e-14));
    }
}
TEST_CASE("A row between bodies that nothing moves is none", "[rows]") {
    Solver<S> solver;
    solver.body({1, 0, 0}, 0);
    solver.body({2, 0, 0}, 0);
    Push impulse = Push::from_value(3);
    solver.rows.add({0, 1, {1, 0, 0}, metre_of(1), &impulse}, solver.bodies);
    solver.rows.add({0, SolverRow<S>::point, {1, 0, 0}, metre_of(1), &impulse}, solver.bodies);
    CHECK(solver.rows.empty());
    solver.solve();
    CHECK(solver.bodies[0].u[0] == 1);
    CHECK(impulse.value() == 3);
}
