// SPDX-License-Identifier: BSL-1.0
// A filter that reads the springs: what is joined does not collide, and every other body does.

#include <ansatz/collision.hpp>
#include <ansatz/soft_bodies/unjoined.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/support.hpp"

#include <map>
#include <random>
#include <set>
#include <sstream>

using namespace soft_tests;

namespace {

constexpr double radius = 0.06, reach = 2 * radius; // m; the threads of a sheet are 0.1 m long

template <class... Filter> auto world_of(const Filter&... filter) {
    return World{SemiImplicitEuler{},   Gravity{}, Springs{},    Drag{1.0 / second}, SortAndSweep{},
                 Narrowphase<Sphere>{}, Impulse{}, Projection{}, filter...};
}
template <class World_> auto pairs_in_contact(const World_& world) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const auto& contact : world.contacts()) all.insert(std::minmax(contact.first.id, contact.second.id));
    return all;
}

} // namespace

TEST_CASE("a sheet whose particles overlap lies still: its threads do not push each other", "[soft_bodies][contact]") {
    const auto strain_after_a_second = []<class World_>(World_ world) {
        world.set(Gravity{metres_per_second_squared(0, 0, 0)});
        Cloth cloth = woven(5, 5);
        for (auto* kind : {&cloth.structural, &cloth.shear, &cloth.bend}) kind->stiffness = 5.0 * N_per_m;
        const auto parts = add_cloth(world, cloth, Sphere{radius * metre}, restitution(0.0));
        run(world, 200, 0.005);
        CHECK(world.status().ok());
        double most = 0;
        for (std::size_t v = 0; v < parts.bodies.size(); ++v)
            most = std::max(most, norm(world.position(parts.bodies[v]) - cloth.mesh.vertices()[v]).value());
        return most;
    };
    CHECK(strain_after_a_second(world_of(Unjoined<Springs<>>{})) == 0);
    CHECK(strain_after_a_second(world_of()) > 0.01);
}

TEST_CASE("it tests every pair but those that a spring joins now, whatever was added and removed before",
          "[soft_bodies][contact]") {
    std::mt19937 random(11);
    const auto below = [&](std::size_t n) { return std::size_t(random()) % n; };
    auto world = world_of(Unjoined<Springs<>>{});
    world.set(Gravity{metres_per_second_squared(0, 0, 0)});
    std::vector<Handle> bodies;
    std::vector<decltype(metres(0, 0, 0))> homes;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<SpringHandle>> joined;
    std::size_t tested = 0, kept_apart = 0;
    for (int i = 0; i < 600; ++i) {
        const auto what = below(10);
        if (what < 3 || bodies.size() < 4) {
            homes.push_back(metres(1e-3 * double(below(500)), 1e-3 * double(below(300)), 1e-3 * double(below(300))));
            bodies.push_back(world.add(position(homes.back()), mass(1.0 * kilogram), Sphere{radius * metre}));
        } else if (what < 7) {
            const auto a = bodies[below(bodies.size())], b = bodies[below(bodies.size())];
            if (a != b)
                joined[std::minmax(a.id, b.id)].push_back(world.add(Spring{a, b, 0.0 * N_per_m, 0.0 * N_s_per_m}));
        } else if (what < 9 && !joined.empty()) {
            auto one = std::next(joined.begin(), std::ptrdiff_t(below(joined.size())));
            world.remove(one->second.back());
            one->second.pop_back();
            if (one->second.empty()) joined.erase(one);
        } else if (bodies.size() > 12) {
            const auto n = below(bodies.size());
            const auto id = bodies[n].id;
            std::erase_if(joined, [&](const auto& pair) { return pair.first.first == id || pair.first.second == id; });
            world.remove(bodies[n]);
            bodies.erase(bodies.begin() + std::ptrdiff_t(n));
            homes.erase(homes.begin() + std::ptrdiff_t(n));
        }
        for (std::size_t n = 0; n < bodies.size(); ++n) { // the step separates them
            world.set_position(bodies[n], homes[n]);
            world.set_velocity(bodies[n], metres_per_second(0, 0, 0));
        }
        if (i % 3 == 0) world = decltype(world)(world); // a copy knows nothing yet
        world.step(1e-9 * second);
        const auto found = pairs_in_contact(world);
        for (std::size_t a = 0; a < bodies.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const auto pair = std::minmax(bodies[a].id, bodies[b].id);
                const double apart = (homes[a].value() - homes[b].value()).norm();
                if (joined.count(pair) > 0) {
                    kept_apart += apart < reach;
                    if (found.count(pair) > 0) FAIL_CHECK("a pair is joined, and was tested");
                } else if (apart > 0 && apart < 0.9 * reach) { // in one place they have no normal
                    ++tested;
                    if (found.count(pair) == 0) FAIL_CHECK("a pair is not joined, and was not tested");
                }
            }
    }
    CHECK(tested > 1000);
    CHECK(kept_apart > 100);
}

TEST_CASE("a rope that falls on itself lies on itself, as in its copy and the loaded world", "[soft_bodies][contact]") {
    auto world = world_of(Unjoined<Springs<>>{});
    const auto add = [&](double x, double y) {
        return world.add(position(metres(x, y, 0.001 * x)), mass(0.02 * kilogram), Sphere{radius * metre},
                         restitution(0.0));
    };
    for (int i = 0; i < 16; ++i) // a shelf
        world.add(position(metres(0.1 * i, 0, 0)), fixed, Sphere{radius * metre}, restitution(0.0));
    std::vector<Handle> rope;
    for (int i = 0; i < 12; ++i) rope.push_back(add(0.2 + 0.1 * i, 0.125));
    rope.push_back(add(1.35, 0.21)); // where it turns
    for (int i = 11; i >= 0; --i) rope.push_back(add(0.2 + 0.1 * i, 0.4));
    for (std::size_t i = 1; i < rope.size(); ++i)
        world.add(Spring{rope[i - 1], rope[i], 400.0 * N_per_m, 0.5 * N_s_per_m});
    auto copy = world;
    double nearest = 1;
    for (int i = 0; i < 600; ++i) {
        world.step(1.0 / 480 * second);
        for (std::size_t a = 0; a < rope.size(); ++a)
            for (std::size_t b = 0; b + 1 < a; ++b)
                nearest = std::min(nearest, norm(world.position(rope[a]) - world.position(rope[b])).value());
    }
    CHECK(world.status().ok());
    CHECK(nearest > 0.9 * reach); // one above the other, never through each other
    run(copy, 100, 1.0 / 480);
    std::stringstream file;
    save(copy, file);
    auto loaded = world_of(Unjoined<Springs<>>{});
    load(loaded, file);
    for (auto* one : {&copy, &loaded}) run(*one, 500, 1.0 / 480);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    // A query from outside is joined to no body.
    std::vector<Handle> overlapped;
    world.query().overlap(Sphere{0.01 * metre}, world.position(rope[3]), overlapped);
    CHECK(std::find(overlapped.begin(), overlapped.end(), rope[3]) != overlapped.end());
}
