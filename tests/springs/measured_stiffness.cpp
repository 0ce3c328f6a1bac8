// SPDX-License-Identifier: BSL-1.0
// How stiff springs are together: from below, beside dense eigenvalues, and as StepLimit takes it.

#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/springs/measured_stiffness.hpp>
#include <ansatz/springs/step_limit.hpp>
#include <ansatz/world/save.hpp>

#include "tests/springs/support.hpp"

#include <Eigen/Dense>

#include <random>
#include <sstream>

using namespace spring_tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Row K2: n x n bodies of m = 1/n^2 kg, all springs of k = 10 N/m.
constexpr std::size_t n = 20;
constexpr double m = 1.0 / (n * n), k = 10;
struct Kinds {
    bool shear, bend;
    double lambda;
};
template <class World_> ClothParts lay(World_& world, const Kinds& row, Lumping lumping = Lumping::equal) {
    const auto stiffness = k * N_per_m;
    Cloth cloth{.mesh = TriangleMesh::grid(n, n, metres(1.9, 0, 0), metres(0, 1.9, 0)),
                .structural = {stiffness},
                .lumping = lumping};
    cloth.mass_per_area = 1.0 * kilogram / cloth.mesh.area();
    if (row.shear) cloth.shear.stiffness = stiffness;
    if (row.bend) cloth.bend.stiffness = stiffness;
    return add_cloth(world, cloth);
}
using Limited = World<SemiImplicitEuler, Springs<>, StepLimit<Refuse>>;
Limited limited(int measured) {
    return Limited{SemiImplicitEuler{}, Springs<>{}, StepLimit<Refuse>{.measured = measured}};
}

} // namespace

TEST_CASE("hard case K2: what is measured in a few iterations allows 1.3 times the step, and nothing grows",
          "[springs][K2]") {
    for (const auto& row : {Kinds{false, false, 3.975}, Kinds{true, false, 7.93}, Kinds{true, true, 9.98}}) {
        CAPTURE(row.lambda);
        auto careful = limited(0), measuring = limited(20);
        lay(careful, row);
        const auto parts = lay(measuring, row);
        MeasuredStiffnessScratch scratch;
        const auto found = measured_stiffness(measuring, 20, scratch);
        CHECK(found.converged);
        CHECK(found.iterations <= 20);
        const double lambda = found.largest.value() * m / k;
        CHECK(lambda >= 0.9025 * row.lambda);     // so that 0.95 of its step is stable
        CHECK(lambda <= row.lambda * (1 + 1e-3)); // the row has three digits

        const double truth = 2 / std::sqrt(row.lambda) * std::sqrt(m / k), certain = stable_step(careful).value();
        CHECK_THROWS_AS(careful.step(1.001 * certain * second), std::invalid_argument);
        CHECK_THROWS_AS(measuring.step(1.01 * truth * second), std::invalid_argument);
        const double allowed = 0.95 * 2 / std::sqrt(found.largest.value());
        CHECK(allowed >= 1.3 * certain);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> push(-1e-7, 1e-7);
        for (const Handle body : parts.bodies)
            measuring.set_velocity(body, metres_per_second(push(random), push(random), 0));
        const auto before = measuring;
        for (int i = 0; i < 150; ++i) measuring.step(0.999 * allowed * second);
        for (const Handle body : parts.bodies) {
            const bool stays = norm(measuring.position(body) - before.position(body)).value() < 1e-6;
            if (!stays) FAIL_CHECK("a body is away");
        }
    }
}

TEST_CASE("what counts as converged is near to the largest eigenvalue, of chains of any masses and springs",
          "[springs]") {
    int converged = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        const auto number = [&](double from, double to) {
            return from * std::pow(to / from, double(random()) / double(random.max()));
        };
        World world{SemiImplicitEuler{}, Springs<>{}};
        constexpr int bodies = 9;
        std::vector<Handle> all;
        Eigen::MatrixXd K = Eigen::MatrixXd::Zero(bodies, bodies); // along the line; across it nothing is stiffer
        Eigen::VectorXd root(bodies);
        const double spread = seed % 2 ? 3 : 100;
        for (int i = 0; i < bodies; ++i) {
            const double mass_ = number(0.1, 0.1 * spread);
            root[i] = 1 / std::sqrt(mass_);
            all.push_back(world.add(position(metres(i, 0, 0)), mass(mass_ * kilogram)));
            const double k_ = number(1, spread);
            K(i, i) += k_;
            if (i == 0) world.add(Spring{metres(-1, 0, 0), all[0], k_ * N_per_m});
            else {
                world.add(Spring{all[std::size_t(i) - 1], all.back(), k_ * N_per_m});
                K(i - 1, i - 1) += k_;
                K(i, i - 1) -= k_;
                K(i - 1, i) -= k_;
            }
        }
        const Eigen::MatrixXd scaled = root.asDiagonal() * K * root.asDiagonal();
        const double truth = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff();
        MeasuredStiffnessScratch scratch;
        const auto found = measured_stiffness(world, 30, scratch);
        CAPTURE(seed, truth, found.largest.value(), found.iterations);
        CHECK(found.largest.value() <= truth * (1 + 1e-12));
        if (found.converged) {
            ++converged;
            CHECK(found.largest.value() >= 0.9025 * truth);
        }
        CHECK(found.iterations <= 30);
        const auto again = measured_stiffness(world, found.iterations - 1, scratch); // not one more than it must
        if (found.converged) CHECK_FALSE(again.converged);
        CHECK(measured_stiffness(world).value() == Approx(truth).epsilon(1e-3));
    }
    CHECK(converged >= 30);
}

TEST_CASE("without convergence the certain bound is taken", "[springs]") {
    // One iteration sees a mixture.
    World world{SemiImplicitEuler{}, Springs<>{}, StepLimit<Divide>{.measured = 1}};
    std::vector<Handle> all;
    for (int i = 0; i < 4; ++i) all.push_back(world.add(position(metres(i, 0, 0)), mass(1.0 * kilogram)));
    for (int i = 0; i < 3; ++i)
        world.add(Spring{all[std::size_t(i)], all[std::size_t(i) + 1], (i == 1 ? 100.0 : 10.0) * N_per_m});
    MeasuredStiffnessScratch scratch;
    REQUIRE_FALSE(measured_stiffness(world, 1, scratch).converged);
    const auto certain = stable_step(world);
    world.step(1.5 * certain);
    CHECK(world.tick() == 2);
    world.set(StepLimit<Divide>{.measured = 50});
    world.step(1.01 * certain); // it is hardly stiffer than the middle one: there is little to gain
    const auto gained = world.tick() - 2;
    const auto found = measured_stiffness(world, 50, scratch);
    REQUIRE(found.converged);
    CHECK(gained == (0.95 * 2 / std::sqrt(found.largest.value()) >= 1.01 * certain.value() ? 1u : 2u));
    CHECK_THROWS_WITH(world.set(StepLimit<Divide>{.measured = -1}),
                      ContainsSubstring("measured is -1") && ContainsSubstring("at least 0"));
}

TEST_CASE("a world that measures, its copy and the loaded one divide alike", "[springs]") {
    World world{SemiImplicitEuler{}, Springs<>{}, StepLimit<Divide>{.measured = 20}};
    auto parts = lay(world, {true, true, 0}, Lumping::by_area);
    world.remove(parts.bodies[7]); // slots move
    world.set_velocity(parts.bodies[30], metres_per_second(0.1, 0.2, 0.1));
    World loaded{SemiImplicitEuler{}, Springs<>{}, StepLimit<Divide>{.measured = 20}};
    std::stringstream file;
    save(world, file);
    load(loaded, file);
    auto copy = world;
    for (auto* one : {&world, &copy, &loaded})
        for (int i = 0; i < 20; ++i) one->step(1.0 / 30 * second);
    CHECK(world.tick() > 20);
    CHECK(world.hash() == copy.hash());
    CHECK(world.hash() == loaded.hash());
    World careful{SemiImplicitEuler{}, Springs<>{}, StepLimit<Divide>{}};
    lay(careful, {true, true, 0}, Lumping::by_area);
    for (int i = 0; i < 20; ++i) careful.step(1.0 / 30 * second);
    CHECK(world.tick() < careful.tick());

    World empty{SemiImplicitEuler{}, Springs<>{}};
    MeasuredStiffnessScratch scratch;
    CHECK(measured_stiffness(empty, 20, scratch).largest.value() == 0);
    empty.add(position(metres(0, 0, 0)), mass(1.0 * kilogram));
    CHECK(measured_stiffness(empty, 20, scratch).largest.value() == 0);
}
