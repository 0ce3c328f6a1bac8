// SPDX-License-Identifier: BSL-1.0

// What docs/collision.md shows and says beside the sections' programs, so that it is compiled and true.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

using namespace collision_tests;

namespace {
constexpr double dt = 1.0 / 60; // s

/// How deep a contact of a column is in the end and was at most, m, the one with the ground included, and whether all
/// fell asleep.
struct Sunk {
    double in_the_end = 0, at_most = 0;
    bool asleep = false;
};
/// Spheres of 1 kg, the one on top of another mass, that begin with gaps of 1 cm.
template <class... Response> Sunk sunk(int n, double top, int steps, Response... response) {
    auto world = world_of(SemiImplicitEuler{}, Gravity{}, Rest{}, response...);
    world.add(Plane::ground(), fixed);
    std::vector<Handle> bodies;
    for (int i = 0; i < n; ++i)
        bodies.push_back(
            world.add(Sphere{0.5 * metre}, at<Space<>>(0, 0.51 + 1.01 * i), mass((i + 1 < n ? 1.0 : top) * kilogram)));
    Sunk result;
    for (int i = 0; i < steps; ++i) {
        world.step(dt * second);
        double below = -0.5;
        result.in_the_end = 0;
        for (const auto body : bodies) {
            const double y = height_of(world, body);
            result.in_the_end = std::max(result.in_the_end, 1 - (y - below));
            below = y;
        }
        result.at_most = std::max(result.at_most, result.in_the_end);
    }
    result.asleep = world.count(Motion::resting) == std::size_t(n);
    return result;
}
} // namespace

TEST_CASE("what the page shows: walls keep a ball in a room, and a lift carries what lies on it", "[collision]") {
    //! [room]
    World room{SemiImplicitEuler{}, Gravity{}, SortAndSweep{}, Narrowphase<Sphere, Box, Plane>{}, SoftSubsteps{}};
    room.add(Plane::ground(), fixed);
    room.add(Plane{Eigen::Vector3d(1, 0, 0), -4.0 * metre}, fixed);              // the wall at x = -4 m; it faces right
    room.add(Plane{Eigen::Vector3d(-1, 0, 0), -4.0 * metre}, fixed);             // the wall at x = 4 m; it faces left
    room.add(Plane::through(metres(2, 0, 0), Eigen::Vector3d(-1, 2, 0)), fixed); // a slope that rises from x = 2 m
    //! [room]
    const auto ball = room.add(Sphere{0.25 * metre}, position(metres(0, 0.25, 3)), mass(1.0 * kilogram),
                               velocity(metres_per_second(3, 0, 0)));
    //! [lift]
    const auto lift = room.add(Box{metres(1, 0.1, 1)}, position(metres(0, 0.1, 0)), moving);
    const auto crate = room.add(Box{metres(0.4, 0.4, 0.4)}, position(metres(0, 0.6, 0)), mass(10.0 * kilogram));
    room.set_velocity(lift, metres_per_second(0, 0.5, 0)); // up
    for (int i = 0; i < 120; ++i) room.step(1.0 / 60 * second);
    room.set_velocity(lift, metres_per_second(0, 0, 0)); // and stop, 1 m higher
    //! [lift]
    CHECK(std::abs(height_of(room, lift) - 1.1) <= 1e-9);
    CHECK(std::abs(height_of(room, crate) - 1.6) <= 0.01);
    double highest = 0, left = 0, right = 0;
    for (int i = 0; i < 600; ++i) {
        room.step(dt * second);
        highest = std::max(highest, height_of(room, ball));
        left = std::min(left, x_of(room, ball));
        right = std::max(right, x_of(room, ball));
    }
    CHECK(std::abs(height_of(room, lift) - 1.1) <= 1e-9);
    CHECK(std::abs(height_of(room, crate) - 1.6) <= 0.01);
    INFO(left << " m to " << right << " m, up to " << highest << " m");
    CHECK(left >= -3.76);
    CHECK(right <= 3.76);
}

TEST_CASE("R4: how deep a heavy sphere lies in a light one, as the page has it", "[collision][piles]") {
    const SoftSubsteps<> by_default, twice{.parts = 8, .frequency = 120.0 * hertz},
        fourfold{.parts = 16, .frequency = 240.0 * hertz};
    for (const auto& [heavy, f60, f120, f240] :
         {std::tuple(1.0, 0.00014, 0.00004, 0.00001), std::tuple(10.0, 0.00076, 0.00019, 0.00005),
          std::tuple(100.0, 0.0067, 0.0018, 0.00044)}) {
        INFO(heavy << ":1");
        CHECK(sunk(2, heavy, 600, by_default).in_the_end == Approx(f60).epsilon(0.15));
        CHECK(sunk(2, heavy, 600, twice).in_the_end == Approx(f120).epsilon(0.15));
        CHECK(sunk(2, heavy, 600, fourfold).in_the_end == Approx(f240).epsilon(0.15));
    }
    CHECK(sunk(2, 1000, 600, twice).in_the_end == Approx(0.0176).epsilon(0.15));
    CHECK(sunk(2, 1000, 600, fourfold).in_the_end == Approx(0.0044).epsilon(0.15));
    for (const int n : {3, 6, 11}) {
        INFO(n);
        CHECK(sunk(n, 1000, 1200, fourfold).in_the_end <= 0.01); // twice as deep in the light one below as in the pair
    }
    for (const double heavy : {1.0, 10.0, 100.0, 1000.0})
        CHECK(sunk(2, heavy, 600, Impulse<>{}, Projection{}).at_most <= 1e-6);
    CHECK(sunk(6, 1000, 600, Impulse<>{}, Projection{}).in_the_end <= 1e-6);
    const auto on_twenty = sunk(21, 1000, 1200, Impulse<>{}, Projection{});
    CHECK(on_twenty.in_the_end <= 1e-6);
    CHECK(on_twenty.at_most <= 0.005);
}

TEST_CASE("R5: columns of one mass fall asleep, as deep as the page says", "[collision][rest]") {
    for (const auto& [n, depth] : {std::pair(5, 0.00055), std::pair(10, 0.0012), std::pair(20, 0.0026),
                                   std::pair(40, 0.0054), std::pair(80, 0.0109)}) {
        INFO(n);
        const auto column = sunk(n, 1, n < 80 ? 600 : 900, SoftSubsteps<>{});
        CHECK(column.asleep);
        CHECK(column.in_the_end == Approx(depth).epsilon(0.05));
    }
    for (const int n : {2, 5, 10}) {
        INFO(n);
        CHECK(sunk(n, 1, 600, Impulse<>{}, Projection{.slop = 0.001 * metre}).asleep);
    }
    // Columns that the sweeps do not hold at once do not fall into themselves.
    CHECK(sunk(40, 1, 1200, Impulse<>{}, Projection{}).at_most <= 0.02);
    CHECK(sunk(80, 1, 1200, Impulse<>{}, Projection{}).at_most <= 0.25);
}
