// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on implicit Euler (notes 1.6.2).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <complex>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using S = Space<double, 2>;

static_assert(SolvingIntegratorIn<exercise::ImplicitEuler, S>,
              "ImplicitEuler is no integrator that solves any more: keep role, writes, and solve(x, v, laws, dt), "
              "which answers a bool");

/// A spring with damping that becomes stiffer with the distance: a = -omega^2 (1 + |x|^2 / l^2) x - c v + push * part
/// of the step. Without the bend 1 / l^2 and the push it is linear.
struct Spring {
    double omega = 0, c = 0, bend = 0, push = 0; // in 1/s, 1/s, 1/m^2, m/s^2

    Eigen::Vector2d pull(const Eigen::Vector2d& x) const { return -omega * omega * (1 + bend * x.squaredNorm()) * x; }
    S::Acceleration operator()(const S::Position& x, const S::Velocity& v, double part) const {
        return S::Acceleration::from_value(pull(x.value()) - c * v.value() + Eigen::Vector2d(push * part, 0));
    }
    Jacobian<S> jacobian(const S::Position& position, const S::Velocity&, double) const {
        using ByPosition = decltype(Jacobian<S>::position);
        using ByVelocity = decltype(Jacobian<S>::velocity);
        const Eigen::Vector2d x = position.value();
        const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
        return {ByPosition::from_value(-omega * omega *
                                       ((1 + bend * x.squaredNorm()) * one + 2 * bend * x * x.transpose())),
                ByVelocity::from_value(-c * one)};
    }
};

struct Body {
    S::Position x = metres(1, -0.5);
    S::Velocity v = metres_per_second(2, 3);
    bool solved = false;
};
const auto dt = 0.05 * second;

Body after_one_step(const Spring& laws) {
    Body body;
    body.solved = exercise::ImplicitEuler::solve(body.x, body.v, laws, TimeStep<S>(dt, dt));
    return body;
}

/// v' = v - (omega^2 (x + v' dt) + c v') dt solved for v', by hand.
S::Velocity linear_answer(double omega, double c) {
    const Body start;
    const double h = 0.05;
    return (start.v - start.x * (omega * omega * h / second)) / (1 + c * h + omega * omega * h * h);
}

void expect_linear(const char* what, const Spring& laws) {
    const Body body = after_one_step(laws);
    std::ostringstream text;
    text << "the velocity after a step of 0.05 s, " << what << ", from (1, -0.5) m with (2, 3) m/s";
    // The place is rounded to 1e-16 m, which is 1e-15 m/s in a step; some tens of operations.
    expect_near(text.str(), body.v, linear_answer(laws.omega, laws.c), 1e-12 * metre_per_second,
                "For a linear force the equation has the answer v' = (v - omega^2 x dt) / (1 + c dt + omega^2 dt^2), "
                "and Newton's "
                "method finds it at once, however stiff the spring is.");
    expect(body.solved,
           text.str() +
               ": the velocity is right, but solve said that the equation was not solved.\n"
               "Answer true when a correction is rounding. With the right derivative that takes two or three.");
}

/// A spring without any solution, u = v + (u^2 / 1 m/s + 1 m/s) in a step of 1 s: the root of -3.
struct Hopeless {
    S::Acceleration operator()(const S::Position&, const S::Velocity& u, double) const {
        return metres_per_second_squared(x(u).value() * x(u).value() + 1, 0);
    }
    Jacobian<S> jacobian(const S::Position&, const S::Velocity& u, double) const {
        Eigen::Matrix2d m = Eigen::Matrix2d::Zero();
        m(0, 0) = 2 * x(u).value();
        return {{}, decltype(Jacobian<S>::velocity)::from_value(m)};
    }
};
bool hopeless_is_solved() {
    S::Position x = metres(0, 0);
    S::Velocity v = metres_per_second(0, 0);
    return exercise::ImplicitEuler::solve(x, v, Hopeless{}, TimeStep<S>(1.0 * second, 1.0 * second));
}

/// As a force of a world.
struct StiffSpring {
    using role = roles::Force;
    using reads = Columns<Position>;
    Parameter<unit::Frequency> omega = 100.0 / second;

    template <class Sp> struct In {
        Spring laws;
        explicit In(const StiffSpring& s) : laws{Quantity<unit::Frequency>(s.omega).value()} {}
        typename Sp::Acceleration acceleration(const typename Sp::Position& x, const auto&) const {
            return laws(x, {}, 1);
        }
        Jacobian<Sp> jacobian(const typename Sp::Position& x, const auto&) const { return laws.jacobian(x, {}, 1); }
    };
};

} // namespace

TEST_CASE("a soft spring", "[task-1][soft]") { expect_linear("omega dt = 0.25", {5}); }

TEST_CASE("a stiff spring, where every explicit method explodes", "[task-1][stiff]") {
    expect_linear("omega dt = 17.5", {350});
    expect_linear("omega dt = 1.5", {30});
}

TEST_CASE("a stiff damper", "[task-1][damper]") { expect_linear("c dt = 25", {5, 500}); }

TEST_CASE("a spring that is not linear", "[task-1][bent]") {
    const Spring laws{5, 0.5, 1};
    const Body start, body = after_one_step(laws);
    const S::Velocity right = start.v + laws(start.x + body.v * dt, body.v, 1) * dt;
    expect_agree(
        "a step on a spring that becomes stiffer with the distance", "your v'", body.v, "v + a(x', v') dt with that v'",
        right, 1e-12 * metre_per_second,
        "The new velocity must solve the equation itself: put it into a, and it must come out again. One correction is "
        "exact only\nwhere the force is linear; repeat it.");
}

TEST_CASE("the position moves with the velocity of the end", "[task-1][position]") {
    const Body start, body = after_one_step({5});
    const S::Position right = start.x + body.v * dt;
    expect_agree("the position after a step of 0.05 s", "your x'", body.x, "x + v' dt with your v'", right,
                 1e-12 * metre, "The position moves with the new velocity.");
}

TEST_CASE("the acceleration is that of the end of the step", "[task-1][end]") {
    const Body start;
    expect_near("the velocity after a step under a push that grows from 0 to 40 m/s^2 within it",
                after_one_step({0, 0, 0, 40}).v, start.v + metres_per_second_squared(40, 0) * dt,
                1e-12 * metre_per_second,
                "The third argument of laws says at which part of the step they are asked; the end is 1.0.");
}

TEST_CASE("it says when there is no solution", "[task-1][hopeless]") {
    expect(!hopeless_is_solved(),
           "u = v + a(u) dt with a dt = u^2 / (1 m/s) + 1 m/s and v = 0: solve said true, but no number solves this.\n"
           "After most_iterations corrections that were not rounding the answer is false.");
}

TEST_CASE("in a world, a stiff spring comes to rest as the scheme says", "[task-1][world]") {
    World world{S{}, exercise::ImplicitEuler{}, StiffSpring{}};
    const auto body = world.add(position(metres(1, 0)), velocity(metres_per_second(20, 0)));
    std::vector<double> yours, right;
    std::complex<double> z(1, 0.2);
    for (int n = 0; n <= 5; ++n) {
        if (n > 0) world.step(0.02 * second);
        yours.push_back(x(world.position(body)).value());
        right.push_back(z.real());
        z /= std::complex<double>(1, 2); // z = x + i v / omega turns by dz/dt = -i omega z
    }
    expect_path("where a mass on a spring is, omega dt = 2", "m", yours, right, 0.02, 1e-12,
                "Each step divides x + i v / omega by 1 + i omega dt: the motion fades, faster for longer steps.");
}

TEST_CASE("the energy of a spring falls by a factor in every step", "[task-2][energy-factor]") {
    for (const double omega : {0.5, 10.0, 350.0}) {
        Body body;
        auto energy = [&] { return squared_norm(body.v) + omega * omega * squared_norm(body.x) / (second * second); };
        const auto before = energy();
        body.v = linear_answer(omega, 0);
        body.x += body.v * dt;
        std::ostringstream what;
        what << "the energy after a step over that before, omega dt = " << omega * 0.05;
        expect_near(
            what.str(), exercise::energy_factor(omega / second, dt), double(energy() / before), 1e-12,
            "The method is explicit Euler seen from the end of the step: go back from there, and the energy grows by "
            "1 + (omega dt)^2.");
    }
}

std::vector<double> probe(int task) {
    if (task == 2)
        return {exercise::energy_factor(10.0 / second, 0.02 * second),
                exercise::energy_factor(3.0 / second, 0.5 * second)};
    std::vector<double> numbers{double(hopeless_is_solved())};
    for (const Spring& laws : {Spring{5}, Spring{30}, Spring{5, 500}, Spring{5, 0.5, 1}, Spring{0, 0, 0, 40}}) {
        const Body body = after_one_step(laws);
        numbers.insert(numbers.end(), {x(body.x).value(), y(body.x).value(), x(body.v).value(), y(body.v).value(),
                                       double(body.solved)});
    }
    return numbers;
}
