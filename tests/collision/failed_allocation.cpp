// SPDX-License-Identifier: BSL-1.0
// A failed allocation (hard case V10): whichever allocation of a verb, a copy, an assignment or a load fails, the world
// is as it was before the call and can be used as if it had not been made. A step that is broken off leaves a world
// that says so.
//
// operator new of this executable counts, and fails at the n-th call where a test asks for it; n goes from the first on
// until the call goes through. With the address sanitizer, what is torn is found, too.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>
#include <ansatz/world/whole.hpp>

#include "tests/operator_new.hpp"

#include <cstddef>
#include <new>
#include <sstream>

using namespace collision_tests;

namespace {

long until_failure = -1;             // negative: none fails
std::size_t smallest_that_fails = 0; // bytes
[[maybe_unused]] const bool asked = [] {
    ansatz::test::before_allocation = [](std::size_t bytes) noexcept {
        return !(until_failure >= 0 && bytes >= smallest_that_fails && until_failure-- == 0);
    };
    return true;
}();

/// Calls `f` with the n-th allocation failing.
/// \return whether it failed
template <class F> bool fails_at(long n, F&& f) {
    until_failure = n;
    try {
        f();
    } catch (const std::bad_alloc&) {
        until_failure = -1;
        return true;
    }
    until_failure = -1;
    return false;
}

/// What can be told of a world from outside, and where it goes.
template <class W> struct Told {
    std::uint64_t hash;
    std::size_t size, elements = 0;
    std::vector<Handle> handles;
    std::vector<std::string> data;

    explicit Told(const W& world) : hash(world.hash()), size(world.size()), handles(world.handles()) {
        for (const auto h : handles) data.push_back(world.datum(h));
        if constexpr (W::composition::element_keepers::size > 0) elements = world.template elements<Spring>().size();
    }
    friend bool operator==(const Told&, const Told&) = default;
};
/// The same, after what everybody does to a world: so that what is torn inside comes to light.
template <class W> Told<W> later(W world) {
    const auto handles = world.handles();
    world.remove(handles[handles.size() / 2]);
    for (int i = 0; i < 3; ++i)
        world.add(Sphere{0.2 * metre}, position(metres(i, 9, 0)), mass(1.0 * kilogram),
                  datum(std::string(40, char('p' + i))));
    for (int i = 0; i < 4; ++i) world.step(1.0 / 240 * second);
    for (const auto h : world.handles()) world.wake(h);
    return Told<W>(world);
}

/// Spheres and a box that lie on the ground, two of them at rest, a platform and, where there are springs, a chain.
template <class... P> auto heap(P... policies) {
    World world{Space<>{},
                SortAndSweep{},
                Narrowphase<Sphere, Box, Plane>{},
                Gravity{},
                Rest{0.05 * metre_per_second, 0.05 * second},
                AppliedForces{},
                Datum<std::string>{},
                policies...};
    using W = decltype(world);
    world.add(Plane::ground(), fixed);
    world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(0, 0.5, 6)), velocity(metres_per_second(0.1, 0, 0)), moving,
              datum(std::string("a platform, which has a longer name than fits")));
    std::vector<Handle> balls;
    for (int i = 0; i < 5; ++i)
        balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(1.0 * i, 0.4999, 0)), mass(1.0 * kilogram),
                                  datum(std::string(30, char('a' + i)))));
    world.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(0, 1.49, 6)), mass(1.0 * kilogram));
    if constexpr (W::composition::element_keepers::size > 0)
        for (int i = 0; i + 1 < 5; ++i)
            world.add(Spring{balls[std::size_t(i)], balls[std::size_t(i) + 1], 5.0 * newton_per_metre});
    for (int i = 0; i < 30; ++i) world.step(1.0 / 240 * second);
    world.add(Sphere{0.5 * metre}, position(metres(20, 0.5, 0)), mass(1.0 * kilogram), resting);
    world.add(Sphere{0.5 * metre}, position(metres(22, 0.5, 0)), mass(1.0 * kilogram), resting);
    world.remove(world.add(Sphere{0.5 * metre}, position(metres(40, 0.5, 0)),
                           mass(1.0 * kilogram))); // an id that is given again
    return world;
}

/// The law, for a verb on a copy of a world (which has no more room than it needs) and on one with room.
template <class W, class F> void law(const char* name, const W& world, F&& verb) {
    for (const bool roomy : {false, true}) {
        INFO(name << (roomy ? " in a world with room" : " in a copy"));
        auto done = world;
        verb(done);
        const Told<W> before(world), then = later(world), after(done), then_after = later(done);
        long n = 0;
        for (bool failed = true; failed && n < 2000; ++n) {
            INFO("allocation " << n);
            auto now = world;
            if (roomy) now.reserve(64);
            failed = fails_at(n, [&] { verb(now); });
            CHECK(now.status().ok());
            if (failed) {
                CHECK(Told<W>(now) == before);
                CHECK(later(now) == then);
                verb(now); // the memory is there again
            }
            CHECK(Told<W>(now) == after);
            CHECK(later(now) == then_after);
        }
        CHECK(n < 2000);
    }
}

/// Every verb.
template <class W> void laws(const W& world) {
    const auto all = world.handles();
    const auto platform = all[1], ball = all[3], neighbour = all[4], box = all[7], sleeper = all[8];
    REQUIRE(world.motion(sleeper) == Motion::resting);
    law("add a sphere", world, [](W& w) {
        w.add(Sphere{0.5 * metre}, position(metres(2, 3, 0)), mass(1.0 * kilogram), datum(std::string(50, 'n')));
    });
    auto stepped_last = world; // no verb since, so that no change waits to be made good
    stepped_last.step(1.0 / 240 * second);
    law("add a sphere behind a step", stepped_last, [](W& w) {
        w.add(Sphere{0.5 * metre}, position(metres(2, 3, 0)), mass(1.0 * kilogram), datum(std::string(50, 'n')));
    });
    law("add many", world, [](W& w) {
        const auto whole = w;
        try {
            for (int i = 0; i < 9; ++i)
                w.add(Sphere{0.1 * metre}, position(metres(2, 5 + i, 0)), mass(1.0 * kilogram),
                      datum(std::string(50, char('A' + i))));
        } catch (...) { // each of them is whole or not there
            const long armed = std::exchange(until_failure, -1);
            const auto handles = w.handles();
            for (std::size_t i = whole.size(); i < handles.size(); ++i) CHECK(w.datum(handles[i]).size() == 50);
            w = whole;
            until_failure = armed;
            throw;
        }
    });
    law("add a platform that pierces a sleeper", world, [](W& w) {
        w.add(Box{metres(0.5, 0.5, 0.5)}, position(metres(21.9, 0.5, 0)), velocity(metres_per_second(0.1, 0, 0)),
              moving);
    });
    law("add a plane", world, [](W& w) { w.add(Plane{Eigen::Vector3d(1, 0, 0), -30.0 * metre}, fixed, sensor); });
    law("remove a ball", world, [&](W& w) { w.remove(ball); });
    law("remove a sleeper", world, [&](W& w) { w.remove(sleeper); });
    law("remove the ground", world, [&](W& w) { w.remove(all[0]); });
    law("set_position", world, [&](W& w) { w.set_position(ball, metres(21, 0.5, 0)); });
    law("set_position of a platform", world, [&](W& w) { w.set_position(platform, metres(22, 0.5, 0)); });
    law("set_velocity", world, [&](W& w) { w.set_velocity(sleeper, metres_per_second(0, 1, 0)); });
    law("set_mass", world, [&](W& w) { w.set_mass(ball, 3.0 * kilogram); });
    law("set_mass of a sleeper", world, [&](W& w) { w.set_mass(sleeper, 3.0 * kilogram); });
    law("apply_impulse", world, [&](W& w) { w.apply_impulse(box, newton_seconds(0, 1, 0)); });
    law("apply_force", world, [&](W& w) { w.apply_force(neighbour, newtons(0, 1, 0)); });
    law("apply_force twice", world, [&](W& w) {
        const auto whole = w;
        try {
            w.apply_force(neighbour, newtons(0, 1, 0)), w.apply_force(sleeper, newtons(0, 1, 0));
        } catch (...) {
            const long armed = std::exchange(until_failure, -1);
            w = whole;
            until_failure = armed;
            throw;
        }
    });
    law("wake", world, [&](W& w) { w.wake(sleeper); });
    law("set a policy", world, [](W& w) { w.set(Gravity{metres_per_second_squared(0, -1.6, 0)}); });
    law("reserve", world, [](W& w) { w.reserve(1000); });
    if constexpr (W::composition::template stores<Restitution>)
        law("write", world, [&](W& w) { w.template write<Restitution>(sleeper, Quantity<unit::Dimensionless>(0.25)); });
    if constexpr (W::composition::element_keepers::size > 0) {
        const auto spring = world.template elements<Spring>().handles()[1];
        law("add a spring", world, [&](W& w) { w.add(Spring{ball, sleeper, 2.0 * newton_per_metre}); });
        law("set a spring", world, [&](W& w) { w.set(spring, Spring{ball, sleeper, 2.0 * newton_per_metre}); });
        law("remove a spring", world, [&](W& w) { w.remove(spring); });
    }

    // Copies, whole or not at all.
    auto grown = world;
    for (int i = 0; i < 40; ++i)
        grown.add(Sphere{0.3 * metre}, position(metres(0.5 * i, 4, 0)), mass(1.0 * kilogram),
                  datum(std::string(60, 'g')));
    for (int i = 0; i < 5; ++i) grown.step(1.0 / 240 * second);
    law("assign a larger world", world, [&](W& w) { w = grown; });
    law("assign a smaller world", grown, [&](W& w) { w = world; });
    for (long n = 0;; ++n) {
        std::optional<W> copy;
        if (!fails_at(n, [&] { copy.emplace(grown); })) {
            CHECK(Told<W>(*copy) == Told<W>(grown));
            break;
        }
        CHECK(!copy);
    }

    // A file: what it holds, and what becomes of the data that no file knows. The parser's destructors allocate, and a
    // failure there ends the program; those are the small ones.
    std::stringstream text;
    save(grown, text);
    const auto file = detail::Json::parse(text.str());
    smallest_that_fails = 256;
    law("load", world, [&](W& w) { Archive::read(w, detail::FileValue{file, "load", true}); });
    smallest_that_fails = 0;

    // A step: as before, or lost; and then nothing is undefined, and another world can take its place.
    auto stepped = grown;
    stepped.step(1.0 / 120 * second);
    long n = 0, lost = 0;
    for (bool failed = true; failed; ++n) {
        INFO("allocation " << n << " of a step");
        auto now = grown;
        failed = fails_at(n, [&] { now.step(1.0 / 120 * second); });
        if (!failed) CHECK(Told<W>(now) == Told<W>(stepped));
        else if (now.status().ok()) {
            CHECK(Told<W>(now) == Told<W>(grown));
            now.step(1.0 / 120 * second);
            CHECK(Told<W>(now) == Told<W>(stepped));
        } else {
            ++lost;
            CHECK(now.status().lost);
            const auto said = [](const std::string& s) {
                return s.find("this world is lost, because its last step was broken off") != std::string::npos;
            };
            CHECK(said(refusal([&] { now.step(1.0 / 120 * second); })));
            CHECK(said(refusal([&] { now.remove(ball); })));
            CHECK(said(refusal([&] { now.add(shapeless, position(metres(0, 1, 0)), mass(1.0 * kilogram)); })));
            CHECK(said(refusal([&] { now.set(Gravity{}); })));
            CHECK(said(refusal([&] {
                std::ostringstream out;
                save(now, out);
            })));
            for (const auto h : now.handles()) (void)now.position(h), (void)now.velocity(h), (void)now.acceleration(h);
            (void)now.hash(), (void)now.contacts(), (void)now.events();
            auto copy = now;
            CHECK(copy.status().lost);
            if (n % 2 == 0) now = grown;
            else {
                std::istringstream in(text.str());
                load(now, in);
            }
            CHECK(now.status().ok());
            CHECK(now.hash() == grown.hash());
            now.step(1.0 / 120 * second);
            CHECK(now.hash() == stepped.hash());
        }
    }
    CHECK(n > 5);
    CHECK(lost > 0);
}

} // namespace

TEST_CASE("V10: a failed allocation leaves the world as it was: Impulse, Projection", "[collision][world][V10]") {
    laws(heap(SemiImplicitEuler{}, Impulse<>{}, Projection{1e-3 * metre}));
}
TEST_CASE("V10: a failed allocation leaves the world as it was: SoftSubsteps with friction, of a history",
          "[collision][world][V10]") {
    laws(heap(Verlet{}, SoftSubsteps<Friction>{}));
}
TEST_CASE("V10: a failed allocation leaves the world as it was: SoftSubsteps by colours", "[collision][world][V10]") {
    laws(heap(SemiImplicitEuler{}, SoftSubsteps<Coloured>{}));
}
TEST_CASE("V10: a failed allocation leaves the world as it was: Penalty and damped springs, of a history",
          "[collision][world][V10]") {
    laws(heap(Verlet{}, Penalty{2e3 * newton_per_metre, 5.0 * newton_second_per_metre}, Springs<>{}));
}
TEST_CASE("V10: a step that finds no room for the boxes of a level leaves a world that takes another one",
          "[collision][world][V10]") {
    World level{SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere>{}, Impulse<>{}};
    for (int i = 0; i < 200; ++i) level.add(Sphere{0.5 * metre}, position(metres(i, 0, 0)), fixed);
    for (int i = 0; i < 8; ++i) level.add(Sphere{0.5 * metre}, position(metres(20 * i, 0.9, 0)), mass(1.0 * kilogram));
    auto stepped = level;
    stepped.step(1.0 / 120 * second);
    REQUIRE(stepped.contacts().size() == 8);
    long n = 0;
    for (bool failed = true; failed; ++n) {
        auto now = level;
        failed = fails_at(n, [&] { now.step(1.0 / 120 * second); });
        if (!failed) break;
        now = level;
        now.step(1.0 / 120 * second);
        REQUIRE(now.hash() == stepped.hash());
    }
    CHECK(n > 10);
}
