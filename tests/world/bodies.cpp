// SPDX-License-Identifier: BSL-1.0
// Handles: a long random life of the directory against one that is obviously right, and stale handles at every member
// of a world.

#include <ansatz/world/bodies.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

/// What must be true of a directory at any time, whatever happened before.
void check_ranges(const Bodies& bodies, const std::vector<int>& lane) {
    CHECK(bodies.begin(Motion::awake) == 0);
    CHECK(bodies.end(Motion::fixed) == bodies.size());
    for (const auto m : {Motion::resting, Motion::moving, Motion::fixed})
        CHECK(bodies.begin(m) == bodies.end(Motion(int(m) - 1)));
    for (std::size_t slot = 0; slot < bodies.size(); ++slot) {
        const auto h = bodies.handle(slot);
        const auto m = bodies.motion(slot);
        if (bodies.slot(h, "here") != slot || bodies.slot_of_id(h.id) != slot || slot < bodies.begin(m) ||
            slot >= bodies.end(m) || lane[slot] < 0) {
            FAIL("slot " << slot << " and handle (" << h.id << ", " << h.generation << ") disagree");
        }
    }
}

} // namespace

TEST_CASE("a hundred thousand random additions, removals, sleeps and wakes leave the directory right",
          "[world][bodies]") {
    Dice dice(1);
    Bodies bodies;
    std::vector<int>
        lane; // stands for the lanes: the number of the body in each slot, moved only by the swaps we are told of
    auto swap = [&](std::size_t i, std::size_t j) {
        REQUIRE(i < lane.size());
        REQUIRE(j < lane.size());
        REQUIRE(i != j);
        std::swap(lane[i], lane[j]);
    };
    struct Known {
        Handle handle;
        Motion motion;
    };
    std::map<int, Known> alive; // the oracle, by a number that is never used again
    std::vector<Handle> gone;
    std::set<std::pair<std::uint32_t, std::uint32_t>> ever;
    int next = 0;
    for (int operation = 0; operation < 100'000; ++operation) {
        // Grows, shrinks to nothing and grows again, so that ids are used many times.
        const bool growing = (operation / 5000) % 2 == 0;
        const auto what = dice.below(10U);
        if (alive.empty() || what < (growing ? 4u : 1u)) {
            const auto motion = Motion(dice.below(4));
            const auto promised = bodies.next_id();
            lane.push_back(next);
            const auto handle = bodies.push_back();
            REQUIRE(handle.id == promised);
            REQUIRE(ever.insert({handle.id, handle.generation}).second); // no handle is given out twice
            bodies.move(Bodies::Slot(bodies.size() - 1), motion, swap);
            alive[next++] = {handle, motion};
        } else {
            auto it = alive.begin();
            std::advance(it, std::ptrdiff_t(dice.below(std::min<std::size_t>(alive.size(), 50))));
            const auto slot = bodies.slot(it->second.handle, "here");
            REQUIRE(lane[slot] == it->first); // the columns followed the body
            if (what < (growing ? 6u : 8u)) {
                bodies.erase(slot, swap);
                lane.pop_back();
                gone.push_back(it->second.handle);
                alive.erase(it);
            } else {
                it->second.motion = Motion(dice.below(4));
                const auto moved = bodies.move(slot, it->second.motion, swap);
                REQUIRE(lane[moved] == it->first);
            }
        }
        REQUIRE(bodies.size() == alive.size());
        if (!gone.empty()) REQUIRE_FALSE(bodies.contains(gone[dice.below(gone.size())]));
        if (operation % 997 == 0) {
            check_ranges(bodies, lane);
            std::array<std::size_t, 4> counts{};
            for (const auto& [number, known] : alive) {
                const auto slot = bodies.slot(known.handle, "here");
                REQUIRE(lane[slot] == number);
                REQUIRE(bodies.motion(slot) == known.motion);
                ++counts[std::size_t(known.motion)];
            }
            for (std::size_t m = 0; m < 4; ++m) CHECK(bodies.count(Motion(m)) == counts[m]);
        }
    }
    for (const auto h : gone) REQUIRE_FALSE(bodies.contains(h));
    CHECK(ever.size() == std::size_t(next));
    CHECK(bodies.ids() < std::size_t(next) / 4); // ids are used again
}

TEST_CASE("a body that is added, removed, moved or put to sleep takes nothing from the others", "[world][bodies]") {
    // Through a world this time: each body carries its number in a column, a datum and a mass.
    Dice dice(2);
    World world{SemiImplicitEuler{}, Rest{}, Keep<Heat, InverseMass>{}, Datum<int>{}};
    std::map<int, Handle> alive;
    std::vector<Handle> gone;
    int next = 1;
    for (int operation = 0; operation < 20'000; ++operation) {
        const auto what = dice.below(8U);
        if (alive.empty() || what < 3) {
            const auto heat = with<Heat>(next * joule);
            const auto heavy = mass(next * kilogram);
            alive[next] = what == 0   ? world.add(heat, fixed, datum(next))
                          : what == 1 ? world.add(heat, heavy, resting, datum(next))
                                      : world.add(heat, heavy, datum(next));
            ++next;
        } else {
            auto it = alive.begin();
            std::advance(it, std::ptrdiff_t(dice.below(std::min<std::size_t>(alive.size(), 20))));
            if (what < 6) {
                world.remove(it->second);
                gone.push_back(it->second);
                alive.erase(it);
            } else if (what == 6) world.wake(it->second);
            else if (operation % 50 == 7) world.step(1.0 / 60 * second);
        }
        if (operation % 199 == 0) {
            REQUIRE(world.size() == alive.size());
            for (const auto& [number, h] : alive) {
                REQUIRE(world.read<Heat>(h) == number * joule);
                REQUIRE(world.datum(h) == number);
                if (world.motion(h) != Motion::fixed)
                    REQUIRE(world.mass(h).value() == Catch::Approx(number).epsilon(1e-15));
            }
            for (const auto h : gone) REQUIRE_FALSE(world.contains(h));
        }
    }
}

namespace {

/// Every member that takes a handle, called with `h`.
template <class W> std::vector<std::pair<std::string, std::string>> everything_with(W& world, Handle h) {
    std::vector<std::pair<std::string, std::string>> all;
    auto add = [&](const char* name, auto&& f) { all.emplace_back(name, sentence<std::out_of_range>(f)); };
    const W& reading = world;
    add("World::remove", [&] { world.remove(h); });
    add("World::motion", [&] { reading.motion(h); });
    add("World::position", [&] { reading.position(h); });
    add("World::velocity", [&] { reading.velocity(h); });
    add("World::acceleration", [&] { reading.acceleration(h); });
    add("World::mass", [&] { reading.mass(h); });
    add("World::inverse_mass", [&] { reading.inverse_mass(h); });
    add("World::read", [&] { reading.template read<Heat>(h); });
    add("World::datum", [&] { world.datum(h); });
    add("World::datum", [&] { reading.datum(h); });
    add("World::row", [&] { reading.row(h); });
    add("World::set_position", [&] { world.set_position(h, metres(1, 2, 3)); });
    add("World::set_velocity", [&] { world.set_velocity(h, metres_per_second(1, 2, 3)); });
    add("World::set_mass", [&] { world.set_mass(h, 1.0 * kilogram); });
    add("World::apply_impulse", [&] { world.apply_impulse(h, newton_seconds(1, 2, 3)); });
    add("World::apply_force", [&] { world.apply_force(h, newtons(1, 2, 3)); });
    add("World::write", [&] { world.template write<Heat>(h, 1.0 * joule); });
    add("World::wake", [&] { world.wake(h); });
    add("World::position", [&] { interpolated_position(reading, h, 0.5); });
    return all;
}

} // namespace

TEMPLATE_TEST_CASE("every member refuses a stale, a foreign and an empty handle with a sentence, and changes nothing",
                   "[world][bodies][door]", SemiImplicitEuler, Verlet) {
    World world{TestType{}, AppliedForces{}, Rest{}, Interpolation{}, Keep<Heat>{}, Datum<int>{}};
    world.add(mass(1.0 * kilogram), datum(1));
    const auto stale = world.add(mass(1.0 * kilogram), datum(2));
    world.step(1.0 / 60 * second);
    world.remove(stale);
    const auto heir = world.add(mass(1.0 * kilogram), datum(3)); // takes the id of the one that was removed
    REQUIRE(heir.id == stale.id);
    REQUIRE(heir.generation != stale.generation);
    const auto before = world;

    for (const auto& [name, text] : everything_with(world, stale)) {
        INFO(text);
        CHECK(text.find(name + ": the handle is stale: body 1 of generation 0 was removed") == 0);
    }
    for (const auto& [name, text] : everything_with(world, Handle{77, 0})) {
        INFO(text);
        CHECK(text.find(name + ": the handle names body 77, but this world has given out only 2; ") == 0);
    }
    for (const auto& [name, text] : everything_with(world, Handle{})) {
        INFO(text);
        CHECK(text.find(name + ": the handle is empty; ") == 0);
    }
    CHECK_FALSE(world.contains(stale));
    CHECK_FALSE(world.contains(Handle{77, 0}));
    CHECK_FALSE(world.contains(Handle{}));
    CHECK(world.hash() == before.hash());
    CHECK(same_state(world, before));
    CHECK(world.datum(heir) == 3);
    // The same calls with a living handle are not refused: it is the handle that was wrong. (The first call removes
    // it.)
    for (const Handle h : world.handles()) CHECK(everything_with(world, h).front().second == "nothing");
}

TEST_CASE("handles are listed by id, and every body has its slot", "[world][bodies]") {
    World world{SemiImplicitEuler{}, Rest{}};
    std::vector<Handle> added;
    for (int i = 0; i < 20; ++i)
        added.push_back(i % 3 == 0 ? world.add(fixed) : i % 3 == 1 ? world.add(resting) : world.add());
    world.remove(added[4]);
    added.erase(added.begin() + 4);
    CHECK(world.handles() == added);
    CHECK(world.count(Motion::fixed) == 7);
    CHECK(world.count(Motion::resting) == 6);
    CHECK(world.count(Motion::awake) == 6);
    CHECK(world.count(Motion::moving) == 0);
    std::set<std::uint32_t> seen;
    for (std::size_t slot = 0; slot < world.size(); ++slot) seen.insert(world.body_at(slot).id);
    CHECK(seen.size() == world.size());
}

TEST_CASE("two directories are equal when the same bodies live in the same state, in whatever slots",
          "[world][bodies]") {
    auto nothing = [](std::size_t, std::size_t) {};
    Bodies a, b;
    a.push_back();
    a.push_back();
    b.push_back();
    b.push_back();
    a.move(0, Motion::awake, nothing);
    a.move(1, Motion::awake, nothing);
    b.move(1, Motion::awake, nothing);
    b.move(1, Motion::awake, nothing);
    CHECK(a == b);
    CHECK(a.id(0) != b.id(0));
    b.move(0, Motion::resting, nothing);
    CHECK_FALSE(a == b);
    a.erase(0, nothing);
    CHECK_FALSE(a == b);
}
