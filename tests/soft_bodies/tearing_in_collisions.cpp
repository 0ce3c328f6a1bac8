// SPDX-License-Identifier: BSL-1.0
// Vertices that split in a world of collisions: which bodies the new ones touch, by testing all pairs; that what lay
// still lies still; copies and files; what a user keeps of each body; that a warm step allocates nothing.

#include <ansatz/collision.hpp>
#include <ansatz/motion/integrators/matrix_free.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/soft_bodies/unjoined.hpp>
#include <ansatz/world/save.hpp>

#include "tests/before_allocation.hpp"
#include "tests/soft_bodies/letting_go.hpp"
#include "tests/soft_bodies/support.hpp"

#include <map>
#include <random>
#include <set>
#include <sstream>
#include <utility>

using namespace soft_tests;

namespace {

constexpr double radius = 0.06; // m, more than half of what lies between two vertices

auto colliding(int room) {
    World world{SemiImplicitEuler{},  Gravity{},      Springs<Breaking>{},           Tearing<Splitting>{.room = room},
                Datum<std::string>{}, SortAndSweep{}, Unjoined<Springs<Breaking>>{}, Narrowphase<Sphere, Plane>{},
                Impulse<>{}};
    world.add(Plane::ground(), fixed, restitution(0), datum(std::string("ground")));
    return world;
}
auto resting_in_parts() {
    World world{SemiImplicitEuler{},
                Gravity{},
                Springs<Breaking>{},
                Tearing<Splitting>{.room = 200},
                Rest{.time = 1e6 * second}, // no body sleeps until it is told
                SortAndSweep{},
                Unjoined<Springs<Breaking>>{},
                Narrowphase<Sphere, Plane>{},
                SoftSubsteps<Friction>{}};
    world.add(Plane::ground(), fixed, restitution(0), friction(0.5));
    return world;
}
Cloth level(std::size_t n, std::size_t m, double height) {
    auto cloth = woven(n, m);
    cloth.mesh = TriangleMesh::grid(n, m, metres(0.1 * double(n - 1), 0, 0), metres(0, 0, 0.1 * double(m - 1)),
                                    metres(0, height, 0));
    return cloth;
}
template <class World_> ClothParts lay(World_& world, std::size_t n, std::size_t m, double height, auto&&... property) {
    return add_cloth(world, level(n, m, height), Sphere{radius * metre}, restitution(0), property...);
}
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;
std::pair<std::uint32_t, std::uint32_t> pair_of(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}
/// Which bodies lie in each other, but for those that a spring joins.
template <class World_> Pairs overlaps(const World_& world) {
    Pairs all, joined;
    for (const auto spring : world.template elements<Spring>().handles()) {
        const auto one = world.get(spring);
        joined.insert(pair_of(one.first.body().id, one.second.body().id));
    }
    const auto bodies = world.handles();
    for (const Handle a : bodies)
        for (const Handle b : bodies) {
            if (a.id >= b.id || joined.count({a.id, b.id}) > 0) continue;
            if (world.motion(a) == Motion::fixed) { // the ground
                if (world.position(b).value()[1] < radius) all.insert({a.id, b.id});
            } else if (norm(world.position(a) - world.position(b)).value() < 2 * radius) all.insert({a.id, b.id});
        }
    return all;
}
template <class World_> Pairs contacts_of(const World_& world) {
    Pairs all;
    for (const auto& c : world.contacts()) {
        CHECK(c.first.id < c.second.id);
        all.insert({c.first.id, c.second.id});
    }
    CHECK(all.size() == world.contacts().size());
    return all;
}
/// Which bodies were one and have not been apart, as sets.
struct Were {
    std::vector<std::set<std::uint32_t>> groups;
    void part(const Pairs& meet) {
        for (auto& group : groups)
            for (const auto id : std::set<std::uint32_t>(group)) {
                bool lies = false;
                for (const auto other : group) lies = lies || meet.count(pair_of(id, other)) > 0;
                if (!lies) group.erase(id);
            }
    }
    void divided(std::uint32_t id, std::uint32_t part) {
        for (auto& group : groups)
            if (group.count(id) > 0) {
                group.insert(part);
                return;
            }
        groups.push_back({id, part});
    }
    bool one(std::uint32_t a, std::uint32_t b) const {
        for (const auto& group : groups)
            if (group.count(a) > 0 && group.count(b) > 0) return true;
        return false;
    }
};

std::size_t allocations = 0;
bool count_one(std::size_t) noexcept {
    ++allocations;
    return true;
}
/// A sheet is pressed together, so that there are more contacts than ever after, and spread again; then it tears.
template <class World_> void tear_when_warm(World_ world) {
    auto copy = world;
    for (World_* one : {&world, &copy}) {
        std::vector<VectorQuantity<unit::Length>> places;
        for (const Handle body : one->handles()) places.push_back(one->position(body));
        const auto spread = [&](double by) { // over the ground, which is the first body
            const auto bodies = one->handles();
            for (std::size_t i = 1; i < bodies.size(); ++i) {
                one->set_position(bodies[i], metres(by * places[i].value()[0], 0.05, by * places[i].value()[2]));
                one->set_velocity(bodies[i], metres_per_second(0, 0, 0));
            }
        };
        std::size_t most = 0, later = 0;
        for (const double by : {0.2, 0.2, 0.2, 0.2, 1.0}) {
            spread(by);
            for (int i = 0; i < 6; ++i) {
                one->step(2e-3 * second);
                most = std::max(most, one->contacts().size());
            }
        }
        CHECK(one->tearing().split == 0);
        std::mt19937 random(8);
        allocations = 0;
        for (int i = 0; i < 60; ++i) {
            let_some_go(*one, random, 2);
            ansatz::test::before_allocation = count_one;
            one->step(2e-3 * second);
            ansatz::test::before_allocation = nullptr;
            later = std::max(later, one->contacts().size());
        }
        CHECK(allocations == 0);
        CHECK(one->tearing().split > 10);
        CHECK(later > 10);
        CHECK(later < most); // or the lists of contacts would grow
    }
}

} // namespace

TEST_CASE(
    "Random tears among collisions: each part has the shape, the datum and the contacts of whom it comes from, and "
    "collides with it once they have been apart",
    "[soft_bodies][tearing][contact]") {
    std::size_t split = 0, left_alone = 0, met_again = 0;
    for (const unsigned seed : {1U, 2U, 3U}) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> push(-1.5, 1.5);
        auto world = colliding(300);
        const auto parts = lay(world, 7, 6, 0.05);
        for (std::size_t v = 0; v < parts.bodies.size(); ++v) {
            world.datum(parts.bodies[v]) = "a vertex with a long name, number " + std::to_string(v);
            const double x = push(random), y = push(random), z = push(random);
            world.set_velocity(parts.bodies[v], metres_per_second(x, y, z));
        }
        Were were;
        std::vector<std::pair<Handle, Handle>> ever;
        const double mass = mass_of_all(world);
        for (int i = 0; i < 150; ++i) {
            let_some_go(world, random, i % 4 == 0 ? 2 : 0);
            world.step(2e-3 * second);
            // The contacts were found before any body split: of those that were there, and by no spring that broke
            // since.
            std::set<std::uint32_t> fresh;
            for (const auto& [from, to] : world.split_vertices()) fresh.insert(to.id);
            Pairs meet = overlaps(world);
            Pairs known = contacts_of(world);
            Pairs expected = meet;
            for (const auto& broken : world.elements<Spring>().broken())
                expected.erase(pair_of(broken.first.body().id, broken.second.body().id));
            std::erase_if(expected, [&](const auto& p) { return fresh.count(p.first) + fresh.count(p.second) > 0; });
            std::erase_if(known, [&](const auto& p) { return fresh.count(p.first) + fresh.count(p.second) > 0; });
            were.part(meet);
            for (auto it = expected.begin(); it != expected.end();)
                if (were.one(it->first, it->second)) it = expected.erase(it), ++left_alone;
                else ++it;
            // Where elements changed in this very step, the springs of before are not known here any more.
            if (world.split_vertices().empty() && world.elements<Spring>().broken().empty()) REQUIRE(known == expected);
            for (const auto& [from, to] : world.split_vertices()) {
                were.divided(from.id, to.id);
                ever.emplace_back(from, to);
                ++split;
                CHECK(world.datum(to) == world.datum(from));
                CHECK(world.datum(to) != "");
                int shapes = 0;
                world.visit_shape(to, [&](const auto& shape) {
                    if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Sphere>)
                        shapes += shape.radius.value() == radius;
                });
                CHECK(shapes == 1);
                for (const auto& c : world.contacts()) {
                    if (!(c.first == from) && !(c.second == from)) continue;
                    const Handle other = c.first == from ? c.second : c.first;
                    if (fresh.count(other.id) > 0) continue;
                    bool same = false;
                    for (const auto& d : world.contacts()) {
                        if (!((d.first == to && d.second == other) || (d.second == to && d.first == other))) continue;
                        const double sign = (d.first == to) == (c.first == from) ? 1 : -1;
                        same = d.normal == sign * c.normal && d.depth == c.depth && d.steps == c.steps;
                    }
                    CHECK(same);
                }
            }
            REQUIRE(mass_of_all(world) == Approx(mass).epsilon(1e-12));
        }
        CHECK(world.status().ok());
        for (const auto& siblings : ever) { // out of each other and in again they are two bodies like all others
            const Handle one = siblings.first, other = siblings.second;
            const auto put = [&](double x, double y, double apart) {
                world.set_position(one, metres(x, y, 0));
                world.set_position(other, metres(x + apart, y, 0));
                for (const Handle body : {one, other}) world.set_velocity(body, metres_per_second(0, 0, 0));
                world.step(1e-5 * second);
                return contacts_of(world).count(pair_of(one.id, other.id));
            };
            CHECK(put(5, 3, 0.5) == 0);
            CHECK(put(5, 3, 0.05) == 1);
            ++met_again;
            put(20 + double(met_again), 3, 0.5);
        }
    }
    CHECK(split > 20);
    CHECK(left_alone > 100); // or nothing was tested
    CHECK(met_again > 0);
}

TEST_CASE("A sheet that lies on the ground lies still while its vertices split, awake or asleep",
          "[soft_bodies][tearing][contact]") {
    for (const bool sleeps : {false, true}) {
        auto world = resting_in_parts();
        if (sleeps) world.set(Rest{});
        lay(world, 6, 5, radius, friction(0.5));
        run(world, 240, 1.0 / 60);
        const auto asleep = [&] {
            std::size_t count = 0;
            for (const Handle body : world.handles()) count += world.motion(body) == Motion::resting;
            return count;
        };
        CHECK(asleep() == (sleeps ? 30 : 0));
        std::mt19937 random(7);
        double speed = 0, lowest = 1, highest = 0;
        std::size_t split = 0;
        for (int i = 0; i < 150; ++i) {
            if (i < 90 && i % 3 == 0) let_some_go(world, random, 2);
            world.step(1.0 / 60 * second);
            split += world.split_vertices().size();
            for (const Handle body : world.handles()) {
                if (world.motion(body) == Motion::fixed) continue;
                speed = std::max(speed, std::abs(double(world.velocity(body).value()[1])));
                lowest = std::min(lowest, double(world.position(body).value()[1]));
                highest = std::max(highest, double(world.position(body).value()[1]));
            }
        }
        CAPTURE(sleeps, split, speed, lowest - radius, highest - radius);
        CHECK(split > 4);
        CHECK(world.status().ok());
        CHECK(speed < 1e-4); // a step of gravity is 0.16 m/s
        CHECK(highest - lowest < 1e-4);
    }
}

TEST_CASE("Copies and worlds from files go on bit for bit where vertices split among collisions",
          "[soft_bodies][tearing][contact]") {
    std::mt19937 random(8);
    auto world = colliding(60);
    lay(world, 9, 8, 0.05);
    for (int i = 0; i < 20; ++i) {
        let_some_go(world, random, 2);
        world.step(2e-3 * second);
    }
    const auto early = world.tearing().split;
    REQUIRE(early > 3);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = colliding(60);
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    auto same = random, again = random;
    for (int i = 0; i < 60; ++i) {
        if (i % 2 == 0) {
            let_some_go(world, random, 3);
            let_some_go(copy, same, 3);
            let_some_go(loaded, again, 3);
        }
        for (auto* one : {&world, &copy, &loaded}) one->step(2e-3 * second);
        REQUIRE(copy.hash() == world.hash());
        REQUIRE(loaded.hash() == world.hash());
    }
    CHECK(world.tearing().split > early);
    for (const Handle body : world.handles()) CHECK(world.datum(body) == copy.datum(body));
}

TEST_CASE("A warm step allocates nothing where vertices split among collisions", "[soft_bodies][tearing][contact]") {
    allocations = 0;
    ansatz::test::before_allocation = count_one;
    std::vector<int>(3).at(0) = 1;
    ansatz::test::before_allocation = nullptr;
    REQUIRE(allocations > 0); // the count counts
    auto struck = colliding(300);
    lay(struck, 9, 8, 0.05);
    tear_when_warm(struck);
    auto held = resting_in_parts();
    lay(held, 9, 8, 0.05);
    tear_when_warm(held);
    World pushed{SemiImplicitEuler{},
                 Gravity{},
                 Springs<Breaking>{},
                 Tearing<Splitting>{.room = 300},
                 UniformGrid<SortAndSweep>{},
                 Swept<Narrowphase<Sphere, Plane>>{},
                 Penalty{20.0 * newton_per_metre, 0.01 * newton_second_per_metre}};
    pushed.add(Plane::ground(), fixed);
    add_cloth(pushed, level(9, 8, 0.05), Sphere{radius * metre});
    tear_when_warm(pushed);
    World solved{ImplicitEulerBy<MatrixFree>{},   Gravity{},      Springs<Breaking>{},
                 Tearing<Splitting>{.room = 300}, SortAndSweep{}, Unjoined<Springs<Breaking>>{},
                 Narrowphase<Sphere, Plane>{},    Impulse<>{}};
    solved.add(Plane::ground(), fixed, restitution(0));
    lay(solved, 9, 8, 0.05);
    tear_when_warm(solved);
}
