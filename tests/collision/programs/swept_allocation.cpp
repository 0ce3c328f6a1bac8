// SPDX-License-Identifier: BSL-1.0
// A warm world with Swept, full of impacts, and its queries. The script of this name says what it shows.
#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include "tests/operator_new.hpp"
#include <cmath>
#include <cstdio>
#include <cstdlib>

/// While this holds, an allocation ends the program.
static bool forbidden = false;
static bool allowed(std::size_t) noexcept {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    return true;
}

using namespace ansatz;

/// The same step from the same snapshot, again and again: contacts that sleep in it and wake, in lists that change
/// places with each other.
static void roll_back() {
    World world{ImplicitEuler{}, Space<float, 2>{},   Gravity{},   Rest{}, Swept<Narrowphase<Sphere, Plane>>{},
                AllPairs{},      Impulse<Friction>{}, Projection{}};
    world.add(Plane{Eigen::Vector3d(0, 1, 0), 0.0 * metre}, fixed, friction(0.5));
    const auto add = [&](double radius, double x, const auto&... more) {
        return world.add(Sphere{radius * metre}, position(metres(x, 0)), mass(1.0 * kilogram), friction(0.5), more...);
    };
    add(0.5, 0, resting);
    add(0.5, 3);
    world.step(1.0 * second);
    add(1, 0);
    world.step(0.02 * second);
    const auto snapshot = world;
    for (int again = 0; again < 8; ++again) {
        forbidden = again > 0;
        world.step(0.5 * second);
        world = snapshot;
        forbidden = false;
    }
}

int main() {
    test::before_allocation = allowed;
    roll_back();
    World world{SemiImplicitEuler{}, Gravity{},      Impulse<>{},
                Projection{},        SortAndSweep{}, Swept<Narrowphase<Sphere, Plane, Box>>{}};
    for (int k = 0; k < 3; ++k)
        for (const int side : {-1, 1}) {
            Eigen::Vector3d n = Eigen::Vector3d::Zero();
            n[k] = -side;
            world.add(Plane{n, -10.0 * metre}, fixed);
        }
    world.add(Box{metres(2, 0.05, 2)}, fixed);
    for (int i = 0; i < 300; ++i) {
        const auto wave = [&](double by) { return std::sin(by * (i + 1)); };
        world.add(Sphere{0.3 * metre}, position(metres(9 * wave(1.1), 9 * wave(1.7), 9 * wave(2.3))),
                  velocity(metres_per_second(150 * wave(3.1), 150 * wave(3.7), 150 * wave(4.3))), mass(1.0 * kilogram),
                  restitution(1));
    }
    std::vector<RayHit<Space<>>> hits;
    std::vector<Handle> bodies;
    hits.reserve(400), bodies.reserve(400);
    std::size_t contacts = 0, asked = 0;
    for (int step = 0; step < 900; ++step) {
        forbidden = step >= 600; // by then its lists are as long as they get
        world.step(1.0 / 60 * second);
        const Ray ray{metres(-10, 0.1 * (step % 9), 0), Eigen::Vector3d(1, 0, 0)};
        world.query().all(ray, hits);
        asked += hits.size() + std::size_t(world.query().closest(ray).has_value());
        world.query().overlap(Sphere{3.0 * metre}, metres(0, 3, 0), bodies, with_sensors);
        asked += bodies.size();
        contacts += world.contacts().size();
        forbidden = false;
    }
    if (contacts < 10000 || asked < 2000) std::puts("little happens: the case has lost its point"), std::exit(1);
    std::printf("%zu contacts, %zu answers: nothing allocated\n", contacts, asked);
}
