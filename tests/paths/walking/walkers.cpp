// SPDX-License-Identifier: BSL-1.0
// Walkers in worlds: on their way to the rounding whatever the speed, step and integrator; pushed off and back; what
// they tell; and all that a state of a world must be able to.

#include <ansatz/paths/walking/walk.hpp>
#include <ansatz/paths/walking/walkers.hpp>

#include <ansatz/paths/walking.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/world/files.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;
using namespace ansatz::test;
using Catch::Matchers::ContainsSubstring;

namespace {

struct Simple : World<SemiImplicitEuler, Walkers> {
    explicit Simple(const Walkers& walkers = {}) : World(SemiImplicitEuler{}, walkers) {}
};
struct Flat : World<Space<float, 2>, Verlet, Walkers> {
    Flat() : World(Space<float, 2>{}, Verlet{}, Walkers{}) {}
};
struct Third : World<Space<double, 2>, RungeKutta4, Walkers> {
    Third() : World(Space<double, 2>{}, RungeKutta4{}, Walkers{}) {}
};
struct Solved : World<Space<float, 3>, ImplicitEuler, Walkers> {
    Solved() : World(Space<float, 3>{}, ImplicitEuler{}, Walkers{}) {}
};
/// What else acts on a walker.
struct Ground : World<SemiImplicitEuler, Gravity, Drag, Walkers> {
    Ground() : World(SemiImplicitEuler{}, Gravity{}, Drag{0.3 / second}, Walkers{}) {}
};

/// Pushes of a user's own policy, by the library's verb.
struct Apart {
    using role = ansatz::roles::Force;
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position>;
    static constexpr std::string_view name = "Apart";
    static void parameters(auto&, auto&&) {}
    template <class S> struct In {
        explicit In(const Apart&) {}
        void couple(auto& view, const auto&) const {
            const auto reach = 2.0 * metre;
            const auto strength = 30.0 * newton;
            view.for_each([&](std::size_t i) {
                view.for_each([&](std::size_t k) {
                    if (view.id(i) < view.id(k))
                        view.add_force_pair(i, k,
                                            separation(view.template get<Position>(i), view.template get<Position>(k),
                                                       reach, strength));
                });
            });
        }
    };
};

/// Way points at random, in the plane of the first two axes.
std::vector<WayPoint> random_path(std::mt19937& random, int n, double size) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<WayPoint> path;
    for (int i = 0; i < n; ++i)
        path.push_back({.place = metres(uniform(-size, size), uniform(-size, size)),
                        .cut = (i % 3 == 2 ? 0.0 : uniform(0.1, 2)) * metre});
    return path;
}
Walk walk_of(Handle body, std::vector<WayPoint> path, double speed, double acceleration) {
    return {.body = body,
            .path = std::move(path),
            .speed = speed * metre / second,
            .acceleration = acceleration * metre / second / second,
            .up = {},
            .astray = 0.5 * metre};
}
template <class W> int count(const W& world, WalkNews news) {
    int n = 0;
    for (const auto& event : world.walk_events()) n += event.news == news;
    return n;
}

} // namespace

TEMPLATE_TEST_CASE("a walker is where its way says, at any step and speed, and stands still at the end", "[walking]",
                   Simple, Flat, Third, Solved) {
    using W = TestType;
    using S = typename W::S;
    const double eps = std::numeric_limits<typename S::Scalar>::epsilon();
    std::mt19937 random(17);
    for (const double speed : {0.3, 3.0, 30.0})
        for (const double dt : {0.01, 0.1, 1.0}) {
            W world;
            const double a = 2;
            const auto body = [&] {
                if constexpr (S::dimension == 2) return world.add(position(metres(1, 2)));
                else return world.add(position(metres(1, 2, 0)));
            }();
            const auto path = random_path(random, 6, 20);
            const auto walk = world.add(walk_of(body, path, speed, a));
            const double all = double(world.walking(walk).time_left.value());
            const double rounding = 400 * eps * 30;
            int steps = 0, passed = 0, arrivals = 0, others = 0;
            auto v = world.velocity(body);
            for (; steps * dt < 1.5 * all + 5 * dt && arrivals == 0; ++steps) {
                world.step(dt * second);
                const auto now = world.velocity(body);
                REQUIRE(double(norm(now).value()) <= speed * (1 + 1e-4) + rounding / dt);
                REQUIRE(double(norm(now - v).value()) <= a * dt * (1 + 1e-4) + 2 * rounding / dt);
                REQUIRE(double(norm(world.position(body) - world.walking(walk).should_be).value()) <= rounding);
                v = now;
                for (const auto& event : world.walk_events()) {
                    passed += event.news == WalkNews::way_point ? int(event.passed) : 0;
                    arrivals += event.news == WalkNews::arrived;
                    others += event.news > WalkNews::arrived;
                }
            }
            INFO("speed " << speed << ", step " << dt << ", " << all << " s");
            CHECK(arrivals == 1);
            CHECK(passed == 5);
            CHECK(others == 0);
            CHECK((steps - 1) * dt <= all * (1 + 1e-3) + 2 * dt); // it is told in the step in which it stands
            for (int i = 0; i < 20; ++i) world.step(dt * second);
            CHECK(double(world.velocity(body).value().norm()) == 0);
            const auto& end = path.back().place.value();
            CHECK(std::hypot(double(world.position(body).value()[0]) - end[0],
                             double(world.position(body).value()[1]) - end[1]) <= rounding);
            CHECK(world.walk_events().empty());
        }
}

TEST_CASE("a walker on the ground leaves heights alone, and walks against drag", "[walking]") {
    Ground world;
    const auto body = world.add(position(metres(0, 100, 0)));
    auto walk = walk_of(body, {{metres(8, 5, 0), 1.0 * metre}, {metres(8, -3, 6)}}, 1.5, 2);
    walk.up = Eigen::Vector3d(0, 2, 0); // its length does not matter
    const auto id = world.add(walk);
    const double all = world.walking(id).time_left.value();
    const auto falling = world.add(position(metres(0, 100, 0)));
    double time = 0;
    int told = 0;
    for (; time < 2 * all && told == 0; time += 0.01) {
        world.step(0.01 * second);
        told += count(world, WalkNews::arrived);
        CHECK(world.walking(id).off == false);
        REQUIRE(world.position(body).value()[1] == world.position(falling).value()[1]);
    }
    CHECK(told == 1);
    CHECK(time <= 1.05 * all); // drag takes 0.45 of its 2 m/s^2 at full speed
    CHECK(world.position(body).value()[0] == Approx(8).margin(1e-3));
    CHECK(world.position(body).value()[2] == Approx(6).margin(1e-3));
}

TEST_CASE("pushed off it is told, comes back, and arrives; what it adds never exceeds its acceleration", "[walking]") {
    std::mt19937 random(23);
    for (int i = 0; i < 60; ++i) {
        Simple world;
        const auto body = world.add(position(metres(0, 0, 0)));
        const double a = 3, dt = std::array{0.01, 0.05, 0.3}[std::size_t(i % 3)];
        const auto walk = world.add(walk_of(body, random_path(random, 4, 15), 2, a));
        const double all = world.walking(walk).time_left.value();
        int off = 0, back = 0, arrived = 0, pushes = 0;
        for (double time = 0; time < 3 * all + 30 && arrived == 0; time += dt) {
            if (pushes < 3 && random() % 1000 < 1000 * dt / 3) {
                ++pushes;
                const double x = std::uniform_real_distribution<double>(-5, 5)(random);
                world.set_velocity(body, metres_per_second(x, 4 - x, x / 2));
            }
            const auto v = world.velocity(body);
            world.step(dt * second);
            REQUIRE(norm(world.velocity(body) - v).value() <= a * dt + 1e-10);
            off += count(world, WalkNews::pushed_off), back += count(world, WalkNews::back);
            arrived += count(world, WalkNews::arrived);
        }
        INFO("case " << i << " step " << dt << " pushes " << pushes);
        CHECK(arrived == 1);
        CHECK(off == back);
        if (pushes > 0 && dt < 0.1) CHECK(off <= pushes);
    }
}

TEST_CASE("put elsewhere on its way, or beside it, it goes on from the nearest place, and not from where it was",
          "[walking]") {
    Simple world;
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto walk = world.add(walk_of(body, {{metres(20, 0, 0)}}, 2, 2));
    const double all = world.walking(walk).time_left.value();
    double time = 0, x = 0;
    const auto go_on = [&](double until) {
        for (; time < until && !world.walking(walk).arrived; time += 0.02) {
            world.step(0.02 * second);
            REQUIRE(world.position(body).value()[0] >= x - 1e-9); // never back
            x = world.position(body).value()[0];
        }
    };
    go_on(3);
    world.set_position(body, metres(x + 6, 0, 0));
    x += 6;
    go_on(5);
    world.set_position(body, metres(x, 0, 0.3)); // not far enough to be told
    go_on(20);
    CHECK(world.walking(walk).arrived);
    CHECK(time == Approx(all - 6 / 2.0).margin(0.1)); // 6 m at 2 m/s less, and hardly anything for the way back
    CHECK(norm(world.position(body) - metres(20, 0, 0)).value() < 1e-9);
}

TEST_CASE("stuck is told once, and again only when it has got on", "[walking]") {
    Simple world;
    world.set(Walkers{.patience = 2.0 * second});
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto walk = world.add(walk_of(body, {{metres(10, 0, 0)}}, 1, 1));
    int stuck = 0, arrived = 0;
    double first = 0;
    for (int i = 0; i < 400; ++i) {
        if (i < 200 && world.position(body).value()[0] > 4) world.set_position(body, metres(4, 0, 0)); // a hand
        world.step(0.05 * second);
        stuck += count(world, WalkNews::stuck);
        if (stuck == 1 && first == 0) first = 0.05 * i;
        arrived += count(world, WalkNews::arrived);
        if (i < 200) CHECK(world.walking(walk).stuck == (stuck == 1));
    }
    CHECK(stuck == 1);
    CHECK(first > 4.5 + 1.5);
    CHECK(first < 4.5 + 2.5);
    CHECK(arrived == 1);
    CHECK(!world.walking(walk).stuck);
}

TEST_CASE("halted it stops as soon as it can, where it says, and goes on", "[walking]") {
    Simple world;
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto walk = world.add(walk_of(body, {{metres(10, 0, 0), 1.0 * metre}, {metres(10, 10, 0)}}, 2, 1));
    for (int i = 0; i < 90; ++i) world.step(0.05 * second);
    const auto stop = world.where_it_can_stop(walk);
    const auto v = world.velocity(body);
    const auto x = world.position(body);
    world.halt(walk);
    for (int i = 0; i < 60; ++i) world.step(0.05 * second);
    CHECK(world.velocity(body).value().norm() == 0);
    CHECK(norm(world.position(body) - stop).value() < 1e-9);
    CHECK(norm(stop - x).value() == Approx(v.value().squaredNorm() / 2).epsilon(1e-9)); // v^2 / 2a
    CHECK(world.walk_events().empty());
    world.halt(walk, false);
    int arrived = 0;
    for (int i = 0; i < 300; ++i) world.step(0.05 * second), arrived += count(world, WalkNews::arrived);
    CHECK(arrived == 1);
    CHECK(norm(world.position(body) - metres(10, 10, 0)).value() < 1e-9);
}

TEST_CASE("two who are steered apart keep their momentum", "[walking]") {
    World world{SemiImplicitEuler{}, Apart{}};
    std::mt19937 random(4);
    std::uniform_real_distribution<double> at(-2, 2), heavy(0.5, 4);
    for (int i = 0; i < 30; ++i)
        world.add(position(metres(at(random), at(random), at(random))), mass(heavy(random) * kilogram));
    for (int i = 0; i < 300; ++i) world.step(0.005 * second);
    Eigen::Vector3d sum(0, 0, 0);
    double size = 0;
    for (const auto body : world.handles()) {
        const Eigen::Vector3d p = world.mass(body).value() * world.velocity(body).value();
        sum += p, size += p.norm();
    }
    CHECK(size > 10);
    CHECK(sum.norm() < 1e-13 * size);
}

TEST_CASE("a world of walkers is a value: copied, saved and loaded it goes on to the bit", "[walking]") {
    std::mt19937 random(8);
    for (int round = 0; round < 20; ++round) {
        Simple world;
        std::vector<Handle> bodies;
        std::vector<ElementHandle<Walk>> walks;
        for (int i = 0; i < 5; ++i) {
            bodies.push_back(world.add(position(metres(i, 0, 0))));
            walks.push_back(world.add(walk_of(bodies.back(), random_path(random, 3, 8), 1 + i, 2)));
        }
        const auto go_on = [&](Simple& w, unsigned seed) { // verbs at random
            std::mt19937 own(seed);
            for (int i = 0; i < 120; ++i) {
                const auto k = own() % 5;
                switch (own() % 12) {
                case 0: w.set_velocity(bodies[k], metres_per_second(1, -2, 0.5)); break;
                case 1:
                    if (w.contains(walks[k])) w.halt(walks[k], own() % 2 == 0);
                    break;
                case 2:
                    if (w.contains(walks[k])) w.set(walks[k], walk_of(bodies[k], random_path(own, 2, 5), 2, 3));
                    break;
                case 3:
                    if (own() % 8 == 0 && w.contains(walks[k])) w.remove(walks[k]);
                    break;
                default: break;
                }
                w.step(0.04 * second);
            }
        };
        go_on(world, unsigned(round));
        Simple copy = world, loaded;
        load_text(loaded, text_of(world));
        REQUIRE(loaded.hash() == world.hash());
        REQUIRE(copy.hash() == world.hash());
        go_on(world, 100), go_on(copy, 100), go_on(loaded, 100);
        CHECK(copy.hash() == world.hash());
        CHECK(loaded.hash() == world.hash());
        for (const auto walk : walks)
            if (world.contains(walk)) CHECK(loaded.walking(walk).left == world.walking(walk).left);
        const auto before = world.hash();
        for (const auto walk : walks)
            if (world.contains(walk)) {
                world.halt(walk, !world.walking(walk).halting);
                CHECK(world.hash() != before);
                break;
            }
    }
}

TEST_CASE("a walk ends with its body, and one that is there already has arrived", "[walking]") {
    Simple world;
    const auto one = world.add(position(metres(0, 0, 0))), other = world.add(position(metres(5, 0, 0)));
    const auto walk = world.add(walk_of(one, {{metres(9, 0, 0)}}, 1, 1));
    const auto here = world.add(walk_of(other, {{metres(5, 0, 0)}}, 1, 1));
    world.step(0.1 * second);
    CHECK(count(world, WalkNews::arrived) == 1);
    CHECK(world.walking(here).arrived);
    CHECK(world.position(other).value() == Eigen::Vector3d(5, 0, 0));
    CHECK(world.walking(here).left.value() == 0);
    world.remove(one);
    CHECK(!world.contains(walk));
    CHECK_THROWS_AS(world.walking(walk), std::out_of_range);
    CHECK_THROWS_AS(world.halt(walk), std::out_of_range);
    world.step(0.1 * second);
}

TEST_CASE("a body has one walk at a time: another is refused, whatever came, went and was loaded", "[walking]") {
    std::mt19937 random(23);
    const std::string twice = "Walk: body is one that has a walk; a body follows one at a time; set this one for the "
                              "handle of the other, or remove that";
    Simple world;
    std::vector<Handle> bodies;
    std::vector<std::pair<ElementHandle<Walk>, std::size_t>> walks; // with the body, by its place in the list
    const auto walker = [&](std::size_t k) {
        for (const auto& walk : walks)
            if (walk.second == k) return std::optional(walk.first);
        return std::optional<ElementHandle<Walk>>();
    };
    int refused = 0, exchanged = 0, loads = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto path = random_path(random, 2, 5);
        const std::size_t k = bodies.empty() ? 0 : random() % bodies.size();
        const std::size_t w = walks.empty() ? 0 : random() % walks.size();
        const auto verb = random() % 16;
        const auto before = world.hash();
        if (bodies.size() < 3 || (verb == 0 && bodies.size() < 30))
            bodies.push_back(world.add(position(metres(i, 0, 0))));
        else if (verb < 6) { // another walk
            std::optional<ElementHandle<Walk>> added;
            const auto said = refusal([&] { added = world.add(walk_of(bodies[k], path, 1, 1)); });
            REQUIRE(said == (walker(k) ? twice : "nothing"));
            if (added) walks.emplace_back(*added, k);
            else REQUIRE(world.hash() == before);
            refused += !added;
        } else if (verb < 11 && !walks.empty()) { // a walk for somebody, the same or another
            const bool may = !walker(k) || *walker(k) == walks[w].first;
            const auto said = refusal([&] { world.set(walks[w].first, walk_of(bodies[k], path, 1, 1)); });
            REQUIRE(said == (may ? "nothing" : twice));
            if (may) exchanged += walks[w].second != k, walks[w].second = k;
            else REQUIRE(world.hash() == before);
        } else if (verb < 13 && !walks.empty()) {
            world.remove(walks[w].first);
            walks.erase(walks.begin() + std::ptrdiff_t(w));
        } else if (verb == 13) {
            world.remove(bodies[k]);
            std::erase_if(walks, [&](const auto& walk) { return walk.second == k; });
            bodies.erase(bodies.begin() + std::ptrdiff_t(k));
            for (auto& walk : walks) walk.second -= walk.second > k;
        } else if (verb == 14 && i % 5 == 0) {
            Simple loaded;
            load_text(loaded, text_of(world));
            REQUIRE(loaded.hash() == world.hash());
            world = loaded;
            ++loads;
        } else world.step(0.05 * second);
        for (std::size_t n = 0; n < bodies.size(); ++n) REQUIRE(world.walk_of(bodies[n]) == walker(n));
    }
    CHECK(refused > 100);
    CHECK(exchanged > 100);
    CHECK(loads > 10);
    CHECK_THROWS_AS(world.walk_of(Handle{}), std::out_of_range);

    Simple two;
    const auto one = two.add(position(metres(0, 0, 0))), other = two.add(position(metres(0, 1, 0)));
    two.add(walk_of(one, {{metres(1, 0)}}, 1, 1)), two.add(walk_of(other, {{metres(1, 1)}}, 1, 1));
    std::string text = text_of(two);
    const auto at = text.rfind("\"body\"");
    REQUIRE(at != std::string::npos);
    text.replace(text.find('1', at), 1, "0");
    CHECK_THAT(refusal([&] { load_text(two, text); }),
               ContainsSubstring("the walks: the number of walks of body 0 is 2; one at most"));
}

TEST_CASE("a walk that cannot be is refused in a sentence, and nothing is changed", "[walking]") {
    Simple world;
    const auto body = world.add(position(metres(0, 0, 0)));
    const auto stone = world.add(position(metres(0, 1, 0)), fixed);
    const auto good = walk_of(body, {{metres(1, 0, 0)}, {metres(2, 0, 0)}}, 1, 1);
    const auto kept = world.add(good);
    const auto hash = world.hash();
    const auto says = [&](auto&& change) {
        Walk bad = good;
        change(bad);
        const std::string added = refusal([&] { world.add(bad); });
        CHECK(refusal([&] { world.set(kept, bad); }) == added);
        CHECK(world.hash() == hash);
        return added;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(says([](Walk& w) { w.speed = {}; }) == "Walk: speed is 0 m/s; it must be finite and greater than zero");
    CHECK_THAT(says([](Walk& w) { w.acceleration = -1.0 * metre / second / second; }),
               ContainsSubstring("Walk: acceleration is -1 m/s^2; it must be finite and greater than zero"));
    CHECK_THAT(says([](Walk& w) { w.astray = {}; }), ContainsSubstring("Walk: astray is 0 m; it must be"));
    CHECK_THAT(says([](Walk& w) { w.path.clear(); }),
               ContainsSubstring("Walk: path is empty; it must have one way point at least"));
    CHECK_THAT(says([](Walk& w) { w.path[1].place = w.path[0].place; }),
               ContainsSubstring("Walk: way point 1 is (1, 0, 0) m; it must lie elsewhere than the one before"));
    CHECK_THAT(says([&](Walk& w) { w.path[1].place = metres(0, nan, 0); }), ContainsSubstring("Walk: way point 1 is"));
    CHECK_THAT(says([&](Walk& w) { w.path[0].cut = -1.0 * metre; }),
               ContainsSubstring("Walk: the cut of way point 0 is -1 m; it must be finite and not negative"));
    CHECK_THAT(says([&](Walk& w) { w.body = stone; }), ContainsSubstring("a walker must be free to move"));
    CHECK_THAT(refusal([] { Simple w(Walkers{.patience = 0.0 * second}); }),
               ContainsSubstring("Walkers: patience is 0 s"));
    Flat flat;
    const auto other = flat.add(position(metres(0, 0)));
    CHECK_THAT(refusal([&] { flat.add(walk_of(other, {{metres(1, 0, 1)}}, 1, 1)); }),
               ContainsSubstring("this world has two dimensions, so its third component must be 0"));

    // And a file whose numbers do not belong together.
    std::string text = text_of(world);
    const auto at = text.find("\"leg\"");
    REQUIRE(at != std::string::npos);
    text.replace(text.find('1', at), 1, "9");
    Simple loaded;
    CHECK_THAT(refusal([&] { load_text(loaded, text); }), ContainsSubstring("a walk: leg is 9; from 1 to 2"));
}
