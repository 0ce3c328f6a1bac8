// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the conservation of momentum (notes 1.4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using exercise::Body;
using Velocity2 = VectorQuantity<unit::Velocity, 2>;

/// Two bodies that meet: along an axis, along a diagonal, light against heavy, one at rest, one overtaken.
struct TwoBodies {
    Body first, second;
};
const std::vector<TwoBodies>& meetings() {
    static const std::vector<TwoBodies> all = {
        {{1.0 * kilogram, metres_per_second(2, 0)}, {3.0 * kilogram, metres_per_second(-1, 0)}},
        {{5.0 * kilogram, metres_per_second(3, 3)}, {0.2 * kilogram, metres_per_second(1, 1)}},
        {{2.0 * kilogram, metres_per_second(0, 4)}, {7.0 * kilogram, metres_per_second(0, 0)}},
        {{4.0 * kilogram, metres_per_second(1, 6)}, {4.0 * kilogram, metres_per_second(1, -2)}},
    };
    return all;
}
const double restitutions[] = {0, 0.25, 0.5, 1};

std::string said(const TwoBodies& m, double e) {
    std::ostringstream text;
    text << m.first.mass << " with " << m.first.velocity << " meets " << m.second.mass << " with " << m.second.velocity
         << ", e = " << e;
    return text.str();
}
/// Calls `check(meeting, e, sentence)` for each meeting and each restitution.
template <class Check> void for_each_collision(Check&& check) {
    for (const auto& m : meetings())
        for (const double e : restitutions) check(m, e, said(m, e));
}
auto momentum_of(const Body& one, const Body& other) { return one.mass * one.velocity + other.mass * other.velocity; }
auto energy_of(const Body& one, const Body& other) {
    return 0.5 * one.mass * squared_norm(one.velocity) + 0.5 * other.mass * squared_norm(other.velocity);
}
TwoBodies moved(TwoBodies m, const Velocity2& by) {
    m.first.velocity += by;
    m.second.velocity += by;
    return m;
}

} // namespace

TEST_CASE("the sum of the momenta stays what it was", "[task-1][momentum]") {
    for_each_collision([](const TwoBodies& m, double e, const std::string& what) {
        const auto [one, other] = exercise::collide(m.first, m.second, e);
        expect_near(what + ": the momentum of both together", momentum_of(one, other), momentum_of(m.first, m.second),
                    1e-12 * kilogram_metre_per_second,
                    "At every e: one impulse acts on both, with opposite signs, and each velocity changes by it over "
                    "its own mass.");
    });
}

TEST_CASE("they separate with e times the speed at which they met", "[task-1][parting]") {
    for_each_collision([](const TwoBodies& m, double e, const std::string& what) {
        const auto [one, other] = exercise::collide(m.first, m.second, e);
        expect_near(what + ": the relative velocity after it, of the second as the first sees it",
                    other.velocity - one.velocity, e * (m.first.velocity - m.second.velocity), 1e-12 * metre_per_second,
                    "The relative velocity is a difference; it turns round and is multiplied by e. The impulse for "
                    "that has the factor 1 + e.");
    });
}

TEST_CASE("at e = 1 no energy is lost", "[task-1][elastic]") {
    for (const auto& m : meetings()) {
        const auto [one, other] = exercise::collide(m.first, m.second, 1);
        expect_near(said(m, 1) + ": the kinetic energy", energy_of(one, other), energy_of(m.first, m.second),
                    1e-12 * energy_of(m.first, m.second), "An elastic collision keeps the momentum and the energy.");
    }
}

TEST_CASE("seen from a train, it is the same collision", "[task-1][train]") {
    const auto train = metres_per_second(-3, 10);
    for_each_collision([&](const TwoBodies& m, double e, const std::string& what) {
        const auto ground = exercise::collide(m.first, m.second, e).first;
        const TwoBodies seen = moved(m, train);
        const auto train_sees = exercise::collide(seen.first, seen.second, e).first.velocity;
        const Velocity2 shifted = ground.velocity + train;
        expect_agree(what + ": the first body's velocity after it, when (-3, 10) m/s are added to every velocity",
                     "yours, added before the collision", train_sees, "yours, added after the collision", shifted,
                     1e-12 * metre_per_second,
                     "Seen from a train a collision is the same: only the difference of the two velocities counts.");
    });
}

TEST_CASE("which of the bodies is the first makes no difference", "[task-1][exchange]") {
    for_each_collision([](const TwoBodies& m, double e, const std::string& what) {
        const auto one = exercise::collide(m.first, m.second, e), other = exercise::collide(m.second, m.first, e);
        expect_agree(
            what + ": the velocity of the second after it", "yours, called in this order", one.second.velocity,
            "yours, with the two bodies swapped", other.first.velocity, 1e-12 * metre_per_second,
            "Which of them is called the first is no physics: what one feels, the other feels with the opposite sign.");
    });
}

TEST_CASE("the energy lost is the energy before minus the energy after", "[task-2][balance]") {
    for_each_collision([](const TwoBodies& m, double e, const std::string& what) {
        const auto [one, other] = mechanics::collide(m.first, m.second, e);
        expect_near(what + ": the energy lost", exercise::energy_lost(m.first, m.second, e),
                    energy_of(m.first, m.second) - energy_of(one, other), 1e-12 * energy_of(m.first, m.second),
                    "The energy of the relative motion is mu |u1 - u2|^2 / 2, and the speed in it falls to e times "
                    "what it was.");
    });
}

TEST_CASE("at e = 1 nothing is lost", "[task-2][nothing]") {
    for (const auto& m : meetings())
        expect_near(said(m, 1) + ": the energy lost", exercise::energy_lost(m.first, m.second, 1), 0.0 * joule,
                    1e-12 * joule, "An elastic collision keeps the energy.");
}

TEST_CASE("seen from a train, the same energy is lost", "[task-2][train-energy]") {
    for_each_collision([](const TwoBodies& m, double e, const std::string& what) {
        const TwoBodies seen = moved(m, metres_per_second(-3, 10));
        expect_agree(what + ": the energy lost", "yours, as it is", exercise::energy_lost(m.first, m.second, e),
                     "yours, with (-3, 10) m/s added to both velocities",
                     exercise::energy_lost(seen.first, seen.second, e), 1e-11 * joule,
                     "The dents are the same for everybody: the motion of both together loses nothing.");
    });
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    for_each_collision([&](const TwoBodies& m, double e, const std::string&) {
        if (task == 2) {
            numbers.push_back(exercise::energy_lost(m.first, m.second, e).value());
            return;
        }
        const auto [one, other] = exercise::collide(m.first, m.second, e);
        for (const Body& body : {one, other})
            // With its mass: who gives the bodies back in the other order makes no momentum out of nothing.
            numbers.insert(numbers.end(), {body.mass.value(), x(body.velocity).value(), y(body.velocity).value()});
    });
    return numbers;
}
