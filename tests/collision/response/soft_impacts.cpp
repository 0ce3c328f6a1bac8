// SPDX-License-Identifier: BSL-1.0
// Impacts within a substep: clusters that share no body come to what they come to alone (but for the last digits: all
// that meet in a round are solved in as many sweeps), and cost what they cost alone.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/response/soft_contacts.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace collision_tests;

namespace {

/// Balls of 1 m in rows along x; counts how often it is asked how far two are apart.
struct Rows : SoftContacts<Space<>, false> {
    using Base = SoftContacts<Space<>, false>;
    mutable std::size_t asked = 0;

    std::size_t awake() const { return bodies.size(); }
    double apart(const Constraint& c) const {
        ++asked;
        return Base::apart(c);
    }
    struct Ball {
        double mass, gap, speed, restitution; ///< kg; m, from the one before it; m/s; of its contact with that one
    };
    void add_row(const std::vector<Ball>& balls) {
        double x = 0;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            x += 1 + balls[i].gap;
            bodies.push_back({Eigen::Vector3d(balls[i].speed, 0, 0), Eigen::Vector3d(x, 0, 0), 1 / balls[i].mass});
            kicks.push_back(Eigen::Vector3d::Zero());
            if (i > 0) touch(bodies.size() - 2, bodies.size() - 1, balls[i].restitution);
        }
    }
    /// The second one is on the side of larger x.
    void touch(std::size_t a, std::size_t b, double restitution) {
        Constraint c{};
        c.slot_a = c.a = std::uint32_t(a);
        c.slot_b = c.b = std::uint32_t(b);
        c.normal = Eigen::Vector3d(-1, 0, 0);
        c.touching = 1;
        all.push_back(c);
        restitutions.push_back(restitution);
    }
    bool answer(double h) {
        weigh();
        for (std::uint32_t n = 0; n < all.size(); ++n) impacts.pairs.push_back({n, restitutions[n]});
        return impacts.answer(*this, h, 0.01);
    }
    std::vector<double> restitutions;
};

} // namespace

TEST_CASE("impacts of one row are the same beside many others", "[collision][impacts]") {
    test::Dice dice(11);
    std::size_t many_rounds = 0;
    for (int round = 0; round < 40; ++round) {
        std::vector<std::vector<Rows::Ball>> rows;
        for (int k = 0; k < 60; ++k) {
            auto& row = rows.emplace_back();
            for (int i = 0, balls = 2 + k % 6; i < balls; ++i)
                row.push_back(
                    {dice.one_in(4) ? 100.0 : dice.number(1.0, 3.0), dice.one_in(3) ? 0.0 : dice.number(0.0, 0.02),
                     dice.one_in(2) ? 0.0 : dice.number(-3.0, 3.0), dice.one_in(3) ? 0.0 : dice.number(0.2, 1.0)});
        }
        Rows together;
        for (const auto& row : rows) together.add_row(row);
        for (int k = 0; k < 2000; ++k) together.add_row({{1, 0, 0, 0}, {1, 0, 0, 0.5}}); // these lie still
        together.answer(0.01);
        std::size_t first = 0;
        for (const auto& row : rows) {
            Rows alone;
            alone.add_row(row);
            alone.answer(0.01);
            // At least one is asked for in a round; after 64 rounds a row alone would go on in the next substep.
            const bool ended = alone.asked < 64;
            many_rounds += ended && alone.asked > 3 * alone.all.size();
            for (std::size_t i = 0; ended && i < alone.bodies.size(); ++i) {
                INFO("ball " << i << " of a row of " << row.size());
                REQUIRE((together.bodies[first + i].u - alone.bodies[i].u).norm() < 1e-9);
                REQUIRE((together.bodies[first + i].position - alone.bodies[i].position).norm() < 1e-9);
            }
            first += alone.bodies.size();
        }
    }
    CHECK(many_rounds > 100); // rows whose balls meet again and again
}

TEST_CASE("a pair meets that has waited for one that never comes", "[collision][impacts]") {
    // The first ball would hit the second after 2 ms, and the third hits the second after 3; but after 1 ms a wall
    // throws the first one back.
    Rows rows;
    rows.add_row({{1, 0, 1, 0}, {1, 0.002, 0, 1}, {1, 0.003, -1, 1}});
    rows.add_row({{1e9, 0.001 + 1, 0, 0}});
    rows.touch(0, 3, 1);
    for (int k = 0; k < 100; ++k) rows.add_row({{1, 0, 0, 0}, {1, 0, 0, 0.5}}); // these lie still
    REQUIRE(rows.answer(0.01));
    const auto speed = [&](std::size_t ball) { return rows.bodies[ball].u.x(); };
    CHECK(std::abs(speed(0) + 1) < 1e-6);
    CHECK(std::abs(speed(1) + 1) < 1e-6);
    CHECK(std::abs(speed(2)) < 1e-6);
}

TEST_CASE("a pair that meets again and again does not cost the pairs that lie still", "[collision][impacts]") {
    // A grain between two heavy balls that come together; elsewhere balls that touch, and may bounce.
    const auto asked = [](int others) {
        Rows rows;
        rows.add_row({{1e4, 0, 3, 0}, {1, 0.001, 0, 0.9}, {1e4, 0.001, -3, 0.9}});
        for (int k = 0; k < others; ++k) rows.add_row({{1, 0, 0, 0}, {1, 0, 0, 0.5}});
        CHECK(rows.answer(0.01));
        return rows.asked;
    };
    const auto alone = asked(0), beside = asked(1000);
    CHECK(alone > 40);
    // All are looked at once or twice; the budget of rounds grows with the pairs, and each of those looks at two.
    CHECK(beside < alone + 2 * 1000 + 2 * (64 + 4 * 1002));
}
