// SPDX-License-Identifier: BSL-1.0
// Verbs on a living world (hard case V1): whatever is done to one body of a sleeping pile is done to that body and to
// no other.
//
// Waking moves bodies to other slots, so a verb that looks a slot up before it wakes a body acts on another one.
// Random verbs are held against a plain model that keeps bodies by their handles (who is there, datum, mass and columns
// exactly; where the others are, to the bit), and against a world of the same bodies that never sleeps (places within
// slop).
//
// Loops that everybody writes (V6): who removes bodies while he walks over contacts, events or handles skips nobody.
// Runs long with the sanitizers.

#include "tests/collision/verb_lives.hpp"

#include <cmath>
#include <random>
#include <set>

using namespace collision_tests;

TEST_CASE("V1: verbs act on the body that is meant: Impulse with friction, Projection", "[collision][verbs][V1]") {
    live(resting_world<Space<>>(SemiImplicitEuler{}, Impulse<Friction>{.sweeps = 20}, Projection{1e-3 * metre}), 60,
         5e-3); // measured 3.1e-3: each of five in a column may be a slop deeper;
}
TEST_CASE("V1: verbs act on the body that is meant: Impulse alone, in float and two dimensions",
          "[collision][verbs][V1]") {
    // Whoever does not sleep sinks for ever (notes 2.2.1), so places are not compared.
    live(resting_world<Space<float, 2>>(SemiImplicitEuler{}, Impulse<>{}, AppliedForces{}), 60, HUGE_VAL);
}
TEST_CASE("V1: verbs act on the body that is meant: SoftSubsteps with friction, and one on a spring",
          "[collision][verbs][V1]") {
    live(resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction>{}, Springs<Breaking>{}, AppliedForces{}),
         60, 5e-3); // measured 2.3e-4
}
TEST_CASE("V1: verbs act on the body that is meant: SoftSubsteps by colours, with friction", "[collision][verbs][V1]") {
    live(resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction, Coloured>{}, AppliedForces{}), 60, 5e-3);
}
TEST_CASE("V1: verbs act on the body that is meant: Penalty, of a history", "[collision][verbs][V1]") {
    live(resting_world<Space<>>(Verlet{}, Penalty{2e4 * newton_per_metre, 80.0 * newton_second_per_metre},
                                AppliedForces{}),
         240, 5e-3);
}

namespace {

/// A hail of bullets (ids above 100) that lie in a floor of boxes, some in two of them.
auto hail() {
    auto world =
        resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction>{}, Springs<Breaking>{}, AppliedForces{});
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 100; ++i)
        world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(i % 10, 0.5, i / 10)), mass(5.0 * kilogram));
    std::mt19937_64 engine(7);
    auto number = [&] { return 9 * double(engine() >> 11) * 0x1p-53; };
    for (int i = 0; i < 60; ++i)
        world.add(Box{metres(0.1, 0.1, 0.1)}, position(metres(number(), 1.05, number())), mass(0.1 * kilogram),
                  datum(i));
    world.step(1.0 / 240 * second);
    return world;
}
using Hail = decltype(hail());
bool is_bullet(const Handle& h) { return h.id > 100; }

/// The contacts of the bullets, counted before anything is removed.
std::size_t of_bullets(const Hail& world) {
    return std::size_t(std::count_if(world.contacts().begin(), world.contacts().end(),
                                     [](const auto& c) { return is_bullet(c.first) || is_bullet(c.second); }));
}

} // namespace

TEST_CASE("V6: who removes bodies while he walks over contacts() meets every contact once", "[collision][verbs][V6]") {
    auto world = hail();
    const auto all = std::vector(world.contacts().begin(), world.contacts().end());
    const auto expected = of_bullets(world);
    REQUIRE(expected > 60); // some lie in two boxes
    std::size_t seen = 0, removed = 0, hits = 0;
    for (const auto& contact : world.contacts()) {
        REQUIRE(seen < all.size());
        CHECK((contact.first == all[seen].first && contact.second == all[seen].second &&
               contact.depth == all[seen].depth));
        ++seen;
        hits += is_bullet(contact.first) || is_bullet(contact.second);
        for (const auto& body : {contact.first, contact.second}) {
            if (!is_bullet(body)) continue;
            if (!world.contains(body)) continue; // it was in another contact, too
            world.remove(body);
            ++removed;
            if (removed % 2 == 0)
                world.add(Box{metres(0.1, 0.1, 0.1)}, position(metres(0, 100.0 + double(removed), 0)),
                          mass(0.1 * kilogram)); // takes the id
        }
    }
    CHECK(seen == all.size());
    CHECK(hits == expected);
    CHECK(removed == 60);
    CHECK(of_bullets(world) == expected); // what it was, until the next step

    // A copy and a loaded world go on in the same way.
    auto copy = world, loaded = world;
    std::stringstream file;
    save(world, file);
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    CHECK(of_bullets(loaded) == expected); // as it was saved, until the next step
    for (auto* w : {&world, &copy, &loaded}) w->step(1.0 / 240 * second);
    CHECK((copy.hash() == world.hash() && loaded.hash() == world.hash()));
    CHECK(of_bullets(world) == 0);
    std::size_t ended = 0;
    for (const auto& end : world.contacts_ended()) {
        const bool of_bullet = is_bullet(end.first) || is_bullet(end.second);
        ended += of_bullet;
        CHECK((!of_bullet || !world.contains(is_bullet(end.first) ? end.first : end.second)));
    }
    CHECK(ended == expected);
    const auto same = [](const auto& x, const auto& y) { return x.first == y.first && x.second == y.second; };
    const auto &told = world.contacts_ended(), &told_by_loaded = loaded.contacts_ended();
    CHECK(std::equal(told.begin(), told.end(), told_by_loaded.begin(), told_by_loaded.end(), same));
    world.step(1.0 / 240 * second);
    CHECK(world.contacts_ended().size() < expected); // told once
}

TEST_CASE("V6: a contact of a removed body wakes nobody and holds nobody, also when its id is given again",
          "[collision][verbs][V6]") {
    auto world =
        resting_world<Space<>>(SemiImplicitEuler{}, SoftSubsteps<Friction>{}, Springs<Breaking>{}, AppliedForces{});
    const auto ground = world.add(Plane::ground(), fixed);
    const auto lower = world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
    const auto upper = world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(0, 1.5, 0)), mass(1.0 * kilogram));
    run(world, 240, 1.0 / 60);
    REQUIRE(world.count(Motion::resting) == 2);
    world.remove(upper);
    const auto other = world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(9, 0.5, 0)), mass(1.0 * kilogram));
    REQUIRE(other.id == upper.id);
    run(world, 240, 1.0 / 60);
    REQUIRE((world.motion(lower) == Motion::resting && world.motion(other) == Motion::resting));
    world.remove(lower);
    world.wake(other); // they never met
    world.remove(ground);
    CHECK(world.contacts().size() == 2);
    run(world, 15, 1.0 / 60);
    CHECK(world.contacts().empty());
    CHECK(height_of(world, other) < 0.5 - 0.99 * 0.5 * 9.81 * 0.0625);
}

TEST_CASE("V6: who removes bodies while he walks over contacts_ended(), events(), handles() and elements skips nobody",
          "[collision][verbs][V6]") {
    auto world = hail();
    SECTION("handles") {
        std::size_t seen = 0;
        for (const auto& body : world.handles()) {
            ++seen;
            if (is_bullet(body)) world.remove(body);
        }
        CHECK(seen == 161);
        CHECK(world.size() == 101);
    }
    SECTION("contacts that ended") {
        for (const auto& body : world.handles())
            if (is_bullet(body)) world.set_position(body, metres(2 * double(body.id), 500, 0));
        world.step(1.0 / 240 * second);
        const auto expected = world.contacts_ended().size();
        REQUIRE(expected >= 60);
        std::size_t seen = 0;
        for (const auto& end : world.contacts_ended()) {
            ++seen;
            for (const auto& body : {end.first, end.second})
                if (is_bullet(body) && world.contains(body)) world.remove(body);
        }
        CHECK(seen == expected);
        CHECK(world.size() == 101);
    }
    SECTION("events") {
        std::set<std::uint32_t> asleep;
        for (int i = 0; i < 2000 && asleep.empty(); ++i) {
            world.step(1.0 / 240 * second);
            const auto before = std::vector(world.events().begin(), world.events().end());
            std::size_t seen = 0;
            for (const auto& event : world.events()) {
                REQUIRE(event == before[seen++]);
                if (event.kind != Event::Kind::slept) continue;
                asleep.insert(event.body.id);
                world.remove(event.body); // wakes its neighbours, which is an event, too
            }
            CHECK(seen == before.size());
        }
        REQUIRE(asleep.size() > 10);
        CHECK(world.size() == 161 - asleep.size());
    }
    SECTION("elements, and those that broke") {
        const auto bodies = world.handles();
        for (std::size_t i = 101; i + 1 < bodies.size(); ++i)
            world.add(Spring{bodies[i], bodies[i + 1], (i % 2 == 0 ? 1.0 : 1e3) * newton_per_metre,
                             0.0 * newton_second_per_metre, 1e-3 * metre},
                      breaks_at(50.0 * newton));
        const auto springs = world.elements<Spring>().handles();
        REQUIRE(springs.size() == 59);
        world.step(1.0 / 240 * second);
        const auto broken = world.elements<Spring>().broken().size();
        REQUIRE(broken > 5);
        REQUIRE(broken < 40);
        std::size_t seen = 0, gone = 0;
        for (const auto& spring : world.elements<Spring>().broken()) {
            ++seen;
            if (world.contains(spring.first.body()))
                world.remove(spring.first.body()), ++gone; // takes its other springs with it
        }
        CHECK(seen == broken);
        CHECK(world.size() == 161 - gone);
        seen = 0;
        for (const auto& spring : world.elements<Spring>().handles()) {
            ++seen;
            CHECK(world.contains(spring));
            world.remove(spring);
        }
        CHECK(seen < springs.size() - broken);
        CHECK(world.elements<Spring>().size() == 0);
    }
}
