// SPDX-License-Identifier: BSL-1.0
// Constraints of a user's own as elements: written once, they are forces, have a Jacobian and an energy, are held by
// every solver, and are shared out among threads.

#include <ansatz/soft_bodies/constraint_force.hpp>

#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/stable_step.hpp>

#include "tests/soft_bodies/support.hpp"

#include <random>
#include <thread>

using namespace soft_tests;

namespace {

//! [corner]
/// Two bars that meet at a right angle: (a - b) . (c - b) = 0.
struct Corner {
    using element = Corner;
    Handle a, b, c;
    double stiffness = 0, damping = 0; // N/m^3, N s/m^3
};
template <class S> struct CornerConstraint {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;
    static constexpr std::size_t bodies = 3;
    static constexpr bool one_sided = false;
    std::array<std::size_t, 3> slots;
    Scalar stiffness, damping;
    Scalar linearise(const std::array<Vec, 3>& x, std::array<Vec, 3>& gradient) const {
        gradient[0] = x[2] - x[1];
        gradient[2] = x[0] - x[1];
        gradient[1] = -gradient[0] - gradient[2];
        return gradient[0].dot(gradient[2]);
    }
    auto curvature(std::size_t i, const auto&, const auto&) const { // C is |b|^2 and what is straight in b, a and c
        using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
        return Matrix((i == 1 ? 2 : 0) * Matrix::Identity());
    }
};
template <class S> struct CornerRow {
    std::array<BodyId, 3> bodies;
    double stiffness = 0, damping = 0;
    static void fields(auto& self, auto&& field) {
        field("bodies", self.bodies), field("stiffness", self.stiffness), field("damping", self.damping);
    }
    static CornerRow from(const auto& asked, const Corner& x) {
        return {{asked.body(x.a), asked.body(x.b), asked.body(x.c)}, x.stiffness, x.damping};
    }
    CornerConstraint<S> constraint(const auto& slot) const {
        using Scalar = typename S::Scalar;
        return {{slot(bodies[0]), slot(bodies[1]), slot(bodies[2])}, Scalar(stiffness), Scalar(damping)};
    }
};
struct Corners : ConstraintForce<Corner, CornerRow> {
    static constexpr std::string_view name = "Corners";
};
//! [corner]

struct Threads {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const {
        const std::size_t half = count / 2;
        std::thread other([&] { loop(0, half); });
        loop(half, count);
        other.join();
    }
};

template <class Scalar, int Dim, class... P> auto bars(const P&... policies) {
    return World{Space<Scalar, Dim>{}, Springs<>{}, Corners{}, policies...};
}
template <class World_> std::vector<Handle> add_corner(World_& world, double k, double c) {
    const auto at = [](double x, double y) {
        if constexpr (World_::S::dimension == 2) return position(metres(x, y));
        else return position(metres(x, y, 0));
    };
    std::vector<Handle> all{world.add(at(1, 0.4), mass(1.0 * kilogram)), world.add(at(0, 0), mass(2.0 * kilogram)),
                            world.add(at(0.3, 0.8), mass(0.7 * kilogram))};
    for (const std::size_t end : {0, 2}) world.add(Spring{all[1], all[end], 100.0 * N_per_m, 4.0 * N_s_per_m});
    world.add(Corner{all[0], all[1], all[2], k, c});
    return all;
}
double product(const auto& world, const std::vector<Handle>& all) {
    return double(
        dot(world.position(all[0]) - world.position(all[1]), world.position(all[2]) - world.position(all[1])).value());
}

} // namespace

TEST_CASE("A constraint that is written once is a force, and is held by every solver", "[soft_bodies]") {
    const auto settle = [](auto world) {
        const auto all = add_corner(world, 60, 4);
        CHECK(product(world, all) > 0.5);
        run(world, 600, 1.0 / 60);
        CHECK(world.status().ok());
        CHECK(total_momentum(world).value().norm() < 1e-5);
        return product(world, all);
    };
    CHECK(std::abs(settle(bars<double, 3>(SemiImplicitEuler{}))) < 1e-6);
    CHECK(std::abs(settle(bars<float, 2>(SemiImplicitEuler{}))) < 1e-5);
    CHECK(std::abs(settle(bars<double, 3>(SemiImplicitEuler{}, Xpbd{4, 2}))) < 1e-6);
    CHECK(std::abs(settle(bars<double, 3>(SemiImplicitEuler{}, VertexBlockDescent{1, 20}))) < 1e-6);
    CHECK(std::abs(settle(bars<double, 3>(ImplicitEuler{}))) < 1e-6);
}

TEST_CASE("Its force is minus the slope of its energy, and its damping takes what it should", "[soft_bodies]") {
    auto world = bars<double, 3>(SemiImplicitEuler{});
    const auto all = add_corner(world, 60, 0);
    CHECK(potential_energy(world).value() == Approx(0.5 * 60 * 0.62 * 0.62).epsilon(1e-12));
    auto stepped = world;
    stepped.step(1e-6 * second);
    for (const auto& body : all)
        for (int d = 0; d < 3; ++d) {
            const auto energy = [&](double by) {
                auto there = world;
                auto x = there.position(body).value();
                x[d] += by;
                there.set_position(body, Space<>::Position::from_value(x));
                return potential_energy(there).value();
            };
            const double force = stepped.velocity(body).value()[d] / 1e-6 * world.mass(body).value();
            CHECK(force == Approx(-(energy(1e-5) - energy(-1e-5)) / 2e-5).epsilon(1e-6).margin(1e-6));
        }
    // P = -c C'^2, with the springs' own taken out.
    auto damped = bars<double, 3>(SemiImplicitEuler{});
    const auto moving_ = add_corner(damped, 0, 5);
    for (const auto spring : damped.elements<Spring>().handles()) damped.remove(spring);
    damped.set_velocity(moving_[0], metres_per_second(0.2, -1, 0.3));
    damped.set_velocity(moving_[1], metres_per_second(1, 1, 1));
    const double before = product(damped, moving_), energy = total_energy(damped).value();
    damped.step(1e-6 * second);
    const double rate = (product(damped, moving_) - before) / 1e-6;
    CHECK((total_energy(damped).value() - energy) / 1e-6 == Approx(-5 * rate * rate).epsilon(1e-4));
}

TEST_CASE("Its derivative is that of its forces where it is kept", "[soft_bodies]") {
    auto world = bars<double, 3>(ImplicitEuler{});
    const auto all = add_corner(world, 60, 5);
    world.set_position(all[2], metres(-0.4, 1, 0.3)); // at right angles: what is left out is none
    REQUIRE(std::abs(product(world, all)) < 1e-15);
    Eigen::Matrix<double, 9, 9> by_x, by_v;
    by_x.setZero();
    by_v.setZero();
    const auto view = world.view<Corners>();
    Corners::In<Space<>>(Corners{}).jacobian(
        view, world.context().restricted<false>(), [&](std::size_t a, std::size_t b, const auto& x, const auto& v) {
            const auto put = [&](auto& into, const Eigen::Matrix3d& block) {
                into.template block<3, 3>(Eigen::Index(3 * a), Eigen::Index(3 * a)) += block;
                if (b == view.size()) return;
                into.template block<3, 3>(Eigen::Index(3 * b), Eigen::Index(3 * b)) += block;
                into.template block<3, 3>(Eigen::Index(3 * a), Eigen::Index(3 * b)) -= block;
                into.template block<3, 3>(Eigen::Index(3 * b), Eigen::Index(3 * a)) -= block.transpose();
            };
            put(by_x, x);
            put(by_v, v);
        });
    Eigen::Matrix<double, 9, 1> gradient;
    const Vector<double, 3> a(1, 0.4, 0), c(-0.4, 1, 0.3);
    gradient << c, -a - c, a;
    CHECK((by_x + 60 * gradient * gradient.transpose()).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((by_v + 5 * gradient * gradient.transpose()).cwiseAbs().maxCoeff() < 1e-12);
    for (const auto spring : world.elements<Spring>().handles()) world.remove(spring);
    const double exact = 60 * (c.squaredNorm() / 1 + (a + c).squaredNorm() / 2 + a.squaredNorm() / 0.7);
    CHECK(measured_stiffness(world).value() == Approx(exact).epsilon(1e-9));
    CHECK(stiffness_of(world).largest.value() >= exact);
}

TEST_CASE("One substep of Xpbd with it alone is the paper's formula", "[soft_bodies]") {
    auto world = bars<double, 3>(SemiImplicitEuler{}, Xpbd{1, 1});
    const auto all = add_corner(world, 60, 5);
    for (const auto spring : world.elements<Spring>().handles()) world.remove(spring);
    world.set_velocity(all[0], metres_per_second(0.5, 1, -2));
    const double h = 1.0 / 60;
    const std::array<double, 3> weight{1, 1 / 2.0, 1 / 0.7};
    std::array<Vector<double, 3>, 3> x, g;
    for (std::size_t i = 0; i < 3; ++i) x[i] = world.position(all[i]).value() + h * world.velocity(all[i]).value();
    const double value = CornerConstraint<Space<>>{{}, 60, 5}.linearise(x, g);
    const double way = h * g[0].dot(world.velocity(all[0]).value());
    double compliance = 0;
    for (std::size_t i = 0; i < 3; ++i) compliance += weight[i] * g[i].squaredNorm();
    const double change = -(h * h * 60 * value + h * 5 * way) / (1 + (h * h * 60 + h * 5) * compliance);
    world.step(h * second);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK((world.position(all[i]).value() - x[i] - weight[i] * change * g[i]).norm() < 1e-14);
}

TEST_CASE("One that was changed or removed between steps acts as it is now", "[soft_bodies]") {
    auto world = bars<double, 3>(SemiImplicitEuler{});
    const auto all = add_corner(world, 60, 0);
    for (const auto spring : world.elements<Spring>().handles()) world.remove(spring);
    const auto pushed = [&] {
        const auto before = world.velocity(all[0]).value();
        world.step(1e-6 * second);
        return (world.velocity(all[0]).value() - before).norm();
    };
    const double first = pushed();
    const auto corner = world.elements<Corner>().handles()[0];
    world.set(corner, Corner{all[0], all[1], all[2], 120, 0});
    CHECK(pushed() == Approx(2 * first).epsilon(1e-6));
    world.remove(corner);
    CHECK(pushed() == 0);
    world.add(Corner{all[0], all[1], all[2], 30, 0});
    CHECK(pushed() == Approx(first / 2).epsilon(1e-6));
}

TEST_CASE("Shared out among threads its forces are the same to the bit", "[soft_bodies]") {
    const auto fill = [](auto& world) {
        std::mt19937 random(4);
        std::uniform_real_distribution<double> number(-1, 1);
        std::vector<Handle> all;
        for (int i = 0; i < 300; ++i)
            all.push_back(world.add(position(metres(number(random), number(random), number(random))),
                                    mass((1.5 + number(random)) * kilogram)));
        for (std::size_t i = 0; i < 900; ++i)
            world.add(Corner{all[i % 300], all[(i * 7 + 1) % 300], all[(i * 11 + 5) % 300], 3, 0.1});
        world.remove(all[17]);
        return world;
    };
    auto serial = bars<double, 3>(SemiImplicitEuler{});
    auto divided = bars<double, 3>(SemiImplicitEuler{}, Threads{});
    fill(serial);
    fill(divided);
    run(serial, 20, 1e-3);
    run(divided, 20, 1e-3);
    CHECK(serial.hash() == divided.hash());
}
