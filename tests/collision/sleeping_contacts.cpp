// SPDX-License-Identifier: BSL-1.0
// Contacts of bodies that sleep are kept apart: what keeps them against a plain map; and worlds in which they are,
// against worlds in which they are not.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/response/soft_islands.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/collision/response/solver_body.hpp>
#include <ansatz/collision/sleeping_contacts.hpp>
#include <ansatz/collision/world_contacts.hpp>
#include <ansatz/world/save.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

using namespace collision_tests;
using ansatz::test::Dice;

namespace {

using S = Space<float, 3>;
using Ids = std::pair<std::uint32_t, std::uint32_t>;

struct Pair {
    std::uint32_t a, b;
    int what;
};

} // namespace

TEST_CASE("pairs that sleep and pairs that act are the pairs that there were", "[collision][contacts]") {
    Dice dice(3);
    std::map<Ids, int> expected; // all pairs
    std::vector<Pair> acting;
    SleepingContacts<Pair> asleep;
    std::set<Ids> left; // of those that sleep, which are about to act again
    const auto names = [](const Ids& ids, std::uint32_t body) { return ids.first == body || ids.second == body; };
    const auto acts = [&](const Ids& ids) {
        return std::ranges::any_of(acting, [&](const Pair& p) { return Ids(p.a, p.b) == ids; });
    };
    int taken = 0, back = 0, forgotten = 0;
    for (int round = 0; round < 5000; ++round) {
        const auto body = dice.below(16u);
        switch (dice.below(6)) {
        case 0: // others are found
            for (auto n = dice.below(20); n > 0; --n) {
                const Ids ids{dice.below(8u), 8 + dice.below(8u)};
                if (expected.contains(ids) && !acts(ids)) continue;
                expected[ids] = int(dice.below(1000u));
                std::erase_if(acting, [&](const Pair& p) { return Ids(p.a, p.b) == ids; });
                acting.push_back({ids.first, ids.second, expected[ids]});
            }
            std::ranges::sort(acting, {}, [](const Pair& p) { return Ids(p.a, p.b); });
            break;
        case 1: {
            const auto before = asleep.size();
            asleep.make_room(acting.size(), 16);
            asleep.take(acting, [&](const Pair& p) { return (p.a + p.b) % 4 == body % 4; });
            CHECK(std::ranges::none_of(acting, [&](const Pair& p) { return (p.a + p.b) % 4 == body % 4; }));
            taken += int(asleep.size() - before);
            break;
        }
        case 2: { // a body wakes
            std::set<Ids> leave;
            for (const auto& [ids, what] : expected)
                if (names(ids, body) && !acts(ids) && !left.contains(ids)) leave.insert(ids);
            asleep.leave(body, [&](std::uint32_t place) {
                const Ids ids(asleep[place].a, asleep[place].b);
                REQUIRE(leave.erase(ids) == 1);
                left.insert(ids);
            });
            REQUIRE(leave.empty());
            break;
        }
        case 3: {
            REQUIRE(asleep.any_left() == !left.empty());
            const auto before = asleep.size();
            asleep.merge(acting, [](const Pair& p) { return Pair{p.a, p.b, p.what}; });
            back += int(before - asleep.size());
            REQUIRE(before - asleep.size() == left.size());
            for (const auto& ids : left) REQUIRE(acts(ids));
            left.clear();
            break;
        }
        case 4: // a body is removed
            if (!dice.one_in(4) || !left.empty()) break;
            forgotten += int(asleep.size());
            asleep.forget(body);
            forgotten -= int(asleep.size());
            std::erase_if(acting, [&](const Pair& p) { return names({p.a, p.b}, body); });
            std::erase_if(expected, [&](const auto& p) { return names(p.first, body); });
            break;
        default:
            if (dice.one_in(2)) { // moved away and back, it is empty in between
                auto other = std::move(asleep);
                REQUIRE(asleep.empty()); // NOLINT(bugprone-use-after-move)
                REQUIRE(!asleep.any_left());
                REQUIRE(!asleep.has(body));
                asleep = std::move(other);
            } else { // a copy in its place
                const auto other = asleep;
                asleep = {};
                asleep = other;
            }
        }
        auto next = expected.begin();
        const auto one = [&](const Pair& p, bool sleeps) {
            REQUIRE(next != expected.end());
            REQUIRE(next->first == Ids(p.a, p.b));
            REQUIRE(next->second == p.what);
            REQUIRE(sleeps == !acts(next->first));
            ++next;
        };
        asleep.each(
            acting, [&](const Pair& p) { one(p, false); }, [&](const Pair& p) { one(p, true); });
        REQUIRE(next == expected.end());
        REQUIRE(acting.size() + asleep.size() == expected.size());
        std::set<Ids> of_body, has;
        for (const auto& [ids, what] : expected)
            if (names(ids, body) && !acts(ids) && !left.contains(ids)) of_body.insert(ids);
        asleep.each_of(body, [&](const Pair& p) { has.insert({p.a, p.b}); });
        REQUIRE(has == of_body);
        REQUIRE(asleep.has(body) == !has.empty());
        for (std::uint32_t other = 0; other < 16; ++other)
            REQUIRE(asleep.has(body, other) == has.contains({body, other}));
    }
    CHECK(taken > 500); // or nothing was tried
    CHECK(back > 500);
    CHECK(forgotten > 50);
}

namespace {

/// A heap that falls asleep again and again, beside a platform that stands or goes, if there is one.
template <class World_> class Heap {
public:
    Heap(const World_& empty, std::uint64_t seed) : world(empty), dice_(seed), empty_(empty) {
        bodies_.push_back(world.add(Plane::ground(), fixed));
        if (seed % 2 == 0) platform_ = world.add(Sphere{0.4 * metre}, position(metres(-3, 0.4, 0)), moving);
        bodies_.push_back(world.add(Sphere{0.7 * metre}, position(metres(0, 0.2, 0)), fixed));
        bodies_.push_back(world.add(Sphere{0.3 * metre}, position(metres(0.2, 0.3, 0)), mass(1.0 * kilogram), sensor));
        for (int i = 0; i < 25; ++i) add(mass(1.0 * kilogram));
        kept_ = world;
    }
    /// Before a step.
    void meddle() {
        if (dice_.one_in(16)) change();
    }
    auto& collisions() { return detail::Key::inside(world).data.collisions; }

    World_ world;
    int sleepers_removed = 0;

private:
    template <class... P> void add(const P&... property) {
        const auto radius = dice_.number(0.15, 0.3) * metre;
        const auto x = somewhere();
        bodies_.push_back(
            world.add(Sphere{radius}, position(x), restitution(dice_.one_in(3) ? 0.5 : 0.0), property...));
    }
    auto somewhere() -> decltype(metres(0, 0, 0)) {
        const double x = dice_.number(-1, 1), y = dice_.number(0.2, 2), z = dice_.number(-1, 1);
        return metres(x, y, z);
    }
    void change() {
        const auto body = bodies_[1 + dice_.below(bodies_.size() - 1)];
        const bool there = world.contains(body);
        switch (dice_.below(12)) {
        case 0: return there ? world.set_position(body, somewhere()) : void();
        case 1:
            if (there && world.motion(body) != Motion::fixed) world.set_velocity(body, metres_per_second(0.5, 1, -0.3));
            return;
        case 2: {
            const auto sleeper = std::ranges::find_if(
                bodies_, [&](Handle h) { return world.contains(h) && world.motion(h) == Motion::resting; });
            if (sleeper == bodies_.end()) return;
            const auto x = world.position(*sleeper);
            ++sleepers_removed;
            world.remove(*sleeper);
            bodies_.push_back(world.add(Sphere{0.3 * metre}, position(x), mass(1.0 * kilogram))); // with the same id
            return;
        }
        case 3: return add(mass(1.0 * kilogram));
        case 4: return add(mass(1.0 * kilogram), resting);
        case 5:
            if (world.contains(platform_))
                world.set_velocity(platform_, metres_per_second(dice_.one_in(2) ? 0.3 : 0, 0, 0));
            return;
        case 6: return void(kept_ = world);
        case 7: return dice_.one_in(4) ? void(world = kept_) : void();
        case 8:
        case 9:
        case 10: return add(mass(1.0 * kilogram), velocity(metres_per_second(0, -3, 0)));
        default:
            std::stringstream file;
            save(world, file);
            World_ loaded = empty_;
            load(loaded, file);
            world = std::move(loaded);
        }
    }

    Dice dice_;
    World_ empty_, kept_ = empty_;
    std::vector<Handle> bodies_;
    Handle platform_;
};

template <class World_> void goes_on_as_if_all_acted(const World_& empty) {
    std::size_t kept_apart = 0, woke = 0;
    int sleepers_removed = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        Heap<World_> apart(empty, seed), together(empty, seed);
        for (int n = 0; n < 400; ++n) {
            apart.meddle();
            together.meddle();
            together.collisions().keeps_apart = false; // a world that was loaded does
            REQUIRE(!together.collisions().contacts.any_sleep());
            if (apart.collisions().contacts.any_sleep()) ++kept_apart;
            const auto dt = n % 40 == 39 ? 0.01 * second : 1.0 / 60 * second;
            apart.world.step(dt);
            together.world.step(dt);
            const auto same = [](const auto& x, const auto& y) {
                return x.first == y.first && x.second == y.second && x.steps == y.steps && x.depth == y.depth;
            };
            INFO("seed " << seed << ", step " << n);
            REQUIRE(std::ranges::equal(apart.world.contacts(), together.world.contacts(), same));
            REQUIRE(std::ranges::equal(apart.world.contacts_ended(), together.world.contacts_ended()));
            REQUIRE(apart.world.hash() == together.world.hash());
            for (const auto& event : apart.world.events())
                if (event.kind == Event::Kind::woke) ++woke;
        }
        sleepers_removed += apart.sleepers_removed;
    }
    CHECK(kept_apart > 500); // or nothing was tried
    CHECK(woke > 50);
    CHECK(sleepers_removed > 10);
}

} // namespace

TEST_CASE("a world whose sleeping contacts are kept apart goes on as if they were not", "[collision][contacts]") {
    const Rest rest{0.3 * metre_per_second, 0.15 * second};
    const Narrowphase<Sphere, Plane> narrow;
    SECTION("SoftSubsteps") {
        goes_on_as_if_all_acted(
            World{SemiImplicitEuler{}, Gravity{}, UniformGrid{}, narrow, SoftSubsteps<Friction>{}, rest});
    }
    SECTION("SoftSubsteps, float, a history") {
        goes_on_as_if_all_acted(World{S{}, Verlet{}, Gravity{}, UniformGrid{}, narrow, SoftSubsteps<Friction>{}, rest});
    }
    SECTION("SoftSubsteps by colours") {
        goes_on_as_if_all_acted(World{S{}, SemiImplicitEuler{}, Gravity{}, UniformGrid{}, narrow,
                                      SoftSubsteps<Friction, Coloured>{}, rest});
    }
    SECTION("Impulse and Projection") {
        goes_on_as_if_all_acted(
            World{SemiImplicitEuler{}, Gravity{}, UniformGrid{}, narrow, Impulse{}, Projection{}, rest});
    }
    SECTION("swept") {
        goes_on_as_if_all_acted(World{SemiImplicitEuler{}, Gravity{}, UniformGrid{},
                                      Swept<Narrowphase<Sphere, Plane>>{}, Impulse{}, Projection{}, rest});
    }
}

TEST_CASE("what takes the place of one that slept is pushed by nothing of what held it", "[collision][contacts]") {
    const auto hash_after = [](bool apart) {
        World world{SemiImplicitEuler{},          Gravity{},        UniformGrid{},
                    Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}, Rest{0.3 * metre_per_second, 0.15 * second}};
        auto& collisions = detail::Key::inside(world).data.collisions;
        collisions.keeps_apart = apart;
        for (const auto& [x, z] :
             {std::pair(0.7, 0.0), std::pair(-0.6, 0.0), std::pair(0.0, 0.7), std::pair(0.0, -0.6)})
            world.add(Sphere{0.5 * metre}, position(metres(x, 0, z)), fixed); // between which it lies
        const auto slept = world.add(Sphere{0.3 * metre}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
        for (int n = 0; n < 400; ++n) world.step(1.0 / 60 * second);
        REQUIRE(world.motion(slept) == Motion::resting);
        REQUIRE(collisions.contacts.any_sleep() == apart);
        const auto x = world.position(slept);
        world.remove(slept);
        const auto next = world.add(Sphere{0.4 * metre}, position(x), mass(1.0 * kilogram));
        REQUIRE(next.id == slept.id);
        world.step(1.0 / 60 * second);
        return world.hash();
    };
    CHECK(hash_after(true) == hash_after(false));
}
