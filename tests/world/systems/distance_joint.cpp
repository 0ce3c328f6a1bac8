// SPDX-License-Identifier: BSL-1.0
// What rods of a user's own do, of distance_joint.hpp.

#include "tests/world/systems/distance_joint.hpp"

#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <vector>

using namespace examples;

namespace {

template <class Scalar, class... More> auto world_of(const More&... more) {
    return World{Space<Scalar, 3>{},           SemiImplicitEuler{}, Gravity{}, SortAndSweep{},
                 Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{},    Rods{},    more...};
}
/// A nail at `height`, and `beads` that hang on each other, each 0.1 m to the side of the one before.
auto chain(auto& world, double height, int beads, double last_mass = 0.1) {
    std::vector<Handle> all{world.add(position(metres(0, height, 0)), shapeless, fixed)};
    for (int i = 1; i <= beads; ++i) {
        all.push_back(world.add(Sphere{0.03 * metre}, position(metres(0.1 * i, height, 0)),
                                mass((i == beads ? last_mass : 0.1) * kilogram)));
        world.add(Rod{all.back(), all[all.size() - 2], 0.1 * metre});
    }
    return all;
}
double longest_off(const auto& world, const std::vector<Handle>& all) {
    double most = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        most =
            std::max(most, std::abs(double(norm(world.position(all[i]) - world.position(all[i - 1])).value()) - 0.1));
    return most;
}
/// The time of the first half swing of a pendulum of 1 m from 0.1 rad, s.
double half_swing(double dt) {
    auto world = world_of<double>();
    const auto nail = world.add(position(metres(0, 5, 0)), shapeless, fixed);
    const auto bob =
        world.add(Sphere{0.1 * metre}, position(metres(std::sin(0.1), 5 - std::cos(0.1), 0)), mass(2.0 * kilogram));
    world.add(Rod{bob, nail, 1.0 * metre});
    double before = 0;
    for (int i = 0;; ++i) { // until it comes back: the velocity is zero between two steps
        world.step(dt * second);
        const double now = world.velocity(bob).value()[0];
        if (i > 2 && before < 0 && now >= 0) return dt * (i + before / (before - now));
        before = now;
    }
}

} // namespace

// At rest a soft row is a spring: it gives way by T / (m omega^2), with m the two masses in a row and omega twice
// 60 Hz, as for all that hangs on what is not moved.
const double omega = 2 * std::acos(-1.0) * 120;

TEST_CASE("A pendulum of a rod keeps its time", "[systems]") {
    const double length = 1 + 9.81 / (omega * omega), small = std::acos(-1.0) * std::sqrt(length / 9.81);
    const double exact = small * (1 + 0.01 / 16);
    const double coarse = std::abs(half_swing(1.0 / 60) - exact), fine = std::abs(half_swing(1.0 / 240) - exact);
    CHECK(coarse < 1e-5);
    CHECK(fine < coarse / 3);
}
TEMPLATE_TEST_CASE("Rods and contacts hold a chain that lies on the ground at rest", "[systems]", double, float) {
    auto world = world_of<TestType>(Drag{2.0 / second});
    world.add(Plane::ground(), fixed);
    const auto beads = chain(world, 0.6, 12);
    for (int i = 0; i < 1200; ++i) world.step(1.0 / 60 * second);
    for (const auto bead : beads) {
        CHECK(double(norm(world.velocity(bead)).value()) < 1e-3);
        CHECK(double(world.position(bead).value()[1]) > 0.029);
    }
    CHECK(longest_off(world, beads) < 0.6 * 9.81 / (0.05 * omega * omega)); // half of them hang
}
TEST_CASE("A chain holds a body of a hundred times the mass of its beads", "[systems]") {
    auto world = world_of<double>(Drag{2.0 / second});
    world.set(SoftSubsteps<>{.parts = 8}); // in four parts it swings on
    const auto beads = chain(world, 5, 8, 10.0);
    for (int i = 0; i < 1200; ++i) world.step(1.0 / 60 * second);
    CHECK(norm(world.velocity(beads.back())).value() < 1e-3);
    CHECK(longest_off(world, beads) == Approx(10.6 * 9.81 / (0.05 * omega * omega)).epsilon(1e-3));
}
TEST_CASE("A chain whose joint goes with a bead is two, and its impulses are saved with it", "[systems]") {
    auto world = world_of<double>();
    const auto beads = chain(world, 5, 6);
    for (int i = 0; i < 30; ++i) world.step(1.0 / 60 * second);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = world_of<double>();
    load(loaded, file);
    for (auto* one : {&world, &copy, &loaded}) {
        for (int i = 0; i < 30; ++i) one->step(1.0 / 60 * second);
        one->remove(beads[3]);
        for (int i = 0; i < 30; ++i) one->step(1.0 / 60 * second);
        CHECK(one->template elements<Rod>().size() == 4);
        CHECK(one->hash() == world.hash());
    }
}
