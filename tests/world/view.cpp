// SPDX-License-Identifier: BSL-1.0
// Views and contexts: what policies are shown, and nothing else.

#include <ansatz/world/context.hpp>
#include <ansatz/world/view.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

/// Records what it sees after each step.
struct Recorder {
    using role = roles::Observer;
    using reads = Columns<Position, Heat>;
    struct Seen {
        std::uint64_t tick;
        double time, x, heat;
        std::uint32_t id;
    };
    std::vector<Seen>* seen;
    void observe(const auto& view) {
        view.for_each([&](std::size_t slot) {
            seen->push_back({view.tick(), double(view.time().value()),
                             double(view.template get<Position>(slot).value()[0]),
                             double(view.template get<Heat>(slot).value()), view.id(slot)});
        });
    }
};

/// A constant force between the first two bodies of a world, by handle.
struct Rope {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    Handle a, b;
    Parameter<unit::Force> pull = 6.0 * newton;
    template <class S> struct In {
        Handle a, b;
        typename S::Scalar pull;
        explicit In(const Rope& rope) : a(rope.a), b(rope.b), pull(typename S::Scalar(rope.pull.value())) {}
        void couple(auto& view, const auto&) const {
            if (!view.contains(a) || !view.contains(b)) return;
            auto f = S::template zero_vector<unit::Force>().value();
            f[0] = pull;
            view.add_force_pair(view.slot(a), view.slot(b), S::Force::from_value(f));
        }
    };
};

} // namespace

TEST_CASE("an observer sees every body by id after each step, with the time that it is then", "[world][view]") {
    std::vector<Recorder::Seen> seen;
    World world{SemiImplicitEuler{}, Rest{}, Keep<Heat>{}, Recorder{&seen}};
    const auto fixed_one = world.add(fixed, with<Heat>(1.0 * joule));
    const auto mover = world.add(velocity(metres_per_second(64, 0, 0)), with<Heat>(2.0 * joule));
    const auto sleeper = world.add(resting, with<Heat>(3.0 * joule));
    CHECK(seen.empty());
    world.step(0.0 * second);
    CHECK(seen.empty()); // nothing happened
    for (int i = 0; i < 2; ++i) world.step(1.0 / 64 * second);
    REQUIRE(seen.size() == 6);
    const std::uint32_t ids[] = {fixed_one.id, mover.id, sleeper.id};
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(seen[k].tick == k / 3 + 1);
        CHECK(seen[k].time == double(k / 3 + 1) / 64);
        CHECK(seen[k].id == ids[k % 3]);
        CHECK(seen[k].heat == double(k % 3 + 1));
        CHECK(seen[k].x == (k % 3 == 1 ? double(k / 3 + 1) : 0));
    }
}

TEST_CASE("a view between steps shows the declared columns, the ranges and the handles", "[world][view]") {
    std::vector<Recorder::Seen> seen;
    World world{Space<float, 2>{}, SemiImplicitEuler{}, Rest{}, Keep<Heat>{}, Recorder{&seen}};
    const auto a = world.add(fixed, position(metres(1, 2))), b = world.add(position(metres(3, 4))),
               c = world.add(resting);
    world.step(1.0 / 64 * second);
    const auto view = world.view<Recorder>();
    CHECK(view.size() == 3);
    CHECK(view.end(Motion::awake) - view.begin(Motion::awake) == 1);
    CHECK(view.handle(view.slot(b)) == b);
    CHECK(view.motion(view.slot(a)) == Motion::fixed);
    CHECK(view.motion(view.slot(c)) == Motion::resting);
    CHECK(view.get<Position>(view.slot(a)) == world.position(a));
    CHECK(view.lane<Position>(1)[view.slot(b)] == 4.0f);
    CHECK(view.lane<Heat>().size() == 3);
    CHECK(view.contains(a));
    CHECK_FALSE(view.contains(Handle{}));
    CHECK(sentence<std::out_of_range>([&] { view.slot(Handle{9, 0}); }).find("view: the handle names body 9") == 0);
    CHECK(view.tick() == 1);
    CHECK(view.time() == world.time());
}

TEMPLATE_TEST_CASE("a pair of forces moves both as their masses say, and a fixed body not at all", "[world][view]",
                   SemiImplicitEuler, RungeKutta4) {
    World world{TestType{}, Rope{}};
    const auto light = world.add(mass(1.0 * kilogram)), heavy = world.add(mass(3.0 * kilogram)),
               ground = world.add(fixed);
    world.set(Rope{light, heavy});
    for (int i = 0; i < 64; ++i) world.step(1.0 / 64 * second);
    CHECK(world.velocity(light).value()[0] == Catch::Approx(6).epsilon(1e-14));
    CHECK(world.velocity(heavy).value()[0] == Catch::Approx(-2).epsilon(1e-14)); // newton's third law
    CHECK(world.acceleration(light).value()[0] == 6);
    world.set(Rope{heavy, ground});
    const auto before = world.velocity(light);
    for (int i = 0; i < 64; ++i) world.step(1.0 / 64 * second);
    CHECK(world.velocity(heavy).value()[0] == Catch::Approx(0).margin(1e-13));
    CHECK(world.velocity(ground) == metres_per_second(0, 0, 0));
    CHECK(world.velocity(light) == before);
    world.remove(heavy); // the rope's handle is stale now, and the rope asks first
    world.step(1.0 / 64 * second);
    CHECK(world.velocity(light) == before);
}

TEST_CASE("a context of a later stage is later by its fraction of the step", "[world][context]") {
    using S = Space<float, 2>;
    const Context<S> now(Quantity<unit::Time>(10.0 * second),
                         TimeStep<S>(S::Time::from_value(0.5f), S::Time::from_value(0.25f)));
    CHECK(now.time() == 10.0 * second);
    CHECK(now.later(0).time() == 10.0 * second);
    CHECK(now.later(0.5).time() == 10.25 * second);
    CHECK(now.later(1).time() == 10.5 * second);
    CHECK(now.later(1).dt().value() == 0.5f);
    CHECK(now.dt().previous.value() == 0.25f);
    CHECK(now.restricted<true>().time() == now.time());
    CHECK(now.restricted<false>().dt().value() == 0.5f);
}
